// SPDX-License-Identifier: MIT
// The generators with joints: chain and net.
#include <cmath>
#include <variant>

#include "sim/joint/expand.h"
#include "tests/scene/scene_helpers.h"

namespace pabd::test_jointed_generators {

using namespace test;

namespace {

Scene generate(const std::string& generator) {
  return parse(scene_text(R"("contact": { "d_hat": 0.02 }, "generate": [ )" + generator + " ]"));
}

Pose pose(const Scene& s, Index body) {
  if (body == kWorld) return {Vec3::Zero(), Mat3::Identity()};
  return {s.initial.c[static_cast<std::size_t>(body)], s.initial.R[static_cast<std::size_t>(body)]};
}

// Where joint k stands, seen from its body i; REQUIREs that body j sees it there too.
Vec3 anchor(const Scene& s, std::size_t k) {
  const Joint& joint = s.model.joints[k];
  const PlacedFrame i = place(joint.on_i, pose(s, joint.i)), j = place(joint.on_j, pose(s, joint.j));
  REQUIRE((i.y - j.y).norm() < 1e-12);
  REQUIRE((i.F - j.F).norm() < 1e-12);
  return i.y;
}

}  // namespace

TEST_CASE("chain: places, joints, ends, masses", "[scene]") {
  const Scene s = generate(R"({ "type": "chain", "links": 3, "size": [2, 0.2, 0.4], "position": [1, 10, 0],
    "direction": [0, -3, 0], "gap": 0.5, "mass": 4, "end_mass": 40, "fixed": "both" })");
  REQUIRE(s.model.size() == 3);
  CHECK(s.model.name[2] == "chain 2");
  CHECK(s.model.mass == std::vector<double>{4, 4, 40});
  for (std::size_t k = 0; k < 3; ++k) {
    CHECK((s.initial.c[k] - Vec3(1, 10 - 2.5 * (static_cast<double>(k) + 0.5), 0)).norm() < 1e-12);
    CHECK((s.initial.R[k].col(0) + Vec3::UnitY()).norm() < 1e-15);  // the length lies along the chain
    CHECK((s.initial.R[k].col(2) - Vec3::UnitZ()).norm() < 1e-15);
  }
  REQUIRE(s.model.joints.size() == 4);
  for (std::size_t k = 0; k < 4; ++k) {
    CHECK((anchor(s, k) - Vec3(1, 10 - 2.5 * static_cast<double>(k), 0)).norm() < 1e-12);
    CHECK(s.model.joints[k].type == JointType::spherical);
    CHECK(s.model.joints[k].name.empty());
  }
  CHECK(s.model.joints[0].i == kWorld);
  CHECK(s.model.joints[3].j == kWorld);
  CHECK(s.model.no_collide == std::vector<std::pair<Index, Index>>{{0, 1}, {1, 2}});

  CHECK(generate(R"({ "type": "chain", "links": 3, "fixed": "none" })").model.joints.size() == 2);
  const Scene hinges =
      generate(R"({ "type": "chain", "links": 3, "joint": "hinge", "axis": [0, 5, 0], "collide": true })");
  REQUIRE(hinges.model.joints.size() == 3);
  CHECK((hinges.model.joints[1].on_i.F.col(0) - Vec3::UnitY()).norm() < 1e-15);
  CHECK(hinges.model.no_collide.empty());
}

TEST_CASE("chain: shapes fill their links", "[scene]") {
  const Scene capsules = generate(
      R"({ "type": "chain", "links": 2, "shape": "capsule", "size": [1, 0.2, 0.2], "direction": [1, 2, 3] })");
  const auto& capsule = std::get<Capsule>(capsules.model.shape[0]);
  CHECK(capsule.radius == Approx(0.1));
  CHECK(capsule.length == Approx(0.8));
  CHECK((capsules.initial.R[0].col(1) - Vec3(1, 2, 3).normalized()).norm() < 1e-14);
  CHECK(capsules.initial.R[0].determinant() == Approx(1));
  const Scene beads = generate(R"({ "type": "chain", "links": 2, "shape": "sphere", "size": [0.5, 1, 1] })");
  CHECK(std::get<Sphere>(beads.model.shape[0]).radius == 0.25);
}

TEST_CASE("net: places, joints, fixed bodies", "[scene]") {
  const Scene s = generate(R"({ "type": "net", "rows": 3, "columns": 4, "size": [1, 0.1, 0.5],
    "position": [0, 7, 0] })");
  REQUIRE(s.model.size() == 12);
  CHECK(s.model.name[7] == "net 1.3");
  CHECK((s.initial.c[1] - s.initial.c[0] - Vec3(1.02, 0, 0)).norm() < 1e-12);  // d̂ apart
  CHECK((s.initial.c[4] - s.initial.c[0] - Vec3(0, 0, 0.52)).norm() < 1e-12);
  CHECK((s.initial.c[0] + s.initial.c[11] - Vec3(0, 14, 0)).norm() < 1e-12);
  REQUIRE(s.model.joints.size() == 3 * 3 + 2 * 4);
  for (std::size_t k = 0; k < s.model.joints.size(); ++k) {
    const Joint& joint = s.model.joints[k];
    CHECK((anchor(s, k) - 0.5 * (pose(s, joint.i).c + pose(s, joint.j).c)).norm() < 1e-12);
  }
  CHECK(s.model.fixed == std::vector<std::uint8_t>{1, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 1});
  CHECK(s.model.no_collide.size() == 17);

  const auto count = [](const char* fixed) {
    const Scene net = generate(R"({ "type": "net", "rows": 3, "columns": 4, "upright": true, "fixed": ")" +
                               std::string(fixed) + "\" }");
    CHECK((net.initial.c[4] - net.initial.c[0] - Vec3(0, -1.02, 0)).norm() < 1e-12);
    return std::pair{std::count(net.model.fixed.begin(), net.model.fixed.end(), 1), net.model.joints.size()};
  };
  // Joints between two fixed bodies are left out.
  CHECK(count("none") == std::pair{0L, std::size_t{17}});
  CHECK(count("edges") == std::pair{10L, std::size_t{7}});
  CHECK(count("top") == std::pair{4L, std::size_t{14}});
}

TEST_CASE("net of rods: distance joints between the centres", "[scene]") {
  const Scene s = generate(R"({ "type": "net", "rows": 2, "columns": 2, "shape": "sphere",
    "size": [0.1, 0.1, 0.1], "gap": 0.3, "joint": "distance", "fixed": "none" })");
  REQUIRE(s.model.joints.size() == 4);
  for (const Joint& joint : s.model.joints) {
    CHECK(joint.type == JointType::distance);
    CHECK(joint.length == Approx(0.4));
    CHECK(joint.on_i.r == Vec3::Zero());
  }
}

TEST_CASE("a long chain is a few lines; its stiffness follows from its whole weight, and from rounding",
          "[scene]") {
  const Scene shorter =
      generate(R"({ "type": "chain", "links": 100, "size": [0.1, 0.02, 0.02], "mass": 0.5 })");
  CHECK(shorter.model.joints[99].law.kappa == Approx(100 * 0.5 * 9.81 / (1e-8 * 0.02)));
  const Scene s = generate(R"({ "type": "chain", "links": 100000, "size": [0.1, 0.02, 0.02], "mass": 0.5 })");
  REQUIRE(s.model.joints.size() == 100000);
  CHECK(s.model.joints[99999].law.kappa == Approx(0.5 * 9.81 / 2.5e-13));
  CHECK(s.model.no_collide.size() == 99999);
  CHECK(sizeof(Joint) <= 328);  // a million joints: 0.33 GB
}

}  // namespace pabd::test_jointed_generators
