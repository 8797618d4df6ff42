// SPDX-License-Identifier: MIT
// Figure 6 of the supplement.
#include "app/overlay/figure6.h"

#include <fmt/format.h>

#include "app/plots/axis_ticks.h"
#include "render/visual/build_visual.h"
#include "render/visual/contact_glyphs.h"
#include "sim/collision/detect.h"
#include "sim/solver/time_step.h"

namespace pabd {

std::optional<ContactReport> deepest_contact(const Model& model, const Params& params, const State& state,
                                             const Vec3& from) {
  CollisionWorkspace workspace;
  std::vector<ContactPoint> points;
  const std::vector<double> reach(static_cast<std::size_t>(model.size()), 0.5 * params.contact.d_hat);
  detect(model, state.c, state.R, reach, {}, 1, workspace, points);
  const ContactPoint* deepest = nullptr;
  for (const ContactPoint& point : points) {
    const double tie = 1e-6 * params.contact.d_hat;
    if (!deepest || point.d < deepest->d - tie ||
        (point.d < deepest->d + tie && (point.y_a - from).norm() < (deepest->y_a - from).norm())) {
      deepest = &point;
    }
  }
  if (!deepest) return std::nullopt;
  const Barrier barrier{params.contact.barrier, params.contact.N, params.contact.d_hat,
                        resolve_kappa(model, params), params.contact.onset};
  ContactReport report{};
  report.a = deepest->a;
  report.b = deepest->b;
  report.y_a = deepest->y_a;
  report.y_b = deepest->y_b;
  report.n = deepest->n;
  report.d = deepest->d;
  report.normal_force = -evaluate(barrier, deepest->d).first;
  report.friction = Vec3::Zero();
  report.sticking = true;
  return report;
}

Figure6 figure6(const Model& model, const Params& params, const State& state, double aspect,
                const Camera* camera) {
  Figure6 out;
  out.scene.camera = camera ? *camera : frame_camera(model, state, aspect);
  const Vec3 eye = out.scene.camera.eye.cast<double>();
  StepReport report;
  const std::optional<ContactReport> pair = deepest_contact(model, params, state, eye);
  if (pair) report.contact_reports.push_back(*pair);
  VisualOptions options;
  options.bonds = true;
  options.d_hat = params.contact.d_hat;
  build_visual(model, state, report, options, out.scene);
  // The bodies would hide a pair inside them, so they are drawn as glass.
  for (Instance& instance : out.scene.instances[static_cast<int>(Primitive::cube)]) instance.color.w() = 0.5f;
  if (!pair) {
    out.caption = "No two bodies are within d̂ of each other.";
    return out;
  }
  const double size = static_cast<double>(out.scene.radius);
  const Vec3 n = pair->n;
  const double length = 0.38 * size, head = 0.07 * size;
  const Vec4f dark(0.02f, 0.03f, 0.05f, 1);
  const auto part = [&](Primitive primitive, const Vec3& at, double sxz, double sy) {
    out.scene.instances[static_cast<int>(primitive)].push_back(
        {place_along(at, n, sxz, sy), dark, false, false});
  };
  part(Primitive::cylinder, pair->y_a + 0.5 * (length - head) * n, 0.007 * size, 0.5 * (length - head));
  part(Primitive::cone, pair->y_a + (length - head) * n, 0.024 * size, head);
  // Labels stand beside what they name, across the line of sight and the normal.
  Vec3 side = (pair->y_a - eye).cross(n);
  side = side.norm() > 1e-9 * size ? side.normalized() : Vec3::UnitX();
  const auto label = [&](const Vec3& at, const char* text) {
    out.scene.labels.push_back({at.cast<float>(), text});
  };
  label(pair->y_a - 0.08 * size * side, "*{y}_{i}");
  label(pair->y_b + 0.08 * size * side, "*{y}_{j}");
  label(pair->y_a + length * n + 0.07 * size * side, "*{n}_{i}");
  out.caption = fmt::format("The chosen contact pair: *{{y}}_{{i}} on {}, *{{y}}_{{j}} on {}, *{{d}} = {} m",
                            model.name[static_cast<std::size_t>(pair->a)],
                            model.name[static_cast<std::size_t>(pair->b)], format_value(pair->d));
  return out;
}

}  // namespace pabd
