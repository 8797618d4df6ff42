// From the command line to a session.
#include "app/cli/simulation_setup.h"

#include <fmt/format.h>

#include "app/cli/scene_lookup.h"
#include "app/cli/streams.h"
#include "sim/trace/trace.h"

namespace pabd::cli {

Session open_session(const std::string& scene, const CommonOptions& common, const std::string& from) {
  Session session(load_scene(find_scene(scene), common.sets), common.thread_count());
  if (!from.empty()) session.set_state(state_from_json(session.model(), read_file(from), from));
  return session;
}

Error diverged_error(const std::string& scene, const Session& session) {
  return Error(
      ExitCode::diverged,
      fmt::format(
          "{}: the simulation diverged at step {} (t = {:.6g} s): the state was no longer finite; try a "
          "smaller time_step, a smaller contact.kappa, or solver.method=descent",
          scene, session.report().step, session.report().time));
}

}  // namespace pabd::cli
