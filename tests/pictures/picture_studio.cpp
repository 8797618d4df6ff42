// SPDX-License-Identifier: MIT
#include "tests/pictures/picture_studio.h"
#include "tests/support/places.h"

#include <cmath>

#include "sim/collision/detect.h"
#include "sim/solver/time_step.h"

namespace pabd {
namespace {

std::vector<ContactReport> contacts_of(const Scene& scene, const Barrier& barrier) {
  const Model& model = scene.model;
  const std::vector<double> reach(model.shape.size(), 0.5 * barrier.d_hat);
  CollisionWorkspace workspace;
  std::vector<ContactPoint> points;
  detect(model, scene.initial.c, scene.initial.R, reach, model.no_collide, 1, workspace, points);
  std::vector<ContactReport> reports;
  for (const ContactPoint& p : points) {
    if (p.d >= barrier.d_hat) continue;
    reports.push_back(
        {p.a, p.b, p.y_a, p.y_b, p.n, p.d, -evaluate(barrier, p.d).first, Vec3::Zero(), true, 0});
  }
  return reports;
}

std::vector<StepSummary> damped_bounce(double h) {
  std::vector<StepSummary> history;
  for (int k = 1; k <= 120; ++k) {
    const double t = k * h, bounce = std::exp(-2 * t) * std::abs(std::cos(5 * t));
    StepSummary report;
    report.step = k;
    report.time = t;
    report.kinetic = 1000 * bounce;
    report.elastic = 400 * (std::exp(-2 * t) - bounce);
    report.min_gap = 0.01 - 0.02 * bounce;
    report.max_penetration = std::max(0.0, -report.min_gap);
    history.push_back(report);
  }
  return history;
}

}  // namespace

std::vector<IterationRecord> invented_records(int count, double rate) {
  std::vector<IterationRecord> records;
  for (int k = 0; k < count; ++k) {
    const double left = std::pow(rate, k);
    const double before = 1e-3 - 0.03 * left, after = -1e-3 - 0.05 * left;
    records.push_back({100 + 400 * left, 0.3 * left, std::max(0.0, -before), std::max(0.0, -after), before,
                       after, 0, left});
  }
  return records;
}

StoredStep::StoredStep(const std::string& scene_name)
    : scene(load_scene(places::scenes() + "/" + scene_name + ".json")) {
  const ContactParams& c = scene.params.contact;
  report.kappa = resolve_kappa(scene.model, scene.params);
  report.contact_reports = contacts_of(scene, {c.barrier, c.N, c.d_hat, report.kappa, c.onset});
  report.contacts = static_cast<int>(report.contact_reports.size());
  report.records = invented_records(16, 0.5);
  report.iterations = 16;
  report.step = 120;
  report.time = 2;
  history = damped_bounce(1.0 / 60);
}

Studio::Studio(int width, int height)
    : width_(width),
      height_(height),
      context_(create_headless_context(Backend::automatic, attempts_)),
      renderer_(*context_, width, height),
      overlay_([this](const unsigned char* rgba, int w, int h) {
        return renderer_.upload_font_atlas(rgba, w, h);
      }) {}

Image Studio::read() {
  renderer_.queue_read();
  Image image;
  renderer_.fetch(image);
  return image;
}

Image Studio::frame(const VisualScene& scene, const OverlayOptions& panels, const OverlayData& data) {
  renderer_.draw(scene, overlay_.frame(panels, data, &scene, width_, height_));
  return read();
}

Image Studio::panels(const Picture& picture) {
  renderer_.compose(width_, height_, {}, Vec3f(1, 1, 1), overlay_.paint(picture, width_, height_));
  return read();
}

VisualScene visual_of(const StoredStep& stored, bool contacts_and_bonds) {
  VisualScene visual;
  VisualOptions options;
  options.bonds = options.contacts = contacts_and_bonds;
  options.d_hat = stored.scene.params.contact.d_hat;
  const CameraDesc& camera = *stored.scene.camera;
  visual.camera.eye = camera.eye.cast<float>();
  visual.camera.target = camera.target.cast<float>();
  visual.camera.fov = static_cast<float>(camera.fov);
  build_visual(stored.scene.model, stored.scene.initial, stored.report, options, visual);
  return visual;
}

FrameView view_of(const StoredStep& stored) {
  FrameView view;
  view.model = std::make_shared<const Model>(stored.scene.model);
  view.params = stored.scene.params;
  view.kappa = stored.report.kappa;
  view.state = std::make_shared<const State>(stored.scene.initial);
  view.report = stored.report;
  ReportList history;
  for (const StepSummary& step : stored.history) add_report(history, step);
  view.history = history.view();
  return view;
}

OverlayData overlay_of(const StoredStep& stored, const FrameView& view) {
  OverlayData data;
  data.scene_name = stored.scene.name;
  data.view = &view;
  return data;
}

}  // namespace pabd
