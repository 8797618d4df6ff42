// Scenes and patches on disk: see workbench.h.
#include <fmt/format.h>

#include <filesystem>

#include "app/session/recording.h"
#include "app/workbench/workbench.h"
#include "sim/base/atomic_file.h"
#include "sim/base/output_path.h"
#include "sim/error.h"
#include "sim/scene/tuning.h"
#include "sim/scene/write_scene.h"

namespace pabd {
namespace {

void check_writable(const std::string& path, bool force) {
  if (path.empty()) throw Error(ExitCode::bad_input, "a file needs a name");
  check_overwrite(path, path, {force, nullptr, "replace it"});
}

void write_text(const std::string& path, const std::string& text, bool force) {
  check_writable(path, force);
  AtomicFile file(path);
  file.write(text);
  file.commit();
}

}  // namespace

void Workbench::carry_out(const command::Load& c) {
  if (a_ && unsaved() && !c.force) {
    throw Error(ExitCode::bad_input, "what was changed is not saved; save it, or load all the same");
  }
  Source source;
  source.path = options_.find_scene ? options_.find_scene(c.scene) : c.scene;
  source.sets = c.sets;
  open(std::move(source));
}

void Workbench::carry_out(const command::Reload&) {
  if (source_.path.empty()) throw Error(ExitCode::bad_input, "this scene has no file to load again");
  const auto changes = differences(scene_->params, a_->params());
  open(source_);
  std::vector<std::string> values;
  for (const auto& [key, value] : changes) values.push_back(key + "=" + value);
  a_->set_params(tuned(a_->params(), values));
  tell(Severity::note, source_.path + ": loaded again");
}

bool Workbench::file_changed() {
  std::error_code error;
  const auto written = std::filesystem::last_write_time(source_.path, error);
  if (error || written == source_.written) return false;  // a file that is gone may come back
  source_.written = written;                              // asked once, also when it turns out to be broken
  return true;
}

// Everything is made before anything is given up.
void Workbench::open(Source source) {
  std::error_code ignored;
  source.written = std::filesystem::last_write_time(source.path, ignored);
  source.text = read_scene_text(source.path);
  const std::filesystem::path path(source.path);
  auto scene =
      std::make_shared<const Scene>(parse_scene(source.text, source.path, path.parent_path(), source.sets));
  Run run(scene, options_.threads, options_.memory);
  run.observe(observe_.iterations, observe_.contacts, observe_.bodies);
  source_ = std::move(source);
  scene_ = std::move(scene);
  a_.emplace(std::move(run));
  b_.reset();
  undo_.clear();
  redo_.clear();
  held_.clear();
  diverged_ = false;
  saved_ = tuning();
  saved_edits_.clear();
  ++scene_serial_;
}

void Workbench::carry_out(const command::SaveScene& c) {
  const Run& run = run_of(c.side);
  if (c.state) {
    std::string name = std::filesystem::path(c.path).stem().string();
    if (name.empty()) name = scene_->name;
    write_text(c.path,
               scene_to_json(run.model(), run.state(), run.params(), scene_->joint_law, name, scene_->camera),
               c.force);
  } else {
    write_text(c.path, tuned_scene_text(source_.text, source_.path, source_.sets, run.params()), c.force);
  }
  saved_ = tuning();
  if (c.state) saved_edits_ = a_->edits();
  const bool partly = !c.state && a_->edits() != saved_edits_;
  tell(partly ? Severity::warning : Severity::note,
       "saved " + c.path +
           (partly ? ", without the bodies and joints that were added or removed here; save the "
                     "present state to keep them"
                   : ""));
}

void Workbench::carry_out(const command::SavePatch& c) {
  write_text(c.path, patch_json(scene_->params, run_of(c.side).params()), c.force);
  saved_ = tuning();
  tell(Severity::note, "saved " + c.path);
}

void Workbench::carry_out(const command::ApplyPatch& c) {
  change(c.side, "patch", patched(run_of(c.side).params(), read_scene_text(c.path), c.path));
}

void Workbench::carry_out(const command::SaveRecording& c) {
  check_writable(c.path, c.force);
  AtomicFile file(c.path);
  write_recording(*a_, [&](std::string_view part) { file.write(part); });
  file.commit();
  saved_ = tuning();
  saved_edits_ = a_->edits();
  tell(Severity::note, fmt::format("saved {}: {} moments", c.path, a_->timeline().size()));
}

// Everything is made before anything is given up.
void Workbench::carry_out(const command::LoadRecording& c) {
  if (unsaved() && !c.force)
    throw Error(ExitCode::bad_input, "what was changed is not saved; save it, or load all the same");
  Timeline past = read_recording(c.path, scene_, options_.memory);
  const auto differs = first_difference(past, options_.threads);
  Run run(scene_, options_.threads, std::move(past));
  run.observe(observe_.iterations, observe_.contacts, observe_.bodies);
  a_.emplace(std::move(run));
  b_.reset();
  undo_.clear();
  redo_.clear();
  held_.clear();
  playing_ = diverged_ = false;
  saved_ = tuning();
  saved_edits_ = a_->edits();
  const std::string what = fmt::format("{}: {} moments", c.path, a_->timeline().size());
  if (!differs) return tell(Severity::note, what);
  tell(Severity::warning,
       fmt::format("{}; made by another build or machine: from step {} on, what is computed again differs in "
                   "the last bits",
                   what, *differs));
}

}  // namespace pabd
