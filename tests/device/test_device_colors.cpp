// SPDX-License-Identifier: MIT
// Bodies coloured by numbers that never leave the GPU: the picture is that of the processor, which reads them back.
#include <catch2/catch.hpp>
#include <cmath>

#include "render/device/device_bodies.h"
#include "render/output/png.h"
#include "render/visual/body_parts.h"
#include "render/visual/palette.h"
#include "sim/body/mass_properties.h"
#include "sim/solver/time_step.h"
#include "tests/device/device_pictures.h"
#include "tests/device/device_scenes.h"
#include "tests/support/tiny_model.h"

namespace pabd::test_device_colors {

using namespace testing;

namespace {

constexpr int kWidth = 640, kHeight = 360;

std::vector<double> read_values(const ComputeFunctions& gl, unsigned buffer, std::size_t count) {
  std::vector<float> values(count);
  gl.MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  gl.BindBuffer(GL_SHADER_STORAGE_BUFFER, buffer);
  gl.GetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, static_cast<GLsizeiptr>(count * sizeof(float)),
                      values.data());
  return {values.begin(), values.end()};
}

double largest_of(const std::vector<double>& values) {
  double out = 0;
  for (const double v : values) out = std::isfinite(v) ? std::max(out, v) : out;
  return out;
}

CompareResult compare(Renderer& renderer, const Twin& twin, DeviceBodies& bodies) {
  return compare_images(picture(renderer, twin.bare, {}, &bodies), picture(renderer, twin.all, {}, nullptr),
                        CompareTier::same_class);
}

}  // namespace

TEST_CASE("the picture of bodies coloured by speed and energy is the same from the GPU's own numbers") {
  const auto context = any_context();
  const ComputeFunctions gl(*context);
  const Scene scene = mixed_heap(8, {3, 0, -2});
  DeviceSolver solver(*context, scene.model, scene.initial);
  for (int k = 0; k < 60; ++k) solver.enqueue(scene.params);
  State state;
  solver.read_state(state);
  Renderer renderer(*context, kWidth, kHeight);
  DeviceBodies bodies(*context, body_parts(scene.model), solver.pose_buffer(), {.late_bounds = false});
  const Camera camera = frame_camera(scene.model, state, double{kWidth} / kHeight);

  const bool energy = GENERATE(false, true);
  const unsigned buffer = solver.value_buffer(energy ? BodyQuantity::energy : BodyQuantity::speed);
  VisualOptions options;
  if (energy) {
    options.values = read_values(gl, buffer, scene.model.shape.size());
  } else {
    for (const Vec3& v : state.v) options.values.push_back(v.norm());
  }
  const float largest = bodies.largest(buffer);
  CHECK(largest == Approx(largest_of(options.values)).epsilon(1e-6));
  CHECK(largest > 0);
  options.value_range = round_range(largest, 1e-6, energy);
  const Twin twin(scene.model, state, options, camera);
  bodies.color_by(buffer, options.value_range);
  const CompareResult result = compare(renderer, twin, bodies);
  CAPTURE(energy, result.reason, result.max_difference, result.differing);
  CHECK(same_but_edges(*context, result));
  // The colours are those of the values, not of the palette; and those come back.
  const Twin plain(scene.model, state, {}, camera);
  CHECK_FALSE(compare(renderer, plain, bodies).equal);
  bodies.color_by(0, {});
  CHECK(same_but_edges(*context, compare(renderer, plain, bodies)));
}

TEST_CASE(
    "values that are none, below and beyond the range, and bodies that do not move have the processor's "
    "colours") {
  const auto context = any_context();
  const ComputeFunctions gl(*context);
  TinyModel tiny;
  tiny.add_fixed(Box{{0.4, 0.4, 0.4}}, {0, 0.4, 3});
  const double none = std::nan(""), infinite = INFINITY;
  std::vector<double> values = {-infinite};
  for (const double v : {none, infinite, -1.0, 0.0, 1e-5, 1e-4, 3e-4, 0.01, 0.3, 0.999, 1.0, 7.0}) {
    tiny.add(Box{{0.4, 0.4, 0.4}}, {static_cast<double>(values.size()) - 8, 0.4, 0});
    values.push_back(v);
  }
  VisualOptions options;
  options.values = values;
  options.value_range = {1e-4, 1, GENERATE(false, true)};
  options.looks.resize(1);
  options.looks[0].color = Vec3(0.9, 0.1, 0.2);
  const std::vector<float> floats(values.begin(), values.end());
  GlBuffer buffer(gl);
  gl.BindBuffer(GL_SHADER_STORAGE_BUFFER, buffer.id());
  gl.BufferData(GL_SHADER_STORAGE_BUFFER, static_cast<GLsizeiptr>(floats.size() * sizeof(float)),
                floats.data(), GL_STATIC_DRAW);
  const PoseBuffer poses(gl, tiny.state);
  Renderer renderer(*context, kWidth, kHeight);
  VisualOptions own = options;
  own.values.clear();
  DeviceBodies bodies(*context, body_parts(tiny.model, own), poses.id(), {.late_bounds = false});
  CHECK(bodies.largest(buffer.id()) == 7);
  const Twin twin(tiny.model, tiny.state, options,
                  frame_camera(tiny.model, tiny.state, double{kWidth} / kHeight));
  bodies.color_by(buffer.id(), options.value_range);
  const CompareResult result = compare(renderer, twin, bodies);
  if (const char* folder = std::getenv("PABD_KEEP_IMAGES")) {
    write_png(std::string(folder) + "/values_cpu.png", picture(renderer, twin.all, {}, nullptr));
    write_png(std::string(folder) + "/values_gpu.png", picture(renderer, twin.bare, {}, &bodies));
  }
  CAPTURE(options.value_range.logarithmic, result.reason, result.max_difference, result.differing);
  CHECK(same_but_edges(*context, result));
}

TEST_CASE("energies of bodies are those that the processor reports") {
  const auto context = any_context();
  const ComputeFunctions gl(*context);
  const Scene scene = exact_scene("stack");
  DeviceSolver solver(*context, scene.model, scene.initial, {.precision = DevicePrecision::twofold});
  // Before there was a step it is all kinetic.
  const auto at_rest = read_values(gl, solver.value_buffer(BodyQuantity::energy), scene.model.shape.size());
  CHECK(largest_of(at_rest) == 0);
  for (int k = 0; k < 20; ++k) solver.enqueue(scene.params);
  State state;
  solver.read_state(state);
  StepOptions options;
  options.report_bodies = true;
  StepWorkspace workspace;
  StepReport report;
  step(scene.model, scene.params, options, state, workspace, report);
  solver.enqueue(scene.params);
  const auto values = read_values(gl, solver.value_buffer(BodyQuantity::energy), scene.model.shape.size());
  const StepSummary& told = solver.finish();
  CHECK(told.elastic == Approx(report.elastic).epsilon(1e-4));
  CHECK(told.contacts == report.contacts);
  double of_contacts = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    CAPTURE(i);
    if (scene.model.fixed[i]) {
      CHECK(values[i] == -INFINITY);
      continue;
    }
    const Vec3 w = state.R[i].transpose() * state.omega[i];
    const double kinetic =
        0.5 * (scene.model.mass[i] * state.v[i].squaredNorm() + w.dot(inertia_tensor(scene.model.J[i]) * w));
    of_contacts += report.body_reports[i].contact_energy;
    CHECK(values[i] == Approx(kinetic + report.body_reports[i].contact_energy).epsilon(1e-3));
  }
  CHECK(of_contacts > 0.3 * report.elastic);  // half of those with the floor is nobody's here
}

}  // namespace pabd::test_device_colors
