// Figure 6 of the supplement.
#include "app/overlay/figure6.h"

#include <fmt/format.h>

#include "app/plots/axis_ticks.h"
#include "render/visual/build_visual.h"
#include "sim/collision/detect.h"
#include "sim/solver/time_step.h"

namespace pabd {

std::optional<ContactReport> deepest_contact(const Model& model, const Params& params, const State& state) {
  CollisionWorkspace workspace;
  std::vector<ContactPoint> points;
  const std::vector<double> reach(static_cast<std::size_t>(model.size()), 0.5 * params.contact.d_hat);
  detect(model, state.c, state.R, reach, {}, 1, workspace, points);
  const ContactPoint* deepest = nullptr;
  for (const ContactPoint& point : points) {
    if (!deepest || point.d < deepest->d) deepest = &point;
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

Figure6 figure6(const Model& model, const Params& params, const State& state, double aspect) {
  Figure6 out;
  StepReport report;
  const std::optional<ContactReport> pair = deepest_contact(model, params, state);
  if (pair) report.contact_reports.push_back(*pair);
  VisualOptions options;
  options.bonds = true;
  options.contacts = true;
  options.d_hat = params.contact.d_hat;
  build_visual(model, state, report, options, out.scene);
  out.scene.camera = frame_camera(model, state, aspect);
  // Bodies hide the chosen pair where they overlap, so they are drawn as glass.
  for (auto& list : out.scene.instances) {
    for (Instance& instance : list) {
      if (instance.shaded && instance.shadow) instance.color.w() = 0.55f;
    }
  }
  if (!pair) {
    out.caption = "No two bodies are within d̂ of each other.";
    return out;
  }
  const double offset = 0.07 * static_cast<double>(out.scene.radius);
  const Vec3 n = pair->n;
  // Beside the points, across the view and the normal, so that the labels do not cover what they name.
  const Vec3 view = (out.scene.camera.target - out.scene.camera.eye).cast<double>();
  Vec3 side = view.cross(n);
  side = side.norm() > 1e-9 * view.norm() ? side.normalized() : Vec3::UnitX();
  const auto label = [&](const Vec3& at, const char* text) {
    out.scene.labels.push_back({at.cast<float>(), text});
  };
  label(pair->y_a - 1.0 * offset * side + 0.3 * offset * n, "*{y}_{i}");
  label(pair->y_b + 1.0 * offset * side - 0.3 * offset * n, "*{y}_{j}");
  out.caption = fmt::format("The chosen contact pair: *{{y}}_{{i}} on {}, *{{y}}_{{j}} on {}, *{{d}} = {} m",
                            model.name[static_cast<std::size_t>(pair->a)],
                            model.name[static_cast<std::size_t>(pair->b)], format_value(pair->d));
  return out;
}

}  // namespace pabd
