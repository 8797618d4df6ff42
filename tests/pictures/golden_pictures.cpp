// Approved pictures, in tests/golden/<renderer class>. PABD_UPDATE_GOLDEN=1 approves what is drawn now: look
// at it first.

#include <catch2/catch.hpp>
#include <cmath>

#include "app/overlay/figure2.h"
#include "app/overlay/panels.h"
#include "app/plots/figure.h"
#include "app/plots/figures/barrier.h"
#include "app/plots/figures/contact_pair.h"
#include "app/plots/figures/convergence.h"
#include "app/plots/figures/slider_joint.h"
#include "app/plots/figures/spherical_joint.h"
#include "render/visual/joint_glyphs.h"
#include "render/visual/outline.h"
#include "tests/output/golden.h"
#include "tests/pictures/joint_scene.h"
#include "tests/pictures/studio.h"

using namespace pabd;

namespace {

void check(const Image& image, const std::string& name, const Studio& studio) {
  const CompareResult result = check_golden(image, name, studio.gl_renderer());
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
  panels.legend = true;
  check(studio.frame(visual_of(stored, true), panels, overlay_of(stored)), "two_boxes_contacts", studio);
}

TEST_CASE("pyramid with all overlays") {
  Studio studio(1280, 720);
  const StoredStep stored("pyramid");
  check(studio.frame(visual_of(stored, true), parse_panels("all"), overlay_of(stored)), "pyramid_overlays",
        studio);
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
  Studio studio(1200, 525);
  BarrierCurves curves;
  curves.kinds = {BarrierKind::polynomial, BarrierKind::even, BarrierKind::log};
  curves.N = {2, 3, 8};
  check(studio.picture(figure_picture(barrier_figure(curves))), "barrier_plot", studio);
}

TEST_CASE("convergence plot") {
  Studio studio(1500, 500);
  const Figure figure = convergence_figure(
      {{"sissm", invented_records(60, 0.85)}, {"descent", invented_records(30, 0.5)}}, Minimiser{100, 0.002});
  check(studio.picture(figure_picture(figure)), "convergence_plot", studio);
}

TEST_CASE("figure 1") {
  Studio studio(1200, 525);
  check(studio.picture(figure_picture(figure1())), "figure_1", studio);
}

TEST_CASE("figures 2, 3 and 4") {
  Studio wide(1200, 525);
  check(wide.frame(figure2(1200.0 / 525)), "figure_2", wide);
  Studio studio(1200, 600);
  check(studio.picture(figure3()), "figure_3", studio);
  check(studio.picture(figure4()), "figure_4", studio);
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
  panels.joints = true;
  OverlayData data;
  data.joint_types = joint_types(joints.model);
  check(studio.frame(scene, panels, data), "joints", studio);
}

TEST_CASE("a mechanism with all overlays, small") {
  Studio studio(640, 360);
  StoredStep stored("slider_crank");
  for (std::size_t k = 0; k < stored.report.records.size(); ++k)
    stored.report.records[k].max_joint_error = 1e-3 * std::pow(0.2, static_cast<double>(k));
  for (StepReport& report : stored.history) report.max_joint_error = 2e-9 + 1e-9 * std::sin(6 * report.time);
  stored.report.max_joint_error = stored.history.back().max_joint_error;
  const BondLaw law{BondPotential::hard, 2.5e8, 0.01, 4};
  OverlayData data = overlay_of(stored);
  data.joint_types = joint_types(stored.scene.model);
  data.joints = stored.scene.model.joints.size();
  data.joint_law = &law;
  OverlayOptions panels = parse_panels("all");
  panels.joints = true;
  panels.joint_rows = joint_row_count(data);
  VisualScene scene = visual_of(stored, true);
  scene.camera.eye += 1.4f * (scene.camera.eye - scene.camera.target);  // room for the panels
  check(studio.frame(scene, panels, data), "mechanism_overlays", studio);
}

TEST_CASE("figure 5") {
  Studio studio(1200, 600);
  check(studio.picture(figure5()), "figure_5", studio);
}
