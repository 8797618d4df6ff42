// SPDX-License-Identifier: MIT
// The layers of the project hold: who may include whom, how long a file may be, and that every test runs.
//
// Sources are read as text. A rule names a folder and what no include line in it may begin with.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "tests/structure/sources.h"
#include "tests/support/files.h"
#include "tests/support/places.h"

namespace pabd::test_structure {

namespace fs = std::filesystem;

using pabd::Source;
using pabd::sources;

namespace {

constexpr std::size_t kMaxLines = 400;

bool begins_with_any(const std::string& text, const std::vector<std::string>& starts) {
  return std::any_of(starts.begin(), starts.end(),
                     [&](const std::string& start) { return text.starts_with(start); });
}

const std::vector<std::string> kGl = {"GL/",  "GLES",   "EGL/",       "GLFW/",
                                      "KHR/", "epoxy/", "render/gl/", "render/context/"};
const std::vector<std::string> kImGui = {"imgui", "ImGui"};
const std::vector<std::string> kPrinting = {"iostream", "print", "fmt/color.h"};

// "path includes what" for every include in `folder` that begins with one of `forbidden`.
std::vector<std::string> violations(const std::string& folder, const std::vector<std::string>& forbidden) {
  std::vector<std::string> found;
  for (const Source& source : sources()) {
    if (!source.path.starts_with(folder)) continue;
    for (const std::string& include : source.includes) {
      if (begins_with_any(include, forbidden)) found.push_back(source.path + " includes " + include);
    }
  }
  return found;
}

// "path: word" for every word that stands in a source of `folder`.
std::vector<std::string> mentions(const std::string& folder, const std::vector<std::string>& words) {
  std::vector<std::string> found;
  for (const Source& source : sources()) {
    if (!source.path.starts_with(folder)) continue;
    for (const std::string& word : words) {
      if (source.text.find(word) != std::string::npos) found.push_back(source.path + ": " + word);
    }
  }
  return found;
}

}  // namespace

TEST_CASE("there is something to check") {
  for (const char* folder : {"sim/", "render/", "app/", "tests/"}) {
    CHECK(std::any_of(sources().begin(), sources().end(),
                      [&](const Source& s) { return s.path.starts_with(folder); }));
  }
  // The scanner sees an include: this very file has one.
  CHECK_FALSE(violations("tests/structure/", {"catch2/"}).empty());
}

TEST_CASE("sim knows nothing of drawing, printing or the program") {
  using List = std::vector<std::string>;
  CHECK(violations("sim/", kGl) == List{});
  CHECK(violations("sim/", kImGui) == List{});
  CHECK(violations("sim/", kPrinting) == List{});
  CHECK(mentions("sim/", {"printf(", "puts(", "std::cout", "std::cerr", "fmt::print"}) == List{});
  CHECK(violations("sim/", {"render/", "app/", "tests/", "stb", "CLI/"}) == List{});
  // Errors have kinds; numbers of the process are the command line's.
  for (const char* folder : {"sim/", "render/", "app/session/", "app/workbench/", "app/plots/",
                             "app/overlay/", "app/frames/", "app/gui/"})
    CHECK(mentions(folder, {"Exit"
                            "Code",
                            "exit_code("}) == List{});
  // What reads, writes and escapes is in sim/base, once.
  CHECK(mentions("app/", {"std::ifstream", "std::ofstream", "fopen("}) == List{});
  CHECK(mentions("sim/", {"std::ifstream", "std::ofstream", "fopen("}) ==
        List{"sim/body/hull_triangles.cpp: fopen("});
  CHECK(mentions("render/", {"std::ifstream", "std::ofstream", "fopen("}) == List{});
}

TEST_CASE("inside sim, data flows one way") {
  // Each may use those before it and itself.
  const std::vector<std::string> order = {"base",  "math",   "body",  "potential", "collision", "bond",
                                          "joint", "solver", "scene", "trace",     "import"};
  for (std::size_t i = 0; i < order.size(); ++i) {
    std::vector<std::string> later;
    for (std::size_t j = i + 1; j < order.size(); ++j) later.push_back("sim/" + order[j] + "/");
    // A scene and a report hold parameters and potentials, which know nothing of the rest.
    CHECK(violations("sim/" + order[i] + "/", later) == std::vector<std::string>{});
  }
}

TEST_CASE("render's parts keep apart") {
  using List = std::vector<std::string>;
  CHECK(violations("render/", {"app/", "tests/", "CLI/"}) == List{});
  CHECK(violations("render/visual/", kGl) == List{});
  CHECK(violations("render/visual/", kImGui) == List{});
  CHECK(violations("render/output/", kGl) == List{});
  CHECK(violations("render/output/", kImGui) == List{});
  CHECK(violations("render/output/",
                   {"render/visual/", "sim/math/", "sim/body/", "sim/solver/", "sim/scene/"}) == List{});
  CHECK(violations("render/context/", kImGui) == List{});
  CHECK(violations("render/context/", {"render/gl/", "render/visual/", "render/output/"}) == List{});
  CHECK(violations("render/device/", kImGui) == List{});
  // The solver knows of no pictures; four files draw from where it leaves poses, numbers and
  // contacts.
  CHECK(violations("render/device/", {"render/visual/", "render/output/"}) ==
        List{"render/device/device_bodies.cpp includes render/visual/body_parts.h",
             "render/device/device_marks.cpp includes render/visual/contact_glyphs.h",
             "render/device/device_marks.cpp includes render/visual/line_shapes.h",
             "render/device/device_marks.cpp includes render/visual/palette.h",
             "render/device/device_sphere.cpp includes render/visual/body_parts.h",
             "render/device/device_sphere.h includes render/visual/bounds.h",
             "render/device/value_colors.cpp includes render/visual/value_map.h"});
  // Pictures are drawn whether or not a GPU solves.
  for (const char* folder : {"render/visual/", "render/output/", "render/context/", "render/gl/"})
    CHECK(violations(folder, {"render/device/"}) == List{});
}

TEST_CASE("GLSL is in files of its own, and each of them is embedded") {
  using List = std::vector<std::string>;
  CHECK(mentions("render/", {"gl_Position", "void main("}) == List{});
  std::set<std::string> names;
  int count = 0;
  for (const char* folder : {"render/gl", "render/device"}) {
    const std::string cmake = pabd::read_bytes(fs::path(places::project()) / folder / "CMakeLists.txt");
    for (const auto& entry : fs::directory_iterator(fs::path(places::project()) / folder / "shaders")) {
      CAPTURE(entry.path());
      REQUIRE(entry.path().extension() == ".glsl");
      CHECK(std::regex_search(cmake, std::regex("\\s" + entry.path().stem().string() + "[\\s)]")));
      // All files are names of one namespace.
      CHECK(names.insert(entry.path().stem().string()).second);
      CHECK(pabd::read_bytes(entry.path()).starts_with("// SPDX-License-Identifier: MIT\n"));
      ++count;
    }
  }
  CHECK(count > 20);
}

TEST_CASE("one file of render knows Dear ImGui") {
  std::set<std::string> files;
  for (const Source& source : sources()) {
    if (!source.path.starts_with("render/")) continue;
    for (const std::string& include : source.includes) {
      if (begins_with_any(include, kImGui)) files.insert(source.path);
    }
  }
  CAPTURE(files);
  CHECK(files.size() <= 1);
}

TEST_CASE("public headers need nothing but each other, Eigen and the standard library") {
  // As they are installed: another header would not be there, another library its users would have to find.
  const std::string list = places::public_headers();
  std::set<std::string> headers;
  for (std::size_t begin = 0; begin < list.size();) {
    const std::size_t end = std::min(list.find(',', begin), list.size());
    headers.insert(list.substr(begin, end - begin));
    begin = end + 1;
  }
  CHECK(headers.size() > 30);
  std::vector<std::string> strangers;
  for (const Source& source : sources()) {
    if (headers.erase(source.path) == 0) continue;
    for (const std::string& include : source.includes) {
      const bool standard = include.find_first_of("./") == std::string::npos || include == "sys/types.h";
      const bool ours = ("," + list + ",").find("," + include + ",") != std::string::npos;
      if (!standard && !ours && !include.starts_with("Eigen/")) {
        strangers.push_back(source.path + " includes " + include);
      }
    }
    // What has another size where the compiler may use other instructions is for the inside.
    if (source.text.find("vector_size") != std::string::npos) strangers.push_back(source.path + " has lanes");
  }
  CHECK(strangers == std::vector<std::string>{});
  CHECK(headers.empty());  // each is there
}

TEST_CASE("app's parts keep apart") {
  using List = std::vector<std::string>;
  CHECK(violations("app/plots/", kGl) == List{});
  CHECK(violations("app/plots/", {"app/session/", "app/cli/", "app/overlay/", "CLI/"}) == List{});
  // What is collected is drawn on machines without OpenGL.
  CHECK(violations("app/sweep/collect_", kGl) == List{});
  CHECK(violations("app/sweep/collect_", {"app/cli/", "app/overlay/", "app/gui/", "CLI/"}) == List{});
  CHECK(violations("app/session/", kGl) == List{});
  CHECK(violations("app/session/", kImGui) == List{});
  CHECK(violations("app/session/", kPrinting) == List{});
  CHECK(violations("app/session/", {"render/", "app/cli/", "app/overlay/", "app/plots/", "CLI/"}) == List{});
  CHECK(violations("app/overlay/", {"app/cli/", "CLI/"}) == List{});
  CHECK(violations("app/frames/", {"app/cli/", "app/gui/", "app/workbench/", "CLI/"}) == List{});
}

TEST_CASE("units of what plots show stand in one table") {
  CHECK(mentions("app/plots/figures/", {" [m]\"", " [J]\"", " [N]\"", " [s]\"", " [ms]\"", " [1]\"",
                                        " [1/m]\"", " [N/m]\""}) == std::vector<std::string>{});
}

TEST_CASE("files are short and headers say what they are") {
  for (const Source& source : sources()) {
    CAPTURE(source.path, source.lines);
    CHECK(source.lines <= kMaxLines);
    if (!source.path.ends_with(".h")) continue;
    CHECK(source.text.starts_with("//"));
    CHECK(source.text.find("#pragma once") != std::string::npos);
  }
}

TEST_CASE("every test runs and can fail") {
  // Hidden, tolerated and empty tests prove nothing. (Spelled in pieces so that this list does not find
  // itself.)
  const std::vector<std::string> forbidden = {
      std::string("\"[") + ".",       std::string("[") + "!mayfail", std::string("[") + "!shouldfail",
      std::string("[") + "!hide",     std::string("SUCCEED") + "(",  std::string("REQUIRE(") + "true)",
      std::string("CHECK(") + "true)"};
  for (const Source& source : sources()) {
    if (!source.path.starts_with("tests/")) continue;
    // A case that another one starts in a process of its own is named so, and may be hidden.
    const std::string text = std::regex_replace(source.text, std::regex("\\[\\.child\\]"), "");
    for (const std::string& word : forbidden) {
      CAPTURE(source.path, word);
      CHECK(text.find(word) == std::string::npos);
    }
  }
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(places::project()) / "tests")) {
    if (entry.path().filename() != "CMakeLists.txt") continue;
    const std::string text = pabd::read_bytes(entry.path());
    for (const char* word : {"DISABLED", "SKIP_RETURN_CODE", "SKIP_REGULAR_EXPRESSION", "WILL_FAIL"}) {
      CAPTURE(entry.path(), word);
      CHECK(text.find(word) == std::string::npos);
    }
  }
}

}  // namespace pabd::test_structure
