// From the command line to a session.
#include "app/cli/simulation_setup.h"

#include <fmt/format.h>

#include "app/cli/scene_lookup.h"
#include "sim/base/input_file.h"
#include "sim/trace/trace.h"

namespace pabd::cli {

Session open_session(const std::string& scene, const CommonOptions& common, const std::string& from,
                     InputFiles& inputs) {
  Session session(load_scene(find_scene(scene), common.sets), common.thread_count());
  for (const auto& file : session.scene().files) inputs.add(file);
  if (!from.empty()) {
    inputs.add(from);
    const std::string text = read_file(from, most_state_bytes(session.model()), "a state of this scene");
    session.set_state(state_from_json(session.model(), text, from));
  }
  return session;
}

Error diverged_error(const std::string& scene, const Session& session) {
  return Error(
      ExitCode::diverged,
      fmt::format("{}: the simulation diverged at step {} (t = {:.6g} s): the state left all bounds; try a "
                  "smaller time_step, a smaller contact.kappa, or solver.method=descent",
                  scene, session.report().step, session.report().time));
}

}  // namespace pabd::cli
