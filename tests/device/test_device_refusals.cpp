// SPDX-License-Identifier: MIT
// What the GPU as the maker of steps refuses, and what it says of it.
#include <catch2/catch.hpp>

#include "render/device/device_engine.h"
#include "sim/body/compound.h"
#include "tests/support/errors.h"
#include "tests/support/tiny_model.h"

namespace pabd::test_device_refusals {

namespace {

TinyModel ball() {
  TinyModel tiny;
  tiny.add_fixed(Plane{Vec3::UnitY(), 0}, Vec3::Zero());
  tiny.add(Sphere{0.5}, Vec3(0, 0.505, 0));
  return tiny;
}

}  // namespace

TEST_CASE("what it cannot do is refused with the remedy, and the state stays") {
  DeviceEngine engine(Backend::automatic);
  const TinyModel tiny = ball();
  const State start = tiny.state;
  const auto refused = [&](const char* words, const Params& params, const StepOptions& options) {
    State state = start;
    StepReport report;
    const Caught error = caught([&] { engine.step(tiny.model, params, options, state, report); });
    CAPTURE(words, error.text);
    CHECK(error.kind == bad_input);
    CHECK(error.says(words));
    CHECK(error.says("--device cpu"));
    CHECK(same_bits(state, start));
  };
  StepOptions options;
  options.record_iterations = true;
  refused("iterations", Params{}, options);
  options = {};
  options.report_bodies = true;
  refused("bodies", Params{}, options);
  options = {};
  options.report_joints = true;
  refused("joints", Params{}, options);
  options = {};
  options.pulls = {Pull{0, Vec3::Zero(), Vec3::Zero(), 1}};
  refused("hands", Params{}, options);
  // Also after steps that it made.
  State state = start;
  StepReport made;
  engine.step(tiny.model, Params{}, {}, state, made);
  Params params;
  params.solver.method = SolverMethod::newton;
  refused("not by newton", params, {});
  params = {};
  params.contact.barrier = BarrierKind::log;
  refused("log barrier", params, {});
  TinyModel joined = ball();
  joined.model.joints.emplace_back();
  CHECK(DeviceEngine::why_not(joined.model, Params{}, {}).find("joints") != std::string::npos);
  CHECK(DeviceEngine::why_not(tiny.model, Params{}, {}).empty());
  Params bounces;
  bounces.contact.restitution = 0.5;
  CHECK(DeviceEngine::why_not(tiny.model, bounces, {}).find("restitution") != std::string::npos);
  Params damped, rolls, spins;
  damped.contact.damping = 0.01;
  rolls.contact.rolling = spins.contact.torsional = 0.01;
  CHECK(DeviceEngine::why_not(tiny.model, damped, {}).find("damping") != std::string::npos);
  CHECK(DeviceEngine::why_not(tiny.model, rolls, {}).find("rolling") != std::string::npos);
  CHECK(DeviceEngine::why_not(tiny.model, spins, {}).find("torsional") != std::string::npos);
  TinyModel beside = ball();
  for (Shape& shape : beside.model.shape)
    if (!is_plane(shape)) shape = with_centre_of_mass(shape, Vec3(0.01, 0, 0));
  CHECK(DeviceEngine::why_not(beside.model, Params{}, {}).find("centre of mass") != std::string::npos);
  TinyModel pushed = ball();
  pushed.model.external.resize(2);
  pushed.model.external[1] = ExternalForce{Keyed<Vec3>{{{0, Vec3::UnitX()}}}, {}};
  CHECK(DeviceEngine::why_not(pushed.model, Params{}, {}).find("forces act") != std::string::npos);
}

}  // namespace pabd::test_device_refusals
