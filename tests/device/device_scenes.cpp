// SPDX-License-Identifier: MIT
// See device_scenes.h.
#include "tests/device/device_scenes.h"

#include <algorithm>

#include "sim/body/convex_hull.h"
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

}  // namespace

void solve_exactly(Params& params) {
  params.solver.method = SolverMethod::descent;
  params.solver.iterations = 4000;
  params.solver.tolerance = 1e-9;
}

Scene exact_scene(const char* name) {
  Scene scene = load_scene(std::string(PABD_SCENES) + "/" + name + ".json");
  solve_exactly(scene.params);
  return scene;
}

Scene mixed_heap(int each, const Vec3& at) {
  SceneBuilder builder("heap");
  builder.params.contact.kappa = 2000;
  builder.params.contact.d_hat = 0.02;
  builder.params.h = 1.0 / 120;
  builder.params.solver.method = SolverMethod::descent;
  builder.add(pabd::spec::Body{.name = "ground", .shape = Plane{{0, 1, 0}, at.y()}});
  const Shape shapes[] = {Box{{0.25, 0.2, 0.3}}, Sphere{0.25}, Capsule{0.15, 0.4}, hull()};
  for (int k = 0; k < 4 * each; ++k) {
    const double turn = 0.3 * k;
    builder.add(pabd::spec::Body{
        .name = {},
        .shape = shapes[k % 4],
        .density = 1000,
        .position = at + Vec3(0.45 * (k % 3), 0.5 + 0.55 * (k / 3), 0.1 * (k % 2)),
        .orientation = std::array{std::cos(turn), 0.6 * std::sin(turn), 0.0, 0.8 * std::sin(turn)}});
  }
  return builder.build();
}

std::unique_ptr<GlContext> any_context() {
  std::vector<ContextAttempt> attempts;
  return create_headless_context(Backend::automatic, attempts);
}

double pose_difference(const State& a, const State& b) {
  double largest = a.c.size() == b.c.size() ? 0 : INFINITY;
  for (std::size_t i = 0; i < std::min(a.c.size(), b.c.size()); ++i) {
    largest = std::max({largest, (a.c[i] - b.c[i]).norm(), (a.R[i] - b.R[i]).norm()});
  }
  return largest;
}

}  // namespace pabd::testing
