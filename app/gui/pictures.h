// SPDX-License-Identifier: MIT
// What leaves the window as files: pictures, plots, videos, camera keys. Drawn as `pabd render` draws.
#pragma once

#include <chrono>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/frames/frame_source.h"
#include "app/frames/runs_painter.h"
#include "app/gui/ui_state.h"
#include "app/workbench/runner.h"
#include "render/gl/renderer.h"
#include "render/output/async_sink.h"

namespace pabd {

// As for `pabd render --overlay` and `--camera`, of what the view shows.
std::string overlay_words(const UiState& ui);

// The scene alone, pixel for pixel what `pabd render` draws of this state with this camera; width × height
// pixels: the bytes of a PNG. Throws Error(bad_input) for a size.
std::vector<std::uint8_t> scene_picture(const Snapshot& sim, const UiState& ui, int width, int height,
                                        GlContext& context);

// Makes a video of the past while the window goes on, some of it in each frame.
class Recorder {
 public:
  struct Progress {
    std::string path;
    int done = 0, count = 0;  // frames; count 0: not known yet
    bool finishing = false;   // all are drawn, the file is being completed
  };
  struct Outcome {
    std::string text;
    bool error = false;
  };

  Recorder(GlContext& context, Runner& runner) : context_(context), runner_(runner) {}

  // Throws Error(bad_input) when it cannot be; what only turns out later, update() tells.
  void start(const command::Record& record, const Snapshot& sim, const UiState& ui);
  // Ends it with the frames that are there, or without a file.
  void stop(bool keep);

  // Draws for about `budget`; with `all` until everything is done. What there is to say about it, if
  // anything.
  std::optional<Outcome> update(std::chrono::milliseconds budget, bool all);

  bool busy() const { return job_ != nullptr; }
  Progress progress() const;

 private:
  struct Job;
  struct JobDeleter {
    void operator()(Job* job) const;
  };
  std::optional<Outcome> work(std::chrono::milliseconds budget, bool all);
  void begin(RunCopies runs);
  void open(const Frame& first);
  void draw(const Frame& frame);
  void deliver();
  void finish();

  GlContext& context_;
  Runner& runner_;
  std::unique_ptr<Job, JobDeleter> job_;
};

// What leaves the window as files, between the commands that ask for it and the frame that it needs.
class Studio {
 public:
  using Tell = std::function<void(Severity severity, const std::string& text)>;

  Studio(GlContext& context, Runner& runner, bool steady, Tell tell)
      : context_(context), steady_(steady), tell_(std::move(tell)), recorder_(context, runner) {}

  // Carries out the commands that write or read such files. Throws Error.
  void act(const ViewCommand& command, const Snapshot& sim, UiState& ui);

  // After a frame was composed: takes the pictures of it, draws some of a video. Leaves the context's
  // ImGui current as it was.
  void work(const Snapshot& sim, const UiState& ui, int width, int height, Renderer& renderer);

  const Recorder& recorder() const { return recorder_; }
  // A frame will have something to do.
  bool busy() const { return !waiting_.empty() || !plots_.empty() || recorder_.busy(); }

 private:
  void take(const command::Screenshot& shot, const Snapshot& sim, const UiState& ui, int width, int height,
            Renderer& renderer);

  GlContext& context_;
  bool steady_;
  Tell tell_;
  Recorder recorder_;
  std::vector<command::Screenshot> waiting_;
  std::vector<command::ExportPlot> plots_;
};

}  // namespace pabd
