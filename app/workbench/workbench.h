// The desk of the tool: one or two runs of a scene, what is undone and redone, what is held for comparison.
// Carries out commands and makes steps; knows no threads, no clock and no drawing.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "app/workbench/command.h"
#include "app/workbench/snapshot.h"

namespace pabd {

struct WorkbenchOptions {
  int threads = 1;
  std::size_t memory = std::size_t{512} << 20;  // bytes for states of the past
  // File of a scene that a person names. Throws Error(file) when there is none.
  std::function<std::string(const std::string& name)> find_scene;
  std::function<bool()> stop = {};  // see stop_when
};

class Workbench {
 public:
  // Loads `scene` (as the command does). Throws Error.
  Workbench(const WorkbenchOptions& options, const command::Load& scene);

  // Throws Error when it cannot be carried out: then nothing has changed.
  void apply(const Command& command);

  // One step of everything that runs. False when that was not possible: the simulation diverged, or was
  // stopped.
  bool advance();

  // Steps that are under way end when it says true; whoever asked is not going to look at the result.
  void stop_when(std::function<bool()> stop) { options_.stop = std::move(stop); }

  bool playing() const { return playing_; }
  double speed() const { return speed_; }
  const Run& run(Side side = Side::a) const;
  bool comparing() const { return b_.has_value(); }

  // Whether the scene's file is another one than when it was loaded or last asked.
  bool file_changed();

  void tell(Severity severity, const std::string& text);

  // All but real_time_factor.
  Snapshot snapshot();

 private:
  struct Source {
    std::string path;
    std::vector<std::string> sets;
    std::string text;  // of the file
    std::filesystem::file_time_type written{};
  };
  struct Change {
    Side side;
    std::string what;
    Params before, after;
    // Of an edit: what was done, in A and in B (null: there was none), and how to do it again.
    std::shared_ptr<const MadeEdit> edit_a = nullptr, edit_b = nullptr;
    std::optional<ModelEdit> edit = {};
    // Of a restart that gave up edits: what was before it.
    std::shared_ptr<Run> run_a = nullptr, run_b = nullptr;
  };

  void carry_out(const command::Set& c);
  void carry_out(const command::SetAll& c);
  void carry_out(const command::ResetParams& c);
  void carry_out(const command::Undo& c);
  void carry_out(const command::Redo& c);
  void carry_out(const command::Play& c);
  void carry_out(const command::Pause& c);
  void carry_out(const command::Step& c);
  void carry_out(const command::Seek& c);
  void carry_out(const command::Speed& c);
  void carry_out(const command::Restart& c);
  void carry_out(const command::Edit& c);
  void carry_out(const command::Pull& c);
  void carry_out(const command::Release& c);
  void carry_out(const command::Shoot& c);
  void carry_out(const command::Compare& c);
  void carry_out(const command::EndCompare& c);
  void carry_out(const command::Hold& c);
  void carry_out(const command::DropHeld& c);
  void carry_out(const command::Observe& c);
  void carry_out(const command::Tell& c);
  void carry_out(const command::Load& c);
  void carry_out(const command::Reload& c);
  void carry_out(const command::SaveScene& c);
  void carry_out(const command::SavePatch& c);
  void carry_out(const command::ApplyPatch& c);
  void carry_out(const command::SaveRecording& c);
  void carry_out(const command::LoadRecording& c);

  Run& run_of(Side side);
  void change(Side side, const std::string& what, const Params& after, bool more = false);
  Change make_edit(const ModelEdit& edit, const std::string& what);
  void edit_here(const ModelEdit& edit, const std::string& what);
  void undo_edit(const Change& change);
  void undo_restart(Change& change);
  void keep(Change change);
  void restore(std::vector<Change>& from, std::vector<Change>& to, bool before);
  std::string tuning() const;
  bool follow();
  bool unsaved() const { return tuning() != saved_ || a_->edits() != saved_edits_; }
  void open(Source source);
  void seek_to(std::size_t moment);
  RunView view(const Run& run) const;
  void measure_distance();

  WorkbenchOptions options_;
  Source source_;
  std::shared_ptr<const Scene> scene_;
  std::uint64_t scene_serial_ = 0, serial_ = 0, message_number_ = 0;
  std::optional<Run> a_, b_;
  bool playing_ = false, diverged_ = false;
  std::string saved_;        // parameters as they were last saved or loaded, both sides
  std::string saved_edits_;  // the same of bodies and joints
  double speed_ = 1;
  command::Observe observe_;
  std::vector<Change> undo_, redo_;
  std::vector<HeldCurve> held_;
  std::vector<RunDistance> distances_;  // ascending in time
  std::vector<Message> messages_;
};

}  // namespace pabd
