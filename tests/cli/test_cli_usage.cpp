// SPDX-License-Identifier: MIT
// How the program is asked: help, version, wrong command lines.
#include <sched.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/cli/program.h"
#include "tests/support/places.h"

namespace pabd::test_cli_usage {

using namespace test;

namespace {

const std::vector<std::vector<std::string>> kCommands = {{"run"},
                                                         {"render"},
                                                         {"export"},
                                                         {"plot"},
                                                         {"plot", "barrier"},
                                                         {"plot", "convergence"},
                                                         {"figure"},
                                                         {"compare"},
                                                         {"scenes"},
                                                         {"doctor"},
                                                         {"view"},
                                                         {"bench"}};

}  // namespace

TEST_CASE("every command has help with an example") {
  for (std::vector<std::string> command : kCommands) {
    std::string name = "pabd";
    for (const std::string& word : command) name += " " + word;
    CAPTURE(name);
    command.push_back("--help");
    const Outcome help = run_pabd(command);
    CHECK(help.exit_code == 0);
    CHECK(help.err.empty());
    const auto examples = help.out.find("Example");
    REQUIRE(examples != std::string::npos);
    CHECK(help.out.find("Usage: " + name + " [OPTIONS]") != std::string::npos);
    CHECK(help.out.find("  " + name, examples) != std::string::npos);
  }
}

TEST_CASE("the program's help lists its commands and exit codes") {
  const Outcome help = run_pabd({"--help"});
  CHECK(help.exit_code == 0);
  for (const auto& command : kCommands) CHECK(help.out.find("  " + command[0]) != std::string::npos);
  CHECK(help.out.find("129/130/143") != std::string::npos);
}

TEST_CASE("the version is one line, everywhere") {
  const Outcome version = run_pabd({"--version"});
  CHECK(version.exit_code == 0);
  CHECK(version.out.starts_with("pabd 0."));
  CHECK(line_count(version.out) == 1);
  CHECK(run_pabd({"render", "--version"}).out == version.out);
  CHECK(run_pabd({"plot", "barrier", "--version"}).out == version.out);
}

TEST_CASE("a wrong command line is refused in one line with a remedy") {
  const std::vector<std::vector<std::string>> wrong = {
      {},
      {"dance"},
      {"run"},
      {"run", "pyramid", "--sideways"},
      {"run", "pyramid", "--time"},
      {"run", "pyramid", "--time", "soon"},
      {"run", "pyramid", "--time", "1", "--steps", "2"},
      {"run", "pyramid", "--threads", "0"},
      {"render", "pyramid"},
      {"render", "pyramid", "-o", "a.mp4", "--backend", "magic"},
      {"plot"},
      {"plot", "barrier"},
      {"plot", "barrier", "-o", "a.csv", "--N", "1,two"},
      {"figure", "-o", "a.png"},
      {"compare", "a.png"},
      {"render", "pyramid", "-o", "a.mp4", "--quality", "superb"},
      {"render", "pyramid", "-o", "a.mp4", "--encoder", "quick"},
      {"run", "pyramid", "--json", "--profile"},
      {"scenes", "--json", "pyramid"},
  };
  for (const auto& command : wrong) {
    CAPTURE(command);
    const Outcome outcome = run_pabd(command);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.out.empty());
    CAPTURE(outcome.err);
    CHECK(is_error_line(outcome.err, {"--help"}));
  }
}

TEST_CASE("values out of range are refused, naming the option") {
  for (const std::vector<std::string>& command :
       std::vector<std::vector<std::string>>{{"view", "--headless"},
                                             {"view", "--headless", "--script", "a.json", "--scale", "9"},
                                             {"view", "--memory", "0"}}) {
    CAPTURE(command);
    const Outcome outcome = run_pabd(command);
    CHECK(outcome.exit_code == 2);
    CHECK(is_error_line(outcome.err,
                        {command.back() == "--headless" ? "--script" : command[command.size() - 2]}));
  }
  const CommandFolder folder;
  const std::string out = folder / "a.png";
  const std::vector<std::pair<std::string, std::vector<std::string>>> wrong = {
      {"--time", {"run", "stack", "--time", "-1"}},
      {"--time", {"run", "stack", "--time", "nan"}},
      {"--steps", {"run", "stack", "--steps", "-1"}},
      {"--fps", {"render", "stack", "-o", out, "--fps", "0"}},
      {"--fps", {"render", "stack", "-o", out, "--fps", "inf"}},
      {"--frames", {"render", "stack", "-o", out, "--frames", "0"}},
      {"--time", {"render", "stack", "-o", folder / "a.mp4", "--time", "0"}},
      {"--size", {"render", "stack", "-o", out, "--size", "0x100"}},
      {"--size", {"render", "stack", "-o", out, "--size", "100000x100"}},
      {"--size", {"render", "stack", "-o", out, "--size", "640"}},
      {"--size", {"render", "stack", "-o", out, "--size", "640x480x3"}},
      {"--camera", {"render", "stack", "-o", out, "--camera", "behind"}},
      {"--camera", {"render", "stack", "-o", out, "--camera", "eye=1,2"}},
      {"--camera", {"render", "stack", "-o", out, "--camera", "eye=1,2,3,target=1,2,3"}},
      {"--camera", {"render", "stack", "-o", out, "--camera", "fov=400"}},
      {"--overlay", {"render", "stack", "-o", out, "--overlay", "params,magic"}},
      {"--resume", {"render", "stack", "-o", folder / "a.mp4", "--resume"}},
      {"--crf", {"render", "stack", "-o", folder / "a.mp4", "--crf", "52"}},
      {"--crf", {"render", "stack", "-o", folder / "a.gif", "--crf", "20"}},
      {"--crf", {"render", "stack", "-o", out, "--crf", "20"}},
      {"--preset", {"render", "stack", "-o", folder / "a.webm", "--preset", "placebo"}},
      {"--loop", {"render", "stack", "-o", folder / "a.mp4", "--loop", "2"}},
      {"--loop", {"render", "stack", "-o", folder / "a.gif", "--loop", "-1"}},
      {"--encoder", {"render", "stack", "-o", folder / "a.webm", "--encoder", "nvenc"}},
      {"expected", {"render", "stack", "-o", folder / "a.xyz"}},
      {"--N", {"plot", "barrier", "-o", folder / "a.csv", "--N", "0"}},
      {"--N", {"plot", "barrier", "-o", folder / "a.csv", "--N", "33"}},
      {"--d-hat", {"plot", "barrier", "-o", folder / "a.csv", "--d-hat", "0"}},
      {"--kappa", {"plot", "barrier", "-o", folder / "a.csv", "--kappa", "-1"}},
      {"--onset", {"plot", "barrier", "-o", folder / "a.csv", "--onset", "1"}},
      {"--kind", {"plot", "barrier", "-o", folder / "a.csv", "--kind", "cubic"}},
      {"curves",
       {"plot", "barrier", "-o", folder / "a.csv", "--N", "1,2,3,4,5,6,7,8,9", "--d-hat",
        "0.1,0.2,0.3,0.4,0.5,0.6,0.7,0.8"}},
      {"--method", {"plot", "convergence", "two_boxes", "-o", folder / "a.csv", "--method", "magic"}},
      {"--at-step", {"plot", "convergence", "two_boxes", "-o", folder / "a.csv", "--at-step", "0"}},
      {"figure 2", {"figure", "2", "-o", folder / "a.svg"}},
      {"figure 8", {"figure", "8", "-o", folder / "a.png"}},
      {"figure 6", {"figure", "6", "-o", folder / "a.svg"}},
  };
  for (const auto& [word, command] : wrong) {
    CAPTURE(command);
    const Outcome outcome = run_pabd(command);
    CAPTURE(outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK((is_error_line(outcome.err, {word, "expected"}) || is_error_line(outcome.err, {word, ";"})));
  }
  CHECK(folder.names().empty());
}

TEST_CASE("a number with another unit, or of the wrong kind, is refused") {
  const std::vector<std::pair<std::vector<std::string>, std::string>> wrong = {
      {{"run", "stack", "--time", "5 m"}, "--time: expected a number (s), got \"5 m\"; 'pabd run"},
      {{"run", "stack", "--set", "time_step=5 m"}, "expected a number (s), got one in m"},
      {{"run", "stack", "--steps", "2.5"}, "--steps: expected a whole number, got \"2.5\"; 'pabd run"},
      {{"run", "stack", "--steps", "2 s"}, "--steps: expected a whole number, got \"2 s\"; 'pabd run"},
      {{"run", "stack", "--steps", "99999999999999999999"}, "--steps: expected a whole number, got"},
      {{"plot", "barrier", "-o", "a.csv", "--d-hat", "0.01,5s"},
       "--d-hat: expected a number (m), got \"5s\"; "},
      {{"render", "stack", "-o", "a.mp4", "--fps", "x"}, "--fps: expected a number, got \"x\"; "}};
  for (const auto& [command, words] : wrong) {
    CAPTURE(command);
    const Outcome outcome = run_pabd(command);
    CHECK(outcome.exit_code == 2);
    CHECK(is_error_line(outcome.err, {words}));
  }
}

TEST_CASE("a number is read with a unit that fits, as an option and with --set") {
  const auto hash = [](const std::string& time, const std::string& step) {
    const Outcome outcome = run_pabd({"run", "two_boxes", "--time", time, "--set", "time_step=" + step});
    CHECK(outcome.exit_code == 0);
    return outcome.err.substr(outcome.err.find("state "), 22);
  };
  CHECK(hash("50ms", "5 ms") == hash("0.05", "0.005"));
  CHECK(hash("50ms", "5 ms") != hash("0.05", "0.01"));
}

TEST_CASE("shipped scenes are listed and are found by name") {
  const Outcome list = run_pabd({"scenes"});
  CHECK(list.exit_code == 0);
  for (const char* name : {"two_boxes", "pyramid", "stack", "pile"})
    CHECK(list.out.find(name) != std::string::npos);
  const auto json = nlohmann::json::parse(run_pabd({"scenes", "--json"}).out);
  CHECK(json.size() + 1 == line_count(list.out));
  for (const auto& scene : json) {
    CAPTURE(scene.dump());
    CHECK(scene["bodies"].get<int>() > 0);
    CHECK_FALSE(scene["description"].get<std::string>().empty());
    if (scene["name"] == "pyramid") CHECK(scene["joints"] == 0);
    if (scene["name"] == "slider_crank") CHECK(scene["joints"] == 4);
  }
  const CommandFolder elsewhere;
  Setting setting;
  setting.folder = elsewhere.path();
  CHECK(run_pabd({"run", "two_boxes", "--steps", "1", "--quiet"}, setting).exit_code == 0);
  CHECK(run_pabd({"run", "two_boxes.json", "--steps", "1", "--quiet"}, setting).exit_code == 0);
  CHECK(
      run_pabd({"run", places::scenes() + "/two_boxes.json", "--steps", "1", "--quiet"}, setting).exit_code ==
      0);
}

TEST_CASE("a shipped scene is printed as it is, to begin another one with") {
  CHECK(run_pabd({"scenes", "pyramid"}).out == read_text(places::scenes() + "/pyramid.json"));
  CHECK(run_pabd({"scenes", "pyramids"}).exit_code == 3);
  CHECK(run_pabd({"scenes", "pyramid", "--json"}).exit_code == 2);
}

TEST_CASE("a name that is nearly right gets a suggestion, a missing command the choices") {
  const Outcome scene = run_pabd({"run", "pendulm"});
  CHECK(scene.exit_code == 3);
  CHECK(is_error_line(scene.err, {"pendulm", "did you mean \"pendulum\"?", "pabd scenes"}));
  const Outcome far = run_pabd({"run", "submarine"});
  CHECK(is_error_line(far.err, {"submarine", "pabd scenes"}));
  CHECK(far.err.find("did you mean") == std::string::npos);
  const std::vector<std::pair<std::vector<std::string>, std::string>> misspelt = {
      {{"rendr", "pyramid", "-o", "a.png"},
       "rendr: no such command; did you mean \"render\"?; 'pabd --help'"},
      {{"scene"}, "scene: no such command; did you mean \"scenes\"?"},
      {{"plot", "convergance", "stack"}, "did you mean \"convergence\"?; 'pabd plot --help'"},
      {{"render", "stack", "--overly=plots"}, "--overly=plots: no such option; did you mean \"--overlay\"?"},
      {{"plot", "barrier", "--dhat", "0.1"}, "did you mean \"--d-hat\"?; 'pabd plot barrier --help'"}};
  for (const auto& [command, words] : misspelt) {
    CAPTURE(command);
    const Outcome outcome = run_pabd(command);
    CAPTURE(outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(is_error_line(outcome.err, {words}));
  }
  const Outcome strange = run_pabd({"dance"});
  CHECK(is_error_line(strange.err, {"dance: no such command; 'pabd --help'"}));
  CHECK(is_error_line(run_pabd({}).err, {"render, export, run, plot,", " or serve", "pabd --help"}));
  CHECK(is_error_line(run_pabd({"plot"}).err,
                      {"barrier, convergence, reactions or series", "pabd plot --help"}));
}

TEST_CASE("the doctor says yes to no encoder that is only in a list") {
  // An ffmpeg that lists all encoders, and has none.
  const CommandFolder folder;
  write_text(folder / "ffmpeg",
             "#!/bin/sh\ncase \"$*\" in *-version*) echo ffmpeg version 9.9 ;; *-encoders*)"
             " echo ' V libx264 x'; echo ' V libvpx-vp9 x'; echo ' V h264_nvenc x' ;;"
             " *) echo '[vost#0:0 @ 0x55ee] Part [x264 @ 0x7f00ab] is missing.' >&2; exit 1 ;; esac\n");
  std::filesystem::permissions(folder / "ffmpeg", std::filesystem::perms::owner_all);
  Setting only;
  only.environment = {{"PATH", folder.path().string() + ":/usr/bin:/bin"}};
  const Outcome text = run_pabd({"doctor"}, only);
  const std::string no = "no (Part [x264] is missing)";
  CHECK(text.out.find("ffmpeg      9.9 · libx264 (.mp4) " + no + " · libvpx-vp9 (.webm) " + no +
                      " · h264_nvenc " + no + "\n") != std::string::npos);
  const auto json = nlohmann::json::parse(run_pabd({"doctor", "--json"}, only).out)["ffmpeg"];
  for (const char* encoder : {"libx264", "libvpx-vp9", "h264_nvenc"}) CHECK(json[encoder] == false);
}

TEST_CASE("the doctor reports, whatever is missing") {
  const CommandFolder empty;
  Setting bare;
  bare.environment = {{"PATH", empty.path().string()}, {"__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent"}};
  const Outcome text = run_pabd({"doctor"}, bare);
  CHECK(text.exit_code == 0);
  CHECK(text.out.find("apt-get install ffmpeg") != std::string::npos);
  CHECK(text.out.find("EGL") != std::string::npos);
  const auto missing = nlohmann::json::parse(run_pabd({"doctor", "--json"}, bare).out);
  CHECK_FALSE(missing["ffmpeg"]["available"].get<bool>());
  CHECK(missing["gl"]["attempts"].size() >= 2);

  const auto here = nlohmann::json::parse(run_pabd({"doctor", "--json"}).out);
  CHECK(here["gl"]["available"].get<bool>());
  CHECK_FALSE(here["gl"]["renderer"].get<std::string>().empty());
  CHECK(here["ffmpeg"]["libx264"].get<bool>());
  const CommandFolder videos;
  const Outcome video =
      run_pabd({"render", "stack", "-o", videos.path() / "nvenc.mp4", "--frames", "1", "--encoder", "nvenc"});
  CHECK(here["ffmpeg"]["h264_nvenc"].get<bool>() == (video.exit_code == 0));
  CHECK(video.err.find("0x") == std::string::npos);
  CHECK(here["cpu"]["cores"].get<int>() >= 1);
  CHECK_FALSE(here["build"].get<std::string>().empty());
  CHECK(here["font_bytes"].get<int>() > 100000);
}

TEST_CASE("the doctor tells how many threads a command takes, and the help where the number comes from") {
  const auto free = nlohmann::json::parse(run_pabd({"doctor", "--json"}).out)["cpu"];
  CHECK(free["threads"].get<int>() >= 1);
  CHECK(free["threads"].get<int>() <= free["allowed"].get<int>());
  CHECK(free["allowed"].get<int>() <= free["cores"].get<int>());
  CHECK((free["quota"].is_null() || free["quota"].get<double>() > 0));
  cpu_set_t all;
  REQUIRE(sched_getaffinity(0, sizeof all, &all) == 0);
  int first = 0;
  while (!CPU_ISSET(first, &all)) ++first;
  const std::vector<std::string> kept = {"taskset", "-c", std::to_string(first), places::program(), "doctor"};
  const Outcome text = run_command(kept);
  CAPTURE(text.err);
  CHECK(text.out.find("\nthreads     1 by default: ") != std::string::npos);
  if (free["cores"] > 1) CHECK(text.out.find("may run on 1 of ") != std::string::npos);
  Setting wide;
  wide.environment = {{"COLUMNS", "120"}};
  CHECK(run_pabd({"run", "--help"}, wide).out.find("at most 64; 'pabd doctor' tells") != std::string::npos);
}

TEST_CASE("the scene in the reference runs") {
  const std::string readme = read_text(places::project() + "/app/cli/README.md");
  const std::string fence = "```json\n";
  const auto begin = readme.find(fence) + fence.size();
  const std::string scene = readme.substr(begin, readme.find("```", begin) - begin);
  const CommandFolder folder;
  write_text(folder / "readme.json", scene);
  const Outcome outcome = run_pabd({"run", folder / "readme.json", "--steps", "3", "--quiet"});
  CAPTURE(outcome.err);
  CHECK(outcome.exit_code == 0);
}

}  // namespace pabd::test_cli_usage
