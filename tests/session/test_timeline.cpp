// SPDX-License-Identifier: MIT
// What a timeline counts, against counting it anew, whatever is done to it.

#include "app/session/timeline.h"

#include <catch2/catch.hpp>
#include <random>

namespace pabd::test_timeline {

namespace {

Moment moment(std::int64_t step, bool start, bool device, bool kept) {
  Moment out;
  out.report.step = step;
  out.report.time = 0.01 * static_cast<double>(step);
  out.start = start;
  out.device = device;
  if (kept) {
    auto state = std::make_shared<State>();
    state->c.resize(3);
    state->R.resize(3);
    state->v.resize(3);
    state->omega.resize(3);
    out.state = std::move(state);
  }
  return out;
}

void check_counts(const Timeline& timeline) {
  std::size_t gone = 0, bytes = 0;
  for (std::size_t i = 0; i < timeline.size(); ++i) {
    const Moment& m = timeline[i];
    if (m.state) bytes += state_bytes(*m.state);
    if (m.device && !m.state) ++gone;
  }
  CHECK(timeline.gone() == gone);
  CHECK(timeline.bytes() == bytes);
  CHECK(timeline.reports().size() == timeline.size());
}

}  // namespace

TEST_CASE(
    "a timeline's counts are those of its moments, with any budget and in any order of steps and branches") {
  for (const std::size_t states : {2, 20, 200}) {
    std::mt19937 rng(static_cast<unsigned>(states));
    const auto one_in = [&rng](unsigned n) { return rng() % n == 0; };
    const std::size_t bytes = state_bytes(*moment(0, true, false, true).state);
    Timeline timeline(states * bytes);
    std::int64_t step = 0;
    timeline.add(moment(step, true, false, true));
    for (int k = 0; k < 2000; ++k) {
      const bool device = one_in(2);
      timeline.add(moment(++step, false, device, !device || one_in(4)));
      check_counts(timeline);
      if (!timeline.back().state && one_in(3)) {
        timeline.put_state(moment(step, false, device, true).state);
        check_counts(timeline);
      }
      if (!one_in(50)) continue;
      const Timeline rest = timeline.branch(timeline.kept(timeline.size() / 2));
      check_counts(timeline);
      check_counts(rest);
      step = timeline.back().report.step;
    }
  }
}

TEST_CASE("a timeline tells how many of the last steps were made with the same parameters") {
  Timeline timeline(1 << 20);
  Params now;
  const auto add = [&](int steps, bool start = false) {
    for (int k = 0; k < steps; ++k) {
      Moment m = moment(static_cast<std::int64_t>(timeline.size()), start, false, true);
      m.params = std::make_shared<const Params>(now);
      timeline.add(std::move(m));
    }
  };
  add(1, true);
  CHECK(timeline.made_alike(0, 60) == 0);  // no step led there
  add(10);
  CHECK(timeline.made_alike(10, 60) == 10);
  CHECK(timeline.made_alike(10, 4) == 4);
  now.solver.iterations = 80;
  add(3);
  CHECK(timeline.made_alike(13, 60) == 3);
  CHECK(timeline.made_alike(10, 60) == 10);
  CHECK(timeline.made_alike(4, 60) == 4);
  add(1, true);  // an edit
  add(2);
  CHECK(timeline.made_alike(16, 60) == 2);
}

}  // namespace pabd::test_timeline
