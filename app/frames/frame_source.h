// SPDX-License-Identifier: MIT
// Where frames come from: a run as it is simulated, the past of one, or a recording, each alone or with other runs
// beside it. All give the same frames, by one rule of which step belongs to a time (app/session/step_at_time.h).
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "app/frames/frame.h"
#include "app/frames/pace.h"
#include "app/session/run.h"

namespace pabd {

class FrameSource {
 public:
  using Stop = std::function<bool()>;

  virtual ~FrameSource() = default;

  // The next frame, in order. None after the last one, when `stop` returns true (it is asked in every step), or when a run
  // diverged; must not be called again then.
  virtual std::optional<Frame> next(const Stop& stop) = 0;
};

// A list of one, of what cannot be copied; of two: those that are compared.
std::vector<Run> runs_of(Run a, std::optional<Run> b = {});

// What LiveSource and PastSource have in common: runs in step, with what plots and trails show of their past.
class RunSource : public FrameSource {
 protected:
  struct Shown {
    Run run;
    TrailRecorder trails;
    ReportList reports = {};
    ConvergenceSpan span = {};

    FrameView view() const;
    void widen_span();                     // by the last step
    void remember();                       // that step, and the one before it
    FrameView view_at(double time) const;  // between the two
    State before = {}, now = {};
  };

  RunSource(std::vector<Run> runs, const TrailRecorder& trails, bool grid = false);

  // Bounds the list of distances; to be called before each frame.
  void drop_old_distances();
  Frame frame(int number, std::vector<FrameView> views) const;
  // Adds how far two runs are apart, if they are at a common time.
  void measure_distance();

  std::vector<Shown> shown_;  // one at least
  const bool grid_;
  DistanceList apart_;
  int next_ = 0;  // frame
};

// Frames [first, count) are handed out; those before are simulated only.
struct FrameRange {
  int first = 0;
  int count = 0;
  double fps = 60;
  Pace pace = {};

  double time(int frame) const { return pace.simulated(frame / fps); }  // simulated since the first frame; s
};

// Is called after each step that was made, by the number of its run.
using Stepped = std::function<void(const StepSummary& step, std::size_t run)>;

// Frames that are simulated as they are asked for. In slow motion bodies, with their contacts, are on their way from one step
// to the next.
class LiveSource : public RunSource {
 public:
  using Skipped = std::function<void(int frames, const StepSummary& step)>;

  // The runs go on from where they are, all from the same step, and need no past (kNoPast). `skipped` is called in the thread
  // that asks for frames while frames before `range.first` are simulated, `stepped` in the same. `trails`: what leaves a
  // trail, in every step. `grid`: two runs are no comparison, and a run that diverges stays where it is until all have.
  LiveSource(std::vector<Run> runs, const FrameRange& range, Skipped skipped = {},
             const TrailRecorder& trails = {}, Stepped stepped = {}, bool grid = false);

  std::optional<Frame> next(const Stop& stop) override;

  // A step that diverged, and the number of its run.
  struct Diverged {
    StepSummary step;
    std::size_t run = 0;
  };
  std::vector<Diverged> diverged() const;

 private:
  struct Place {
    std::int64_t step = 0;
    std::optional<double> before_end = {};  // from the end of that step, negative; s; none: it is the end
  };
  Place place(const Run& run, double time) const;
  std::vector<FrameView> views_at(double time) const;
  bool advance_to(double time, const Stop& stop);
  bool advance(const Stop& stop);
  static bool ended(const Shown& shown) { return shown.run.report().status == StepStatus::non_finite; }

  const FrameRange range_;
  const Skipped skipped_;
  const Stepped stepped_;
  const std::int64_t first_step_;  // a state that a run continues from may be at any step
  std::size_t leader_ = 0;         // whose time is that of the frames
};

// Which part of the past, in seconds of the simulation; a negative end means the first or last moment.
struct PastRange {
  double from = -1, to = -1;
  double fps = 60;
};

// Which moment each frame shows. Where all steps are of the same length, those that `pabd render` shows; else
// the last one that is not after the frame's time. T seconds have T·fps frames, one at least. Of what a device made,
// frames show what is kept (Timeline::kept).
std::vector<std::size_t> moments_of_frames(const Timeline& timeline, const PastRange& range);

// Frames of a run that was made already, in this process or in a recording: it is wound through its past.
// They are the frames that LiveSource simulates.
class PastSource : public RunSource {
 public:
  // `iterations`, `contacts`, `bodies`: what reports contain. The parameters of a frame are those of its last step. `trails`: what
  // leaves a trail, from frame to frame.
  PastSource(std::vector<Run> runs, const PastRange& range, bool iterations, bool contacts,
             const TrailRecorder& trails = {}, bool bodies = false);

  std::optional<Frame> next(const Stop& stop) override;

  int count() const { return static_cast<int>(moments_.size()); }
  // Simulated time of a frame; s.
  double time(int frame) const { return times_[static_cast<std::size_t>(frame)]; }

 private:
  bool go_to(std::size_t moment, const Stop& stop);

  std::vector<std::size_t> moments_;
  std::vector<double> times_;
  std::vector<std::size_t> last_;  // moment of each run up to which its reports have them
};

}  // namespace pabd
