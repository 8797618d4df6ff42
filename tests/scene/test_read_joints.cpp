// SPDX-License-Identifier: MIT
// Joints in scene files: what a file says arrives in the model, and bad joints are refused.
#include "sim/joint/auto_kappa.h"
#include "tests/scene/scene_helpers.h"

namespace pabd::test_read_joints {

using namespace test;

namespace {

// A fixed post, two movable crates (one turned by a quarter about z) and the given scene members.
std::string with_crates(const std::string& members) {
  return scene_text(R"("bodies": [
    { "name": "post", "shape": { "type": "box", "size": [1, 1, 1] }, "fixed": true, "position": [-5, 0, 0] },
    { "name": "a", "shape": { "type": "box", "size": [2, 1, 1] }, "mass": 3, "position": [0, 1, 0] },
    { "name": "b", "shape": { "type": "sphere", "radius": 0.25 }, "mass": 5, "position": [2, 1, 0],
      "orientation": [0.70710678118654757, 0, 0, 0.70710678118654757] } ])" +
                    (members.empty() ? "" : ", " + members));
}

std::string joints(const std::string& list) { return with_crates("\"joints\": [ " + list + " ]"); }

Joint only_joint(const std::string& members) {
  const Scene s = parse(joints("{" + members + "}"));
  REQUIRE(s.model.joints.size() == 1);
  return s.model.joints[0];
}

const std::string kHinge = R"("type": "hinge", "bodies": ["a", "b"], "anchor": [1, 1, 0], "axis": [0, 0, 2])";
const std::string kSlider =
    R"("type": "slider", "bodies": [null, "a"], "anchor": [0, 1, 0], "axis": [1, 0, 0])";
const std::string kBall = R"("type": "spherical", "bodies": ["a", "b"], "anchor": [1, 1, 0])";
const std::string kRod = R"("type": "distance", "bodies": ["a", "b"], "points": [[0, 1, 0], [2, 1, 0.5]])";

}  // namespace

TEST_CASE("a hinge: bodies, frames, defaults", "[scene]") {
  const Joint joint = only_joint(kHinge);
  CHECK(joint.name == "joint 0");
  CHECK(joint.type == JointType::hinge);
  CHECK(joint.i == 1);
  CHECK(joint.j == 2);
  CHECK((joint.on_i.r - Vec3(1, 0, 0)).norm() < 1e-15);
  CHECK((joint.on_j.r - Vec3(0, 1, 0)).norm() < 1e-15);  // b is turned: −x of the world is its +y
  CHECK((joint.on_i.F.col(0) - Vec3::UnitZ()).norm() < 1e-15);
  CHECK((joint.on_j.F.col(0) - Vec3::UnitZ()).norm() < 1e-15);
  CHECK(joint.on_i.F.determinant() == Approx(1));
  CHECK(joint.arm == Approx(0.125));  // half the radius of the smaller body
  CHECK(joint.symmetric);
  CHECK_FALSE(joint.limits);
  CHECK_FALSE(joint.drive);
  CHECK(joint.law.potential == BondPotential::soft);
}

TEST_CASE("limits and drives are degrees in files, radians in the model", "[scene]") {
  const Joint limited =
      only_joint(kHinge + R"(, "limits": [-45, 90], "arm": 0.3, "symmetric": false, "name": "knee")");
  REQUIRE(limited.limits);
  CHECK(limited.limits->lo == Approx(-kPi / 4));
  CHECK(limited.limits->hi == Approx(kPi / 2));
  CHECK(limited.arm == 0.3);
  CHECK_FALSE(limited.symmetric);
  CHECK(limited.name == "knee");
  Joint copy = limited;  // a copy has limits of its own
  CHECK(&*copy.limits != &*limited.limits);
  CHECK(copy.limits->hi == limited.limits->hi);
  copy.limits = JointRange{0, 1};
  CHECK(limited.limits->hi == Approx(kPi / 2));

  const Joint driven = only_joint(kHinge + R"(, "drive": { "keys": [[0.5, 0], [2, 720]] })");
  REQUIRE(driven.drive);
  CHECK(driven.drive->at(0) == 0);
  CHECK(driven.drive->at(1.25) == Approx(2 * kPi));
  CHECK(driven.drive->at(9) == Approx(4 * kPi));
  CHECK(only_joint(kHinge + R"(, "drive": { "value": 180 })").drive->at(3) == Approx(kPi));

  const Joint ball = only_joint(kBall + R"(, "drive": { "keys": [[0, [0, 0, 0]], [1, [90, 0, -180]]] })");
  REQUIRE(ball.turn);
  CHECK((ball.turn->at(0.5) - Vec3(kPi / 4, 0, -kPi / 2)).norm() < 1e-14);
  CHECK(ball.arms == 7);
  CHECK(only_joint(kBall + R"(, "drive": { "value": [0, 0, 0] }, "axes": "xz")").arms == 5);
}

TEST_CASE("sliders: metres, the world as a body, three kinds of twist", "[scene]") {
  const Joint joint = only_joint(kSlider + R"(, "limits": [-0.5, 2])");
  CHECK(joint.i == kWorld);
  CHECK(joint.on_i.r == Vec3(0, 1, 0));
  CHECK(joint.limits->hi == 2);
  CHECK(joint.twist == Twist::locked);
  CHECK(only_joint(kSlider + R"(, "twist": "free", "drive": { "value": 0.25 })").twist == Twist::free);
  const Joint twisting = only_joint(kSlider + R"(, "twist": { "limits": [-90, 0] })");
  CHECK(twisting.twist == Twist::limited);
  REQUIRE(twisting.twist_limits);
  CHECK(twisting.twist_limits->lo == Approx(-kPi / 2));
}

TEST_CASE("distance joints: length at the start by default", "[scene]") {
  const Joint rod = only_joint(kRod);
  CHECK(rod.length == Approx(std::sqrt(4.25)));
  CHECK((rod.on_j.r - Vec3(0, 0, 0.5)).norm() < 1e-15);
  CHECK(only_joint(kRod + R"(, "length": 0)").length == 0);
}

TEST_CASE("the law of a joint: its own, the default, or auto", "[scene]") {
  const auto scene = [](const std::string& defaults, const std::string& own) {
    return parse(with_crates(R"("joints_default": {)" + defaults + R"(}, "joints": [ {)" + kBall +
                             (own.empty() ? "" : ", ") + own + "} ]"));
  };
  // auto: the weight of both movable bodies, 8 kg, stretches a bond by 1e-8 of the smaller, 0.5 m thick.
  const double soft = 8 * 9.81 / (1e-8 * 0.5);
  Scene s = scene("", "");
  CHECK(s.model.joints[0].law.kappa == Approx(soft));
  CHECK(s.joint_law.kappa == Approx(soft));
  CHECK(s.model.joints[0].law.N == BondLaw{}.N);
  CHECK(s.model.joints[0].law.d_hat == BondLaw{}.d_hat);

  s = scene(R"("kappa": 500, "N": 6, "d_hat": 0.2)", "");
  CHECK(s.model.joints[0].law.kappa == 500);
  CHECK(s.model.joints[0].law.N == 6);
  CHECK(s.model.joints[0].law.d_hat == 0.2);
  CHECK(scene(R"("kappa": 500)", R"("kappa": "auto")").model.joints[0].law.kappa == Approx(soft));
  CHECK(scene("", R"("kappa": 7)").model.joints[0].law.kappa == 7);

  // Another potential has another unit, so that the default's number does not hold for it.
  s = scene(R"("kappa": 500, "d_hat": 0.2)", R"("potential": "hard")");
  CHECK(s.model.joints[0].law.potential == BondPotential::hard);
  CHECK(s.model.joints[0].law.kappa == Approx(soft * 0.2 * 0.2));  // Ψ' = κ s/d̂² for small s
  CHECK(s.joint_law.kappa == 500);

  CHECK(parse(with_crates(R"("joints": [ {)" + kBall + "} ]"), {"joints_default.kappa=33"})
            .model.joints[0]
            .law.kappa == 33);
}

TEST_CASE("jointed bodies do not collide unless they are told to", "[scene]") {
  const auto pairs = [](const std::string& list) { return parse(joints(list)).model.no_collide; };
  using Pairs = std::vector<std::pair<Index, Index>>;
  const std::string other = R"("type": "fixed", "bodies": ["a", "post"], "anchor": [0, 0, 0])";
  CHECK(pairs("{" + kBall + "}, {" + other + "}") == Pairs{{0, 1}, {1, 2}});
  CHECK(pairs("{" + kBall + R"(, "collide": true }, {)" + other + "}") == Pairs{{0, 1}});
  CHECK(pairs("{" + kBall + "}, {" + kRod + "}") == Pairs{{1, 2}});
  CHECK(pairs("{" + kSlider + "}").empty());  // the world is no body
}

TEST_CASE("joints may hold generated bodies, and come before those of generators", "[scene]") {
  const Scene s = parse(with_crates(R"("generate": [ { "type": "chain", "links": 3, "position": [0, 9, 0] } ],
    "joints": [ { "type": "spherical", "bodies": ["chain 2", "b"], "anchor": [3, 9, 0] } ])"));
  REQUIRE(s.model.joints.size() == 4);
  CHECK(s.model.joints[0].name == "joint 0");
  CHECK(s.model.joints[0].i == 5);
  CHECK(s.model.joints[0].j == 2);
  CHECK(s.model.joints[1].i == kWorld);
  CHECK(s.model.joints[1].j == 3);
}

TEST_CASE("bad joints are refused", "[scene]") {
  const std::vector<std::pair<std::string, std::vector<std::string>>> cases{
      {"5", {"/joints/0", "expected an object"}},
      {"{}", {"/joints/0/type", "missing", "\"hinge\""}},
      {R"({ "type": "hing" })", {"/joints/0/type", "did you mean \"hinge\"?"}},
      {R"({ "type": "hinge" })", {"/joints/0/bodies", "missing"}},
      {R"({ "type": "hinge", "bodies": ["a"] })", {"/joints/0/bodies", "two names"}},
      {R"({ "type": "hinge", "bodies": ["a", "b", "b"] })", {"/joints/0/bodies", "two names"}},
      {R"({ "type": "hinge", "bodies": "a" })", {"/joints/0/bodies", "array"}},
      {R"({ "type": "hinge", "bodies": ["a", 2] })", {"/joints/0/bodies/1", "name of a body, or null"}},
      {R"({ "type": "hinge", "bodies": ["pots", "a"] })",
       {"/joints/0/bodies/0", "no body \"pots\"", "did you mean \"post\"?"}},
      {R"({ "type": "hinge", "bodies": ["a", "a"] })", {"/joints/0/bodies", "itself"}},
      {R"({ "type": "hinge", "bodies": [null, null] })", {"/joints/0/bodies", "at least one movable"}},
      {R"({ "type": "hinge", "bodies": ["post", null] })", {"/joints/0/bodies", "at least one movable"}},
      {R"({ "type": "hinge", "bodies": ["a", "b"] })", {"/joints/0/anchor", "missing"}},
      {R"({ "type": "hinge", "bodies": ["a", "b"], "anchor": [0, 2e6, 0] })",
       {"/joints/0/anchor/1", "1000000"}},
      {R"({ "type": "hinge", "bodies": ["a", "b"], "anchor": [0, 0, 0] })", {"/joints/0/axis", "missing"}},
      {R"({ "type": "slider", "bodies": ["a", "b"], "anchor": [0, 0, 0], "axis": [0, 0, 0] })",
       {"/joints/0/axis", "not zero"}},
      {"{" + kBall + R"(, "axis": [0, 0, 1] })", {"/joints/0/axis", "unknown key"}},
      {"{" + kHinge + R"(, "limits": [10, -10] })", {"/joints/0/limits", "swap them"}},
      {"{" + kHinge + R"(, "limits": [10, 20] })", {"/joints/0/limits", "include 0"}},
      {"{" + kHinge + R"(, "limits": [-200, 20] })", {"/joints/0/limits/0", "degrees"}},
      {"{" + kHinge + R"(, "limits": [0] })", {"/joints/0/limits", "array of 2"}},
      {"{" + kHinge + R"(, "limits": [-1, 1], "drive": { "value": 0 } })",
       {"/joints/0/limits", "remove one of"}},
      {"{" + kHinge + R"(, "drive": 5 })", {"/joints/0/drive", "expected an object"}},
      {"{" + kHinge + R"(, "drive": {} })", {"/joints/0/drive", "either \"value\" or \"keys\""}},
      {"{" + kHinge + R"(, "drive": { "value": 1, "keys": [[0, 1]] } })", {"/joints/0/drive", "either"}},
      {"{" + kHinge + R"(, "drive": { "value": "fast" } })", {"/joints/0/drive/value", "degrees"}},
      {"{" + kHinge + R"(, "drive": { "value": [1, 2, 3] } })", {"/joints/0/drive/value", "a number"}},
      {"{" + kHinge + R"(, "drive": { "keys": [] } })", {"/joints/0/drive/keys", "at least one pair"}},
      {"{" + kHinge + R"(, "drive": { "keys": [[0, 1, 2]] } })", {"/joints/0/drive/keys/0", "a pair"}},
      {"{" + kHinge + R"(, "drive": { "keys": [[-1, 1]] } })", {"/joints/0/drive/keys/0/0", "(s)"}},
      {"{" + kHinge + R"(, "drive": { "keys": [[0, 1], [1, 2], [1, 3]] } })",
       {"/joints/0/drive/keys/2/0", "rising times"}},
      {"{" + kHinge + R"(, "drive": { "keys": [[0, 1], [1, 1e7]] } })", {"/joints/0/drive/keys/1/1"}},
      {"{" + kRod + R"(, "drive": { "value": 1 } })", {"/joints/0/drive", "unknown key"}},
      {"{" + kBall + R"(, "drive": { "value": 1 } })", {"/joints/0/drive/value", "array of 3"}},
      {"{" + kBall + R"(, "limits": [0, 1] })", {"/joints/0/limits", "unknown key"}},
      {"{" + kBall + R"(, "axes": "x" })", {"/joints/0/axes", "add \"drive\""}},
      {"{" + kBall + R"(, "axes": "zx", "drive": { "value": [0, 0, 0] } })", {"/joints/0/axes", "\"xz\""}},
      {"{" + kSlider + R"(, "twist": "loose" })", {"/joints/0/twist", "\"free\""}},
      {"{" + kSlider + R"(, "twist": true })", {"/joints/0/twist", "\"free\"", "limits"}},
      {"{" + kSlider + R"(, "twist": {} })", {"/joints/0/twist/limits", "missing"}},
      {"{" + kSlider + R"(, "twist": { "limits": [-181, 0] } })", {"/joints/0/twist/limits/0", "180"}},
      {"{" + kHinge + R"(, "twist": "free" })", {"/joints/0/twist", "unknown key"}},
      {"{" + kHinge + R"(, "arm": 0 })", {"/joints/0/arm", "1e-06"}},
      {"{" + kHinge + R"(, "symmetric": 1 })", {"/joints/0/symmetric", "true or false"}},
      {"{" + kHinge + R"(, "collide": "yes" })", {"/joints/0/collide", "true or false"}},
      {"{" + kHinge + R"(, "potential": "firm" })", {"/joints/0/potential", "\"soft\""}},
      {"{" + kHinge + R"(, "kappa": 0 })", {"/joints/0/kappa", "(N/m)"}},
      {"{" + kHinge + R"(, "kappa": 1e300, "potential": "hard" })", {"/joints/0/kappa", "(J)"}},
      {"{" + kHinge + R"(, "kappa": "stiff" })", {"/joints/0/kappa", "\"auto\""}},
      {"{" + kHinge + R"(, "N": 1, "potential": "hard" })", {"/joints/0/N", "from 2 to 32"}},
      {"{" + kHinge + R"(, "d_hat": 0 })", {"/joints/0/d_hat", "1e-09"}},
      {"{" + kRod + R"(, "length": -1 })", {"/joints/0/length", "(m)"}},
      {R"({ "type": "distance", "bodies": ["a", "b"], "points": [[0, 0, 0]] })",
       {"/joints/0/points", "two points"}},
      {R"({ "type": "distance", "bodies": ["a", "b"], "points": [[0, 0, 0], 1] })",
       {"/joints/0/points/1", "array of 3"}},
      {"{" + kRod + R"(, "arm": 1 })", {"/joints/0/arm", "unknown key"}},
      {"{" + kBall + R"(, "name": "" })", {"/joints/0/name", "at least one character"}},
      {"{" + kBall + R"(, "name": "x" }, {)" + kRod + R"(, "name": "x" })",
       {"/joints/1/name", "\"x\"", "different names"}}};
  for (const auto& [list, parts] : cases) check_refused(joints(list), parts);
}

TEST_CASE("every value of a joint changes the hash of the scene", "[scene]") {
  const std::string base = with_crates(R"("joints": [
    {)" + kHinge + R"(, "limits": [-1, 1], "arm": 0.5 }, {)" +
                                       kSlider + R"(, "drive": { "keys": [[0, 0], [1, 1]] } }, {)" + kBall +
                                       R"(, "drive": { "value": [0, 0, 0] } }, {)" + kRod + "} ]");
  std::vector<std::string> hashes{parse(base).hash};
  for (const char* change : {"joints.0.name=h",
                             "joints.0.bodies.1=post",
                             "joints.0.anchor.0=2",
                             "joints.0.axis.0=1",
                             "joints.0.limits.0=-2",
                             "joints.0.limits.1=2",
                             "joints.0.arm=0.6",
                             "joints.0.symmetric=false",
                             "joints.0.potential=hard",
                             "joints.0.kappa=5",
                             "joints.0.N=6",
                             "joints.0.d_hat=0.5",
                             "joints.0.collide=true",
                             "joints.1.twist=free",
                             "joints.1.twist={\"limits\":[0,1]}",
                             "joints.1.drive.keys.1.0=2",
                             "joints.1.drive.keys.1.1=2",
                             "joints.1.drive={\"value\":1}",
                             "joints.2.drive.value.2=3",
                             "joints.2.axes=xy",
                             "joints.3.points.0.0=1",
                             "joints.3.length=1"}) {
    INFO(change);
    hashes.push_back(parse(base, {change}).hash);
    for (std::size_t k = 0; k + 1 < hashes.size(); ++k) CHECK(hashes[k] != hashes.back());
  }
}

}  // namespace pabd::test_read_joints
