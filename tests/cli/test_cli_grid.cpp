// SPDX-License-Identifier: MIT
// pabd render --grid: a picture of many parameter sets.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "render/output/png.h"
#include "tests/cli/program.h"
#include "tests/support/places.h"

namespace pabd::test_cli_grid {

using namespace test;
using pabd::Image;
using pabd::read_png;
using pabd::read_png_text;

namespace {

constexpr int kCellWidth = 160, kCellHeight = 100, kSeam = 2;
constexpr const char* kFromHere = "eye=3,2,4,target=0,0.5,0";

Outcome render(const std::string& out, const std::string& size, const std::vector<std::string>& more) {
  std::vector<std::string> command = {"render", "two_boxes", "--size", size,       "--force", "--time",
                                      "0.3",    "-o",        out,      "--camera", kFromHere};
  command.insert(command.end(), more.begin(), more.end());
  return run_pabd(command);
}

// The lower two thirds: below the caption.
std::vector<std::uint8_t> below_caption(const Image& image, int left, int top) {
  std::vector<std::uint8_t> out;
  for (int y = top + kCellHeight / 3; y < top + kCellHeight; ++y) {
    const auto at = image.rgb.begin() + 3 * (y * image.width + left);
    out.insert(out.end(), at, at + 3 * kCellWidth);
  }
  return out;
}

}  // namespace

TEST_CASE("a cell of a grid is the picture of the run with its settings") {
  const CommandFolder folder;
  // One of them belongs to the scene, which is read for each.
  const std::vector<std::string> axes = {"--grid", "contact.N=1,6,3", "bodies.1.density=500,4000"};
  REQUIRE(render(folder / "grid.png", "484x202", axes).exit_code == 0);
  const Image grid = read_png(folder / "grid.png");
  REQUIRE(grid.width == 3 * kCellWidth + 2 * kSeam);
  REQUIRE(grid.height == 2 * kCellHeight + kSeam);
  std::vector<std::vector<std::uint8_t>> cells;
  for (int row = 0; row < 2; ++row) {
    for (int column = 0; column < 3; ++column) {
      CAPTURE(row, column);
      const std::string N = std::vector{"1", "6", "3"}[static_cast<std::size_t>(column)];
      REQUIRE(render(folder / "one.png", "160x100",
                     {"--set", "contact.N=" + N, "--set",
                      std::string("bodies.1.density=") + (row == 0 ? "500" : "4000")})
                  .exit_code == 0);
      cells.push_back(below_caption(grid, column * (kCellWidth + kSeam), row * (kCellHeight + kSeam)));
      CHECK(cells.back() == below_caption(read_png(folder / "one.png"), 0, 0));
      for (std::size_t k = 0; k + 1 < cells.size(); ++k) CHECK(cells[k] != cells.back());
    }
  }
  const auto text = read_png_text(folder / "grid.png");
  CHECK(nlohmann::json::parse(text.at("View"))["grid"] == "contact.N=1,6,3 bodies.1.density=500,4000");
  CHECK(nlohmann::json::parse(text.at("Parameters"))["contact"]["N"] == 1);
}

TEST_CASE(
    "all cells are seen from one place, from where bodies are seen that go farther than in the scene as it "
    "is") {
  const CommandFolder folder;
  // With a sixth of the weight the upper box bounces out of what the others need.
  REQUIRE(run_pabd({"render", "two_boxes", "--size", "322x182", "--time", "2", "--grid",
                    "gravity=[0,-9.81,0],[0,-1.62,0]", "contact.d_hat=1cm,5cm", "-o", folder / "grid.png"})
              .exit_code == 0);
  const Image grid = read_png(folder / "grid.png");
  std::vector<int> blue(4);  // pixels of that box
  for (int y = 0; y < grid.height; ++y) {
    for (int x = 0; x < grid.width; ++x) {
      const std::uint8_t* pixel = &grid.rgb[static_cast<std::size_t>(3 * (y * grid.width + x))];
      if (pixel[2] > pixel[0] + 35) ++blue[static_cast<std::size_t>(2 * (y / 91) + x / 161)];
    }
  }
  for (const int pixels : blue) {
    CHECK(pixels > 100);
    CHECK(pixels > 0.75 * blue[0]);
  }
}

TEST_CASE("colours have one range over a grid, and a sequence goes on byte for byte") {
  const CommandFolder folder;
  const std::vector<std::string> options = {
      "--grid", "bodies.1.velocity=[0,0,0],[0,-9,0]", "--color-by", "speed", "--fps", "20"};
  REQUIRE(render(folder / "f{frame}.png", "322x100", options).exit_code == 0);
  const std::string last = read_text(folder / "f5.png");
  std::filesystem::remove(folder / "f5.png");
  std::vector<std::string> again = options;
  again.emplace_back("--resume");
  REQUIRE(render(folder / "f{frame}.png", "322x100", again).exit_code == 0);
  CHECK(read_text(folder / "f5.png") == last);
  // Alone the slow run has colours of its own; beside the fast one the same speed is nearer to 0.
  REQUIRE(render(folder / "alone{frame}.png", "160x100",
                 {"--color-by", "speed", "--fps", "20", "--set", "bodies.1.velocity=[0,0,0]"})
              .exit_code == 0);
  CHECK(below_caption(read_png(folder / "alone5.png"), 0, 0) !=
        below_caption(read_png(folder / "f5.png"), 0, 0));
}

TEST_CASE("a run of a grid that diverges is a result that is told; all of them are an error") {
  const CommandFolder folder;
  // The log barrier has no force for boxes that start inside each other.
  const Outcome one = render(folder / "one.png", "322x100", {"--grid", "contact.barrier=log,polynomial"});
  CHECK(one.exit_code == 0);
  CHECK(one.err.find("two_boxes with contact.barrier=log") != std::string::npos);
  CHECK(std::filesystem::exists(folder / "one.png"));
  const Outcome all =
      render(folder / "all.png", "322x100", {"--grid", "contact.N=3,8", "--set", "contact.barrier=log"});
  CHECK(all.exit_code == 5);
}

TEST_CASE("a grid that cannot be is refused in one line") {
  const CommandFolder folder;
  const auto refused = [&](const std::vector<std::string>& options, const std::vector<std::string>& words) {
    const Outcome outcome = render(folder / "x.png", "320x180", options);
    CHECK(outcome.exit_code == 2);
    CHECK(is_error_line(outcome.err, words));
    CHECK_FALSE(std::filesystem::exists(folder / "x.png"));
  };
  refused({"--grid", "contact.N"}, {"--grid contact.N", "KEY=V1,V2"});
  refused({"--grid", "contact.M=1,2"}, {"contact.M"});
  refused({"--grid", "contact.N=1,2.5"}, {"contact.N", "2.5"});
  refused({"--grid", "contact.kappa=1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20", "contact.N=1,2,3,4"},
          {"80 runs"});
  refused({"--grid", "contact.kappa=1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20", "contact.N=1,2"},
          {"pixels"});
  refused({"--grid", "contact.N=1,2", "--overlay", "difference"}, {"difference"});
  write_text(folder / "patch.json", "{}");
  CHECK(render(folder / "x.png", "320x180", {"--grid", "contact.N=1,2", "--ab", folder / "patch.json"})
            .exit_code == 2);
}

}  // namespace pabd::test_cli_grid
