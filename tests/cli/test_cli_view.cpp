// SPDX-License-Identifier: MIT
// What pictures show, by the options of `pabd render`: cameras, themes, trails, marks.
#include <catch2/catch.hpp>

#include "render/output/png.h"
#include "tests/cli/program.h"

namespace pabd::test_cli_view {

using namespace test;

namespace {

Image picture(const CommandFolder& folder, const std::string& name, std::vector<std::string> arguments) {
  const std::string file = folder / (name + ".png");
  arguments.insert(arguments.begin(), "render");
  arguments.insert(arguments.end(), {"--size", "320x180", "--quiet", "--force", "-o", file});
  const Outcome outcome = run_pabd(arguments);
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  return read_png(file);
}

double share_that_differs(const Image& a, const Image& b) {
  REQUIRE(a.rgb.size() == b.rgb.size());
  double count = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) count += a.rgb[i] != b.rgb[i] ? 1 : 0;
  return count / static_cast<double>(a.rgb.size());
}

}  // namespace

TEST_CASE("trails of a still show the past; marks and themes show, and the picture says so") {
  const CommandFolder folder;
  const std::vector<std::string> plain{"four_bar", "--time", "1.5"};
  const auto with = [&](const std::string& name, std::vector<std::string> more) {
    more.insert(more.begin(), plain.begin(), plain.end());
    return picture(folder, name, more);
  };
  const Image base = with("plain", {});
  const double trail = share_that_differs(base, with("trail", {"--trail", "pen", "--trail", "com"}));
  CHECK(trail > 0.001);
  CHECK(trail < 0.1);
  for (const char* mark : {"axes", "scale", "velocities", "boxes"}) {
    CAPTURE(mark);
    const double differs = share_that_differs(base, with(mark, {"--overlay", mark}));
    CHECK(differs > 0.0005);
    CHECK(differs < 0.2);
  }
  CHECK(share_that_differs(base, with("dark", {"--theme", "dark"})) > 0.5);
  const std::string view = read_png_text(folder / "dark.png").at("View");
  CHECK(view.find("dark") != view.npos);
  CHECK(read_png_text(folder / "trail.png").at("View").find("com") != view.npos);
}

TEST_CASE("a transparent picture has no background, and is only for PNG files") {
  const CommandFolder folder;
  // Read as laid over black.
  const Image image = picture(folder, "through", {"spin", "--time", "0", "--theme", "transparent"});
  CHECK(image.rgb[0] == 0);
  const std::size_t middle = 3 * (90 * 320 + 160);
  CHECK(image.rgb[middle] > 30);
  const Outcome video = run_pabd({"render", "spin", "-o", folder / "x.mp4", "--theme", "transparent"});
  CHECK(video.exit_code == 2);
  CHECK(video.err.find(".png") != video.err.npos);
}

TEST_CASE("what is none is refused in one line that says what there is") {
  const CommandFolder folder;
  const struct {
    std::vector<std::string> arguments;
    const char* says;
  } kWrong[] = {{{"--theme", "pink"}, "paper"},
                {{"--trail", "nobody"}, "no body of that name"},
                {{"--trail", "pen@1,2"}, "three numbers"},
                {{"--trail-time", "0"}, "--trail-time"},
                {{"--camera", "follow:nobody"}, "no such body"},
                {{"--overlay", "axis"}, "axes"}};
  for (const auto& wrong : kWrong) {
    std::vector<std::string> arguments{"render", "four_bar", "-o", folder / "x.png"};
    arguments.insert(arguments.end(), wrong.arguments.begin(), wrong.arguments.end());
    CAPTURE(wrong.says);
    const Outcome outcome = run_pabd(arguments);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.err.find(wrong.says) != outcome.err.npos);
  }
}

}  // namespace pabd::test_cli_view
