// SPDX-License-Identifier: MIT
// Names on the timeline: beside their places, never over each other or over what stands there.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "app/gui/track_events.h"
#include "app/workbench/workbench.h"
#include "tests/support/places.h"

namespace pabd::test_track_events {

TEST_CASE("names stand beside their places where there is room, and nowhere else") {
  const Span room{0, 300};
  const std::vector<Span> taken = {{100, 140}};
  const auto place = [&](std::vector<NameAt> names) { return place_names(names, taken, room, 6); };
  REQUIRE(place({{20, 40}}).size() == 1);
  CHECK(place({{20, 40}})[0].left == 26);             // right of it
  CHECK(place({{80, 40}})[0].left == 80 - 6 - 40);    // no room there: left
  CHECK(place({{280, 40}})[0].left == 280 - 6 - 40);  // beyond the end
  CHECK(place({{120, 40}}).empty());                  // amid what stands there
  CHECK(place({{20, 90}}).empty());                   // too long for either side
  // A briefer one where the name has no room, and no briefer one where it has.
  const auto brief = place({{20, 90, 40}});
  REQUIRE(brief.size() == 1);
  CHECK((brief[0].brief && brief[0].left == 26));
  CHECK_FALSE(place({{20, 40, 10}})[0].brief);
  // The first has the choice.
  const auto both = place({{200, 60}, {205, 60}, {210, 60}});
  REQUIRE(both.size() == 1);
  CHECK(both[0].number == 0);
}

TEST_CASE("no two names, and no name and time, overlap, wherever they are") {
  const Span room{10, 900};
  std::vector<Span> taken;
  for (float x = 10; x < 900; x += 130) taken.push_back({x - 6, x + 45});
  std::size_t placed_in_all = 0;
  unsigned seed = 1;
  const auto random = [&seed](float most) {
    seed = seed * 1664525 + 1013904223;
    return most * static_cast<float>(seed >> 8) / 16777216.0f;
  };
  for (int trial = 0; trial < 400; ++trial) {
    std::vector<NameAt> names;
    for (int k = 0; k < 9; ++k) names.push_back({10 + random(890), 20 + random(80), 15});
    std::vector<Span> seen = taken;
    for (const PlacedName& placed : place_names(names, taken, room, 6)) {
      const Span span{placed.left,
                      placed.left + (placed.brief ? names[placed.number].brief : names[placed.number].width)};
      for (const Span& other : seen) REQUIRE_FALSE(span.overlaps(other));
      REQUIRE(span.lo >= room.lo);
      REQUIRE(span.hi <= room.hi);
      const float x = names[placed.number].x;
      REQUIRE((span.lo == Approx(x + 6) || span.hi == Approx(x - 6)));
      seen.push_back(span);
      ++placed_in_all;
    }
  }
  CHECK(placed_in_all > 400);
}

TEST_CASE("the first contact is that of the first step with one, and none where they are from the start on") {
  const auto events = [](const char* scene, int steps) {
    Workbench bench({}, command::Load{std::string(places::scenes()) + "/" + scene + ".json", {}, false});
    bench.apply(command::Step{steps});
    const Snapshot sim = bench.snapshot();
    std::optional<double> named, found;
    for (const TrackEvent& event : track_events(sim, UiState{}))
      if (event.name == "first contact") named = event.time;
    for (const StepSummary& r : sim.a.history)
      if (r.contacts > 0 && !found) found = r.time;
    return std::pair{named, found};
  };
  const auto [mixer, contact] = events("marble_mixer", 40);
  REQUIRE(contact);
  REQUIRE(mixer);
  CHECK(*mixer == *contact);
  const auto [stack, from_start] = events("stack", 20);
  REQUIRE(from_start);
  CHECK_FALSE(stack);
}

TEST_CASE("the timeline names the first step that was made again in halves") {
  Workbench bench({}, command::Load{std::string(places::scenes()) + "/two_boxes.json", {}, false});
  bench.apply(command::Step{60});
  const auto halves = [](const Snapshot& sim) {
    std::optional<TrackEvent> out;
    for (const TrackEvent& event : track_events(sim, UiState{}))
      if (event.name == "first halves") out = event;
    return out;
  };
  const Snapshot sim = bench.snapshot();
  const auto begin = sim.a.history.begin(), end = sim.a.history.end();
  const auto first = std::find_if(begin, end, [](const StepSummary& r) { return r.halved_bodies > 0; });
  REQUIRE(first != end);  // they hit the ground
  const auto event = halves(sim);
  REQUIRE(event);
  CHECK(event->time == first->time);
  CHECK_FALSE(event->warning);  // a hit is no trouble
  bench.apply(command::Set{"solver.halvings", "0"});
  bench.apply(command::Restart{});
  bench.apply(command::Step{60});
  CHECK_FALSE(halves(bench.snapshot()));
}

}  // namespace pabd::test_track_events
