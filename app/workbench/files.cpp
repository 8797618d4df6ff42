// SPDX-License-Identifier: MIT
// Scenes, patches and recordings on disk, and what is not on disk yet: see workbench.h.
#include <fmt/format.h>

#include <filesystem>

#include "app/session/joint_settings.h"
#include "app/session/recording.h"
#include "app/workbench/check_output.h"
#include "app/workbench/workbench.h"
#include "sim/base/atomic_file.h"
#include "sim/base/counted.h"
#include "sim/base/error.h"
#include "sim/base/input_file.h"
#include "sim/import/import.h"
#include "sim/scene/thickness.h"
#include "sim/scene/tuning.h"
#include "sim/scene/write_scene.h"
#include "sim/trace/trace.h"

namespace pabd {
namespace {

namespace fs = std::filesystem;

// {"key=value"}.
std::vector<std::string> text_of(const std::vector<std::pair<std::string, std::string>>& settings) {
  std::vector<std::string> out;
  for (const auto& [key, value] : settings) out.push_back(key + "=" + value);
  return out;
}

// What differs between `from` and `p`, put on `to`.
Params rebased(const Params& p, const Params& from, const Params& to) {
  std::vector<std::string> values;
  for (const auto& [key, value] : differences(from, p)) values.push_back(key + "=" + value);
  return tuned(to, values);
}

}  // namespace

std::string listed(const std::vector<std::string>& words) {
  std::string out;
  for (std::size_t i = 0; i < words.size(); ++i)
    out += (i == 0 ? "" : i + 1 == words.size() ? " and " : ", ") + words[i];
  return out;
}

// ---- what a person made ----

bool Workbench::edits_saved() const { return same_edits(a_->timeline().edits().get(), saved_.edits.get()); }
bool Workbench::hands_saved() const { return a_->timeline().pulled() == 0 || hands_ == saved_.hands; }

void Workbench::params_are_saved(Side side) {
  if (side == Side::a) {
    saved_.a = a_->params();
  } else {
    saved_.b = b_->params();
    saved_.joints_b = b_->scene().joint_law;
  }
}

std::vector<std::string> Workbench::made_since_saved() const {
  std::vector<std::string> out;
  if (a_->params() != saved_.a) out.emplace_back(b_ ? "parameters of A" : "parameters");
  if (b_ && b_->params() != saved_params(Side::b)) out.emplace_back("parameters of B");
  if (b_ && !same_law(b_->scene().joint_law, saved_.joints_b.value_or(shown_.scene->joint_law)))
    out.emplace_back("law of the joints of B");
  if (!edits_saved()) out.emplace_back("bodies and joints that were added or removed");
  if (!hands_saved()) out.emplace_back("what was pulled by hand");
  return out;
}

// A timeline that nobody laid hands on is not: it can be computed again.
std::vector<std::string> Workbench::at_stake() const {
  std::vector<std::string> out = made_since_saved();
  if (!shown_.held.empty()) out.push_back(counted(shown_.held.size(), "held curve", "held curves"));
  return out;
}

// Parameters of A and B, how they were changed, and held curves stay.
std::vector<std::string> Workbench::reload_loses() const {
  std::vector<std::string> out;
  const Timeline& past = a_->timeline();
  if (past.size() > 1) out.push_back(fmt::format("the timeline ({})", counted(past.size(), "moment")));
  if (past.edits()) out.emplace_back("bodies and joints that were added or removed");
  std::size_t steps = 0;
  for (const auto* changes : {&undo_, &redo_})
    for (const Change& c : *changes) steps += c.kind != Change::Kind::parameters || c.given_up ? 1 : 0;
  if (steps > 0) out.push_back(counted(steps, "step of undo", "steps of undo"));
  return out;
}

void Workbench::check_stake(bool force) const {
  if (force || at_stake().empty()) return;
  throw Error(ErrorKind::bad_input,
              fmt::format("not saved: {}; save what is needed, or load all the same", listed(at_stake())));
}

// ---- the scene's file ----

void Workbench::carry_out(const command::Load& c) {
  if (a_) check_stake(c.force);
  Source source;
  source.path = options_.find_scene ? options_.find_scene(c.scene) : c.scene;
  source.sets = c.sets;
  source.from = c.from;
  open(read(std::move(source)));
  if (const auto note = thickness_note(*shown_.scene))
    tell(note->warning ? Severity::warning : Severity::note, note->text);
}

void Workbench::carry_out(const command::Reload& c) {
  if (source_.path.empty()) throw Error(ErrorKind::bad_input, "this scene has no file to load again");
  if (const auto loses = reload_loses(); !c.force && !loses.empty()) {
    throw Error(ErrorKind::bad_input, fmt::format("{}: loading it again gives up {}; save what is needed, or "
                                                  "load it all the same",
                                                  source_.path, listed(loses)));
  }
  // Everything is made before anything is given up.
  Opened opened = read(source_);
  const auto onto = [&](const Params& p) { return rebased(p, shown_.scene->params, opened.scene->params); };
  const Params a = onto(a_->params());
  std::optional<Params> b;
  if (b_) b = onto(b_->params());
  std::shared_ptr<const Scene> scene_b;
  if (b_ && !same_law(b_->scene().joint_law, shown_.scene->joint_law))
    scene_b = read_with_joints(opened.source, *opened.scene, opened.scene->joint_law,
                               text_of(joint_settings(b_->scene().joint_law)));
  Saved saved{onto(saved_.a), {}, saved_.joints_b, {}, 0};
  if (saved_.b) saved.b = onto(*saved_.b);
  const auto kept = [&](const std::vector<Change>& changes) {
    std::vector<Change> out;
    for (const Change& one : changes) {
      if (one.kind != Change::Kind::parameters || one.given_up) continue;
      try {
        out.push_back({one.kind, one.side, one.what, onto(one.before), onto(one.after)});
      } catch (const Error&) {  // one that the scene as it is now does not allow
      }
    }
    return out;
  };
  std::vector<Change> undo = kept(undo_), redo = kept(redo_);
  std::vector<HeldCurve> held = std::move(shown_.held);

  open(std::move(opened));
  a_->set_params(a);
  if (b) b_.emplace(a_->fork());
  if (scene_b) b_->continue_as(std::move(scene_b));
  if (b) b_->set_params(*b);
  saved_ = std::move(saved);
  undo_ = std::move(undo);
  redo_ = std::move(redo);
  shown_.held = std::move(held);
  measure_distance();
  tell(Severity::note, source_.path + ": loaded again");
}

void Workbench::carry_out(const command::IgnoreFile&) {
  shown_.file_changed = false;
  try {
    source_.ignored = read_any_scene_text(source_.path, options_.may_read);
  } catch (const Error&) {  // gone or unreadable: there is nothing to load
  }
}

bool Workbench::look_at_file() {
  std::error_code error;
  const auto written = fs::last_write_time(source_.path, error);
  if (error || written == source_.written) return false;  // a file that is gone may come back
  std::string text;
  try {
    text = read_any_scene_text(source_.path, options_.may_read);
  } catch (const Error&) {
    return false;  // looked at again
  }
  source_.written = written;
  const bool changed = text != source_.text && text != source_.ignored;
  return std::exchange(shown_.file_changed, changed) != changed;
}

Workbench::Opened Workbench::read(Source source) const {
  std::error_code ignored;
  source.written = fs::last_write_time(source.path, ignored);
  source.text = read_any_scene_text(source.path, options_.may_read);
  source.ignored.clear();
  auto scene = std::make_shared<const Scene>(parse_any_scene(
      source.text, source.path, fs::path(source.path).parent_path(), source.sets, options_.may_read));
  std::optional<State> start;
  if (!source.from.empty()) {
    const std::string text = read_file(source.from, most_state_bytes(scene->model), "a state of this scene");
    start = state_from_json(scene->model, text, source.from);
  }
  Run run(scene, options_.threads, options_.memory, start);
  run.offer(options_.devices);
  if (const auto answer = run.answer(run.params()); answer.refused)
    throw Error(answer.kind, source.path, answer.why);
  return {std::move(source), std::move(scene), std::move(run)};
}

void Workbench::open(Opened opened) {
  source_ = std::move(opened.source);
  shown_.scene = std::move(opened.scene);
  begin_with(std::move(opened.run));
  shown_.file_changed = false;
  told_a_ = told_b_ = {};
  ++shown_.scene_serial;
}

// Without a comparison, anything to undo and held curves.
void Workbench::begin_with(Run run) {
  run.observe(observe_.iterations, observe_.contacts, observe_.bodies);
  a_.emplace(std::move(run));
  b_.reset();
  distances_ = {};
  undo_.clear();
  redo_.clear();
  shown_.held.clear();
  shown_.diverged = false;
  saved_ = {a_->params(), {}, {}, a_->timeline().edits(), hands_};
}

// ---- saving ----

// Only a scene may take the place of the scene's own file, and is no change of it then.
void Workbench::save(const std::string& path, const std::string& text, bool force, bool scene) {
  check_output(path, force, scene ? "" : source_.path);
  const bool own = same_file(path, source_.path);
  write_file(path, text);
  if (!own) return;
  std::error_code ignored;
  source_.text = text;
  source_.sets.clear();  // the file has them
  source_.written = fs::last_write_time(source_.path, ignored);
  shown_.file_changed = false;
}

void Workbench::carry_out(const command::SaveScene& c) {
  Run& run = run_of(c.side);
  if (c.state) {
    run.complete();
    std::string name = fs::path(c.path).stem().string();
    if (name.empty()) name = shown_.scene->name;
    save(c.path,
         scene_to_json(run.model(), run.state(), run.params(), run.scene().joint_law, name,
                       shown_.scene->camera, shown_.scene->duration, parameter_table(), shown_.scene->looks),
         c.force, true);
    saved_.edits = a_->timeline().edits();
  } else {
    std::vector<std::string> sets = source_.sets;
    if (!same_law(run.scene().joint_law, shown_.scene->joint_law))
      for (const std::string& set : text_of(joint_settings(run.scene().joint_law))) sets.push_back(set);
    Params defaults;
    defaults.contact.d_hat =
        shown_.scene->params.contact.d_hat;  // where the text states none, it was the default
    save(c.path,
         tuned_scene_text(source_.text, source_.path, sets, run.params(), parameter_table(), defaults),
         c.force, true);
  }
  params_are_saved(c.side);
  const bool partly = !c.state && !edits_saved();
  tell(partly ? Severity::warning : Severity::note,
       "saved " + c.path +
           (partly ? ", without the bodies and joints that were added or removed here; save the "
                     "present state to keep them"
                   : ""));
}

void Workbench::carry_out(const command::SavePatch& c) {
  const Run& run = run_of(c.side);
  save(c.path,
       patch_with_joints(patch_json(shown_.scene->params, run.params()), shown_.scene->joint_law,
                         run.scene().joint_law),
       c.force);
  params_are_saved(c.side);
  tell(Severity::note, "saved " + c.path);
}

void Workbench::carry_out(const command::ApplyPatch& c) {
  std::string patch = read_scene_text(c.path);
  const std::vector<std::string> joints = take_joint_settings(patch, c.path);
  change(c.side, "patch", patched(run_of(c.side).params(), patch, c.path), joints);
  tell(Severity::note, "applied " + c.path);
}

void Workbench::carry_out(const command::SaveRecording& c) {
  check_output(c.path, c.force, source_.path);
  a_->complete();
  AtomicFile file(c.path);
  write_recording(*a_, [&](std::string_view part) { file.write(part); });
  file.commit();
  params_are_saved(Side::a);
  saved_.edits = a_->timeline().edits();
  saved_.hands = hands_;
  tell(Severity::note, fmt::format("saved {}: {}", c.path, counted(a_->timeline().size(), "moment")));
}

// Everything is made before anything is given up.
void Workbench::carry_out(const command::LoadRecording& c) {
  check_stake(c.force);
  Timeline past = read_recording(c.path, shown_.scene, options_.memory);
  const auto differs = first_difference(past, options_.threads);
  Run run(shown_.scene, options_.threads, std::move(past));
  run.offer(options_.devices);
  begin_with(std::move(run));
  shown_.playing = false;
  ++shown_.jumps;
  const std::string what = fmt::format("{}: {}", c.path, counted(a_->timeline().size(), "moment"));
  if (!differs) return tell(Severity::note, what);
  tell(Severity::warning,
       fmt::format("{}; made by another build or machine: from step {} on, what is computed again differs in "
                   "the last bits",
                   what, *differs));
}

}  // namespace pabd
