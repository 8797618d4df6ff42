// SPDX-License-Identifier: MIT
// pabd export as a user meets it: names, exit codes, what is left behind. Formats: tests/export.
#include <signal.h>

#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/cli/program.h"

namespace pabd::test_cli_export {

using namespace test;

namespace {

std::vector<std::string> command(const std::string& scene, const std::string& out,
                                 const std::vector<std::string>& more = {}) {
  std::vector<std::string> all{"export", scene, "-o", out};
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

}  // namespace

TEST_CASE("every format is written under its name, the same for each number of threads") {
  const CommandFolder folder;
  for (const char* name : {"a.glb", "a.usda", "a.npz"}) {
    CAPTURE(name);
    const Outcome outcome = run_pabd(command("pyramid", folder / name, {"--frames", "4", "--threads", "1"}));
    CAPTURE(outcome.err);
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.out.empty());
    CHECK(outcome.err.find("4 frames of ") != std::string::npos);
    const std::string again = folder / ("again_" + std::string(name));
    CHECK(run_pabd(command("pyramid", again, {"--frames", "4", "--threads", "3", "--quiet"})).err.empty());
    CHECK((read_text(folder / name) == read_text(again)));
  }
  CHECK(read_text(folder / "a.glb").starts_with("glTF"));
  CHECK(read_text(folder / "a.usda").starts_with("#usda 1.0"));
  CHECK(read_text(folder / "a.npz").starts_with("PK"));
}

TEST_CASE("what cannot be is refused in one line, before the first step") {
  const CommandFolder folder;
  write_text(folder / "scene.glb", small_scene());
  write_text(folder / "there.glb", "mine");
  const auto refused = [&](const std::vector<std::string>& arguments, int code,
                           const std::vector<std::string>& words) {
    const Outcome outcome = run_pabd(arguments);
    CAPTURE(outcome.err);
    CHECK(outcome.exit_code == code);
    CHECK(is_error_line(outcome.err, words));
  };
  refused(command("pyramid", folder / "a.fbx"), 2, {"a.fbx", ".glb", ".usda", ".npz"});
  refused(command("pyramid", folder / "there.glb"), 2, {"there.glb", "--force"});
  refused(command(folder / "scene.glb", folder / "scene.glb", {"--force"}), 2, {"scene.glb"});
  refused(command("pyramid", folder / "a.glb", {"--time", "1e5", "--fps", "1000"}), 2, {"--fps", "frames"});
  refused(command("pyramid", folder / "a.glb", {"--frames", "9999999"}), 2, {"a.glb", "poses"});
  refused(command("pyramid", folder / "a.npz", {"--frames", "60000"}), 2, {"a.npz", "GB of poses", "--fps"});
  refused(command("pyramid", folder / "a.glb", {"--fps", "0"}), 2, {"--fps"});
  refused(command("pyramid", folder / "a.glb", {"--trail", "nobody"}), 2, {"--trail", "nobody"});
  refused(command("pyramid", folder / "a.npz", {"--trails"}), 2, {"a.npz", "--trails"});
  refused(command("pyramid", folder / "there.glb/a.glb"), 3, {"there.glb"});
  refused(command("pyramid", folder / "a.glb", {"--recording", folder / "none.pabdrec"}), 3,
          {"none.pabdrec"});
  CHECK(read_text(folder / "there.glb") == "mine");
  CHECK(folder.names() == std::vector<std::string>{"scene.glb", "there.glb"});
}

TEST_CASE("a disk that is full leaves nothing and is exit code 3") {
  const CommandFolder folder;
  Setting setting;
  setting.largest_file = 20'000;
  for (const char* name : {"a.glb", "a.npz", "a.usda"}) {
    const Outcome outcome =
        run_pabd(command("pyramid", folder / name, {"--frames", "9", "--quiet"}), setting);
    CAPTURE(name, outcome.err);
    CHECK(outcome.exit_code == 3);
    CHECK(is_error_line(outcome.err, {name}));
  }
  CHECK(folder.names().empty());
}

TEST_CASE("an interrupted export is whole, as far as it came") {
  const CommandFolder folder;
  const Outcome outcome = run_pabd_interrupted(
      command("two_boxes", folder / "a.glb", {"--frames", "9999999", "--fps", "1000"}), SIGINT,
      [](const std::string& err) { return err.find("ETA") != std::string::npos; });
  CAPTURE(outcome.err);
  CHECK(outcome.exit_code == 130);
  CHECK(folder.names() == std::vector<std::string>{"a.glb"});
  const std::string bytes = read_text(folder / "a.glb");
  CHECK(bytes.starts_with("glTF"));
  std::uint32_t length = 0;
  std::copy_n(bytes.data() + 8, 4, reinterpret_cast<char*>(&length));
  CHECK(length == bytes.size());
}

TEST_CASE("a recording gives what its run gave") {
  const CommandFolder folder;
  write_text(folder / "play.json",
             R"([{"do": "step", "steps": 30}, {"do": "save_recording", "path": "run.pabdrec"}])");
  REQUIRE(run_pabd({"view", "two_boxes", "--headless", "--script", folder / "play.json", "-o", folder / ""})
              .exit_code == 0);
  const std::vector<std::string> recorded = {"--recording", folder / "run.pabdrec", "--fps", "60"};
  const Outcome past = run_pabd(command("two_boxes", folder / "past.glb", recorded));
  CAPTURE(past.err);
  REQUIRE(past.exit_code == 0);
  REQUIRE(run_pabd(command("two_boxes", folder / "live.glb", {"--frames", "30", "--fps", "60"})).exit_code ==
          0);
  CHECK((read_text(folder / "past.glb") == read_text(folder / "live.glb")));
}

TEST_CASE("a recording of a robot is exported with the robot's own file") {
  const CommandFolder folder;
  write_text(folder / "ball.xml",
             "<mujoco><worldbody><geom type=\"plane\"/><body pos=\"0 0 1\"><freejoint/>"
             "<geom size=\"0.1\"/></body></worldbody></mujoco>");
  write_text(folder / "play.json",
             R"([{"do": "step", "steps": 5}, {"do": "save_recording", "path": "run.pabdrec"}])");
  REQUIRE(run_pabd({"view", folder / "ball.xml", "--headless", "--script", folder / "play.json", "-o",
                    folder / ""})
              .exit_code == 0);
  const Outcome past =
      run_pabd(command(folder / "ball.xml", folder / "past.glb", {"--recording", folder / "run.pabdrec"}));
  CAPTURE(past.err);
  CHECK(past.exit_code == 0);
  CHECK(read_text(folder / "past.glb").starts_with("glTF"));
}

}  // namespace pabd::test_cli_export
