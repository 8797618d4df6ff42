// SPDX-License-Identifier: MIT
// MJCF: where the links of an arm stand, what they weigh, what holds them; a tree of bodies that falls.
#include <cmath>
#include <fstream>

#include <fmt/format.h>

#include "sim/body/compound.h"
#include "sim/body/mass_properties.h"
#include "sim/body/shape.h"
#include "tests/import/import_helpers.h"
#include "tests/support/places.h"
#include "tests/support/temp_folder.h"

namespace pabd::test_mjcf {

using namespace test;

namespace {

const std::filesystem::path kModels = places::tests() + "/import/models";

bool apart(const Scene& scene, std::size_t a, std::size_t b) {
  const std::pair pair(static_cast<Index>(std::min(a, b)), static_cast<Index>(std::max(a, b)));
  const auto& pairs = scene.model.no_collide;
  return std::binary_search(pairs.begin(), pairs.end(), pair);
}

}  // namespace

TEST_CASE("an MJCF arm stands and weighs what it says", "[import]") {
  const ImportedScene imported = import_robot(kModels / "arm.xml");
  const ImportedRun run(imported.text);
  const Model& model = run.scene.model;
  CHECK(run.scene.params.h == 0.002);
  // The floor, four links, and a light body between the two hinges of the shoulder.
  REQUIRE(model.size() == 6);
  REQUIRE(model.joints.size() == 5);
  const std::size_t palm = run.body("palm"), wrist = run.body("wrist"), shoulder = run.body("shoulder");
  // Turned by 30 degrees about y, which points down; z is up and becomes y.
  const double c = std::cos(kPi / 6), s = std::sin(kPi / 6);
  CHECK((run.state.c[palm] - Vec3(0.35 + 0.55 * c, 1 - 0.55 * s, 0)).norm() < 1e-12);
  CHECK((run.state.c[wrist] - Vec3(0.35 + 0.40 * c, 1 - 0.40 * s, 0)).norm() < 1e-12);
  // A capsule of radius 0.04 m and 0.3 m between its caps; a box.
  const double r = 0.04;
  CHECK(model.mass[shoulder] == Approx(500 * kPi * r * r * (0.3 + 4.0 / 3 * r)).epsilon(1e-12));
  CHECK(model.mass[palm] == Approx(1000 * 0.06 * 0.1 * 0.04).epsilon(1e-12));
  // The box's longest edge is along the robot's y in every pose here.
  const Vec3 y = run.state.R[palm].transpose() * Vec3(0, 0, -1);
  CHECK(y.dot(inertia_tensor(model.J[palm]) * y) ==
        Approx(model.mass[palm] / 12 * (0.0036 + 0.0016)).epsilon(1e-9));

  CHECK(apart(run.scene, shoulder, wrist));
  CHECK_FALSE(apart(run.scene, shoulder, palm));
  int held = 0, lifts = 0;
  for (const Joint& joint : model.joints) {
    held += joint.action && joint.action->spring.stiffness == 100 ? 1 : 0;
    if (joint.name != "lift") continue;
    ++lifts;
    REQUIRE(joint.limits);
    CHECK(joint.limits->lo == Approx(-kPi / 2));
  }
  CHECK(held == 1);
  CHECK(lifts == 1);
  const ImportNote motor = note_with(imported, "motor or velocity actuator");
  REQUIRE(motor.where.size() == 1);
  CHECK(motor.where[0].second == 32);
}

TEST_CASE("an arm that swings keeps its energy but for the losses of implicit steps", "[import]") {
  // Until its slider comes to its end, which it meets without bouncing.
  double lost[2] = {}, fallen = 0;
  for (int k = 0; k < 2; ++k) {
    ImportedRun run(import_robot(kModels / "arm.xml").text, {"time_step=" + std::to_string(0.001 / (k + 1))});
    const Model& model = run.scene.model;
    const auto height = [&] {
      double sum = 0;
      for (std::size_t i = 0; i < model.mass.size(); ++i) sum += 9.81 * model.mass[i] * run.state.c[i].y();
      return sum;
    };
    const auto kinetic = [&] {
      double sum = 0;
      for (std::size_t i = 0; i < model.mass.size(); ++i) {
        const Vec3 spin = run.state.R[i].transpose() * run.state.omega[i];
        sum += 0.5 * model.mass[i] * run.state.v[i].squaredNorm();
        sum += 0.5 * spin.dot(inertia_tensor(model.J[i]) * spin);
      }
      return sum;
    };
    const double start = height();
    run.run(0.1);
    fallen = start - height();
    lost[k] = fallen - kinetic();
  }
  REQUIRE(fallen > 0.2);  // it does swing; J
  CHECK(lost[0] > 0);
  // The losses go with the step.
  CHECK(std::abs(2 * lost[1] - lost[0]) < 1e-3 * fallen);
}

TEST_CASE("a tree of bodies falls freely, then lies on the ground", "[import]") {
  ImportedRun run(import_robot(kModels / "tree.xml").text, {"time_step=0.002", "solver.integrator=euler"});
  const Model& model = run.scene.model;
  const auto centre = [&] {
    Vec3 sum = Vec3::Zero();
    double mass = 0;
    for (std::size_t i = 0; i < model.mass.size(); ++i) {
      sum += model.mass[i] * run.state.c[i];
      mass += model.mass[i];
    }
    return Vec3(sum / mass);
  };
  const Vec3 start = centre();
  run.run(0.2);
  // Joints move no common centre: by Euler y falls by g h² n (n + 1)/2.
  CHECK(start.y() - centre().y() == Approx(9.81 * 4e-6 * 100 * 101 / 2).epsilon(1e-6));
  CHECK(std::hypot(centre().x() - start.x(), centre().z() - start.z()) < 1e-8);
  run.run(2.5);
  const std::size_t trunk = run.body("trunk");
  CHECK(run.state.c[trunk].y() < 0.5);
  for (std::size_t i = 0; i < model.mass.size(); ++i) {
    if (model.fixed[i]) continue;
    INFO(model.name[i]);
    CHECK(bounds(model.shape[i], run.state.c[i], run.state.R[i]).lo.y() > -0.005);
  }
}

TEST_CASE("what falls hardly bounces, whatever the step", "[import]") {
  for (const double h : {0.005, 0.002, 0.0005}) {
    constexpr int kPhases = 6;  // where within a step it hits decides how much is left
    double sum = 0;
    for (int k = 0; k < kPhases; ++k) {
      const double height = 0.3 + 2 * h * k / kPhases;
      ImportedRun run(import_robot_text(fmt::format("<mujoco><option timestep='{}'/><worldbody>"
                                                    "<geom type='plane' size='1 1 1'/><body pos='0 0 {}'>"
                                                    "<geom size='0.1' mass='40'/><freejoint/></body>"
                                                    "</worldbody></mujoco>",
                                                    h, height),
                                        "ball.xml", {})
                          .text);
      const std::size_t ball = run.body("link 1");
      double hit = 0, left = 0;
      while (run.state.time < 0.5) {
        run.run(run.state.time + h);
        hit = std::max(hit, -run.state.v[ball].y());
        left = std::max(left, run.state.v[ball].y());
      }
      CAPTURE(h, height);
      // It has fallen to the ground, but for d̂ and a step.
      CHECK(hit == Approx(std::sqrt(2 * 9.81 * (height - 0.1))).epsilon(0.05));
      CHECK(left < 0.16 * hit);
      CHECK(run.state.c[ball].y() == Approx(0.1).margin(0.006));
      sum += left / hit;
    }
    CHECK(sum / kPhases < 0.12);
  }
}

TEST_CASE("what MuJoCo is told not to compute is not there", "[import]") {
  const auto scene = [](const std::string& flags) {
    return parse_scene(import_robot_text("<mujoco><option><flag " + flags + R"(/></option><worldbody>
        <geom type='plane' size='1 1 1'/><body name='a' pos='0 0 1'><freejoint/><geom size='0.1'/></body>
        <body name='b' pos='1 0 1'><joint range='-10 10'/><geom size='0.1'/></body></worldbody>
        <equality><connect body1='a' body2='b' anchor='0 0 0'/></equality></mujoco>)",
                                         "m.xml", {})
                           .text,
                       "m", {});
  };
  const Scene all = scene("energy='enable'");
  CHECK(all.params.gravity.norm() == Approx(9.81));
  CHECK(all.model.joints.size() == 2);
  CHECK(all.model.no_collide.size() == 1);  // of what is connected
  CHECK(scene("gravity='disable'").params.gravity.norm() == 0);
  CHECK(scene("equality='disable'").model.joints.size() == 1);
  CHECK_FALSE(scene("limit='disable' equality='disable'").model.joints[0].limits);
  CHECK(scene("contact='disable'").model.no_collide.size() == 3);
}

TEST_CASE("a round geom beside the centre of mass stays round", "[import]") {
  const ImportedScene imported =
      import_robot_text(R"(<mujoco><worldbody><body pos='0 0 1' euler='0 90 0'><freejoint/>
      <inertial pos='0.1 0 0.02' mass='2' diaginertia='.02 .03 .03'/>
      <geom type='cylinder' size='0.2 0.05' pos='0 0 0.03' euler='30 0 0'/></body></worldbody></mujoco>)",
                        "m.xml", {});
  for (const ImportNote& note : imported.notes) CHECK(note.text.find("polyhedron") == std::string::npos);
  const Scene s = parse_scene(imported.text, "m", {});
  REQUIRE(s.model.size() == 1);
  const CompoundPart* part = off_centre(s.model.shape[0]);
  REQUIRE(part);
  CHECK(std::holds_alternative<Solid>(part->shape));
  // z of the robot is y here, its y is -z: turned about y by 90 degrees its x points down and its z along x.
  CHECK((s.initial.c[0] - Vec3(0.02, 1 - 0.1, 0)).norm() < 1e-9);
  CHECK((s.initial.c[0] + s.initial.R[0] * part->offset - Vec3(0.03, 1, 0)).norm() < 1e-9);
  CHECK(s.model.mass[0] == 2);
  const Mat3 I = s.initial.R[0] * inertia_tensor(s.model.J[0]) * s.initial.R[0].transpose();
  CHECK((I - Vec3(0.03, 0.02, 0.03).asDiagonal().toDenseMatrix()).norm() < 1e-9);
}

TEST_CASE("an equality of two joints makes one follow the other", "[import]") {
  const auto scene = [](const std::string& equality, const std::string& flags = "") {
    const auto finger = [](const std::string& name) {
      return "<body name='" + name + "' pos='0 1 0'><joint name='" + name +
             " joint'/><geom size='0.1'/></body>";
    };
    return import_robot_text("<mujoco><option><flag " + flags + "/></option><worldbody>" + finger("a") +
                                 finger("b") + "</worldbody><equality>" + equality + "</equality></mujoco>",
                             "m.xml", {});
  };
  const std::string plain = "<joint joint1='b joint' joint2='a joint'";
  const auto follows = [&](const std::string& equality, const std::string& flags = "") {
    return parse_scene(scene(equality, flags).text, "m", {}).model.joints[1].follows;
  };
  REQUIRE(follows(plain + "/>"));
  CHECK(follows(plain + "/>")->ratio == 1);
  CHECK(follows(plain + " polycoef='0.3 -2 0 0 0'/>")->ratio == -2);
  CHECK(follows(plain + " polycoef='0.3 -2 0 0 0'/>")->offset == Approx(0.3));
  CHECK_FALSE(follows(plain + " active='false'/>"));
  CHECK_FALSE(follows(plain + "/>", "equality='disable'"));
  CHECK_FALSE(follows(plain + " polycoef='0 1 2 0 0'/>"));
  note_with(scene(plain + " polycoef='0 1 2 0 0'/>"), "above the first order");
  CHECK_FALSE(follows("<joint joint1='b joint'/>"));
  CHECK_THROWS_WITH(scene("<joint joint1='c'/>"), Catch::Contains("there is no joint"));
}

TEST_CASE("friction of a geom has the kinds that its condim asks for", "[import]") {
  const auto friction = [](const std::string& geom) {
    const std::string robot =
        "<mujoco><worldbody><geom type='plane' size='1 1 1' friction='3 4 5' condim='6'/>"
        "<body pos='0 0 1'><freejoint/><geom size='0.1' " +
        geom + "/></body></worldbody></mujoco>";
    const ImportedScene imported = import_robot_text(robot, "m.xml", {});
    for (const ImportNote& note : imported.notes) CHECK(note.text.find("condim") == std::string::npos);
    return *parse_scene(imported.text, "m", {}).model.friction[1];
  };
  CHECK(friction("") == SurfaceFriction{1, 1});
  CHECK(friction("friction='0.7 0.02 0.001'") == SurfaceFriction{0.7, 0.7});
  CHECK(friction("friction='0.7 0.02 0.001' condim='1'") == SurfaceFriction{0, 0});
  CHECK(friction("friction='0.7 0.02 0.001' condim='4'") == SurfaceFriction{0.7, 0.7, 0.02, 0});
  CHECK(friction("friction='0.7 0.02 0.001' condim='6'") == SurfaceFriction{0.7, 0.7, 0.02, 0.001});
  CHECK(friction("condim='6'") == SurfaceFriction{1, 1, 0.005, 0.0001});
  CHECK_THROWS_WITH(friction("friction='0.7 -1'"), Catch::Contains("is negative"));
}

TEST_CASE("defaults of a nested class may stand in a file of their own", "[import]") {
  const TempFolder folder;
  std::ofstream(folder / "heavy.xml") << "<mujoco><geom mass='7'/></mujoco>";
  const ImportedScene imported = import_robot_text(R"(<mujoco>
      <default><default class='heavy'><include file='heavy.xml'/></default></default>
      <worldbody><body><freejoint/><geom class='heavy' size='0.1'/></body></worldbody></mujoco>)",
                                                   "m.xml", folder.path());
  CHECK(parse_scene(imported.text, "m", {}).model.mass[0] == Approx(7));
}

TEST_CASE("a free joint beside others is refused, as in MuJoCo", "[import]") {
  for (const char* joints : {"<freejoint/><joint/>", "<joint/><freejoint/>"})
    CHECK_THROWS_WITH(import_robot_text("<mujoco><worldbody><body>" + std::string(joints) +
                                            "<geom size='1'/></body></worldbody></mujoco>",
                                        "m.xml", {}),
                      Catch::Contains("a free joint beside others"));
}

TEST_CASE("what is connected to a link that is left out is not pinned to the world instead", "[import]") {
  const ImportedScene imported = import_robot_text(R"(<mujoco><worldbody>
      <body name='a' pos='0 0 1'><freejoint/><geom size='0.1'/></body>
      <body name='nothing' pos='1 0 1'><joint/></body></worldbody>
      <equality><connect body1='nothing' body2='a' anchor='0 0 0'/></equality></mujoco>)",
                                                   "m.xml", {});
  CHECK(note_with(imported, "holds a link that was left out").where[0].second == 4);
  CHECK(parse_scene(imported.text, "m", {}).model.joints.empty());
}

TEST_CASE("a primitive is fitted to a mesh by its moments", "[import]") {
  // The corner of a cube: moments of m/10 along (1, 1, 1) and of m/16 across. MuJoCo has the same sphere for it.
  const auto with = [](const std::string& type) {
    return parse_scene(
        import_robot_text(
            "<mujoco><asset><mesh name='m' vertex='0 0 0  1 0 0  0 1 0  0 0 1'/></asset><worldbody><body>"
            "<freejoint/><geom mesh='m' " +
                type + "/></body></worldbody></mujoco>",
            "m.xml", {})
            .text,
        "m", {});
  };
  const double small = std::sqrt(0.0375), large = std::sqrt(0.15);
  const Scene ball = with("");
  CHECK(std::get<Sphere>(ball.model.shape[0]).radius == Approx((small + 2 * large) / 3).epsilon(1e-12));
  CHECK(ball.model.mass[0] == Approx(140.826).epsilon(1e-5));
  // z, which is turned up, is y.
  CHECK((ball.initial.c[0] - Vec3(0.25, 0.25, -0.25)).norm() < 1e-12);
  const Scene can = with("type='cylinder'");
  const Aabb box = bounds(can.model.shape[0], Vec3::Zero(), Mat3::Identity());
  CHECK((box.hi - Vec3((small + large) / 2, large, (small + large) / 2)).norm() < 1e-12);
}

TEST_CASE("a concave mesh is told with its line, and with how much larger its hull is", "[import]") {
  // Three cubes of 1 m in an L; the hull has a wedge of half a cube more.
  const TempFolder folder;
  std::ofstream(folder / "l.obj") << "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\n"
                                     "v 0 0 1\nv 2 0 1\nv 2 1 1\nv 1 1 1\nv 1 2 1\nv 0 2 1\n"
                                     "f 4 3 2 1\nf 6 5 4 1\nf 7 8 9 10\nf 7 10 11 12\nf 1 2 8 7\nf 2 3 9 8\n"
                                     "f 3 4 10 9\nf 4 5 11 10\nf 5 6 12 11\nf 6 1 7 12\n";
  const std::string robot =
      "<mujoco><asset><mesh file='l.obj'/></asset><worldbody><body>\n"
      "<geom type='mesh' mesh='l' density='2'/><freejoint/></body></worldbody></mujoco>";
  const ImportedScene imported = import_robot_text(robot, "l.xml", folder.path());
  const ImportNote note = note_with(imported, "\"l.obj\" is concave");
  CHECK_THAT(note.text, Catch::Contains("of 1.17 times its volume"));
  CHECK(note.where == std::vector{std::pair(std::string("l.xml"), 2)});
  CHECK(parse_scene(imported.text, "l", {}).model.mass[0] == Approx(6).epsilon(1e-12));
}

}  // namespace pabd::test_mjcf
