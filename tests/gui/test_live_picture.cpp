// SPDX-License-Identifier: MIT
// When the picture of the scene is drawn, and how well: by a made-up clock.
#include <catch2/catch.hpp>

#include "app/gui/live_picture.h"

namespace pabd::test_live_picture {

TEST_CASE("at rest the picture is as good as it can be, in motion plain and seldom enough") {
  LivePicture live;
  Snapshot sim;
  UiState ui;
  ui.camera.eye.x() += 1;
  CHECK(live.plan(sim, ui, 0).quality.level == Quality::draft);
  const auto rest = live.plan(sim, ui, 1);
  CHECK(rest.draw);
  CHECK(rest.scale == 1);
  CHECK(rest.quality.level == Quality::good);

  // Pictures of 40 ms in frames that take 10 ms else: at most three tenths of the time go into them.
  sim.playing = true;
  double now = 2, drawing = 0;
  for (const double start = now; now < start + 5;) {
    const auto plan = live.plan(sim, ui, now);
    CHECK(plan.quality.level == Quality::draft);
    CHECK(plan.scale >= 0.5);
    now += 0.01;
    if (!plan.draw) continue;
    live.took(plan, 40);
    now += 0.04;
    drawing += 0.04;
  }
  CHECK(drawing > 0.2 * 5);
  CHECK(drawing < 0.32 * 5);

  // Paused: plain for a moment, then good again.
  sim.playing = false;
  CHECK(live.plan(sim, ui, now + 0.1).quality.level == Quality::draft);
  CHECK(live.plan(sim, ui, now + 0.5).quality.level == Quality::good);

  // Quick pictures are drawn in every frame.
  sim.playing = true;
  for (int i = 0; i < 20; ++i) {
    const auto plan = live.plan(sim, ui, now + 1 + 0.016 * i);
    if (i > 0) CHECK(plan.draw);
    if (plan.draw) live.took(plan, 5);
  }
}

TEST_CASE("one picture that takes seconds, while a driver compiles, holds nothing up") {
  LivePicture live;
  Snapshot sim;
  UiState ui;
  sim.playing = true;
  double now = 1, pending = 0;  // pending: ms of the next picture
  auto state = std::make_shared<State>();
  const auto next = [&] {  // time until the next picture is drawn; s
    const double from = now;
    for (;; now += 0.01) {
      state = std::make_shared<State>(*state);
      ++state->step;
      sim.a.state = state;
      if (now > from) sim.serial += 1;
      const auto chosen = live.choose(std::make_shared<Snapshot>(sim), now);
      const auto plan = live.plan(*chosen, ui, now);
      if (plan.draw) {
        live.took(plan, pending);
        return now - from;
      }
    }
  };
  pending = 3000;
  next();
  now += 3;
  pending = 15;
  CHECK(next() < 0.5);
  CHECK(next() < 0.1);
}

TEST_CASE("the picture is never older than what is shown beside it") {
  struct Speed {
    double picture, frame;  // s
  };
  for (const Speed& speed : {Speed{0.1, 0.01}, Speed{0.04, 0.016}, Speed{0.005, 0.016}, Speed{0.4, 0.03}}) {
    CAPTURE(speed.picture, speed.frame);
    LivePicture live;
    UiState ui;
    std::int64_t drawn = -1;
    int pictures = 0, frames = 0;
    double now = 10;
    for (std::int64_t step = 0; now < 16; ++step, ++frames) {
      auto sim = std::make_shared<Snapshot>();
      sim->a.report.step = step;
      auto state = std::make_shared<State>(*sim->a.state);
      state->step = step;
      sim->a.state = std::move(state);
      sim->a.params.contact.N = static_cast<int>(step % 7) + 1;
      sim->playing = now < 15;
      ui.camera.eye.x() = now > 12 && now < 15.5 ? static_cast<float>(now) : 1.0f;  // moves
      const auto shown = live.choose(sim, now);
      const auto plan = live.plan(*shown, ui, now);
      now += speed.frame;
      if (plan.draw) {
        drawn = shown->a.state->step;
        live.took(plan, 1000 * speed.picture);
        now += speed.picture;
        ++pictures;
      }
      CHECK(drawn == shown->a.report.step);
      CHECK(shown->a.params.contact.N == sim->a.params.contact.N);  // what a person sets is there at once
      CHECK(shown->playing == sim->playing);
    }
    CHECK(drawn > 0);
    const bool slow = speed.picture > 0.012;
    CHECK((slow ? pictures < frames : pictures == frames));
  }
}

}  // namespace pabd::test_live_picture
