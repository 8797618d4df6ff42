// SPDX-License-Identifier: MIT
// Where the tasks stand in grids, and what the pixels of sheets and maps say.
#include <catch2/catch.hpp>
#include <cmath>

#include "app/plots/figure.h"
#include "app/sweep/collect_plots.h"
#include "app/sweep/collect_sheet.h"
#include "tests/support/errors.h"
#include "tests/sweep/swept_folder.h"

namespace pabd::test_collect_pictures {

using namespace test;

namespace {

// N = 1 … columns along x, κ = 10, 20, … along y; penetration = 10^(N − row).
void fill(const SweptFolder& folder, int columns, int rows) {
  for (int i = 0; i < columns * rows; ++i) {
    const int n = i % columns, row = i / columns;
    folder.add({.index = i,
                .parameters = {{"contact.N", std::to_string(n + 1)},
                               {"contact.kappa", std::to_string(10 * (row + 1))}},
                .status = i == 1 ? "diverged" : "done",
                .metrics = {{"penetration", "1e" + std::to_string(n - row)}},
                .picture = fake_picture(i)});
  }
}

Color pixel(const Image& image, double x, double y) {
  const std::size_t at =
      3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x));
  return {image.rgb[at], image.rgb[at + 1], image.rgb[at + 2], 255};
}

int difference(Color a, Color b) { return std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b); }

const Criterion& criterion(const std::vector<Criterion>& all, const std::string& key) {
  for (const Criterion& one : all) {
    if (one.quantity.key == key) return one;
  }
  throw std::runtime_error("no such criterion");
}

}  // namespace

TEST_CASE("tasks stand in the grid of two parameters, a slice for each value of the others") {
  const SweptFolder folder(
      R"({"parameters": [{"key": "contact.kappa"}, {"key": "contact.N"}, {"key": "time_step"}]})");
  int index = 0;
  for (const char* kappa : {"100", "9", "20"}) {
    for (const char* n : {"2", "1"}) {
      for (const char* h : {"0.02", "0.01"})
        folder.add(
            {.index = index++, .parameters = {{"contact.kappa", kappa}, {"contact.N", n}, {"time_step", h}}});
    }
  }
  const CollectedSweep sweep = collect_sweep(folder.path());
  const TaskGrid grid = grid_of(sweep);
  CHECK_FALSE(grid.scattered);
  CHECK(grid.x.label == "stiffness κ [J]");
  CHECK(grid.x.names == std::vector<std::string>{"9", "20", "100"});  // as numbers, not as text
  CHECK(grid.y.names == std::vector<std::string>{"1", "2"});
  REQUIRE(grid.slices.size() == 2);
  CHECK(grid.slices[0].name == "h = 0.01 s");
  CHECK(grid.slices[1].name == "h = 0.02 s");
  // κ = 9 are the tasks 4 … 7; of N = 1 and h = 0.01 the last.
  CHECK(*grid.slices[0].tasks[0] == 7);
  CHECK(*grid.slices[1].tasks[0] == 6);
  CHECK(*grid.slices[0].tasks[3] == 5);
  CHECK(*grid.slices[0].tasks[2] == 3);

  const TaskGrid turned = grid_of(sweep, "time_step", "contact.kappa");
  CHECK(turned.x.names == std::vector<std::string>{"0.01", "0.02"});
  CHECK(turned.rows() == 3);
  CHECK(turned.slices.size() == 2);
  CHECK(grid_of(sweep, "contact.N").y.label == "stiffness κ [J]");
  CHECK(caught([&] { grid_of(sweep, "contact.n"); }).says("\"contact.n\" is no parameter of this sweep"));
  CHECK(caught([&] { grid_of(sweep, "contact.N", "contact.N"); }).says("both axes"));
}

TEST_CASE("a large sample is no grid, and takes no memory for one") {
  // As a grid 3000 × 3000 cells in 3000 slices.
  CollectedSweep sweep;
  for (const char* key : {"contact.N", "contact.kappa", "contact.d_hat"})
    sweep.parameters.push_back({key, key, key, ""});
  for (int i = 0; i < 3000; ++i) {
    SweptTask task;
    task.index = i;
    for (const int factor : {1, 7, 11}) {
      const double value = factor * i % 3001;
      task.parameters.push_back({value, std::to_string(value)});
    }
    sweep.tasks.push_back(std::move(task));
  }
  const TaskGrid grid = grid_of(sweep);
  CHECK(grid.scattered);
  CHECK(grid.columns() == 55);
  CHECK(grid.rows() == 55);
  // Few along the axes, but a slice for each.
  for (SweptTask& task : sweep.tasks) {
    task.parameters[0] = {1.0 + task.index % 2, std::to_string(1 + task.index % 2)};
    task.parameters[1] = {1.0 + task.index % 90, std::to_string(1 + task.index % 90)};
  }
  CHECK(grid_of(sweep, "contact.N", "contact.kappa").scattered);
}

TEST_CASE("a sample has no grid: its tasks stand in lines") {
  const SweptFolder folder;
  for (int i = 0; i < 30; ++i)
    folder.add({.index = i,
                .parameters = {{"contact.kappa", std::to_string(i * i + 1)},
                               {"contact.d_hat", std::to_string(0.01 * (i + 1))}},
                .metrics = {{"drift", "1"}}});
  const CollectedSweep sweep = collect_sweep(folder.path());
  const TaskGrid grid = grid_of(sweep);
  REQUIRE(grid.scattered);
  CHECK(grid.columns() == 6);
  CHECK(grid.rows() == 5);
  CHECK(*grid.slices[0].tasks[4 * 6] == 0);  // at the upper left
  CHECK(*grid.slices[0].tasks[5] == 29);     // at the lower right
  CHECK(criterion_picture(sweep, grid, criteria_of(sweep)[0]).picture);
}

TEST_CASE("the cells of a heat map have the colour of their value, and its axes the values") {
  const SweptFolder folder;
  fill(folder, 5, 3);
  const CollectedSweep sweep = collect_sweep(folder.path());
  const std::vector<Criterion> criteria = criteria_of(sweep);
  const HeatMap map = heat_map_of(sweep, grid_of(sweep), criterion(criteria, "penetration"));
  CHECK(map.log);
  CHECK(map.x_names == std::vector<std::string>{"1", "2", "3", "4", "5"});
  CHECK(map.y_names == std::vector<std::string>{"10", "20", "30"});
  CHECK(map.y_label == "stiffness κ [J]");
  CHECK(map.value_label == "penetration [m]");
  for (const PictureSize size : {default_size(map), PictureSize{500, 360}, PictureSize{1900, 1000}}) {
    CAPTURE(size.width);
    const Image image = picture_to_image(heat_map_picture(map), size.width, size.height);
    const HeatLayout layout = layout_heat_map(map, size.width, size.height, FontMetrics());
    CHECK(layout.scale.lo == Approx(1e-2));
    CHECK(layout.scale.hi == Approx(1e4));
    int good = 0;
    for (std::size_t i = 0; i < 15; ++i) {
      const Rect cell = cell_rect(map, layout, 0, i % 5, i / 5);
      const Color corner = pixel(image, cell.x + 2, cell.y + 2);
      // 10^(column − row) on a scale from 10⁻² to 10⁴; what diverged has no value.
      const double place = (static_cast<double>(i % 5) - static_cast<double>(i / 5) + 2) / 6;
      if (i == 1) {
        CHECK(difference(corner, sweep_color(place)) > 60);
      } else {
        good += difference(corner, sweep_color(place)) <= 3;
      }
      CHECK(cell.right() < layout.bar.x);
    }
    CHECK(good == 14);
    // The lowest row is the lowest value.
    CHECK(cell_rect(map, layout, 0, 0, 0).y > cell_rect(map, layout, 0, 0, 2).y);
    CHECK(layout.bar.right() < size.width);
    CHECK(difference(pixel(image, layout.bar.x + 3, layout.bar.bottom() - 2), sweep_color(0)) < 12);
    CHECK(difference(pixel(image, layout.bar.x + 3, layout.bar.y + 2), sweep_color(1)) < 12);
  }
  const std::string svg = picture_to_svg(heat_map_picture(map), 700, 400);
  for (const char* text : {">diverged<", ">penetration [m]<", ">30<", "stiffness κ [J]"})
    CHECK(svg.find(text) != std::string::npos);
}

TEST_CASE("the contact sheet shows every task's picture at its place, and marks what did not end well") {
  const SweptFolder folder;
  fill(folder, 4, 3);
  std::filesystem::remove(folder.task_folder(6) / "end.png");
  write_bytes(folder.task_folder(7) / "end.png", "no picture");
  const CollectedSweep sweep = collect_sweep(folder.path());
  const TaskGrid grid = grid_of(sweep);
  const Image sheet = contact_sheet(sweep, grid, 0);
  const SheetLayout layout = layout_sheet(grid, FontMetrics());
  CHECK(sheet.width == layout.width);
  CHECK(layout.picture_w == 320);
  for (int i = 0; i < 12; ++i) {
    CAPTURE(i);
    const Rect at = layout.picture(static_cast<std::size_t>(i % 4), static_cast<std::size_t>(i / 4), 3);
    const Color seen = pixel(sheet, at.x + 240, at.y + 60);
    const Image picture = fake_picture(i);
    const bool shown = difference(seen, pixel(picture, 240, 60)) <= 4;
    CHECK(shown == (i != 6 && i != 7));
    const Color rim = pixel(sheet, at.x + 1, at.y + 0.5 * at.h);
    CHECK((difference(rim, status_color(SweptStatus::diverged)) == 0) == (i == 1));
  }
  CHECK(caught([&] { read_end_picture(sweep.tasks[7]); }).says("is no PNG file"));
  write_png(folder.task_folder(7) / "end.png", fake_picture(0, 2100, 20));
  CHECK(caught([&] { read_end_picture(sweep.tasks[7]); }).says("at most 2048"));
}

TEST_CASE("what can be read on a colour is written on it") {
  CHECK(ink_on({255, 255, 255, 255}).r < 60);
  CHECK(ink_on({0, 0, 0, 255}).r == 255);
  CHECK(wants_log({1e-3, 1}));
  CHECK_FALSE(wants_log({1, 20}));
  CHECK_FALSE(wants_log({0, 1e3}));
  CHECK_FALSE(wants_log({}));
}

}  // namespace pabd::test_collect_pictures
