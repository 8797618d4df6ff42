// SPDX-License-Identifier: MIT
// A .usda read back by a small reader of its own: brackets match, and time samples are the poses of the run.
#include <catch2/catch.hpp>
#include <map>
#include <regex>
#include <sstream>

#include "tests/export/export_helpers.h"
#include "tests/support/temp_folder.h"

namespace pabd::test_usd {

using namespace testing;

namespace {

// Whether every bracket outside of strings is closed by its own kind.
bool balanced(const std::string& text) {
  std::string open;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '"') {
      for (++i; i < text.size() && text[i] != '"'; ++i)
        if (text[i] == '\\') ++i;
      continue;
    }
    const std::string pairs = "()[]{}";
    const auto at = pairs.find(text[i]);
    if (at == std::string::npos) continue;
    if (at % 2 == 0) {
      open += text[i];
    } else {
      if (open.empty() || open.back() != pairs[at - 1]) return false;
      open.pop_back();
    }
  }
  return open.empty();
}

std::vector<double> numbers_in(const std::string& text) {
  std::vector<double> out;
  const std::regex number(R"(-?[0-9][0-9.]*(e[-+]?[0-9]+)?)");
  for (std::sregex_iterator at(text.begin(), text.end(), number), end; at != end; ++at)
    out.push_back(std::stod(at->str()));
  return out;
}

// The text of the prim of that name, braces and all.
std::string prim(const std::string& text, const std::string& name) {
  const auto begin = text.find("\"" + name + "\"");
  REQUIRE(begin != std::string::npos);
  const auto start = text.rfind('\n', begin) + 1;
  const std::string indent = text.substr(start, text.find_first_not_of(' ', start) - start);
  const auto end = text.find("\n" + indent + "}\n", begin);
  REQUIRE(end != std::string::npos);
  return text.substr(start, end - start);
}

// Numbers in the brackets of an attribute that does not change.
std::vector<double> list(const std::string& prim, const std::string& attribute) {
  const auto begin = prim.find(attribute + " = [");
  REQUIRE(begin != std::string::npos);
  const auto from = prim.find('[', begin);  // of its value, not of its type
  return numbers_in(prim.substr(from, prim.find(']', from) - from));
}

// Code → numbers of an attribute's samples.
std::map<double, std::vector<double>> samples(const std::string& prim, const std::string& attribute) {
  std::map<double, std::vector<double>> out;
  const auto begin = prim.find(attribute + ".timeSamples = {\n");
  if (begin == std::string::npos) return out;
  std::istringstream lines(prim.substr(prim.find('{', begin) + 2));
  for (std::string line; std::getline(lines, line) && line.find('}') == std::string::npos;) {
    const auto colon = line.find(':');
    out[std::stod(line.substr(0, colon))] = numbers_in(line.substr(colon + 1));
  }
  return out;
}

}  // namespace

TEST_CASE("normals of a .usda are of its vertices: metadata of the attribute say so") {
  const TempFolder folder;
  const auto scene = varied_scene();
  const auto out = folder / "a.usda";
  export_frames(out.string(), *scene, frames_of(scene, 1, 30), {});
  std::istringstream lines(read_bytes(out));
  int seen = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.find("primvars:normals") == std::string::npos) continue;
    ++seen;
    CHECK(line.find("normal3f[] primvars:normals = [(") != std::string::npos);
    CHECK(line.ends_with(")] (interpolation = \"vertex\")"));
  }
  CHECK(seen > 3);
}

TEST_CASE("a hull and a compound in a .usda have their corners and enclose their volume") {
  const TempFolder folder;
  const auto scene = varied_scene();
  const auto out = folder / "a.usda";
  export_frames(out.string(), *scene, frames_of(scene, 2, 30), {});
  const std::string text = read_bytes(out);
  for (const Polyhedron& solid : polyhedra()) {
    const std::string body = prim(text, solid.name);
    std::smatch shape;
    REQUIRE(std::regex_search(body, shape, std::regex("inherits = </World/Shapes/(\\w+)>")));
    const std::string mesh = prim(text, shape[1]);
    const auto points = list(mesh, "points"), counts = list(mesh, "faceVertexCounts"),
               indices = list(mesh, "faceVertexIndices");
    CHECK(counts == std::vector<double>(indices.size() / 3, 3));
    std::vector<Vec3> corners;
    for (const double index : indices) corners.emplace_back(&points.at(3 * static_cast<std::size_t>(index)));
    check_surface(solid, corners, 1e-6);
  }
}

TEST_CASE("time samples of a .usda are the poses of the run") {
  const TempFolder folder;
  const auto scene = varied_scene();
  const double fps = 24;  // no divisor of the steps: samples lie where the states are
  const auto frames = frames_of(scene, 20, fps);
  const auto out = folder / "a.usda";
  export_frames(out.string(), *scene, frames, {.fps = fps, .trails = {{"ball"}}});
  const std::string text = read_bytes(out);
  CHECK(text.starts_with("#usda 1.0\n"));
  CHECK(balanced(text));
  for (const char* line :
       {"metersPerUnit = 1\n", "upAxis = \"Y\"\n", "timeCodesPerSecond = 24\n", "startTimeCode = 0\n",
        "defaultPrim = \"World\"\n", "string name = \"crate \\\"2\\\" é\"\n"})
    CHECK(text.find(line) != std::string::npos);

  const std::map<std::string, std::size_t> bodies = {{"crate", 2}, {"crate_2_", 3}, {"ball", 4},  {"pill", 5},
                                                     {"arm", 8},   {"wedge", 9},    {"angle", 10}};
  for (const auto& [name, i] : bodies) {
    CAPTURE(name);
    const std::string body = prim(text, name);
    const auto moves = samples(body, "double3 xformOp:translate"),
               turns = samples(body, "quatf xformOp:orient");
    REQUIRE(moves.size() == frames.size());
    std::size_t k = 0;
    for (const auto& [code, place] : moves) {
      const State& state = *frames[k++].a().state;
      CHECK(code == Approx(fps * state.time).margin(1e-3));
      REQUIRE(place.size() == 3);
      for (std::size_t x = 0; x < 3; ++x)
        CHECK(static_cast<float>(place[x]) == static_cast<float>(state.c[i][static_cast<int>(x)]));
    }
    k = 0;
    for (const auto& [code, q] : turns) {
      REQUIRE(q.size() == 4);
      CHECK(rotation_error(frames[k++].a().state->R[i], q[0], q[1], q[2], q[3]) < 4e-7);
    }
    CHECK((turns.empty() || turns.size() == frames.size()));
  }
  CHECK(samples(prim(text, "crate"), "quatf xformOp:orient").size() == frames.size());
  const std::string post = prim(text, "post");
  CHECK(post.find("timeSamples") == std::string::npos);
  CHECK(post.find("double3 xformOp:translate = (3, 1, 0)") != std::string::npos);
  CHECK(prim(text, "ground").find("timeSamples") == std::string::npos);
  CHECK(prim(text, "trail_of_ball").find("curveVertexCounts = [20]") != std::string::npos);

  // What is referred to is there.
  const std::regex path("</World/(Materials|Shapes)/(\\w+)>");
  int found = 0;
  for (std::sregex_iterator at(text.begin(), text.end(), path), end; at != end; ++at, ++found)
    CHECK(text.find("\"" + (*at)[2].str() + "\"") != std::string::npos);
  CHECK(found > 15);
}

}  // namespace pabd::test_usd
