// SPDX-License-Identifier: MIT
// What leaves the window as files: pictures, plots, videos, camera keys. Between the commands that ask for them and
// the frame that they need.
#pragma once

#include <functional>
#include <vector>

#include "app/gui/pictures.h"

namespace pabd {

class Studio {
 public:
  using Tell = std::function<void(Severity severity, const std::string& text)>;

  Studio(GlContext& context, Runner& runner, bool steady, Tell tell)
      : context_(context), steady_(steady), tell_(std::move(tell)), recorder_(context, runner) {}

  // Does what is its business. Throws Error when that cannot be.
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
