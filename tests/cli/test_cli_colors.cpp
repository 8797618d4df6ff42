// SPDX-License-Identifier: MIT
// pabd render: what colours of bodies and contacts say.
#include <catch2/catch.hpp>

#include "render/output/png.h"
#include "tests/cli/program.h"

namespace pabd::test_cli_colors {

using namespace test;
using pabd::read_png;
using pabd::read_png_text;

namespace {

std::vector<std::string> render(const std::string& out, const std::vector<std::string>& more) {
  std::vector<std::string> command = {"render", "two_boxes", "--size", "160x90", "--quiet", "-o", out};
  command.insert(command.end(), more.begin(), more.end());
  return command;
}

}  // namespace

TEST_CASE("a continued sequence has the ranges of colours that the frames before had") {
  const CommandFolder whole, cut;
  // The range of speeds grows until a box lands, and rests when all come to rest.
  std::vector<std::string> options = {"--frames", "12", "--fps", "5", "--color-by", "speed"};
  REQUIRE(run_pabd(render(whole / "{frame:02}.png", options)).exit_code == 0);
  CHECK(read_png_text(whole / "11.png").at("View").find("\"color_by\":\"speed\"") != std::string::npos);
  for (const std::string& name : whole.names()) {
    if (name != "11.png") std::filesystem::copy(whole / name, cut / name);
  }
  options.push_back("--resume");
  REQUIRE(run_pabd(render(cut / "{frame:02}.png", options)).exit_code == 0);
  CHECK(read_text(cut / "11.png") == read_text(whole / "11.png"));
  // Alone, the last picture has the range of its own speeds.
  REQUIRE(run_pabd(render(cut / "still.png", {"--frames", "12", "--fps", "5", "--color-by", "speed"}))
              .exit_code == 0);
  CHECK(read_png(cut / "still.png").rgb != read_png(whole / "11.png").rgb);
}

TEST_CASE("--contacts-by shows contacts by another quantity, and its text says so") {
  const CommandFolder folder;
  const auto picture = [&](const std::string& name, const std::vector<std::string>& more) {
    std::vector<std::string> options = {"--time", "1.5"};
    options.insert(options.end(), more.begin(), more.end());
    REQUIRE(run_pabd(render(folder / name, options)).exit_code == 0);
    return read_png(folder / name).rgb;
  };
  const auto gap = picture("gap.png", {"--overlay", "contacts"});
  CHECK(picture("same.png", {"--overlay", "contacts", "--contacts-by", "gap"}) == gap);
  const auto force = picture("force.png", {"--contacts-by", "force"});
  CHECK(force != gap);
  CHECK(force != picture("plain.png", {}));
  CHECK(picture("friction.png", {"--contacts-by", "friction"}) != gap);
  CHECK(read_png_text(folder / "force.png").at("View").find("\"contacts_by\":\"force\"") !=
        std::string::npos);
  CHECK(read_png_text(folder / "same.png") == read_png_text(folder / "gap.png"));
  CHECK(run_pabd(render(folder / "x.png", {"--contacts-by", "heat"})).exit_code == 2);
}

}  // namespace pabd::test_cli_colors
