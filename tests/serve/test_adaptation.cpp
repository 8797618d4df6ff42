// SPDX-License-Identifier: MIT
// Frames get smaller and coarser where link or encoder are slow, and good again.
#include <catch2/catch.hpp>

#include "app/serve/adaptation.h"

namespace pabd::test_adaptation {

namespace {

// A link of that many bytes a millisecond, and an encoder of that many pixels.
double run(Adaptation& adaptation, double bytes_a_ms, double pixels_a_ms, double& now, double seconds) {
  double ms = 0;
  for (const double end = now + seconds; now < end; now += ms / 1000) {
    const FrameLook look = adaptation.look();
    const double pixels = 1280 * 720 * look.scale * look.scale;
    const double encode = pixels / pixels_a_ms, link = pixels * look.quality / 85 * 0.12 / bytes_a_ms;
    ms = encode + link;
    adaptation.took(encode, link, static_cast<std::size_t>(0.12 * pixels), now);
  }
  return ms;
}

}  // namespace

TEST_CASE("a good link gets good frames") {
  Adaptation adaptation;
  double now = 0;
  run(adaptation, 100'000, 200'000, now, 5);
  CHECK(adaptation.look() == FrameLook{1, 85});
}

TEST_CASE("a slow link gets 25 frames a second by coarser ones, and good ones again when it is better") {
  for (const double bytes_a_ms : {500.0, 1000.0, 2000.0}) {
    Adaptation adaptation;
    double now = 0;
    CHECK(run(adaptation, bytes_a_ms, 200'000, now, 20) < 1.05 * Adaptation::kFrameMs);
    CHECK(adaptation.look().scale <= 1);
    CHECK(adaptation.look() != FrameLook{1, 85});
    run(adaptation, 100'000, 200'000, now, 30);
    CHECK(adaptation.look() == FrameLook{1, 85});
  }
}

TEST_CASE("a slow encoder gets fewer pixels") {
  Adaptation adaptation;
  double now = 0;
  CHECK(run(adaptation, 100'000, 1280 * 720 / 60.0, now, 20) < Adaptation::kFrameMs);
  CHECK(adaptation.look().scale < 1);
}

TEST_CASE("a long way, or a few late frames, are not mended by coarser ones") {
  Adaptation far;
  for (int i = 0; i < 400; ++i) far.took(2, i % 10 == 0 ? 150 : 155, i % 10 == 0 ? 900 : 60'000, 0.16 * i);
  CHECK(far.look() == FrameLook{1, 85});
  // The same way, and slow beside it.
  for (int i = 0; i < 400; ++i)
    far.took(2, i % 10 == 0 ? 150 : 250, i % 10 == 0 ? 900 : 60'000, 64 + 0.16 * i);
  CHECK(far.look() != FrameLook{1, 85});
  Adaptation busy;
  for (int i = 0; i < 400; ++i) busy.took(2, i % 3 == 0 ? 200 : 6, 60'000, 0.03 * i);
  CHECK(busy.look() == FrameLook{1, 85});
}

TEST_CASE("what a person chooses holds") {
  Adaptation adaptation;
  double now = 0;
  adaptation.choose(Adaptation::Mode::fine);
  run(adaptation, 100, 1000, now, 10);
  CHECK(adaptation.look().scale == 1);
  CHECK(adaptation.look().quality > 90);
  adaptation.choose(Adaptation::Mode::fast);
  run(adaptation, 100'000, 200'000, now, 30);
  CHECK(adaptation.look().scale < 1);
}

}  // namespace pabd::test_adaptation
