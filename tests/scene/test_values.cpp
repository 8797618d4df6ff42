// SPDX-License-Identifier: MIT
// What a scene says arrives in the model, the state and the parameters; defaults are the documented ones.
#include <variant>

#include "tests/scene/scene_helpers.h"

namespace pabd::test_values {

using namespace test;

TEST_CASE("defaults of a scene that says nothing", "[scene]") {
  const Scene s = parse(with_body(""));
  const Params defaults;
  CHECK(s.name == "test");
  CHECK(s.params.gravity == defaults.gravity);
  CHECK(s.params.h == defaults.h);
  CHECK(s.params.solver.method == SolverMethod::automatic);
  CHECK(s.params.solver.iterations == 20);
  CHECK(s.params.contact.N == 3);
  CHECK_FALSE(s.params.contact.kappa.has_value());
  CHECK(s.params.contact.mu_static == 0.5);
  CHECK(s.params.contact.mu_dynamic == 0.5);
  CHECK_FALSE(s.camera.has_value());
  CHECK(s.model.no_collide.empty());
  REQUIRE(s.model.size() == 1);
  // ρ V = 1000 · 4/3 π 0.5³
  CHECK(s.model.mass[0] == Approx(1000 * 4.0 / 3 * kPi * 0.125).epsilon(1e-14));
  CHECK(s.initial.c[0] == Vec3::Zero());
  CHECK(s.initial.R[0] == Mat3::Identity());
  CHECK(s.initial.time == 0);
  CHECK(s.initial.step == 0);
}

TEST_CASE("every parameter is read", "[scene]") {
  const Scene s = parse(with_body(R"(
    "name": "all", "description": "every key", "$schema": "x.json", "gravity": [1, 2, 3], "time_step": 0.01,
    "solver": { "method": "sissm", "iterations": 7, "tolerance": 0, "relaxation": 0.25, "projection": "weighted" },
    "contact": { "barrier": "even", "N": 4, "d_hat": 0.03, "kappa": 12.5, "onset": 0.5,
                 "friction": { "static": 0.4, "dynamic": 0.3 } },
    "joints_default": { "potential": "hard", "kappa": "auto", "N": 2, "d_hat": 0.1 }, "joints": [],
    "camera": { "eye": [1, 2, 3], "target": [4, 5, 6], "fov": 30 })"));
  CHECK(s.name == "all");
  CHECK(s.description == "every key");
  CHECK(s.params.gravity == Vec3(1, 2, 3));
  CHECK(s.params.h == 0.01);
  CHECK(s.params.solver.method == SolverMethod::sissm);
  CHECK(s.params.solver.iterations == 7);
  CHECK(s.params.solver.tolerance == 0);
  CHECK(s.params.solver.relaxation == 0.25);
  CHECK(s.params.solver.projection == Projection::weighted);
  CHECK(s.params.contact.barrier == BarrierKind::even);
  CHECK(s.params.contact.N == 4);
  CHECK(s.params.contact.d_hat == 0.03);
  CHECK(s.params.contact.kappa == 12.5);
  CHECK(s.params.contact.onset == 0.5);
  CHECK(s.params.contact.mu_static == 0.4);
  CHECK(s.params.contact.mu_dynamic == 0.3);
  CHECK(s.joint_law.potential == BondPotential::hard);
  CHECK(s.joint_law.N == 2);
  CHECK(s.joint_law.d_hat == 0.1);
  CHECK(s.joint_law.kappa > 0);
  REQUIRE(s.camera.has_value());
  CHECK(s.camera->eye == Vec3(1, 2, 3));
  CHECK(s.camera->target == Vec3(4, 5, 6));
  CHECK(s.camera->fov == 30);
}

TEST_CASE("the words of choices", "[scene]") {
  CHECK(parse(with_body(R"("solver": { "method": "descent" })")).params.solver.method ==
        SolverMethod::descent);
  CHECK(parse(with_body(R"("solver": { "method": "newton" })")).params.solver.method == SolverMethod::newton);
  CHECK(parse(with_body(R"("solver": { "method": "auto" })")).params.solver.method ==
        SolverMethod::automatic);
  CHECK(parse(with_body(R"("solver": { "projection": "polar" })")).params.solver.projection ==
        Projection::polar);
  CHECK(parse(with_body(R"("contact": { "barrier": "log" })")).params.contact.barrier == BarrierKind::log);
  CHECK(parse(with_body(R"("contact": { "barrier": "polynomial" })")).params.contact.barrier ==
        BarrierKind::polynomial);
  CHECK_FALSE(parse(with_body(R"("contact": { "kappa": "auto" })")).params.contact.kappa.has_value());
}

TEST_CASE("friction: dynamic follows static, one number stands for both", "[scene]") {
  const Scene a = parse(with_body(R"("contact": { "friction": { "static": 0.3 } })"));
  CHECK(a.params.contact.mu_static == 0.3);
  CHECK(a.params.contact.mu_dynamic == 0.3);
  const Scene b = parse(with_body(R"("contact": { "friction": 0.7 })"));
  CHECK(b.params.contact.mu_static == 0.7);
  CHECK(b.params.contact.mu_dynamic == 0.7);
}

TEST_CASE("whole numbers may be written as 3.0", "[scene]") {
  CHECK(parse(with_body(R"("contact": { "N": 5.0 })")).params.contact.N == 5);
}

TEST_CASE("bodies: shapes, mass, pose, velocities", "[scene]") {
  const Scene s = parse(only_body(R"(
    { "name": "ground", "shape": { "type": "plane", "normal": [0, 3, 4], "offset": 2 } },
    { "shape": { "type": "box", "size": [1, 2, 4] }, "density": 500, "position": [1, 2, 3],
      "orientation": [0.70745, 0, 0, 0.70745], "velocity": [4, 5, 6], "angular_velocity": [0, 180, 360] },
    { "name": "c", "shape": { "type": "capsule", "radius": 0.25, "length": 0.5 }, "mass": 7 },
    { "name": "post", "shape": { "type": "box", "size": [1, 1, 1] }, "fixed": true, "density": 10 })"));
  REQUIRE(s.model.size() == 4);
  CHECK(s.model.name == std::vector<std::string>{"ground", "body 1", "c", "post"});

  const auto& plane = std::get<Plane>(s.model.shape[0]);
  CHECK((plane.normal - Vec3(0, 0.6, 0.8)).norm() < 1e-15);
  CHECK(plane.offset == 2);
  CHECK(s.model.fixed == std::vector<std::uint8_t>{1, 0, 0, 1});
  CHECK(s.model.mass[0] == 0);

  CHECK(std::get<Box>(s.model.shape[1]).half == Vec3(0.5, 1, 2));
  CHECK(s.model.mass[1] == Approx(4000).epsilon(1e-14));
  CHECK(s.model.J[1](0, 0) == Approx(4000 / 12.0).epsilon(1e-14));  // m a²/12, a = 1
  CHECK(s.model.J[1](2, 2) == Approx(4000 * 16 / 12.0).epsilon(1e-14));
  CHECK(s.initial.c[1] == Vec3(1, 2, 3));
  CHECK(s.initial.v[1] == Vec3(4, 5, 6));
  CHECK((s.initial.omega[1] - Vec3(0, kPi, 2 * kPi)).norm() < 1e-14);
  // A quarter turn about z, whose quaternion was 5e-4 too long: normalised.
  Mat3 quarter;
  quarter << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  CHECK((s.initial.R[1] - quarter).norm() < 1e-15);

  CHECK(s.model.mass[2] == 7);
  CHECK(s.model.mass[3] == 0);
  CHECK(s.model.J[3].isZero(0));
}

}  // namespace pabd::test_values
