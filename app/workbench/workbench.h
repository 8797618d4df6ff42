// SPDX-License-Identifier: MIT
// The desk of the tool: one or two runs of a scene, undo and redo, curves held for comparison. Carries out commands and
// makes steps; knows no threads, no clock and no drawing.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "app/workbench/command.h"
#include "app/workbench/snapshot.h"
#include "sim/scene/guarded_scene.h"

namespace pabd {

struct WorkbenchOptions {
  int threads = 1;
  std::size_t memory = std::size_t{512} << 20;  // bytes for states of the past
  // File of a scene that a person names. Throws Error(file) when there is none.
  std::function<std::string(const std::string& name)> find_scene;
  std::function<bool()> stop = {};                  // see stop_when
  std::shared_ptr<const StepDevices> devices = {};  // beside the processor; null: none
  MayRead may_read = {};                            // of the meshes of a scene
};

class Workbench {
 public:
  // Loads `scene` (as the command does). Throws Error.
  Workbench(const WorkbenchOptions& options, const command::Load& scene);

  // Throws Error when the command cannot be carried out; nothing has changed then.
  void apply(const Command& command);

  // One step of A, and of B up to the same time. False when a run diverged or was stopped.
  bool advance();

  // Steps under way end when `stop` returns true; their result is not used.
  void stop_when(std::function<bool()> stop) { options_.stop = std::move(stop); }

  bool playing() const { return shown_.playing; }
  double speed() const { return shown_.speed; }
  const Run& run(Side side = Side::a) const;
  bool comparing() const { return b_.has_value(); }

  // Checks whether the scene's file changed, other than by this program. True when the answer differs from the last one.
  // Nothing is loaded.
  bool look_at_file();

  // `about`: the command that it answers.
  void tell(Severity severity, const std::string& text, const std::string& about = {},
            ErrorKind kind = ErrorKind::bad_input);

  // All but real_time_factor.
  Snapshot snapshot();

 private:
  struct Source {
    std::string path;
    std::vector<std::string> sets;
    std::string from;     // file of the state that it begins with; empty: the scene's own
    std::string text;     // of the file
    std::string ignored;  // another text of the file, which the person chose to ignore
    std::filesystem::file_time_type written{};
  };
  // What a change discarded: undo and redo exchange it with what is there.
  struct GivenUp {
    bool with_a = false, with_b = false;
    std::optional<Head> a, b;  // where the runs were; none: there was no such run
    SharedList<RunDistance> distances;
    std::optional<std::vector<HeldCurve>> held;
    bool touched = false;  // the discarded future has edits or hands
  };
  struct Change {
    enum class Kind : std::uint8_t { parameters, edit, exchange };
    Kind kind;
    Side side;
    std::string what;
    Params before, after;
    // Of an edit: what was done, in A and in B (null: there was none), and how to do it again.
    std::shared_ptr<const MadeEdit> edit_a = nullptr, edit_b = nullptr;
    std::optional<ModelEdit> edit = {};
    std::shared_ptr<GivenUp> given_up = nullptr;
    std::size_t at = 0;      // moment of the run, for parameters that discarded something
    bool exchanged = false;  // given_up holds what the change led to
  };
  // What was last saved or loaded.
  struct Saved {
    Params a;
    std::optional<Params> b;          // else as a
    std::optional<BondLaw> joints_b;  // else as the scene has it
    std::shared_ptr<const EditChain> edits;
    std::uint64_t hands = 0;
  };
  struct Opened {
    Source source;
    std::shared_ptr<const Scene> scene;
    Run run;
  };
  struct ChangedKeys {  // of those parameters in that scene
    std::uint64_t scene = 0;
    Params params;
    std::vector<std::pair<std::string, std::string>> keys;
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
  void carry_out(const command::IgnoreFile& c);
  void carry_out(const command::SaveScene& c);
  void carry_out(const command::SavePatch& c);
  void carry_out(const command::ApplyPatch& c);
  void carry_out(const command::SaveRecording& c);
  void carry_out(const command::LoadRecording& c);

  Run& run_of(Side side);
  void change(Side side, const std::string& what, const Params& after, bool more = false);
  // With settings of joints as well, "joints_default.key=value", which only B takes.
  void change(Side side, const std::string& what, const Params& after,
              const std::vector<std::string>& joints);
  // B with the joints of that scene.
  void change_b(const std::string& what, const Params& after, std::shared_ptr<const Scene> scene);
  // `scene`, which was read from `source`, with those settings after the law `now`. Throws Error(bad_input).
  std::shared_ptr<const Scene> read_with_joints(const Source& source, const Scene& scene, const BondLaw& now,
                                                const std::vector<std::string>& settings) const;
  [[noreturn]] static void refuse_joints_of_a();
  Change make_edit(const ModelEdit& edit, const std::string& what);
  void edit_here(const ModelEdit& edit, const std::string& what);
  bool undo_edit(const Change& change);
  void pull(const std::vector<Pull>& pulls);

  void keep(Change change);
  void keep_exchange(const std::string& what, std::shared_ptr<GivenUp> given_up);
  void keep_held(const std::string& what);
  void restore(std::vector<Change>& from, std::vector<Change>& to, bool before);
  bool restore_heads(Change& change, bool before);
  std::shared_ptr<GivenUp> restore_params(Change& change, bool before);
  std::shared_ptr<GivenUp> heads(bool with_a, bool with_b) const;
  void exchange(GivenUp& other);
  void thin(std::vector<Change>& changes) const;

  bool edits_saved() const;
  bool hands_saved() const;
  const Params& saved_params(Side side) const { return side == Side::b && saved_.b ? *saved_.b : saved_.a; }
  void params_are_saved(Side side);
  std::vector<std::string> made_since_saved() const;
  std::vector<std::string> at_stake() const;
  std::vector<std::string> reload_loses() const;
  void check_stake(bool force) const;
  void save(const std::string& path, const std::string& text, bool force, bool scene = false);

  Opened read(Source source) const;
  void open(Opened opened);
  void begin_with(Run run);
  void check_device(const Run& run, const Params& after) const;
  void tell_of_device(const Run& run, const char* name, DeviceStatus& told);
  void seek_to(std::size_t moment);
  bool let_bodies_stay();
  void bring_bodies_back();
  RunView view(const Run& run, ChangedKeys& changed) const;
  void measure_distance();

  WorkbenchOptions options_;
  Source source_;
  Snapshot shown_;  // all but what snapshot() finds out
  std::optional<Run> a_, b_;
  Saved saved_;
  std::uint64_t hands_ = 0;  // rises with every pull
  ChangedKeys changed_a_, changed_b_;
  command::Observe observe_;
  std::vector<Change> undo_, redo_;
  SharedList<RunDistance> distances_;  // ascending in time
  DeviceStatus told_a_, told_b_;       // of devices, in messages
  std::string about_;                  // the command that is carried out
};

}  // namespace pabd
