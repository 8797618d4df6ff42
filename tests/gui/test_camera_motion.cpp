// SPDX-License-Identifier: MIT
// What moves along with time in the window: its trails have a gap where the timeline was wound on, and none where the
// run went by steps; and the words for a camera that follows a body.
#include <catch2/catch.hpp>

#include "app/frames/camera_option.h"
#include "app/gui/camera_motion.h"
#include "app/workbench/workbench.h"
#include "tests/support/places.h"

namespace pabd::test_camera_motion {

namespace {

struct Window {
  Workbench bench{{}, command::Load{places::scenes() + "/four_bar.json", {}, false}};
  UiState ui;
  CameraMotion motion;

  Window() { ui.trails = {{"pen", Vec3::Zero()}}; }
  void show() { motion.move(bench.snapshot(), {1280, 720}, ui); }
  void apply(const Command& command) {
    bench.apply(command);
    show();
    show();  // at rest, another frame
  }
  void play(int steps) {
    for (int k = 0; k < steps; ++k) {
      bench.advance();
      show();
    }
  }
  // Number of gaps, and the longest piece that is drawn; m.
  std::pair<int, double> trail() const {
    const std::vector<Trail> trails = motion.trails();
    int gaps = 0;
    double longest = 0;
    for (std::size_t k = 0; k + 1 < trails[0].path.size(); ++k) {
      const Vec3 &a = trails[0].path[k], &b = trails[0].path[k + 1];
      if (!b.allFinite()) ++gaps;
      if (a.allFinite() && b.allFinite()) longest = std::max(longest, (b - a).norm());
    }
    return {gaps, longest};
  }
};

}  // namespace

TEST_CASE("the trail in the window draws no chord over a jump of the timeline") {
  Window w;
  w.show();
  w.play(240);
  const auto [none, piece] = w.trail();
  REQUIRE(none == 0);
  REQUIRE(piece > 0);
  w.apply(command::Seek{0.1});
  CHECK(w.trail().first == 0);
  w.apply(command::Seek{0.9});
  CHECK(w.trail().first == 1);
  w.play(20);  // replayed
  CHECK(w.trail().first == 1);
  CHECK(w.trail().second <= 1.01 * piece);
  w.apply(command::Step{-1});
  w.apply(command::Step{1});
  w.apply(command::Seek{w.bench.run().state().time + w.bench.run().params().h});  // the next step
  CHECK(w.trail().first == 1);
  w.apply(command::Restart{});
  w.play(10);
  CHECK(w.trail().first == 0);
}

TEST_CASE("undo that brings back a run that is further on breaks the trail") {
  Window w;
  w.show();
  w.play(200);
  w.apply(command::Restart{});  // nothing of a hand: cannot be undone
  w.apply(command::Edit{R"({"do": "remove_joint", "joint": 0})"});
  w.play(120);
  w.apply(command::Seek{0.05});
  w.apply(command::Restart{});
  REQUIRE(w.bench.run().state().time == 0);
  w.play(1);
  w.apply(command::Undo{});  // of the restart
  REQUIRE(w.bench.run().state().time == Approx(0.05).margin(0.005));
  CHECK(w.trail().first == 1);
}

TEST_CASE("a camera that follows a body is told as it stands where that body begins") {
  Window w;
  w.ui.camera.eye = {1, 2, 6};
  w.ui.camera.target = {1, 1, 0};
  const Snapshot start = w.bench.snapshot();
  CHECK(camera_words(followed_view(start, w.ui), *start.a.model, *start.a.state) ==
        camera_words(rounded(w.ui.camera)));
  for (std::size_t i = 0; i < start.a.model->name.size(); ++i)
    if (start.a.model->name[i] == "pen") w.ui.follow = static_cast<Index>(i);
  REQUIRE(w.ui.follow);
  w.show();
  const Vec3 eye = w.ui.camera.eye;
  w.play(120);
  CHECK((w.ui.camera.eye - eye).norm() > 0.05);
  const std::string words =
      camera_words(followed_view(w.bench.snapshot(), w.ui), *start.a.model, *start.a.state);
  const CameraOption option = parse_camera(words);
  CHECK(option.follow == "pen");
  REQUIRE(option.eye);
  CHECK((option.eye->cast<double>() - eye).norm() < 1e-5);
}

}  // namespace pabd::test_camera_motion
