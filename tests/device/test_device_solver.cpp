// SPDX-License-Identifier: MIT
// The solver on the GPU against the processor's, and against theory. On software GL too.
#include <catch2/catch.hpp>

#include <cstring>

#include "render/device/compute_functions.h"
#include "render/device/device_layout.h"
#include "sim/body/convex_hull.h"
#include "sim/body/shape_kind.h"
#include "sim/scene/builder.h"
#include "sim/solver/time_step.h"
#include "tests/device/device_scenes.h"
#include "tests/device/wrapped_context.h"
#include "tests/support/places.h"
#include "tests/support/sanitized.h"

namespace pabd::test_device_solver {

using namespace testing;

namespace {

#ifdef PABD_SANITIZED
constexpr int kSteps = 4;
#else
constexpr int kSteps = 30;
#endif

// One step by each from the same state, again and again.
void check_steps(const Scene& scene, int warm_up, double same, int steps = kSteps) {
  const auto context = any_context();
  const bool exact = keeps_doubles(*context);
  if (!exact) same = 1e-6;
  DeviceOptions options;
  options.precision = DevicePrecision::twofold;
  options.report_contacts = true;
  State state = scene.initial, there;
  StepWorkspace workspace;
  StepReport report;
  for (int k = 0; k < warm_up; ++k) step(scene.model, scene.params, {}, state, workspace, report);
  DeviceSolver device(*context, scene.model, state, options);
  StepOptions detailed;
  detailed.report_contacts = true;
  std::vector<ContactReport> contacts;
  int converged = 0;
  for (int k = 0; k < steps; ++k) {
    CAPTURE(k);
    device.set_state(state);
    const StepSummary summary = device.step(scene.params);
    device.read_state(there);
    device.read_contacts(contacts);
    step(scene.model, scene.params, detailed, state, workspace, report);
    REQUIRE(there.step == state.step);
    if (summary.status != StepStatus::converged || report.status != StepStatus::converged) continue;
    ++converged;
    REQUIRE(pose_difference(there, state) < same);
    for (std::size_t i = 0; i < state.v.size(); ++i) {
      REQUIRE((there.v[i] - state.v[i]).norm() < same / scene.params.h);
      REQUIRE((there.omega[i] - state.omega[i]).norm() < 10 * same / scene.params.h);
    }
    CHECK(summary.kinetic == Approx(report.kinetic).epsilon(exact ? 1e-6 : 1e-3).margin(1e-6));
    CHECK(summary.potential == Approx(report.potential).epsilon(1e-9));
    CHECK(summary.elastic == Approx(report.elastic).epsilon(exact ? 1e-4 : 1e-2).margin(1e-6));
    CHECK(summary.max_normal_force ==
          Approx(report.max_normal_force).epsilon(exact ? 1e-4 : 1e-2).margin(1e-6));
    REQUIRE(summary.contacts == report.contacts);
    REQUIRE(contacts.size() == report.contact_reports.size());
    REQUIRE(there.contacts.size() == state.contacts.size());
    for (std::size_t c = 0; c < state.contacts.size(); ++c) {
      REQUIRE(there.contacts[c].pair == state.contacts[c].pair);
      REQUIRE(there.contacts[c].feature == state.contacts[c].feature);
      REQUIRE((there.contacts[c].stretch - state.contacts[c].stretch).norm() < 10 * same);
    }
  }
  CHECK(converged > steps / 3);
}

}  // namespace

TEST_CASE("a step on the GPU in double is the processor's: a stack") {
  check_steps(exact_scene("stack"), 20, 1e-9);
}
TEST_CASE("a step on the GPU in double is the processor's: two boxes that start deep in each other") {
  Scene scene = exact_scene("two_boxes");
  scene.initial.c[2].y() +=
      1e-4;  // 0.1 m of overlap is 2 d̂, from where on it comes apart slowly: a matter of rounding
  check_steps(scene, 0, 1e-9);
}
TEST_CASE("a step on the GPU in double is the processor's: sliding and sticking on a slope") {
  check_steps(exact_scene("incline"), 0, 1e-9);
}
TEST_CASE("a step on the GPU in double is the processor's: bodies with friction of their own, and groups") {
  for (const FrictionRule rule : {FrictionRule::geometric_mean, FrictionRule::average, FrictionRule::min,
                                  FrictionRule::max, FrictionRule::product}) {
    CAPTURE(to_string(rule));
    check_steps(slope_of_own_friction(rule), 0, 1e-8, kSteps / 2);
  }
}
TEST_CASE("a step on the GPU in double is the processor's: a heap of all shapes, falling along parabolas") {
  Scene scene = mixed_heap(3, Vec3::Zero(), true);
  scene.params.solver.integrator = Integrator::bdf2;
  solve_exactly(scene.params);
  scene.params.contact.mu_static = scene.params.contact.mu_dynamic = 0.2;  // of more, few steps have a limit
  check_steps(scene, 30, 1e-8, kSteps / 3);
}
TEST_CASE("a step on the GPU in double is the processor's: a board that touches a hundred corners") {
  check_steps(board_on_posts(5), 0, 1e-9);
}

// Half a metre high, with the corners that they stand on.
struct Standing {
  const char* name;
  Shape shape;
  int corners;
};
std::vector<Standing> standing() {
  return {{"box", Box{{0.5, 0.25, 0.5}}, 4},
          {"cylinder", make_shape("cylinder", {0.5, 0.5}), 8},
          {"cone", make_shape("cone", {0.5, 1}), 8},  // its centre a quarter up
          {"compound", bench(), 8}};
}

TEST_CASE("bodies on the GPU rest where their weight says, to 1e-5 d̂ in float") {
  for (const Standing& body : standing()) {
    CAPTURE(body.name);
    SceneBuilder builder("rest");
    builder.params.contact.kappa = 50;
    builder.params.contact.N = 2;
    builder.params.contact.onset = 0;
    builder.params.contact.barrier = BarrierKind::even;
    builder.params.solver.iterations = 200;
    builder.add(spec::Body{.name = "ground", .shape = Plane{{0, 1, 0}, 0}});
    builder.add(spec::Body{.name = "body", .shape = body.shape, .mass = 20, .position = Vec3(0, 0.257, 0)});
    const Scene scene = builder.build();
    const State state = run(scene, {}, 400);
    // The corners carry m g = n κ u/d̂, B' of the even barrier of order 2 being −u/d̂.
    const double d_hat = 0.01, u = 20 * 9.81 * d_hat / (body.corners * 50);
    CHECK(state.c[1].y() - 0.25 == Approx(d_hat * (1 - u)).margin(1e-5 * d_hat));
    CHECK(state.v[1].norm() < 1e-5);
  }
}

TEST_CASE("every barrier that the GPU takes is its own there, and one that it does not know is refused") {
  const double d_hat = 0.01, weight = 20 * 9.81;
  for (const BarrierKind kind : kBarrierKinds) {
    CAPTURE(to_string(kind));
    SceneBuilder builder("rest");
    builder.params.contact.kappa = 2;
    builder.params.contact.barrier = kind;
    builder.params.solver.iterations = 200;
    builder.add(spec::Body{.name = "ground", .shape = Plane{{0, 1, 0}, 0}});
    builder.add(
        spec::Body{.name = "box", .shape = Box{{0.5, 0.25, 0.5}}, .mass = 20, .position = Vec3(0, 0.257, 0)});
    const Scene scene = builder.build();
    const std::string why = DeviceSolver::why_not(scene.model, scene.params);
    CHECK(why.empty() == device::is_on_device(kind));
    if (!why.empty()) {
      CHECK_THAT(
          why, Catch::Contains(std::string(to_string(kind)) + " barrier") && Catch::Contains("--device cpu"));
      continue;
    }
    // Each of the four corners carries −Ψ' = m g/4, which grows with the overlap.
    const ContactParams& contact = scene.params.contact;
    const Barrier barrier{kind, contact.N, d_hat, *contact.kappa, contact.onset};
    double lo = -10 * d_hat, hi = d_hat;
    for (int k = 0; k < 60; ++k) {
      const double d = (lo + hi) / 2;
      (evaluate(barrier, d).first < -weight / 4 ? lo : hi) = d;
    }
    const State state = run(scene, {}, 400);
    CHECK(state.c[1].y() - 0.25 == Approx(lo).margin(1e-5 * d_hat));
  }
  CHECK(device::is_on_device(BarrierKind::quadratic));
  CHECK_FALSE(device::is_on_device(BarrierKind::log));
  CHECK_FALSE(device::is_on_device(static_cast<BarrierKind>(kBarrierKinds.size())));
}

TEST_CASE("Coulomb's law holds on the GPU in float: tan of the slope against μ") {
  for (const Standing& body : standing()) {
    for (const double degrees : {26.0, 27.2}) {
      CAPTURE(body.name, degrees);
      const double angle = degrees * 0.017453292519943295;
      SceneBuilder builder("slope");
      builder.params.gravity = 9.81 * Vec3(std::sin(angle), -std::cos(angle), 0);
      builder.params.solver.iterations = 200;
      builder.add(spec::Body{.name = "ground", .shape = Plane{{0, 1, 0}, 0}});
      builder.add(
          spec::Body{.name = "body", .shape = body.shape, .mass = 20, .position = Vec3(0, 0.2595, 0)});
      const Scene scene = builder.build();
      const State early = run(scene, {}, 60), late = run(scene, {}, 120);
      const double acceleration = 9.81 * (std::sin(angle) - 0.5 * std::cos(angle));
      const double gained = late.v[1].x() - early.v[1].x();
      CHECK(gained == Approx(std::max(0.0, acceleration)).epsilon(0.01).margin(1e-4));
    }
  }
}

TEST_CASE("a cylinder on the GPU rolls down a slope with two thirds of what slides without friction") {
  constexpr double kAngle = 0.1;
  SceneBuilder builder("rolling");
  builder.params.gravity = 9.81 * Vec3(std::sin(kAngle), -std::cos(kAngle), 0);
  builder.params.solver.iterations = 200;
  builder.add(spec::Body{.name = "ground", .shape = Plane{{0, 1, 0}, 0}});
  const double half = std::sqrt(0.5);
  builder.add(spec::Body{.name = "roller",
                         .shape = make_shape("cylinder", {0.4, 1}),
                         .mass = 20,
                         .position = Vec3(0, 0.4095, 0),
                         .orientation = std::array{half, half, 0.0, 0.0}});
  const Scene scene = builder.build();
  const State early = run(scene, {}, 30), late = run(scene, {}, 90);
  const double gained = late.v[1].x() - early.v[1].x();
  CHECK(gained == Approx(2.0 / 3 * 9.81 * std::sin(kAngle) * 60 * scene.params.h).epsilon(0.01));
}

// Forces act on both bodies along one line at the end of the step, while they have moved past each other: angular
// momentum is kept to first order in the step, and balanced afterwards of two that meet alone.
TEST_CASE("momentum is kept when bodies meet on the GPU in float") {
  const auto change = [](double h, bool third = false) {
    SceneBuilder builder("free");
    builder.params.gravity = Vec3::Zero();
    builder.params.h = h;
    builder.params.solver.iterations = 400;
    builder.params.solver.tolerance = 1e-7;
    builder.add(
        spec::Body{.name = "a", .shape = Box{{0.5, 0.5, 0.5}}, .mass = 20, .velocity = Vec3(2, 0, 0)});
    builder.add(spec::Body{.name = "b",
                           .shape = Sphere{0.4},
                           .mass = 5,
                           .position = Vec3(1.2, 0.2, 0.1),
                           .velocity = Vec3(-3, 0, 0)});
    if (third)
      builder.add(spec::Body{.name = "c",
                             .shape = Sphere{0.4},
                             .mass = 5,
                             .position = Vec3(2.003, 0.2, 0.1),
                             .velocity = Vec3(-3, 0, 0)});
    const Scene scene = builder.build();
    const auto momentum = [&](const State& s) {
      Vec3 p = Vec3::Zero(), L = p;
      for (std::size_t i = 0; i < scene.model.mass.size(); ++i) {
        const Mat3 J = scene.model.J[i], I = J.trace() * Mat3::Identity() - J;
        p += scene.model.mass[i] * s.v[i];
        L += scene.model.mass[i] * s.c[i].cross(s.v[i]) + s.R[i] * I * s.R[i].transpose() * s.omega[i];
      }
      return std::pair(p, L);
    };
    const State end = run(scene, {}, static_cast<int>(0.5 / h));
    REQUIRE(end.v[0].x() < 1.5);  // they met
    const auto [p, L] = momentum(scene.initial);
    const auto [q, M] = momentum(end);
    return std::pair((p - q).norm() / p.norm(), (L - M).norm() / L.norm());
  };
  const auto [linear, angular] = change(1.0 / 60);
  const auto [fine_linear, fine_angular] = change(1.0 / 480);
  CHECK(linear < 1e-5);
  CHECK(fine_linear < 1e-5);
  CHECK(angular < 1e-5);
  CHECK(fine_angular < 1e-5);
  // Of three as well as the solve came to its end.
  const double of_three = change(1.0 / 60, true).second, fine_of_three = change(1.0 / 480, true).second;
  CHECK(of_three < 0.05);
  CHECK(fine_of_three < of_three / 3);
}

TEST_CASE("ten kilometres away a heap on the GPU behaves as at the origin") {
  const Vec3 far(8000, 2048, -6000);
  const Scene here = mixed_heap(2), there = mixed_heap(2, far);
  const int steps = 20;
  const State a = run(here, {}, steps), b = run(there, {}, steps);
  for (std::size_t i = 1; i < a.c.size(); ++i) {
    CAPTURE(i);
    CHECK((a.c[i] - (b.c[i] - far)).norm() < 1e-5);
  }
}

TEST_CASE("the same bits come from the GPU in every run, however much room there was at first") {
  const Scene scene = mixed_heap(3);
  const State roomy = run(scene, {}, 2 * kSteps);
  int repeated = 0;
  DeviceOptions tight;
  tight.pairs = tight.contacts = 1;
  CHECK(same_bits(roomy, run(scene, {}, 2 * kSteps)));
  CHECK(same_bits(roomy, run(scene, tight, 2 * kSteps, &repeated)));
  CHECK(repeated >= 2);
}

TEST_CASE("the same bits come from the GPU in every run where bodies are crowded") {
  const Scene scene = mixed_heap(3);
  DeviceOptions crowded;
  crowded.team = 1;
  crowded.few = 2;
  crowded.crowd = 5;
  int repeated = 0;
  const State first = run(scene, crowded, 2 * kSteps, &repeated);
  CHECK(repeated >= 1);  // nobody knew of crowds
  CHECK(same_bits(first, run(scene, crowded, 2 * kSteps)));
  crowded.pairs = crowded.contacts = 1;
  CHECK(same_bits(first, run(scene, crowded, 2 * kSteps)));
}

TEST_CASE("what rests on the GPU keeps its contacts, and rests where it would without") {
  // Small enough that the sweeps converge: of what does not, a hundred sweeps more move the top by 0.1 d̂.
  constexpr int kRows = 6;
  SceneBuilder builder("pyramid");
  builder.params.solver.method = SolverMethod::descent;
  builder.params.solver.iterations = 400;
  builder.params.contact.mu_static = builder.params.contact.mu_dynamic = 0.5;
  builder.add(spec::Body{.name = "ground", .shape = Plane{{0, 1, 0}, 0}});
  for (int row = 0; row < kRows; ++row) {
    for (int k = 0; k + row < kRows; ++k) {
      builder.add(spec::Body{.name = {},
                             .shape = Box{{0.25, 0.25, 0.25}},
                             .density = 1000,
                             .position = Vec3(0.55 * (k + 0.5 * row), 0.259 + 0.509 * row, 0)});
    }
  }
  const Scene scene = builder.build();
  const auto context = any_context();
  State with, without;
  for (const bool keep : {true, false}) {
    DeviceOptions options;
    options.keep_contacts = keep;
    DeviceSolver device(*context, scene.model, scene.initial, options);
    for (int k = 0; k < 60; ++k) device.enqueue(scene.params);
    device.read_state(keep ? with : without);
    if (keep) {
      CHECK(device.kept_pairs() > 9 * device.pairs() / 10);
    } else {
      CHECK(device.kept_pairs() == 0);
    }
  }
  const double d_hat = scene.params.contact.d_hat;
  for (std::size_t i = 0; i < with.c.size(); ++i) {
    CAPTURE(i);
    CHECK((with.c[i] - without.c[i]).norm() < 1e-4 * d_hat);
  }
}

TEST_CASE("the GPU refuses what it cannot solve, with words that help") {
  const auto why = [](const char* name) {
    const Scene scene = load_scene(std::string(places::scenes()) + "/" + name + ".json");
    return DeviceSolver::why_not(scene.model, scene.params);
  };
  CHECK(why("pyramid").empty());
  CHECK(why("pendulum").find("joints") != std::string::npos);
  CHECK(why("pendulum").find("--device cpu") != std::string::npos);
  CHECK(why("shapes").empty());
  SceneBuilder builder("drum");
  std::vector<Vec3> corners;
  for (int k = 0; k < 32; ++k)
    for (const double y : {-0.5, 0.5}) corners.emplace_back(std::cos(0.19 * k), y, std::sin(0.19 * k));
  builder.add(spec::Body{.name = "drum", .shape = Hull{make_hull(corners).hull}, .density = 1000});
  const Scene drum = builder.build();
  CHECK(DeviceSolver::why_not(drum.model, drum.params) ==
        "body 'drum' has 34 faces, the GPU takes at most 32: --device cpu");
}

TEST_CASE("the large scenes are as large as they say, and the GPU takes them") {
  const auto load = [](const char* name) {
    return load_scene(std::string(places::scenes()) + "/../large/" + name + ".json");
  };
  const Scene avalanche = load("avalanche");
  CHECK(avalanche.model.size() == 100'005);
  CHECK(DeviceSolver::why_not(avalanche.model, avalanche.params).empty());
#ifndef PABD_SANITIZED
  const Scene million = load("million");
  CHECK(million.model.size() > 1'000'000);
  CHECK(DeviceSolver::why_not(million.model, million.params).empty());
#endif
}

namespace {

// A context whose GPU is lost while the solver waits.
class LostContext : public WrappedContext {
 public:
  using WrappedContext::WrappedContext;
  void* proc_address(const char* name) override {
    if (std::strcmp(name, "glClientWaitSync") == 0) return reinterpret_cast<void*>(&fail_to_wait);
    return WrappedContext::proc_address(name);
  }

 private:
  static GLenum APIENTRY fail_to_wait(GLsync, GLbitfield, GLuint64) { return GL_WAIT_FAILED; }
};

}  // namespace

TEST_CASE("a GPU that is lost in the middle ends with an error, not with a wait") {
  const auto context = any_context();
  LostContext lost(*context);
  const Scene scene = mixed_heap(1);
  DeviceSolver device(lost, scene.model, scene.initial);
  CHECK_THROWS_WITH(device.step(scene.params), Catch::Contains("lost"));
}

}  // namespace pabd::test_device_solver
