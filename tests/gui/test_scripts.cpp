// The whole window without a display: every script in scripts/ is carried out, what it expects of the state
// must hold, and the frames that it writes are compared with approved pictures (tests/golden/*/NAME.png).
#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "app/gui/script.h"
#include "app/workbench/command_json.h"
#include "render/output/png.h"
#include "sim/error.h"
#include "tests/output/golden.h"
#include "tests/output/temp_folder.h"

using namespace pabd;
namespace fs = std::filesystem;

namespace {

std::string shipped_scene(const std::string& name) {
  if (fs::exists(name)) return name;
  const fs::path path = fs::path(PABD_SCENES) / (name + ".json");
  if (!fs::exists(path)) throw Error(ExitCode::file, name + ": no such scene");
  return path.string();
}

// A tool of its own for every script.
void carry_out(const Script& script, const TempFolder& folder, std::string& renderer,
               std::string* copied = nullptr) {
  std::vector<ContextAttempt> attempts;
  const auto context = create_headless_context(Backend::automatic, attempts);
  WorkbenchOptions bench;
  bench.find_scene = shipped_scene;
  Runner runner(std::make_unique<Workbench>(bench, command::Load{"two_boxes", {}, false}));
  ViewerOptions options;
  options.steady = true;
  options.shipped_scenes = [] {
    std::vector<fs::path> out;
    for (const char* name : {"dominoes", "four_bar", "pile", "two_boxes"})
      out.emplace_back(shipped_scene(name));
    return out;
  };
  if (copied) options.set_clipboard = [copied](const std::string& text) { *copied = text; };
  Viewer viewer(*context, runner, options);
  renderer = viewer.renderer().gl_renderer();
  script.run(viewer, runner, {folder.path(), false, 1280, 720, {}, {}});
}

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
  for (const fs::path& path : sorted(PABD_GUI_SCRIPTS, ".json")) {
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
  CHECK_THAT(refusal(R"([{"do":"mouse"}])"), Catch::Contains("[x, y]"));
  CHECK_THAT(refusal(R"([{"do":"key","key":"ctrl+banana"}])"), Catch::Contains("banana"));
  CHECK_THAT(refusal(R"([{"do":"expect","at":"/a/stepp","is":1}])"), Catch::Contains("/a/stepp"));
  CHECK_THAT(refusal(R"([{"do":"step","steps":3},{"do":"expect","at":"/a/step","is":4}])"),
             Catch::Contains("/a/step is 3"));
  CHECK(refusal(R"([{"do":"step","steps":3},{"do":"expect","at":"/a/step","is":3}])").empty());
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

TEST_CASE("the copied command repeats what is seen") {
  std::string copied, renderer;
  const TempFolder folder;
  carry_out(
      Script(
          R"([{"do":"set","key":"contact.kappa","value":50},{"do":"look","eye":[1,2,3],"target":[0,0.5,0],"fov":40},{"do":"key","key":"ctrl+shift+c"}])",
          "s"),
      folder, renderer, &copied);
  CHECK_THAT(copied, Catch::StartsWith("pabd render ") && Catch::Contains("two_boxes.json -o ") &&
                         Catch::Contains("--set contact.kappa=50") &&
                         Catch::Contains("--camera eye=1,2,3,target=0,0.5,0,fov=40"));
}
