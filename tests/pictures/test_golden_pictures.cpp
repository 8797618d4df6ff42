// SPDX-License-Identifier: MIT
// Approved pictures, in tests/golden/<renderer class>. PABD_UPDATE_GOLDEN=1 approves what is drawn now: look
// at it first.

#include <catch2/catch.hpp>
#include <cmath>

#include "app/overlay/figure2.h"
#include "app/overlay/overlay_panels.h"
#include "app/plots/figure.h"
#include "app/plots/figures/barrier_curves.h"
#include "app/plots/figures/barrier_figure.h"
#include "app/plots/figures/barrier_plots.h"
#include "app/plots/figures/contact_pair.h"
#include "app/plots/figures/convergence.h"
#include "app/plots/figures/difference.h"
#include "app/plots/figures/slider_joint.h"
#include "app/plots/figures/spherical_joint.h"
#include "app/plots/figures/time_panel.h"
#include "app/plots/plot_layout.h"
#include "render/visual/force_chains.h"
#include "render/visual/joint_glyphs.h"
#include "render/visual/outline.h"
#include "tests/pictures/joint_scene.h"
#include "tests/pictures/picture_studio.h"
#include "tests/support/golden.h"

namespace pabd::test_golden_pictures {

namespace {

void check(const Image& image, const std::string& name, const Studio& studio) {
  const CompareResult result = check_golden(image, name, studio.gl_renderer());
  INFO(result.reason);
  CHECK(result.equal);
}

// A plot or a drawing, which cairo paints.
void check_figure(const Picture& picture, int width, int height, const std::string& name) {
  const CompareResult result = check_golden(picture_to_image(picture, width, height), name, "cairo");
  INFO(result.reason);
  CHECK(result.equal);
}

}  // namespace

TEST_CASE("two boxes, plain") {
  Studio studio(640, 360);
  check(studio.frame(visual_of(StoredStep("two_boxes"), false)), "two_boxes", studio);
}

TEST_CASE("two boxes with contacts, bond points and legend") {
  Studio studio(1280, 720);
  const StoredStep stored("two_boxes");
  OverlayOptions panels;
  panels.show(legend_overlay);
  const FrameView view = view_of(stored);
  check(studio.frame(visual_of(stored, true), panels, overlay_of(stored, view)), "two_boxes_contacts",
        studio);
}

TEST_CASE("pyramid with all overlays") {
  Studio studio(1280, 720);
  const StoredStep stored("pyramid");
  const FrameView view = view_of(stored);
  check(studio.frame(visual_of(stored, true), parse_panels("all"), overlay_of(stored, view)),
        "pyramid_overlays", studio);
}

TEST_CASE("loads of a pyramid as bars over bodies by speed, with both legends") {
  Studio studio(640, 360);
  StoredStep stored("pyramid");
  const State& state = stored.scene.initial;
  for (ContactReport& contact : stored.report.contact_reports)  // more below, and some next to nothing
    contact.normal_force = contact.y_a.x() < -3 ? 1 : 3000 * std::pow(0.8, contact.y_a.y());
  FrameView view = view_of(stored);
  State moving = state;
  for (std::size_t i = 0; i < moving.v.size(); ++i) moving.v[i] = {0.2 * state.c[i].y(), 0, 0};
  view.state = std::make_shared<const State>(moving);
  const BodyColors colors = body_colors(view, ColorQuantity::speed);
  OverlayData data = overlay_of(stored, view);
  data.colors = &colors;
  data.contacts_by = ContactQuantity::force;
  data.force_range = force_range(largest_force(stored.scene.model, stored.report));
  VisualOptions options;
  options.contacts = true;
  options.contacts_by = data.contacts_by;
  options.force_range = data.force_range;
  options.values = colors.values;
  options.value_range = colors.range;
  VisualScene scene = visual_of(stored, false);
  build_visual(stored.scene.model, state, stored.report, options, scene);
  OverlayOptions panels;
  panels.show(legend_overlay);
  panels.show(colors_overlay);
  check(studio.frame(scene, panels, data), "pyramid_loads", studio);
}

TEST_CASE("round and flat shapes") {
  Studio studio(640, 360);
  check(studio.frame(visual_of(StoredStep("shapes"), false)), "shapes", studio);
}

TEST_CASE("bodies by value, a selected one, a ghost and a spring") {
  Studio studio(640, 360);
  const StoredStep stored("shapes");
  const Model& model = stored.scene.model;
  const State& state = stored.scene.initial;
  VisualOptions options;
  for (Index i = 0; i < model.size(); ++i) options.values.push_back(i);
  options.value_range = {0, static_cast<double>(model.size() - 1), false};
  options.selected_body = model.size() - 1;
  VisualScene scene;
  scene.camera = frame_camera(model, state, 640.0 / 360);
  build_visual(model, state, stored.report, options, scene);
  State other = state;
  for (Vec3& c : other.c) c += Vec3(0.1, 0.25, 0);
  add_ghost(model, other, ghost_color(), scene);
  const Vec3& held = state.c.back();
  add_spring(held + Vec3(0.5, 0.9, 0.2), held, scene);
  check(studio.frame(scene), "selection", studio);
}

TEST_CASE("barrier plot") {
  BarrierCurves curves;
  curves.kinds = {BarrierKind::polynomial, BarrierKind::even, BarrierKind::log};
  curves.N = {2, 3, 8};
  check_figure(figure_picture(barrier_figure(curves)), 1200, 525, "barrier_plot");
}

TEST_CASE("convergence plot") {
  const Figure figure = convergence_figure(
      {{"sissm", invented_records(60, 0.85)}, {"descent", invented_records(30, 0.5)}}, Minimiser{100, 0.002});
  check_figure(figure_picture(figure), 1500, 500, "convergence_plot");
}

TEST_CASE("figure 1") { check_figure(figure_picture(figure1()), 1200, 525, "figure_1"); }

TEST_CASE("figures 2, 3 and 4") {
  Studio wide(1200, 525);
  check(wide.frame(figure2(1200.0 / 525)), "figure_2", wide);
  check_figure(figure3(), 1200, 600, "figure_3");
  check_figure(figure4(), 1200, 600, "figure_4");
}

TEST_CASE("one joint of each type with bond points and legend") {
  Studio studio(1280, 720);
  const JointScene joints = joint_scene();
  VisualScene scene;
  scene.camera = frame_camera(joints.model, joints.state, 1280.0 / 720);
  VisualOptions options;
  options.bonds = true;
  build_visual(joints.model, joints.state, {}, options, scene);
  OverlayOptions panels;
  panels.show(joints_overlay);
  FrameView view;
  view.model = std::make_shared<const Model>(joints.model);
  OverlayData data;
  data.view = &view;
  check(studio.frame(scene, panels, data), "joints", studio);
}

TEST_CASE("a mechanism with all overlays, small") {
  Studio studio(640, 360);
  StoredStep stored("slider_crank");
  for (std::size_t k = 0; k < stored.report.records.size(); ++k)
    stored.report.records[k].max_joint_error = 1e-3 * std::pow(0.2, static_cast<double>(k));
  for (StepSummary& report : stored.history) report.max_joint_error = 2e-9 + 1e-9 * std::sin(6 * report.time);
  stored.report.max_joint_error = stored.history.back().max_joint_error;
  const BondLaw law{BondPotential::hard, 4, 2.5e8, 0.01};
  const FrameView view = view_of(stored);
  OverlayData data = overlay_of(stored, view);
  data.joint_law = &law;
  OverlayOptions panels = parse_panels("all");
  panels.show(joints_overlay);
  VisualScene scene = visual_of(stored, true);
  scene.camera.eye += 1.4f * (scene.camera.eye - scene.camera.target);  // room for the panels
  check(studio.frame(scene, panels, data), "mechanism_overlays", studio);
}

TEST_CASE("figure 5") { check_figure(figure5(), 1200, 600, "figure_5"); }

TEST_CASE("panels of the window, light and dark") {
  const StoredStep stored("pyramid");
  std::vector<ContactReport> contacts = stored.report.contact_reports;
  for (std::size_t k = 0; k < contacts.size(); ++k) {  // spread, one of them overlapping
    const double u = static_cast<double>(k % 100) / 100;
    contacts[k].d = stored.scene.params.contact.d_hat * (k == 0 ? -0.2 : 1 - 0.4 * u * u);
  }
  BarrierPanelOptions linear, log;
  linear.variants = log.variants = {true, true, true, true};
  log.quantity = BarrierQuantity::slope;
  log.log_y = true;
  const ContactParams& contact = stored.scene.params.contact;
  TimePanelOptions time;
  time.cursor = 1.3;
  time.d_hat = contact.d_hat;
  time.marks = {{0.4, "κ 100 → 50 J", MarkKind::parameter},
                {0.9, "branch", MarkKind::branch},
                {1.6, "parts", MarkKind::divergence}};
  std::vector<DistancePoint> apart;
  for (int k = 1; k <= 120; ++k) {
    const double t = k / 60.0;
    apart.push_back({t, 1e-6 * std::exp(5 * t), 1e-5 * std::exp(4 * t)});
  }
  const std::vector<MethodRun> runs{{"descent", invented_records(30, 0.5)},
                                    {"sissm", invented_records(60, 0.85)}};
  const std::vector<Plot> plots = {
      barrier_panel(contact, stored.report.kappa, contacts, contact_ink, linear).plot,
      barrier_panel(contact, stored.report.kappa, contacts, contact_ink, log).plot,
      contact_histogram(contact, contacts, contact_ink).plot,
      convergence_panel(runs, ConvergenceQuantity::penetration, Minimiser{100, 0.002}),
      time_panel(stored.history, TimeQuantity::gap, time),
      difference_series_plot({}, {}, DifferenceQuantity::distance, apart)};
  for (const PlotTheme* theme : {&light_theme(), &dark_theme()}) {
    Studio studio(1140, 600);
    const Image image = studio.panels([&](Canvas& canvas, double width, double height) {
      canvas.fill_rect({0, 0, width, height}, theme->paper);
      PlotStyle style = panel_style();
      style.theme = *theme;
      for (std::size_t k = 0; k < plots.size(); ++k) {
        const Rect cell{380.0 * static_cast<double>(k % 3), k < 3 ? 0.0 : 300.0, 380, 300};
        paint_plot(plots[k], layout_plot(plots[k], cell.inset(10), style, canvas.font()), style, canvas);
      }
    });
    check(image, theme == &light_theme() ? "panels_light" : "panels_dark", studio);
  }
}

}  // namespace pabd::test_golden_pictures
