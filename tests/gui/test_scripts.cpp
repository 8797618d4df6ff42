// SPDX-License-Identifier: MIT
// The whole window without a display: every script in scripts/ is carried out, what it expects of the state
// must hold, and the frames that it writes are compared with approved pictures (tests/golden/*/NAME.png).
#include <catch2/catch.hpp>
#include <optional>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "app/gui/script.h"
#include "app/gui/script_actions.h"
#include "app/workbench/command_json.h"
#include "render/output/png.h"
#include "sim/base/error.h"
#include "tests/gui/script_runner.h"
#include "tests/support/golden.h"
#include "tests/support/places.h"
#include "tests/support/temp_folder.h"

namespace pabd::test_scripts {

namespace fs = std::filesystem;

namespace {

std::vector<fs::path> sorted(const fs::path& folder, const char* extension) {
  std::vector<fs::path> out;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == extension) out.push_back(entry.path());
  }
  std::sort(out.begin(), out.end());
  return out;
}

std::string refusal(const std::string& json) {
  try {
    const Script script(json, "s.json");
    const TempFolder folder;
    std::string renderer;
    carry_out(script, folder, renderer);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("every script finds what it expects, and its frames are the approved ones") {
  for (const fs::path& path : sorted(places::tests() + "/gui/scripts", ".json")) {
    DYNAMIC_SECTION(path.stem().string()) {
      const TempFolder folder;
      std::string renderer;
      const Script script(read_bytes(path), path.filename().string());
      REQUIRE(script.size() > 0);
      carry_out(script, folder, renderer);
      for (const fs::path& frame : sorted(folder.path(), ".png")) {
        if (frame.stem().string().starts_with("free_")) continue;  // not for comparing
        const CompareResult result = check_golden(read_png(frame), "gui_" + frame.stem().string(), renderer);
        INFO(result.reason);
        CHECK(result.equal);
      }
    }
  }
}

TEST_CASE("the same script gives the same bytes") {
  const Script script(
      R"([{"do":"step","steps":30},{"do":"set","key":"contact.N","value":6},{"do":"step","steps":5},{"do":"frame","path":"free_a.png"}])",
      "s");
  const TempFolder first, second;
  std::string renderer;
  carry_out(script, first, renderer);
  carry_out(script, second, renderer);
  CHECK(read_bytes(first.path() / "free_a.png") == read_bytes(second.path() / "free_a.png"));
}

TEST_CASE("a script that is wrong is refused with its place before anything is done") {
  CHECK_THAT(refusal("{"), Catch::Contains("s.json") && Catch::Contains("line 1"));
  CHECK_THAT(refusal("{}"), Catch::Contains("list of actions"));
  CHECK_THAT(refusal(R"([{"do":"stepp"}])"), Catch::Contains("action 0") && Catch::Contains("\"step\"?"));
  CHECK_THAT(refusal(R"([{"do":"step"},{"do":"seek"}])"),
             Catch::Contains("action 1") && Catch::Contains("time"));
  CHECK_THAT(refusal(R"([{"do":"mouse"}])"), Catch::Contains("\"at\"") && Catch::Contains("missing"));
  CHECK_THAT(refusal(R"([{"do":"mouse","at":[1]}])"), Catch::Contains("[x, y]"));
  CHECK_THAT(refusal(R"([{"do":"expect","at":"/a/step","abve":3}])"), Catch::Contains("\"above\"?"));
  CHECK_THAT(refusal(R"([{"do":"expect","at":"/a/step"}])"), Catch::Contains("is_not"));
  CHECK_THAT(refusal(R"([{"do":"frame","path":"a.png","of":"midle"}])"), Catch::Contains("\"midle\""));
  CHECK_THAT(refusal(R"([{"do":"step","may_fail":"yes"}])"), Catch::Contains("true or false"));
  CHECK_THAT(refusal(R"([{"do":"key","key":"ctrl+banana"}])"), Catch::Contains("banana"));
  CHECK_THAT(refusal(R"([{"do":"expect","at":"/a/stepp","is":1}])"), Catch::Contains("/a/stepp"));
  CHECK_THAT(refusal(R"([{"do":"step","steps":3},{"do":"expect","at":"/a/step","is":4}])"),
             Catch::Contains("/a/step is 3"));
  CHECK(refusal(R"([{"do":"step","steps":3},{"do":"expect","at":"/a/step","is":3}])").empty());
}

namespace {

struct Ending {
  std::optional<ErrorKind> kind;  // empty: it went well
  std::string text;
};

// With a scene in a folder of its own: how the script ends.
Ending ending(const std::string& json, const TempFolder& folder) {
  try {
    std::string renderer;
    carry_out(Script(json, "try.json"), folder, renderer);
  } catch (const Error& error) {
    return {error.kind(), error.what()};
  }
  return {};
}

}  // namespace

TEST_CASE("an action that is refused ends the script, with file, number and why") {
  const TempFolder folder;
  const std::pair<const char*, const char*> refused[] = {
      {R"({"do":"set","key":"contact.kapa","value":5})", "contact.kappa"},
      {R"({"do":"set","key":"contact.N","value":33})", "1 to 32"},
      {R"({"do":"set_all","values":["time_step=2"]})", "time_step"},
      {R"({"do":"reset_params","key":"solver.methd"})", "solver.method"},
      {R"({"do":"set","key":"contact.N","value":4,"side":"b"})", "no second simulation"},
      {R"({"do":"panel","panel":"serie"})", "\"series\""},
      {R"({"do":"series_view","quantity":"gaps"})", "\"gap\""},
      {R"({"do":"convergence_view","quantity":"energy gap"})", "\"energy_gap\""},
      {R"({"do":"color_by","quantity":"weight"})", "\"speed\""},
      {R"({"do":"contacts_by","quantity":"heat"})", "\"force\""},
      {R"({"do":"select","kind":"body","item":"nobody"})", "nobody"},
      {R"({"do":"seek","time":1e999})", ""},
      {R"({"do":"edit","edit":{"do":"remove_body","body":12}})", "12"},
      {R"({"do":"hold"})", "nothing to hold"},
      {R"({"do":"key","key":"h"})", "nothing to hold"},
      {R"({"do":"look_from","view":"below"})", "\"bottom\""}};
  for (const auto& [action, why] : refused) {
    INFO(action);
    const std::string before = R"([{"do":"wait"},)", after = R"(,{"do":"frame","path":"reached.png"}])";
    const Ending end = ending(before + action + after, folder);
    CHECK(end.kind == ErrorKind::bad_input);
    if (*why != 0) CHECK_THAT(end.text, Catch::StartsWith("try.json: action 1") && Catch::Contains(why));
    CHECK_FALSE(fs::exists(folder / "reached.png"));
  }
  CHECK(ending(R"([{"do":"load","scene":"no_such"}])", folder).kind == ErrorKind::file);
  CHECK(ending(R"([{"do":"save_patch","path":"/dev/null/x.json"}])", folder).kind == ErrorKind::file);
  CHECK(ending(R"([{"do":"expect","at":"/a/stp","is":1}])", folder).kind == ErrorKind::bad_input);
  CHECK(ending(R"([{"do":"expect","at":"/a/step","is":1}])", folder).kind == ErrorKind::images_differ);
  CHECK(ending(R"([{"do":"expect","at":"/a/step","is":1,"may_fail":true}])", folder).kind ==
        ErrorKind::images_differ);
  CHECK(ending(R"([{"do":"hold","may_fail":true},{"do":"step","steps":3},{"do":"hold"}])", folder).kind ==
        std::nullopt);
}

TEST_CASE("every name of a file is relative to the folder of the script") {
  const TempFolder folder;
  const fs::path here = fs::current_path();
  const Ending end = ending(R"([
    {"do":"set","key":"contact.N","value":5},{"do":"step","steps":3},
    {"do":"save_scene","path":"s.json"},{"do":"save_patch","path":"p.json"},
    {"do":"save_recording","path":"r.pabdrec"},{"do":"load_recording","path":"r.pabdrec"},
    {"do":"apply_patch","path":"p.json"},{"do":"add_camera_key"},{"do":"save_camera","path":"c.json"},
    {"do":"load_camera","path":"{out}/c.json"},{"do":"screenshot","path":"w.png"},
    {"do":"record","path":"v{frame:02}.png","width":64,"height":36,"to":0.02},
    {"do":"load","scene":"s.json"},{"do":"expect","at":"/a/params/contact/N","is":5}])",
                            folder);
  CHECK(end.text.empty());
  for (const char* name : {"s.json", "p.json", "r.pabdrec", "c.json", "w.png", "v00.png"}) {
    INFO(name);
    CHECK(fs::exists(folder / name));
    CHECK_FALSE(fs::exists(here / name));
  }
}

TEST_CASE("a script prints values of the state") {
  const TempFolder folder;
  std::string renderer, printed;
  carry_out(Script(R"([{"do":"step","steps":3},{"do":"print","at":"/a/step"},
                       {"do":"print","at":"/scene/name"},{"do":"print","at":"/a/changed"}])",
                   "s"),
            folder, renderer, nullptr, &printed);
  CHECK(printed == "/a/step 3\n/scene/name \"two boxes\"\n/a/changed {}\n");
}

TEST_CASE("the examples of the list of actions are actions") {
  const auto check = [](const std::vector<CommandJson>& examples) {
    for (const CommandJson& example : examples) {
      INFO(example.dump());
      CHECK_NOTHROW(parse_action(example, "x"));
    }
  };
  for (const bool all : {false, true}) {
    check(command_examples<Command>(all));
    check(command_examples<ViewCommand>(all));
  }
  check(command_examples<ScriptAction>(true));
  const std::string list = action_list();
  CHECK_THAT(list, Catch::Contains("      time          number           simulated time, s; e.g. 0.5\n"));
  CHECK_THAT(list, Catch::Contains("may_fail"));
}

TEST_CASE("the file of a scene that changes while the window is open is offered, and loaded with a click") {
  const TempFolder folder;
  const std::string path = (folder / "mine.json").string();
  const std::string text = read_bytes(shipped_scene("two_boxes"));
  write_bytes(path, text);
  std::vector<ContextAttempt> attempts;
  const auto context = create_headless_context(Backend::automatic, attempts);
  Runner runner(std::make_unique<Workbench>(WorkbenchOptions{}, command::Load{path, {}, false}));
  ViewerOptions options;
  options.steady = true;
  Viewer viewer(*context, runner, options);
  ScriptOptions script_options;
  script_options.folder = folder.path();
  script_options.after_frame = [&, changed = false]() mutable {
    if (changed || viewer.snapshot().a.state->step < 20) return;
    changed = true;
    std::string other = text;
    other.replace(other.find("two boxes"), 9, "new boxes");
    write_bytes(path, other);
  };
  const Script script(R"([{"do":"set","key":"contact.N","value":5},{"do":"step","steps":20},
    {"do":"until","at":"/file_changed","is":true,"seconds":300},
    {"do":"expect","at":"/a/step","is":20},{"do":"expect","at":"/scene/name","is":"two boxes"},
    {"do":"mouse","at":[700,714]},{"do":"frame","path":"file_offer.png","of":"picture"},
    {"do":"window","size":[640,400]},{"do":"frame","path":"small.png"},
    {"do":"window","size":[1280,720],"scale":2},{"do":"frame","path":"large.png"},
    {"do":"window","size":[1280,720],"scale":1},
    {"do":"mouse","at":[458,123],"how":"click"},
    {"do":"expect","at":"/scene/name","is":"new boxes"},{"do":"expect","at":"/a/params/contact/N","is":5},
    {"do":"expect","at":"/file_changed","is":false}])",
                      "s");
  script.run(viewer, runner, script_options);
  const CompareResult result =
      check_golden(read_png(folder / "file_offer.png"), "gui_file_offer", viewer.renderer().gl_renderer());
  INFO(result.reason);
  CHECK(result.equal);
}

TEST_CASE("the list of actions has every command once, with its fields") {
  const std::string list = action_list();
  for (const auto& names : {command_names<Command>(), command_names<ViewCommand>()}) {
    for (const std::string_view name : names) {
      INFO(name);
      const std::string line = "\n  " + std::string(name);
      CHECK((list.find(line + " ") != list.npos || list.find(line + "\n") != list.npos));
    }
  }
  CHECK_THAT(list, Catch::Contains("set               key, value [, side] [, more]\n"));
}

TEST_CASE("scripts.md shows only actions that there are, with their fields, and every dialog") {
  const std::string page = read_bytes(places::project() + "/app/gui/scripts.md");
  std::size_t shown = 0;
  for (std::size_t at = page.find("{\"do\":"); at != page.npos; at = page.find("{\"do\":", at + 1)) {
    std::size_t end = page.find('}', at);
    while (!CommandJson::accept(page.substr(at, end + 1 - at))) {
      end = page.find('}', end + 1);
      REQUIRE(end != page.npos);
    }
    const std::string text = page.substr(at, end + 1 - at);
    INFO(text);
    CHECK_NOTHROW(parse_action(CommandJson::parse(text), "x"));
    ++shown;
  }
  CHECK(shown > 15);
  for (const DialogKind& dialog : kDialogs) {
    INFO(dialog.name);
    CHECK(page.find('`' + std::string(dialog.name) + '`') != page.npos);
  }
}

TEST_CASE("the copied command repeats what is seen") {
  std::string copied, renderer;
  const TempFolder folder;
  carry_out(
      Script(
          R"([{"do":"set","key":"contact.kappa","value":50},{"do":"look","eye":[1,2,3],"target":[0,0.5,0],"fov":40},{"do":"key","key":"ctrl+shift+c"}])",
          "s"),
      folder, renderer, &copied);
  std::erase(copied, '\'');  // around a path with a blank
  CHECK_THAT(copied, Catch::StartsWith("pabd render ") && Catch::Contains("two_boxes.json -o ") &&
                         Catch::Contains("--set contact.kappa=50") &&
                         Catch::Contains("--camera eye=1,2,3,target=0,0.5,0,fov=40"));
  CHECK_THAT(copied,
             !Catch::Contains("--theme") && !Catch::Contains("--trail") && !Catch::Contains("follow"));
}

TEST_CASE("the copied command has theme, trails, and the body that the camera follows from the start on") {
  std::string copied, printed, renderer;
  const TempFolder folder;
  carry_out(Script(R"([{"do":"load","scene":"four_bar","force":true},{"do":"background","theme":"dark"},
                       {"do":"trail","of":"com"},{"do":"trail","of":"pen@0.1,0,0"},
                       {"do":"color_by","quantity":"speed"},{"do":"contacts_by","quantity":"friction"},
                       {"do":"look","eye":[1,2,6],"target":[1,1,0],"fov":40},
                       {"do":"print","at":"/ui/eye"},{"do":"follow","body":"pen"},{"do":"step","steps":90},
                       {"do":"expect","at":"/ui/eye","is_not":[1,2,6]},{"do":"copy_command"}])",
                   "s"),
            folder, renderer, &copied, &printed);
  std::erase(copied, '\'');
  CHECK_THAT(copied, Catch::Contains(" --color-by speed --contacts-by friction --theme dark ") &&
                         Catch::Contains(" --trail com --trail pen@0.1,0,0 ") &&
                         Catch::Contains(",follow:pen"));
  // Where the camera was when the body was where the run begins; it is rounded to floats on the way.
  const std::size_t eye = copied.find("eye=");
  REQUIRE(eye != std::string::npos);
  double x = 0, y = 0, z = 0;
  REQUIRE(std::sscanf(copied.c_str() + eye, "eye=%lf,%lf,%lf", &x, &y, &z) == 3);
  CHECK(x == Approx(1).margin(1e-5));
  CHECK(y == Approx(2).margin(1e-5));
  CHECK(z == Approx(6).margin(1e-5));
}

TEST_CASE("a recording takes what render takes for its video, and refuses what does not fit its kind") {
  CHECK_THAT(refusal(R"([{"do":"step"},{"do":"record","path":"{out}/a.mp4","crf":52}])"),
             Catch::Contains("record: crf 52") && Catch::Contains("51"));
  CHECK_THAT(refusal(R"([{"do":"step"},{"do":"record","path":"{out}/a.webm","preset":"quick"}])"),
             Catch::Contains("record: preset quick") && Catch::Contains("veryfast"));
  CHECK_THAT(refusal(R"([{"do":"step"},{"do":"record","path":"{out}/a.mp4","loop":2}])"),
             Catch::Contains("record: loop 2") && Catch::Contains(".gif"));
  CHECK_THAT(refusal(R"([{"do":"step"},{"do":"record","path":"{out}/a.webm","encoder":"nvenc"}])"),
             Catch::Contains("record: encoder nvenc"));
  CHECK_THAT(refusal(R"([{"do":"step"},{"do":"record","path":"{out}/a.mp4","encoder":"x265"}])"),
             Catch::Contains("record: encoder x265"));
  const TempFolder folder;
  std::string renderer;
  carry_out(Script(R"([{"do":"step","steps":20},
      {"do":"record","path":"{out}/fine.mp4","width":160,"height":90,"crf":4,"preset":"slow"},
      {"do":"record","path":"{out}/coarse.mp4","width":160,"height":90,"crf":45},
      {"do":"record","path":"{out}/once.gif","width":160,"height":90,"fps":20,"loop":1},
      {"do":"record","path":"{out}/ever.gif","width":160,"height":90,"fps":20},
      {"do":"expect","at":"/message","contains":"saved"}])",
                   "s"),
            folder, renderer);
  CHECK(fs::file_size(folder.path() / "fine.mp4") > 2 * fs::file_size(folder.path() / "coarse.mp4"));
  const auto repeats = [&](const char* name) {
    return read_bytes(folder.path() / name).find("NETSCAPE2.0") != std::string::npos;
  };
  CHECK(repeats("ever.gif"));
  CHECK_FALSE(repeats("once.gif"));
}

}  // namespace pabd::test_scripts
