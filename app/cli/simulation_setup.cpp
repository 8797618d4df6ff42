// SPDX-License-Identifier: MIT
// From the command line to a session.
#include "app/cli/simulation_setup.h"

#include <fmt/format.h>

#include <memory>
#include <optional>
#include <utility>

#include "app/cli/scene_lookup.h"
#include "app/cli/streams.h"
#include "sim/base/input_file.h"
#include "sim/import/import.h"
#include "sim/scene/thickness.h"
#include "sim/trace/trace.h"

namespace pabd::cli {

namespace {

struct Start {
  std::shared_ptr<const Scene> scene;
  std::optional<State> state;  // none: the scene's
};

Start open(const std::string& scene, const CommonOptions& common, const std::string& from,
           InputFiles& inputs) {
  Start start{open_scene(scene, common, inputs), {}};
  if (!from.empty()) {
    inputs.add(from);
    const Model& model = start.scene->model;
    const std::string text = read_file(from, most_state_bytes(model), "a state of this scene");
    start.state = state_from_json(model, text, from);
  }
  return start;
}

}  // namespace

void write_import_notes(const std::string& robot, const std::vector<ImportNote>& notes) {
  if (notes.empty()) return;
  write_note(fmt::format("{}: {} {} not as in the file:", robot, notes.size(),
                         notes.size() == 1 ? "thing is" : "things are"));
  for (const ImportNote& note : notes) write_note("  " + note.line());
}

std::shared_ptr<const Scene> open_scene(const std::string& scene, const CommonOptions& common,
                                        InputFiles& inputs) {
  std::vector<ImportNote> notes;
  auto loaded = std::make_shared<const Scene>(load_any_scene(find_scene(scene), common.sets, &notes));
  if (!common.quiet) {
    write_import_notes(scene, notes);
    if (const auto note = thickness_note(*loaded)) write_note("pabd: note: " + note->text);
  }
  for (const auto& file : loaded->files) inputs.add(file);
  return loaded;
}

Session open_session(const std::string& scene, const CommonOptions& common, const std::string& from,
                     InputFiles& inputs) {
  Start start = open(scene, common, from, inputs);
  Session session(std::move(start.scene), common.thread_count());
  if (start.state) session.set_state(*std::move(start.state));
  return session;
}

Run open_run(const std::string& scene, const CommonOptions& common, const std::string& from,
             InputFiles& inputs) {
  Start start = open(scene, common, from, inputs);
  return Run(std::move(start.scene), common.thread_count(), kNoPast, start.state);
}

}  // namespace pabd::cli
