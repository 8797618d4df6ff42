// SPDX-License-Identifier: MIT
// See device_scenes.h.
#include "tests/device/device_scenes.h"
#include "tests/support/places.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/device/compute_program.h"
#include "render/gl/gl_objects.h"
#include "sim/body/compound.h"
#include "sim/body/convex_hull.h"
#include "sim/body/shape_kind.h"
#include "sim/scene/builder.h"

namespace pabd::testing {
namespace {

Shape hull() {
  std::vector<Vec3> corners;
  for (int k = 0; k < 6; ++k) {
    const double angle = k * 1.0471975511965976;
    corners.emplace_back(0.3 * std::cos(angle), -0.2, 0.3 * std::sin(angle));
    corners.emplace_back(0.2 * std::cos(angle), 0.25, 0.2 * std::sin(angle));
  }
  return Hull{make_hull(corners).hull};
}

Hull brick(const Vec3& lo, const Vec3& hi) {
  std::vector<Vec3> corners;
  for (int k = 0; k < 8; ++k)
    corners.emplace_back(k & 1 ? hi.x() : lo.x(), k & 2 ? hi.y() : lo.y(), k & 4 ? hi.z() : lo.z());
  return Hull{make_hull(corners).hull};
}

Shape angle() {
  return make_compound(
      {brick({0, 0, -0.15}, {0.45, 0.15, 0.15}), brick({0, 0.15, -0.15}, {0.15, 0.4, 0.15})});
}

}  // namespace

Shape bench() {
  return make_compound({brick({-0.5, -0.25, -0.5}, {-0.2, 0.25, 0.5}),
                        brick({0.2, -0.25, -0.5}, {0.5, 0.25, 0.5}),
                        brick({-0.2, -0.1, -0.5}, {0.2, 0.1, 0.5})});
}

void solve_exactly(Params& params) {
  params.solver.method = SolverMethod::descent;
  params.solver.iterations = 4000;
  params.solver.halvings = 0;  // what is compared is one solve
  params.solver.tolerance = 1e-9;
}

Scene exact_scene(const char* name) {
  Scene scene = load_scene(std::string(places::scenes()) + "/" + name + ".json");
  solve_exactly(scene.params);
  return scene;
}

Scene mixed_heap(int each, const Vec3& at, bool compounds) {
  SceneBuilder builder("heap");
  builder.params.contact.kappa = 2000;
  builder.params.contact.d_hat = 0.02;
  builder.params.h = 1.0 / 120;
  builder.params.solver.method = SolverMethod::descent;
  builder.params.solver.halvings = 0;
  builder.add(pabd::spec::Body{.name = "ground", .shape = Plane{{0, 1, 0}, at.y()}});
  std::vector<Shape> shapes = {Box{{0.25, 0.2, 0.3}},
                               Sphere{0.25},
                               Capsule{0.15, 0.4},
                               hull(),
                               make_shape("cylinder", {0.22, 0.4}),
                               make_shape("cone", {0.28, 0.5})};
  if (compounds) shapes.push_back(angle());
  const int kinds = static_cast<int>(shapes.size());
  for (int k = 0; k < kinds * each; ++k) {
    const double turn = 0.3 * k;
    builder.add(pabd::spec::Body{
        .name = {},
        .shape = shapes[static_cast<std::size_t>(k % kinds)],
        .density = 1000,
        .position = at + Vec3(0.45 * (k % 3), 0.5 + 0.55 * (k / 3), 0.1 * (k % 2)),
        .orientation = std::array{std::cos(turn), 0.6 * std::sin(turn), 0.0, 0.8 * std::sin(turn)}});
  }
  return builder.build();
}

Scene board_on_posts(int side) {
  SceneBuilder builder("board");
  solve_exactly(builder.params);
  builder.params.contact.mu_static = builder.params.contact.mu_dynamic = 0.5;
  for (int k = 0; k < side * side; ++k) {
    builder.add(spec::Body{.name = {},
                           .shape = Box{{0.2, 1.5, 0.2}},
                           .fixed = true,
                           .position = Vec3(0.5 * (k % side), 1.5, 0.5 * (k / side))});
  }
  const double middle = 0.25 * (side - 1);
  builder.add(spec::Body{.name = "board",
                         .shape = Box{{middle + 0.3, 0.1, middle + 0.3}},
                         .density = 100,
                         .position = Vec3(middle, 3.109, middle)});
  for (const double x : {0.3, middle}) {
    builder.add(spec::Body{
        .name = {}, .shape = Box{{0.2, 0.2, 0.2}}, .density = 100, .position = Vec3(x, 3.418, 0.6)});
  }
  return builder.build();
}

std::unique_ptr<GlContext> any_context() {
  std::vector<ContextAttempt> attempts;
  return create_headless_context(Backend::automatic, attempts);
}

bool keeps_doubles(GlContext& context) {
  const ComputeFunctions gl(context);
  const ComputeProgram program(gl, "private doubles", "", std::array{ShaderPart{"private doubles", R"glsl(
layout(local_size_x = 8) in;
layout(std430, binding = 0) buffer Numbers { double number[]; };
double kept[8];
void main() {
  const uint k = gl_LocalInvocationID.x;
  for (uint i = 0u; i <= k; ++i) kept[i] = number[i];
  number[8u + k] = kept[k];
}
)glsl"}});
  std::array<double, 16> numbers{};
  for (std::size_t k = 0; k < 8; ++k) numbers[k] = std::sqrt(2.0 + static_cast<double>(k));
  const GlBuffer buffer(gl);
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, buffer.id());
  gl.BufferData(GL_SHADER_STORAGE_BUFFER, sizeof numbers, numbers.data(), GL_STATIC_DRAW);
  program.use();
  gl.DispatchCompute(1, 1, 1);
  gl.MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  gl.GetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, sizeof numbers, numbers.data());
  return std::equal(numbers.begin(), numbers.begin() + 8, numbers.begin() + 8);
}

State run(const Scene& scene, const DeviceOptions& options, int steps, int* repeated) {
  const auto context = any_context();
  DeviceSolver device(*context, scene.model, scene.initial, options);
  for (int k = 0; k < steps; ++k) device.enqueue(scene.params);
  State out;
  device.read_state(out);
  if (repeated) *repeated = device.repeated();
  return out;
}

double pose_difference(const State& a, const State& b) {
  double largest = a.c.size() == b.c.size() ? 0 : INFINITY;
  for (std::size_t i = 0; i < std::min(a.c.size(), b.c.size()); ++i) {
    largest = std::max({largest, (a.c[i] - b.c[i]).norm(), (a.R[i] - b.R[i]).norm()});
  }
  return largest;
}

Scene slope_of_own_friction(FrictionRule rule) {
  SceneBuilder builder("own");
  solve_exactly(builder.params);
  builder.params.contact.friction_rule = rule;
  builder.params.gravity = {4, -9, 0};  // a slope of 24°: tan is 0.44
  builder.add(
      spec::Body{.name = "ground", .shape = Plane{{0, 1, 0}, 0}, .friction = SurfaceFriction{0.5, 0.5}});
  const double mu[] = {0.1, 0.3, 0.6, 1.2};
  for (int k = 0; k < 4; ++k) {
    for (const double y : {0.2595, 0.7595}) {  // the upper one falls through the lower one
      builder.add(spec::Body{.shape = Box{{0.4, 0.25, 0.4}},
                             .mass = 20,
                             .position = Vec3(0, y, 2.0 * k),
                             .friction = SurfaceFriction{mu[k], mu[k]},
                             .groups = {y < 0.5 ? "low" : "high"}});
    }
  }
  builder.add(spec::Body{.shape = Box{{0.4, 0.25, 0.4}}, .mass = 20, .position = Vec3(0, 0.2595, 9)});
  builder.add(spec::NoCollide{spec::Group{"low"}, spec::Group{"high"}});
  return builder.build();
}

}  // namespace pabd::testing
