// SPDX-License-Identifier: MIT
// An .npz is what numpy.load reads without pickle, with every number of the run in it (check_npz.py).
#include <array>
#include <catch2/catch.hpp>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "tests/export/export_helpers.h"
#include "tests/support/errors.h"
#include "tests/support/file_size_limit.h"
#include "tests/support/places.h"
#include "tests/support/temp_folder.h"

namespace pabd::test_npz {

using namespace testing;

namespace {

// What a command writes and how it ends.
std::pair<int, std::string> outcome(const std::string& command) {
  std::FILE* pipe = ::popen((command + " 2>&1").c_str(), "r");
  REQUIRE(pipe != nullptr);
  std::string text;
  std::array<char, 4096> part;
  while (const std::size_t n = std::fread(part.data(), 1, part.size(), pipe)) text.append(part.data(), n);
  return {::pclose(pipe), text};
}

template <class V>
void append(const V& v, nlohmann::json& list) {
  for (const double x : v) list.push_back(x);
}

}  // namespace

TEST_CASE("numpy reads every array of an .npz, and they are the run") {
  const TempFolder folder;
  const auto scene = std::make_shared<Scene>(*varied_scene());
  scene->params.solver.integrator =
      Integrator::euler;  // the force at the end is what the step's momentum is from
  const double fps = 1 / scene->params.h;
  const auto frames = frames_of(scene, 61, fps);
  const std::string out = (folder / "a.npz").string();
  export_frames(out, *scene, frames, {.fps = fps});

  nlohmann::json exact, contacts = nlohmann::json::array();
  for (const Frame& frame : frames) {
    const State& state = *frame.a().state;
    exact["time"].push_back(state.time);
    exact["step"].push_back(state.step);
    for (std::size_t i = 0; i < state.c.size(); ++i) {
      append(state.c[i], exact["position"]);
      append(state.v[i], exact["velocity"]);
      append(state.omega[i], exact["angular_velocity"]);
      for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column) exact["A"].push_back(state.R[i](row, column));
    }
    contacts.push_back(frame.a().report.contact_reports.size());
    for (const ContactReport& contact : frame.a().report.contact_reports) {
      exact["contact_a"].push_back(contact.a);
      exact["contact_b"].push_back(contact.b);
      exact["contact_sticking"].push_back(contact.sticking);
      exact["contact_normal_force"].push_back(contact.normal_force);
      append(contact.friction, exact["contact_friction"]);
    }
  }
  const Vec3 g = scene->params.gravity;
  // The solver stops where displacements no longer change by more than its tolerance times d̂.
  nlohmann::json expected = {
      {"exact", exact}, {"contacts", contacts}, {"gravity", {g.x(), g.y(), g.z()}}, {"tolerance", 0.02}};
  for (const Polyhedron& solid : polyhedra()) {
    nlohmann::json& told = expected["polyhedra"][solid.name];
    told["volume"] = solid.volume;
    for (const Vec3& corner : solid.corners) append(corner, told["corners"]);
  }
  write_bytes(folder / "expected.json", expected.dump());
  const auto [code, text] = outcome("/usr/bin/python3 " + places::tests() + "/export/check_npz.py " + out +
                                    " " + (folder / "expected.json").string());
  CAPTURE(text);
  CHECK(code == 0);
}

TEST_CASE("the world is the end of a joint without a body") {
  const TempFolder folder;
  const auto scene = std::make_shared<const Scene>(parse_scene(R"({ "format": "pabd-scene", "version": 1,
    "bodies": [ { "name": "bob", "shape": { "type": "sphere", "radius": 0.1 }, "position": [1, 0, 0] } ],
    "joints": [ { "name": "hook", "type": "spherical", "bodies": [null, "bob"], "anchor": [0, 0, 0] } ] })",
                                                               "hook", "."));
  const std::string out = (folder / "a.npz").string();
  export_frames(out, *scene, frames_of(scene, 2, 60), {.fps = 60});
  // Entries are stored as they are.
  const std::string bytes = read_bytes(out);
  const std::size_t from = bytes.find("{\n"), to = bytes.find("\n}\n", from);
  REQUIRE(to != std::string::npos);
  const auto about = nlohmann::json::parse(bytes.substr(from, to + 3 - from));
  CHECK(about["joints"][0]["bodies"] == nlohmann::json({nullptr, "bob"}));
}

TEST_CASE("an archive that cannot be written whole leaves nothing and says why") {
  const TempFolder folder;
  const auto scene = varied_scene();
  const auto frames = frames_of(scene, 200, 60);
  const std::string out = (folder / "a.npz").string();
  {
    const FileSizeLimit full(100'000);
    const Caught failed = caught([&] { export_frames(out, *scene, frames, {.fps = 60}); });
    CHECK(failed.kind == file_error);
    CHECK(failed.says(out));
    CHECK(failed.says("ulimit"));
  }
  { const auto given_up = make_exporter(out, *scene, frames.front().a(), {}); }
  CHECK(folder.names().empty());
}

}  // namespace pabd::test_npz
