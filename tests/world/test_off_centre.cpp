// SPDX-License-Identifier: MIT
// Bodies whose centre of mass is not that of their shape, against closed forms.
#include <catch2/catch.hpp>
#include <cmath>

#include "sim/body/mass_properties.h"
#include "sim/body/shape_kind.h"
#include "sim/scene/write_scene.h"
#include "tests/world/world.h"

namespace pabd::test_off_centre {

using namespace world;

namespace {

constexpr double kRadius = 0.2, kMass = 2, kGap = 0.01;  // d̂: where nothing pushes yet

// I about the centre of mass and the axis of rolling, z.
double inertia_about_z(const Run& run, const std::string& name) {
  return inertia_tensor(run.scene.model.J[static_cast<std::size_t>(run[name])])(2, 2);
}

}  // namespace

// A tumbler rolls to and fro with ω² = m g b/(I + m (r − b)²), b how far its centre of mass lies below its centre.
TEST_CASE("a tumbler rights itself with the period of theory") {
  const double h = GENERATE(1.0 / 240, 1.0 / 1000), below = GENERATE(0.02, 0.1);
  const std::vector<Shape> shapes{Sphere{kRadius}, make_shape("cylinder", {kRadius, 0.3}),
                                  Capsule{kRadius, 0.2}};
  for (const Shape& shape : shapes) {
    // Round about z: the axis y of the shape lies along it.
    const bool lies = !std::holds_alternative<Sphere>(shape);
    Setting setting(h, 0.8);
    setting.ground();
    const double start = 0.1;  // rad
    const Vec3 com = lies ? Vec3(0, 0, below) : Vec3(0, -below, 0);
    const spec::AxisAngle turned{Vec3::UnitZ(), start * 180 / kPi};
    spec::Body body{
        .shape = shape, .mass = kMass, .position = Vec3(0, kRadius + kGap, 0), .center_of_mass = com};
    body.orientation = turned;
    if (lies) {  // about x by 90°, then about z
      const Quat q =
          Quat(Eigen::AngleAxisd(start, Vec3::UnitZ())) * Quat(Eigen::AngleAxisd(kPi / 2, Vec3::UnitX()));
      body.orientation = spec::Orientation(q.w(), q.x(), q.y(), q.z());
    }
    const std::string name = setting.add(body);
    Run run(setting);
    const Index i = run[name];
    const double arm = kRadius - below;  // friction acts at the surface of what is round
    const double inertia = lies ? inertia_tensor(run.scene.model.J[static_cast<std::size_t>(i)])(1, 1)
                                : inertia_about_z(run, name);
    const double omega = std::sqrt(kMass * kG * below / (inertia + kMass * arm * arm));
    std::vector<double> crossings;
    double before = run.omega(name).z();
    run.go(3.2 * 2 * kPi / omega, [&] {
      const double now = run.omega(name).z();
      if (before < 0 && now >= 0) crossings.push_back(run.state.time - h * now / (now - before));
      before = now;
    });
    CAPTURE(h, below, shape.index(), omega);
    REQUIRE(crossings.size() >= 2);
    const double period = (crossings.back() - crossings.front()) / static_cast<double>(crossings.size() - 1);
    CHECK(period == Approx(2 * kPi / omega).epsilon(0.01));
    CHECK(run.rise < 1e-4);
  }
}

TEST_CASE("what flies turns about its centre of mass, wherever its shape is") {
  Setting setting(1.0 / 60);
  const std::string name = setting.add(spec::Body{.shape = Box{{0.3, 0.1, 0.1}},
                                                  .mass = kMass,
                                                  .position = Vec3(0, 5, 0),
                                                  .center_of_mass = Vec3(0.2, 0, 0),
                                                  .velocity = Vec3(1, 2, 0),
                                                  .angular_velocity = Vec3(0, 0, 300)});
  Run run(setting);
  CHECK(run.c(name) == Vec3(0.2, 5, 0));
  run.go(0.5);
  CHECK((run.c(name) - Vec3(0.7, 5 + 1 - 0.125 * kG, 0)).norm() < 1e-12);
}

TEST_CASE("a box over an edge stays as its centre of mass says, not as its shape does") {
  const double h = GENERATE(1.0 / 60, 1.0 / 240);
  for (const double beyond : {-0.03, 0.03}) {
    Setting setting(h, 0.6);
    setting.add(Box{{1, 0.5, 1}}, 0, {-1, 0.5, 0});  // a table that ends at x = 0
    const std::string name = setting.add(spec::Body{.shape = Box{{0.3, 0.1, 0.2}},
                                                    .mass = kMass,
                                                    .position = Vec3(0.1, 1.1 + kGap, 0),
                                                    .center_of_mass = Vec3(beyond - 0.1, 0, 0)});
    Run run(setting);
    run.go(1.5);
    CAPTURE(h, beyond);
    CHECK((run.c(name).y() < 1) == (beyond > 0));
    if (beyond < 0) CHECK(run.kinetic() < 1e-9);
  }
}

TEST_CASE("an unbalanced wheel rolls without making energy") {
  // Contacts are of first order: a centre that circles loses about (ω h)² a turn.
  const auto [h, kept] =
      GENERATE(table<double, double>({{1.0 / 60, 0.2}, {1.0 / 240, 0.7}, {1.0 / 1000, 0.9}}));
  Setting setting(h, 0.8);
  setting.ground();
  const double b = 0.08;
  const std::string name = setting.add(spec::Body{.shape = make_shape("cylinder", {kRadius, 0.1}),
                                                  .mass = kMass,
                                                  .position = Vec3(0, kRadius + kGap, 0),
                                                  .orientation = along_z(),
                                                  .center_of_mass = Vec3(b, 0, 0)});
  Run run(setting);
  run.send(name, {2, -b * 2 / kRadius, 0}, {0, 0, -2 / kRadius});
  run.go(3);
  CAPTURE(h);
  CHECK(run.rise < 1e-3 * kMass * 4);
  CHECK(run.kinetic() + kMass * kG * (run.c(name).y() - kRadius) > kept * 0.5 * kMass * 4);
  CHECK(run.unsolved == 0);
}

TEST_CASE("a saved scene has the centre of mass where it was") {
  Setting setting(1.0 / 60);
  setting.ground();
  setting.add(spec::Body{.name = "tumbler",
                         .shape = Sphere{kRadius},
                         .mass = kMass,
                         .position = Vec3(0.3, 0.5, 0),
                         .orientation = spec::AxisAngle{Vec3(1, 2, 3), 40},
                         .center_of_mass = Vec3(0.03, -0.05, 0.01)});
  Run run(setting);
  run.go(0.2);
  const Scene& scene = run.scene;
  const std::string text =
      scene_to_json(scene.model, run.state, scene.params, scene.joint_law, "saved", {}, {});
  const Scene again = parse_scene(text, "saved.json", {});
  CHECK((again.initial.c[1] - run.state.c[1]).norm() < 1e-15);
  CHECK((again.model.J[1] - scene.model.J[1]).norm() < 1e-15);
  CHECK(text.find("center_of_mass") != std::string::npos);
}

}  // namespace pabd::test_off_centre
