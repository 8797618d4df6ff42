// SPDX-License-Identifier: MIT
// Figure 6 of the supplement.
#include "app/overlay/figure6.h"

#include <fmt/format.h>

#include <utility>
#include <variant>

#include "app/overlay/overlap_solid.h"
#include "app/plots/axis_ticks.h"
#include "render/visual/build_visual.h"
#include "render/visual/contact_glyphs.h"
#include "render/visual/line_shapes.h"
#include "render/visual/palette.h"
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

namespace {

constexpr double kScale = 0.1;  // m
const Vec4f kDark(0.02f, 0.03f, 0.05f, 1);
const Vec4f kOverlap(0.72f, 0.11f, 0.04f, 0.55f);

struct PlacedShape {
  const Shape* shape;
  Pose pose;
};

PlacedShape body_of(const Model& model, const State& state, Index k) {
  const auto at = static_cast<std::size_t>(k);
  return {&model.shape[at], {state.c[at], state.R[at]}};
}

}  // namespace

Figure6 figure6(const Model& model, const Params& params, const State& state, double aspect,
                const Camera* camera) {
  Figure6 out;
  out.scene.camera = camera ? *camera : frame_camera(model, state, aspect);
  const Vec3 eye = out.scene.camera.eye.cast<double>();
  const std::optional<ContactReport> pair = deepest_contact(model, params, state, eye);
  VisualOptions options;
  options.bonds = false;
  options.d_hat = params.contact.d_hat;
  build_visual(model, state, StepReport{}, options, out.scene);
  // The bodies would hide a pair inside them, so they are drawn as glass.
  for (Instance& instance : out.scene.instances[static_cast<int>(Primitive::cube)])
    instance.color.w() = 0.45f;
  if (!pair) {
    out.caption = "No two bodies are within d̂ of each other.";
    return out;
  }
  const PixelMeter meter(out.scene.camera);
  const PlacedShape i = body_of(model, state, pair->a), j = body_of(model, state, pair->b);
  if (const auto* a = std::get_if<Box>(i.shape), *b = std::get_if<Box>(j.shape); a && b) {
    if (auto shaded = convex_solid(overlap_corners(*a, i.pose, *b, j.pose), kOverlap))
      out.scene.meshes.push_back(std::move(*shaded));
    // Glass without its outline is hard to see.
    for (const auto& [box, body] : {std::pair{a, i}, std::pair{b, j}})
      for (const auto& [from, to] : edges_of(*box, body.pose))
        add_line(out.scene, from, to, {kDark, 1.4, false});
  }

  // Sizes in pixels of the frame, so that they suit scenes of any size.
  const Vec3 n = pair->n;
  const double pixel = meter.at(pair->y_a);
  const double length = 175 * pixel, head = 26 * pixel;
  const auto part = [&](Primitive primitive, const Vec3& at, const Vec3& along, double sxz, double sy,
                        const Vec4f& color) {
    out.scene.instances[static_cast<int>(primitive)].push_back(
        {place_along(at, along, sxz, sy), color, false, false});
  };
  part(Primitive::cylinder, pair->y_a + 0.5 * (length - head) * n, n, 1.8 * pixel, 0.5 * (length - head),
       kDark);
  part(Primitive::cone, pair->y_a + (length - head) * n, n, 8 * pixel, head, kDark);
  part(Primitive::sphere, pair->y_a, n, 6.5 * pixel, 6.5 * pixel, srgb_color(0x1f6fb2));
  part(Primitive::sphere, pair->y_b, n, 6.5 * pixel, 6.5 * pixel, srgb_color(0xcc5533));

  // Labels stand beside what they name, across the line of sight and the normal.
  Vec3 side = (pair->y_a - eye).cross(n);
  side = side.norm() > 1e-9 * pixel ? side.normalized() : Vec3::UnitX();
  const auto label = [&](const Vec3& at, const char* text, float size = 24) {
    out.scene.labels.push_back({at.cast<float>(), text, size});
  };
  label(pair->y_a - 26 * pixel * side, "*{y}_{i}");
  label(pair->y_b + 26 * pixel * side, "*{y}_{j}");
  label(pair->y_a + length * n + 22 * pixel * side, "*{n}_{i}");
  // In the middle of each body, on the side that the pair does not take.
  label(i.pose.c - 0.12 * (pair->y_a - i.pose.c), "*{i}", 30);
  label(j.pose.c - 0.12 * (pair->y_b - j.pose.c), "*{j}", 30);

  // The scale starts at the height of the pair's lower point: −d is read off it.
  const Vec3 foot = (pair->d < 0 ? pair->y_b : pair->y_a) - 85 * pixel * side;
  const Pen pen{kDark, 2.2};
  add_line(out.scene, foot, foot + kScale * n, pen);
  for (const double end : {0.0, kScale}) {
    const Vec3 at = foot + end * n;
    add_line(out.scene, at - 7 * pixel * side, at + 7 * pixel * side, pen);
  }
  label(foot + 0.5 * kScale * n - 36 * pixel * side, "0.1 m", 18);
  out.caption = fmt::format("The chosen contact pair: *{{y}}_{{i}} on {}, *{{y}}_{{j}} on {}, *{{d}} = {} m",
                            model.name[static_cast<std::size_t>(pair->a)],
                            model.name[static_cast<std::size_t>(pair->b)], format_value(pair->d));
  return out;
}

}  // namespace pabd
