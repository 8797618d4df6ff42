// SPDX-License-Identifier: MIT
// A run that a GPU simulates and draws: the pictures and reports of the run whose states come back.
#include "app/frames/device_film.h"

#include <catch2/catch.hpp>

#include "app/frames/runs_painter.h"
#include "render/device/device_engine.h"
#include "render/output/compare_images.h"
#include "render/visual/body_parts.h"
#include "tests/device/device_pictures.h"
#include "tests/device/device_scenes.h"

namespace pabd::test_device_film {

using namespace testing;

namespace {

constexpr int kWidth = 320, kHeight = 180;
const FrameRange kRange{1, 5, 20};  // a few steps a frame

struct Made {
  std::vector<Image> images;
  std::vector<StepSummary> steps;
};

bool same_step(const StepSummary& a, const StepSummary& b) {
  return a.step == b.step && a.time == b.time && a.status == b.status && a.kinetic == b.kinetic &&
         a.potential == b.potential && a.contacts == b.contacts && a.min_gap == b.min_gap;
}

RunsPainter painter_of(GlContext& context, const Run& run, const OverlayChoice& overlay) {
  return {context, {run.shared_scene()}, make_frame(0, {run.view()}), {}, kWidth, kHeight, overlay, {}};
}

template <class Draw>
Made make(FrameSource& source, RunsPainter& painter, const Draw& draw) {
  Made out;
  while (const auto frame = source.next([] { return false; })) {
    draw(*frame);
    painter.fetch(out.images.emplace_back());
    out.steps.push_back(frame->a().report.summary());
  }
  return out;
}

std::shared_ptr<const Scene> heap_of(int bodies) {
  return std::make_shared<const Scene>(mixed_heap(bodies, {3, 0, -2}));
}

}  // namespace

TEST_CASE("a film from the GPU's memory has the pictures and the reports of the run whose states come back") {
  const auto scene = heap_of(24);
  const auto context = any_context();
  const auto [shown, theme] = GENERATE(table<const char*, const char*>(
      {{"none", "studio"}, {"params", "transparent"}, {"contacts", "studio"}}));
  OverlayChoice overlay = parse_overlay(shown);
  overlay.theme = &find_theme(theme);
  const Run run(scene, 1, kNoPast);
  REQUIRE(DeviceFilm::shows_all(run, overlay, {}));

  Run solved = run.fork();
  solved.observe(false, overlay.needs_contacts());
  solved.solve_with(std::make_shared<DeviceEngine>(Backend::automatic));
  context->make_current();
  RunsPainter painter = painter_of(*context, run, overlay);
  LiveSource source(runs_of(std::move(solved)), kRange);
  const Made expected = make(source, painter, [&](const Frame& frame) {
    REQUIRE(frame.a().state->size() == run.state().size());
    context->make_current();  // the engine has one of its own
    painter.draw(frame);
  });

  DeviceFilm film(*context, run, kRange, overlay.contacts);
  const Made actual = make(film, painter, [&](const Frame& frame) {
    REQUIRE(frame.a().state->size() == 0);
    const BodiesOnDevice bodies = film.bodies();
    painter.draw(frame, &bodies);
  });

  REQUIRE(expected.images.size() == 4);
  REQUIRE(actual.images.size() == 4);
  for (std::size_t k = 0; k < 4; ++k) {
    CAPTURE(k);
    CHECK(same_step(actual.steps[k], expected.steps[k]));
    const CompareResult result =
        compare_images(actual.images[k], expected.images[k], CompareTier::same_class);
    CAPTURE(result.reason, result.max_difference, result.differing);
    // Glyphs that bodies hide show through in another order.
    CHECK((overlay.contacts ? result.differing < 1e-3 : same_but_edges(*context, result)));
  }
  CHECK(actual.steps.back().contacts > 5);
  CHECK_FALSE(compare_images(actual.images[0], actual.images[3], CompareTier::cross_class).equal);
}

TEST_CASE("what a film cannot show of a run is drawn from its states") {
  const Run run(heap_of(4), 1, kNoPast);
  CHECK(DeviceFilm::shows_all(run, parse_overlay("axes,scale"), parse_camera("front")));
  for (const char* overlay : {"bonds", "convergence", "velocities", "boxes", "all"}) {
    CAPTURE(overlay);
    CHECK_FALSE(DeviceFilm::shows_all(run, parse_overlay(overlay), {}));
  }
  CHECK_FALSE(DeviceFilm::shows_all(run, {}, parse_camera("follow:1")));
  auto glass = std::make_shared<Scene>(run.scene());
  glass->looks[glass->model.name[1]].opacity = 0.5;
  CHECK_FALSE(DeviceFilm::shows_all(Run(glass, 1, kNoPast), {}, {}));
}

TEST_CASE("a film ends with the step that leaves the numbers") {
  const auto context = any_context();
  auto scene = std::make_shared<Scene>(*heap_of(6));
  scene->initial.v[1] = Vec3(0, -1e200, 0);
  const Run run(scene, 1, kNoPast);
  DeviceFilm film(*context, run, {0, 5, 60}, false);
  int frames = 0;
  while (film.next([] { return false; })) ++frames;
  CHECK(frames == 1);
  REQUIRE(film.diverged().has_value());
  CHECK(film.diverged()->step == 1);
}

TEST_CASE("the sphere around bodies on the GPU is that of their state") {
  const auto context = any_context();
  const ComputeFunctions gl(*context);
  Scene scene = mixed_heap(30, {3, 0, -2}, true);
  State state = scene.initial;
  for (std::size_t i = 0; i < state.c.size(); ++i) {
    if (scene.model.fixed[i]) continue;
    state.c[i] += Vec3(0.31 * static_cast<double>(i % 7), 0.5 * static_cast<double>(i), 0);
    state.R[i] = Eigen::AngleAxisd(0.7 * static_cast<double>(i), Vec3(1, 2, 3).normalized()) * state.R[i];
  }
  const auto check = [&] {
    const PoseBuffer poses(gl, state);
    DeviceSphere sphere(*context, scene.model, state, body_parts(scene.model), poses.id());
    const auto actual = sphere();
    const auto expected = bounding_sphere(scene.model, state);
    REQUIRE(actual.has_value() == expected.has_value());
    if (!expected) return 0.0;
    CHECK((actual->centre - expected->centre).norm() < 1e-6 * expected->radius);
    CHECK(actual->radius == Approx(expected->radius).epsilon(1e-6));
    return expected->radius;
  };
  const double all = check();
  CHECK(all > 5);
  state.c[state.c.size() - 1] = Vec3(std::nan(""), 0, 0);  // left the numbers
  CHECK(check() > 0);
  for (std::size_t i = 0; i < state.c.size(); ++i)  // nothing moves: all that is fixed
    scene.model.fixed[i] = 1;
  CHECK(check() > 0);
}

}  // namespace pabd::test_device_film
