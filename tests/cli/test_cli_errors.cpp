// SPDX-License-Identifier: MIT
// What goes wrong outside: bad scenes, files, no GL, no encoder. The exit code tells which, one line tells
// where and what helps, and nothing that is not whole has a final name.
#include <catch2/catch.hpp>

#include "tests/cli/program.h"

namespace pabd::test_cli_errors {

using namespace test;

namespace {

struct BadScene {
  const char* what;
  std::string text;
  std::vector<std::string> words;  // in the message: where
};

std::vector<BadScene> bad_scenes() {
  const auto box = [](const std::string& rest) {
    return R"("shape": { "type": "box", "size": [1, 1, 1] }, )" + rest;
  };
  const auto shape = [](const std::string& text) { return R"("shape": { )" + text + " }"; };
  return {
      {"zero mass", small_scene(box(R"("mass": 0)")), {"/bodies/1/mass"}},
      {"negative mass", small_scene(box(R"("mass": -2)")), {"/bodies/1/mass"}},
      {"negative density", small_scene(box(R"("density": -1)")), {"/bodies/1/density"}},
      {"both", small_scene(box(R"("density": 1, "mass": 1)")), {"/bodies/1"}},
      {"zero size", small_scene(shape(R"("type": "box", "size": [1, 0, 1])")), {"/bodies/1/shape/size"}},
      {"negative size", small_scene(shape(R"("type": "box", "size": [1, -1, 1])")), {"/bodies/1/shape/size"}},
      {"zero radius", small_scene(shape(R"("type": "sphere", "radius": 0)")), {"/bodies/1/shape/radius"}},
      {"zero d_hat", small_scene("", R"("d_hat": 0)"), {"/contact/d_hat"}},
      {"negative d_hat", small_scene("", R"("d_hat": -0.01)"), {"/contact/d_hat"}},
      {"N below 1", small_scene("", R"("N": 0)"), {"/contact/N"}},
      {"N too large", small_scene("", R"("N": 33)"), {"/contact/N"}},
      {"kappa", small_scene("", R"("kappa": 0)"), {"/contact/kappa"}},
      {"onset", small_scene("", R"("onset": 1)"), {"/contact/onset"}},
      {"zero step", small_scene("", "", R"("time_step": 0,)"), {"/time_step"}},
      {"negative step", small_scene("", "", R"("time_step": -0.1,)"), {"/time_step"}},
      {"huge number", small_scene("", "", R"("time_step": 1e999,)"), {"line"}},
      {"unknown key", small_scene("", R"("kapa": 5)"), {"kapa"}},
      {"duplicate key", small_scene("", R"("N": 3, "N": 4)"), {"/contact/N", "twice"}},
      {"newer version", R"({ "format": "pabd-scene", "version": 2, "bodies": [] })", {"/version"}},
      {"not a scene", "[1, 2]", {}},
      {"not JSON", "{ bodies }", {"line 1"}},
      {"empty", "", {}},
      {"deep", std::string(100000, '['), {}},
  };
}

// A setting in which no EGL driver can be found.
Setting without_egl() {
  Setting setting;
  setting.environment = {{"__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent"}};
  return setting;
}

}  // namespace

TEST_CASE("a bad scene is refused by name and place") {
  const CommandFolder folder;
  const std::string file = folder / "bad scene.json";
  for (const BadScene& scene : bad_scenes()) {
    CAPTURE(scene.what);
    write_text(file, scene.text);
    const Outcome outcome = run_pabd({"run", file, "--steps", "1"});
    CAPTURE(outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(is_error_line(outcome.err, {"bad scene.json"}));
    CHECK(is_error_line(outcome.err, scene.words));
  }
  write_text(file, small_scene());
  CHECK(run_pabd({"run", file, "--steps", "1", "--quiet"}).exit_code == 0);
}

TEST_CASE("a bad --set is refused") {
  for (const char* set :
       {"contact.d_hat=0", "contact.kapa=1", "contact.N=0", "time_step=-1", "nonsense", "=1"}) {
    CAPTURE(set);
    const Outcome outcome = run_pabd({"run", "two_boxes", "--steps", "1", "--set", set});
    CAPTURE(outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(is_error_line(outcome.err, {}));
  }
}

TEST_CASE("a file that cannot be read is exit code 3") {
  const CommandFolder folder;
  CHECK(run_pabd({"run", folder / "none.json"}).exit_code == 3);
  CHECK(run_pabd({"run", "no_such_scene"}).exit_code == 3);
  CHECK(is_error_line(run_pabd({"run", "no_such_scene"}).err, {"no_such_scene", "pabd scenes"}));
  CHECK(run_pabd({"run", "two_boxes", "--steps", "1", "--from", folder / "none.json"}).exit_code == 3);
  CHECK(run_pabd({"compare", folder / "a.png", folder / "b.png"}).exit_code == 3);
  CHECK(run_pabd({"run", folder.path().string()}).exit_code == 2);
}

TEST_CASE("an output that cannot be made is exit code 3, before any work") {
  const CommandFolder folder;
  write_text(folder / "file", "");
  const std::string below = (folder / "file") + "/out";
  const std::string deeper = (folder / "file") + "/none/out";
  for (const std::string& place : {below, deeper}) {
    const std::vector<std::vector<std::string>> commands = {
        {"run", "pile", "--time", "1000", "--trace", place + ".csv"},
        {"run", "pile", "--time", "1000", "--state", place + ".json"},
        {"render", "pile", "--time", "1000", "--size", "160x90", "-o", place + ".mp4"},
        {"render", "pile", "--time", "1000", "--size", "160x90", "-o", place + ".png"},
        {"render", "pile", "--time", "1000", "--size", "160x90", "-o", place + "{frame:04}.png"},
        {"plot", "barrier", "-o", place + ".svg"},
        {"plot", "barrier", "-o", place + ".png"},
    };
    for (const auto& command : commands) {
      CAPTURE(command);
      const Outcome outcome = run_pabd(command);
      CAPTURE(outcome.err);
      CHECK(outcome.exit_code == 3);
      CHECK(is_error_line(outcome.err, {"out"}));
    }
  }
  CHECK(folder.names() == std::vector<std::string>{"file"});
}

TEST_CASE("a full disk is exit code 3 and leaves nothing half-written") {
  const CommandFolder folder;
  Setting full;
  full.out_to = "/dev/full";
  for (const std::vector<std::string>& command : std::vector<std::vector<std::string>>{
           {"scenes"},
           {"doctor"},
           {"render", "--help"},
           {"plot", "barrier", "-o", "-"},
           {"run", "two_boxes", "--steps", "2", "--quiet", "--trace", "-"},
           {"render", "two_boxes", "--frames", "2", "--size", "160x90", "--quiet", "-o", "-"}}) {
    CAPTURE(command);
    const Outcome outcome = run_pabd(command, full);
    CAPTURE(outcome.err);
    CHECK(outcome.exit_code == 3);
    CHECK(is_error_line(outcome.err, {}));
  }
  CHECK(run_pabd({"plot", "barrier", "-o", "/dev/full", "--format", "csv"}).exit_code != 0);

  Setting small;  // no file may grow beyond 2000 bytes
  small.largest_file = 2000;
  for (const std::vector<std::string>& command : std::vector<std::vector<std::string>>{
           {"plot", "barrier", "-o", folder / "a.csv"},
           {"plot", "barrier", "-o", folder / "a.svg"},
           {"run", "stack", "--steps", "60", "--quiet", "--trace", folder / "a.csv"},
           {"render", "two_boxes", "--frames", "1", "--size", "160x90", "--quiet", "-o", folder / "a.png"},
           {"render", "two_boxes", "--frames", "2", "--size", "160x90", "--quiet", "-o",
            folder / "a{frame}.png"}}) {
    CAPTURE(command);
    const Outcome outcome = run_pabd(command, small);
    CAPTURE(outcome.err);
    CHECK(outcome.exit_code == 3);
    CHECK(is_error_line(outcome.err, {"a"}));
  }
  CHECK(folder.names().empty());
}

TEST_CASE("a video that does not fit on the disk is an error without a file") {
  const CommandFolder folder;
  Setting small;
  small.largest_file = 2000;
  const Outcome outcome = run_pabd(
      {"render", "two_boxes", "--frames", "30", "--size", "320x180", "--quiet", "-o", folder / "a.mp4"},
      small);
  CAPTURE(outcome.err);
  CHECK((outcome.exit_code == 6 || outcome.exit_code == 3));
  CHECK(is_error_line(outcome.err, {"a.mp4"}));
  CHECK(folder.names().empty());
}

TEST_CASE("what exists is kept unless --force is given") {
  const CommandFolder folder;
  for (const char* name : {"a.csv", "a.mp4", "a.png", "a.json", "a0000.png"})
    write_text(folder / name, "mine");
  const std::vector<std::vector<std::string>> commands = {
      {"run", "two_boxes", "--steps", "1", "--quiet", "--trace", folder / "a.csv"},
      {"run", "two_boxes", "--steps", "1", "--quiet", "--iterations", folder / "a.csv"},
      {"run", "two_boxes", "--steps", "1", "--quiet", "--state", folder / "a.json"},
      {"plot", "barrier", "-o", folder / "a.csv"},
      {"render", "two_boxes", "--frames", "1", "--size", "160x90", "--quiet", "-o", folder / "a.mp4"},
      {"render", "two_boxes", "--frames", "1", "--size", "160x90", "--quiet", "-o", folder / "a.png"},
      {"render", "two_boxes", "--frames", "1", "--size", "160x90", "--quiet", "-o",
       folder / "a{frame:04}.png"},
  };
  for (std::vector<std::string> command : commands) {
    CAPTURE(command);
    const Outcome refused = run_pabd(command);
    CHECK(refused.exit_code == 2);
    CHECK(is_error_line(refused.err, {"--force"}));
  }
  for (const std::string& name : folder.names()) CHECK(read_text(folder / name) == "mine");
  for (std::vector<std::string> command : commands) {
    CAPTURE(command);
    command.push_back("--force");
    CHECK(run_pabd(command).exit_code == 0);
  }
  for (const std::string& name : folder.names()) CHECK(read_text(folder / name) != "mine");
}

TEST_CASE("without OpenGL: exit code 4 with what was tried; what needs none still works") {
  const CommandFolder folder;
  const Outcome render = run_pabd(
      {"render", "two_boxes", "--frames", "1", "-o", folder / "a.png", "--backend", "egl"}, without_egl());
  CAPTURE(render.err);
  CHECK(render.exit_code == 4);
  CHECK(is_error_line(render.err, {"EGL"}));
  CHECK(folder.names().empty());
  CHECK(run_pabd({"run", "two_boxes", "--steps", "1", "--quiet"}, without_egl()).exit_code == 0);
  for (const char* name : {"a.svg", "a.png", "a.pdf"})
    CHECK(run_pabd({"plot", "barrier", "-o", folder / name}, without_egl()).exit_code == 0);
}

TEST_CASE(
    "a simulation that leaves the numbers is exit code 5 and says where; the trace up to there is kept") {
  const CommandFolder folder;
  // The log barrier has no force for boxes that start inside each other.
  const Outcome outcome =
      run_pabd({"run", "two_boxes", "--set", "contact.barrier=log", "--quiet", "--trace", folder / "t.csv"});
  CAPTURE(outcome.err);
  CHECK(outcome.exit_code == 5);
  CHECK(is_error_line(outcome.err, {"step 1", "diverged"}));
  const auto rows = lines_of(read_text(folder / "t.csv"));
  REQUIRE(rows.size() == 2);
  // Where it failed is known, and nothing of where it ended: not that it was perfect.
  CHECK(rows[1].find(",non_finite,0,nan,nan,nan,nan,nan,nan,nan,nan,") != std::string::npos);

  const Outcome render = run_pabd({"render", "two_boxes", "--set", "contact.barrier=log", "--quiet", "--size",
                                   "160x90", "--frames", "5", "-o", folder / "f{frame}.png"});
  CHECK(render.exit_code == 5);
  CHECK(folder.names() == std::vector<std::string>{"f0.png", "t.csv"});
}

TEST_CASE("without ffmpeg: exit code 6 for videos, and PNG frames still work") {
  const CommandFolder folder, empty;
  Setting setting;
  setting.environment = {{"PATH", empty.path().string()}};
  const Outcome video =
      run_pabd({"render", "two_boxes", "--frames", "2", "--size", "160x90", "-o", folder / "a.mp4"}, setting);
  CAPTURE(video.err);
  CHECK(video.exit_code == 6);
  CHECK(is_error_line(video.err, {"ffmpeg"}));
  CHECK(folder.names().empty());
  CHECK(run_pabd(
            {"render", "two_boxes", "--frames", "2", "--size", "160x90", "--quiet", "-o", folder / "a.png"},
            setting)
            .exit_code == 0);
}

}  // namespace pabd::test_cli_errors
