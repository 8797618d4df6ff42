// SPDX-License-Identifier: MIT
// State files: the same bits come back, and a file that does not fit is refused.
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "sim/base/error.h"
#include "sim/scene/random.h"
#include "sim/scene/scene.h"
#include "sim/trace/trace.h"

namespace pabd::test_state_files {

using Json = nlohmann::json;

namespace {

struct Example {
  Model model;
  State state;
};

// A pile in the middle of a run: every number has all its digits.
Example example() {
  Scene scene = parse_scene(R"({ "format": "pabd-scene", "version": 1, "bodies": [
    { "name": "ground \"0\" \\ é", "shape": { "type": "plane" } } ],
    "generate": [ { "type": "pile", "count": 50, "shape": "mixed" } ],
    "joints": [ { "type": "spherical", "bodies": ["pile 1", "pile 2"], "anchor": [0, 1, 0] },
                { "type": "spherical", "bodies": ["pile 2", null], "anchor": [0, 1, 0] } ] })",
                            "test.json", {});
  Example e{std::move(scene.model), std::move(scene.initial)};
  Random random(5);
  e.state.time = 1.0 / 3;
  e.state.step = 20;
  for (std::size_t i = 1; i < e.state.c.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      e.state.c[i][k] *= 1 + 1e-3 * random.symmetric();
      e.state.v[i][k] = 3 * random.symmetric();
      e.state.omega[i][k] = 9 * random.symmetric();
    }
    e.state.R[i](0, 1) += 1e-13 * random.symmetric();  // no longer what any quaternion gives
  }
  e.state.v[1] = Vec3(-0.0, 1e-310, 1e300);
  e.state.contacts.push_back({(std::uint64_t{0} << 32) | 3, 7, Vec3(1e-9, -0.0, 2.0 / 3)});
  e.state.contacts.push_back({(std::uint64_t{2} << 32) | 5, 0xffffffffu, Vec3(0, 0.1, 0), true, true});
  e.state.joint_force = {Vec3(1.0 / 3, -0.0, 1e9), Vec3(0, 2e-300, 0)};
  return e;
}

void check_refused(const Example& e, const Json& json, const std::vector<std::string>& parts) {
  INFO(parts[0]);
  try {
    state_from_json(e.model, json.dump(), "end.json");
    FAIL_CHECK("accepted");
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::bad_input);
    CHECK_THAT(error.what(), Catch::StartsWith("end.json: "));
    for (const std::string& part : parts) CHECK_THAT(error.what(), Catch::Contains(part));
  }
}

}  // namespace

TEST_CASE("a state file gives the same bits back", "[trace]") {
  const Example e = example();
  const std::string text = state_to_json(e.model, e.state);
  const State back = state_from_json(e.model, text, "end.json");
  CHECK(state_hash(back) == state_hash(e.state));
  CHECK(std::signbit(back.v[1].x()));
  CHECK(back.v[1] == e.state.v[1]);
  CHECK(back.R[7] == e.state.R[7]);
  REQUIRE(back.contacts.size() == 2);
  CHECK(back.contacts[1].feature == 0xffffffffu);
  CHECK_FALSE(back.contacts[0].sliding);
  CHECK(back.contacts[1].sliding);
  CHECK_FALSE(back.contacts[0].recovers);
  CHECK(back.contacts[1].recovers);
  CHECK(back.contacts[1].pair == e.state.contacts[1].pair);
  CHECK(state_to_json(e.model, back) == text);
}

TEST_CASE("what people read in a state file", "[trace]") {
  const Example e = example();
  const Json json = Json::parse(state_to_json(e.model, e.state));
  CHECK(json["time"] == e.state.time);
  CHECK(json["step"] == 20);
  CHECK(json["hash"] == state_hash(e.state));
  const Json& body = json["bodies"][9];
  CHECK(body["name"] == e.model.name[9]);
  CHECK(body["position"][1] == e.state.c[9].y());
  const Quat q(body["orientation"][0], body["orientation"][1], body["orientation"][2],
               body["orientation"][3]);
  CHECK((q.toRotationMatrix() - e.state.R[9]).norm() < 1e-12);
  CHECK(body["angular_velocity"][2].get<double>() == Approx(e.state.omega[9].z() * 180 / kPi).epsilon(1e-14));
  CHECK(json["bodies"][0]["name"] == e.model.name[0]);
}

TEST_CASE("a state written by hand needs only the readable keys", "[trace]") {
  const Example e = example();
  Json json = Json::parse(state_to_json(e.model, e.state));
  json.erase("hash");
  json.erase("anchors");
  json.erase("step");
  for (Json& body : json["bodies"]) {
    body.erase("rotation");
    body.erase("omega");
  }
  const State s = state_from_json(e.model, json.dump(), "end.json");
  CHECK(s.step == 0);
  CHECK(s.contacts.empty());
  CHECK((s.R[9] - e.state.R[9]).norm() < 1e-12);
  CHECK((s.omega[9] - e.state.omega[9]).norm() < 1e-12);
}

TEST_CASE("every number of a state enters its hash", "[trace]") {
  const Example e = example();
  std::set<std::string> seen{state_hash(e.state)};
  const auto changed = [&](auto&& change) {
    State s = e.state;
    change(s);
    CHECK(seen.insert(state_hash(s)).second);
  };
  const auto next = [](double& x) { x = std::nextafter(x, 1e300); };
  changed([&](State& s) { next(s.time); });
  changed([&](State& s) { ++s.step; });
  for (const std::size_t i : {std::size_t{0}, std::size_t{50}}) {
    for (int k = 0; k < 3; ++k) {
      changed([&](State& s) { next(s.c[i][k]); });
      changed([&](State& s) { next(s.v[i][k]); });
      changed([&](State& s) { next(s.omega[i][k]); });
    }
    for (int k = 0; k < 9; ++k) changed([&](State& s) { next(s.R[i].data()[k]); });
  }
  changed([&](State& s) { s.contacts[0].feature ^= 1; });
  changed([&](State& s) { s.contacts[0].pair ^= 1; });
  changed([&](State& s) { s.contacts[0].sliding = true; });
  changed([&](State& s) { s.contacts[0].restless = true; });
  changed([&](State& s) { next(s.contacts[0].stretch[2]); });
  changed([&](State& s) { s.contacts.pop_back(); });
  for (int k = 0; k < 3; ++k) changed([&](State& s) { next(s.joint_force[1][k]); });
  changed([&](State& s) { s.joint_force.clear(); });
  changed([&](State& s) { std::swap(s.v[3], s.v[4]); });
  CHECK(state_hash(State{}).size() == 16);
}

TEST_CASE("state files that do not fit are refused", "[trace]") {
  const Example e = example();
  const Json good = Json::parse(state_to_json(e.model, e.state));
  const auto refuse = [&](const char* pointer, const Json& value, const std::vector<std::string>& parts) {
    Json json = good;
    json[Json::json_pointer(pointer)] = value;
    check_refused(e, json, parts);
  };
  refuse("/joint_forces", Json::array({Json::array({0, 0, 0})}),
         {"/joint_forces", "each of 2 joints, got 1"});
  refuse("/joint_forces/1/2", nullptr, {"/joint_forces/1/2", "number"});
  refuse("/format", "other", {"/format", "pabd-state"});
  refuse("/version", 2, {"/version", "from 1 to 1"});
  refuse("/time", nullptr, {"/time", "expected a number"});
  refuse("/time", -1, {"/time", "expected a number"});
  refuse("/step", 1.5, {"/step", "whole number"});
  refuse("/stepp", 1, {"/stepp", "did you mean \"step\"?"});
  refuse("/bodies/1/name", "x", {"/bodies/1/name", "another scene"});
  refuse("/bodies/1/position", Json::array({1, 2}), {"/bodies/1/position", "an array of 3 numbers"});
  refuse("/bodies/1/velocity/0", nullptr, {"/bodies/1/velocity/0", "expected a number"});
  refuse("/bodies/1/rotation/0", 0.123, {"/bodies/1/rotation", "rotation matrix"});
  refuse("/bodies/1/orientation", Json::array({1, 0, 0, 0}),
         {"/bodies/1/orientation", "remove \"rotation\""});
  refuse("/bodies/1/angular_velocity/0", 1234, {"/bodies/1/angular_velocity", "remove \"omega\""});
  refuse("/bodies/1/position/0", 99, {"/hash", "remove \"hash\""});
  refuse("/anchors/0/bodies", Json::array({3, 0}), {"/anchors/0/bodies", "rising order"});
  refuse("/anchors/0/bodies/1", 51, {"/anchors/0/bodies/1", "from 0 to 50"});
  refuse("/anchors/1", good["anchors"][0], {"/anchors/1", "rising order"});
  refuse("/anchors/0/feature", 4294967296, {"/anchors/0/feature", "whole number"});

  // Mirrored: orthonormal, but not a rotation.
  Json mirrored = good;
  mirrored["bodies"][1].erase("orientation");
  mirrored["bodies"][1]["rotation"] = {1, 0, 0, 0, 1, 0, 0, 0, -1};
  check_refused(e, mirrored, {"/bodies/1/rotation", "rotation matrix"});

  Json moving_ground = good;
  moving_ground["bodies"][0]["velocity"] = {1, 0, 0};
  check_refused(e, moving_ground, {"/bodies/0", "fixed"});

  Json fewer = good;
  fewer["bodies"].erase(3);
  check_refused(e, fewer, {"/bodies", "expected 51 bodies, got 50"});

  Json missing = good;
  missing["bodies"][2].erase("position");
  check_refused(e, missing, {"/bodies/2/position", "missing"});

  const std::string text = state_to_json(e.model, e.state);
  for (std::size_t n = 0; n < text.size() - 2; n += 97) {
    CHECK_THROWS_AS(state_from_json(e.model, text.substr(0, n), "end.json"), Error);
  }
}

}  // namespace pabd::test_state_files
