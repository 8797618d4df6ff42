// SPDX-License-Identifier: MIT
// Several runs in one picture.
#include "app/frames/runs_painter.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/frames/outlook.h"
#include "app/overlay/parameter_words.h"
#include "app/plots/axis_ticks.h"
#include "sim/base/error.h"

namespace pabd {
namespace {

constexpr int kSeam = 2;                 // px between pictures, white
constexpr int kLeastCell = 16;           // px
constexpr double kSeenToo = 2;           // of the radius of what a run shows: another one's is seen with it
constexpr std::size_t kMostDetails = 6;  // lines of a caption

std::string law_words(const BondLaw& law) {
  const bool hard = law.potential == BondPotential::hard;
  return (hard ? fmt::format("hard, *{{N}} {}, *{{d̂}} {} m, ", law.N, format_value(law.d_hat)) : "soft, ") +
         fmt::format("*{{κ}} {} {}", format_value(law.kappa), hard ? "J" : "N/m");
}

std::vector<std::string> details_of(const FrameView& a, const FrameView& b, const BondLaw& joints_a,
                                    const BondLaw& joints_b) {
  std::vector<std::string> lines = difference_words(a.params, a.kappa, b.params, b.kappa);
  const std::string from = law_words(joints_a), to = law_words(joints_b);
  if (from != to) lines.push_back(fmt::format("joints {} → {}", from, to));
  if (lines.empty()) lines.emplace_back("the same parameters");
  if (lines.size() > kMostDetails) {
    const std::size_t more = lines.size() - (kMostDetails - 1);
    lines.resize(kMostDetails - 1);
    lines.push_back(fmt::format("and {} more", more));
  }
  return lines;
}

// Copies `cell` into `picture`, whose sides are at least those of both; `channels`: bytes a pixel.
void paste(const std::vector<std::uint8_t>& cell, int width, int left, int top, int channels,
           std::vector<std::uint8_t>& picture, int picture_width) {
  const auto row = static_cast<std::ptrdiff_t>(channels) * width;
  const auto rows = static_cast<std::ptrdiff_t>(cell.size()) / row;
  for (std::ptrdiff_t y = 0; y < rows; ++y)
    std::copy_n(cell.begin() + y * row, row, picture.begin() + channels * ((top + y) * picture_width + left));
}

// Where cell i of n begins, of a side of so many pixels; i = n: one after the last one ends.
int begin_of(int i, int n, int pixels) {
  return static_cast<int>(static_cast<std::int64_t>(pixels + kSeam) * i / n);
}

// From the same place for all runs of a scene, whatever their parameters.
Outlook outlook_of(const std::shared_ptr<const Scene>& scene, const FrameView& first,
                   const CameraOption& camera, double seconds) {
  const bool ahead = camera.frames() && camera.follow.empty();
  FrameView start = first;
  start.params = scene->params;
  if (start.poses) {  // they are on a GPU
    start.model = {scene, &scene->model};
    start.state = {scene, &scene->initial};
  }
  return look_ahead(scene, start, ahead ? std::max(seconds, look_ahead_time(*scene)) : 0,
                    bodies_to_fit(camera, *start.model));
}

// Of each run of a grid. Those with as many bodies are seen from one place: it shows all of the run that they are variants
// of, and of the others what is not too far from it.
std::vector<Outlook> outlooks_of(const std::vector<std::shared_ptr<const Scene>>& scenes, const Frame& first,
                                 const std::shared_ptr<const Scene>& plain, const CameraOption& camera,
                                 double seconds) {
  const auto bodies = [](const Model& model) { return model.shape.size(); };
  const std::size_t usual = bodies(*first.a().model);
  Outlook shared = outlook_of(bodies(plain->model) == usual ? plain : scenes[0], first.a(), camera, seconds);
  const auto reach = [&](const Spot& spot) {
    return (spot.centre - shared.start_middle).norm() + spot.radius;
  };
  double radius = 0;
  for (const Spot& spot : shared.all()) radius = std::max(radius, reach(spot));
  std::vector<Outlook> out;
  for (std::size_t run = 0; run < first.runs.size(); ++run) {
    out.push_back(outlook_of(scenes[run], first.runs[run], camera, seconds));
    if (bodies(scenes[run]->model) != usual) continue;
    for (const Spot& spot : out.back().all())
      if (reach(spot) <= kSeenToo * radius) shared.start.push_back(spot);
  }
  for (std::size_t run = 0; run < out.size(); ++run)
    if (bodies(scenes[run]->model) == usual) out[run] = shared;
  return out;
}

}  // namespace

AbView parse_ab_view(const std::string& text) {
  if (text == "side") return AbView::side;
  if (text == "ghost") return AbView::ghost;
  throw Error(ErrorKind::bad_input, fmt::format("--ab-view {}: expected side or ghost", text));
}

RunsPainter::RunsPainter(GlContext& context, const std::vector<std::shared_ptr<const Scene>>& scenes,
                         const Frame& first, const Arrangement& arrangement, int width, int height,
                         const OverlayChoice& overlay, const CameraOption& camera, double seconds)
    : width_(width), height_(height) {
  const auto scene_of = [&](std::size_t run) { return scenes[run < scenes.size() ? run : 0]; };
  const RunGrid& grid = arrangement.grid;
  const std::vector<Outlook> outlooks =
      grid.empty() ? std::vector(first.runs.size(), outlook_of(scene_of(0), first.a(), camera, seconds))
                   : outlooks_of(scenes, first, arrangement.plain, camera, seconds);
  const auto add = [&](std::size_t run, int columns, int rows, const Comparison& comparison) {
    const int column = static_cast<int>(run) % columns, row = static_cast<int>(run) / columns;
    const int left = begin_of(column, columns, width), top = begin_of(row, rows, height);
    const int w = begin_of(column + 1, columns, width) - kSeam - left;
    const int h = begin_of(row + 1, rows, height) - kSeam - top;
    if (std::min(w, h) < kLeastCell) {
      throw Error(ErrorKind::bad_input,
                  fmt::format("{} × {} pixels are too few for {} × {} pictures: expected {} a side or more "
                              "for each",
                              width, height, columns, rows, kLeastCell));
    }
    cells_.push_back({std::make_unique<FramePainter>(context, scene_of(run), first, run, outlooks[run], w, h,
                                                     overlay, camera, seconds, comparison),
                      left, top});
  };
  if (!grid.empty()) {
    const int columns = grid.columns(width, height), cells = static_cast<int>(grid.size());
    for (std::size_t run = 0; run < grid.size(); ++run)
      add(run, columns, (cells + columns - 1) / columns,
          {grid.words(run, first.runs[run].params, first.runs[run].kappa), {}, false, 0});
  } else if (!first.compared) {
    add(0, 1, 1, {});
  } else {
    const std::vector<std::string> details =
        details_of(first.a(), *first.b(), scene_of(0)->joint_law, scene_of(1)->joint_law);
    if (arrangement.view == AbView::ghost) {
      add(0, 1, 1, {"A, and B as a ghost", details, true, 0});
    } else {
      add(0, 2, 1, {first.a().label, {"as it is"}, false, details.size()});
      add(1, 2, 1, {first.b()->label, details, false, 0});
    }
  }
}

void RunsPainter::set_quality(const RenderQuality& quality) {
  for (Cell& cell : cells_) cell.painter->set_quality(quality);
}

void RunsPainter::draw(const Frame& frame, const BodiesOnDevice* on_device) {
  for (Cell& cell : cells_) cell.painter->draw(frame, on_device);
}

void RunsPainter::look_at(const Frame& frame) {
  for (Cell& cell : cells_) cell.painter->look_at(frame);
}

void RunsPainter::fetch(Image& out) {
  if (cells_.size() == 1) return cells_.front().painter->fetch(out);
  out.resize(width_, height_);
  std::fill(out.rgb.begin(), out.rgb.end(), std::uint8_t{255});
  out.alpha.clear();
  for (Cell& cell : cells_) {
    cell.painter->fetch(cell_);
    paste(cell_.rgb, cell_.width, cell.left, cell.top, 3, out.rgb, width_);
    if (cell_.alpha.empty()) continue;
    out.alpha.resize(out.rgb.size() / 3, 0);
    paste(cell_.alpha, cell_.width, cell.left, cell.top, 1, out.alpha, width_);
  }
}

}  // namespace pabd
