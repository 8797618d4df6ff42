// SPDX-License-Identifier: MIT
// Sources of frames: a run as it is made, its past and a recording of it hand out the same frames, and none
// changes any more once it is handed out.
#include <catch2/catch.hpp>
#include <stdexcept>

#include "app/frames/frame_source.h"
#include "app/frames/frame_thread.h"
#include "app/frames/run_grid.h"
#include "app/session/recording.h"
#include "app/session/step_at_time.h"
#include "sim/base/error.h"
#include "sim/scene/tuning.h"
#include "sim/trace/trace.h"
#include "tests/support/places.h"

namespace pabd::test_frame_sources {

namespace {

constexpr std::size_t kPlenty = std::size_t{64} << 20;

std::shared_ptr<const Scene> two_boxes() {
  return std::make_shared<const Scene>(load_scene(places::scenes() + "/two_boxes.json"));
}

Run tuned_run(const std::shared_ptr<const Scene>& scene, std::size_t memory, const std::string& set) {
  Run run(scene, 1, memory);
  run.set_params(tuned(run.params(), {set}));
  run.observe(true, true);
  return run;
}

bool never() { return false; }

std::vector<Frame> all_of(FrameSource& source) {
  std::vector<Frame> out;
  while (auto frame = source.next(never)) out.push_back(*std::move(frame));
  return out;
}

void check_same(const FrameView& x, const FrameView& y) {
  CHECK(same_bits(*x.state, *y.state));
  CHECK(state_hash(*x.state) == state_hash(*y.state));
  CHECK(x.params == y.params);
  CHECK(x.kappa == y.kappa);
  CHECK(x.label == y.label);
  CHECK(x.report.step == y.report.step);
  CHECK(x.report.records.size() == y.report.records.size());
  CHECK(x.report.contact_reports.size() == y.report.contact_reports.size());
  REQUIRE(x.history.size() == y.history.size());
  for (std::size_t i = 0; i < x.history.size(); ++i) {
    CHECK(x.history[i].step == y.history[i].step);
    CHECK(x.history[i].residual == y.history[i].residual);
  }
}

void check_same(const std::vector<Frame>& x, const std::vector<Frame>& y) {
  REQUIRE(x.size() == y.size());
  for (std::size_t k = 0; k < x.size(); ++k) {
    CAPTURE(k);
    CHECK(x[k].number == y[k].number);
    REQUIRE(x[k].runs.size() == y[k].runs.size());
    for (std::size_t run = 0; run < x[k].runs.size(); ++run) check_same(x[k].runs[run], y[k].runs[run]);
    REQUIRE(x[k].apart.size() == y[k].apart.size());
    for (std::size_t i = 0; i < x[k].apart.size(); ++i) {
      CHECK(x[k].apart[i].time == y[k].apart[i].time);
      CHECK(x[k].apart[i].position == y[k].apart[i].position);
    }
  }
}

}  // namespace

TEST_CASE(
    "a run, its past and its recording are the same frames, alone and "
    "beside another one") {
  const auto scene = two_boxes();
  const double h = scene->params.h;
  constexpr int kSteps = 40;
  for (const double step_b : {0.0, h, 2.5 * h, 0.4 * h}) {
    CAPTURE(step_b);
    const bool two = step_b > 0;
    const auto b_of = [&](std::size_t memory) {
      std::optional<Run> b;
      if (two) b = tuned_run(scene, memory, "time_step=" + std::to_string(step_b));
      return b;
    };
    LiveSource live(runs_of(tuned_run(scene, kNoPast, "contact.N=4"), b_of(kNoPast)), {0, kSteps, 1 / h});
    const std::vector<Frame> frames = all_of(live);
    REQUIRE(frames.size() == kSteps);
    CHECK(frames.back().a().history.size() == kSteps - 1);
    CHECK(frames[0].a().label == (two ? "A" : ""));

    Run a = tuned_run(scene, kPlenty, "contact.N=4");
    std::optional<Run> b = b_of(kPlenty);
    for (int i = 0; i < kSteps; ++i) {
      REQUIRE(a.advance());
      if (b) REQUIRE(follow(a, *b));
    }
    const std::string recording_a = encode_recording(a);
    std::optional<Run> again_b;
    if (b) again_b.emplace(scene, 1, decode_recording(encode_recording(*b), "b.rec", scene, kPlenty));
    PastSource past(runs_of(std::move(a), std::move(b)), {-1, -1, 1 / h}, true, true);
    CHECK(past.count() == kSteps);
    check_same(frames, all_of(past));
    PastSource recorded(
        runs_of(Run(scene, 1, decode_recording(recording_a, "a.rec", scene, kPlenty)), std::move(again_b)),
        {-1, -1, 1 / h}, true, true);
    check_same(frames, all_of(recorded));
  }
}

TEST_CASE("a frame stays what it was when it was handed out") {
  const auto scene = two_boxes();
  LiveSource source(runs_of(Run(scene, 1, kNoPast), Run(scene, 1, kNoPast)), {5, 60, 60});
  const auto early = source.next(never);
  REQUIRE(early);
  CHECK(early->number == 5);
  const std::string hash = state_hash(*early->a().state);
  const std::size_t distances = early->apart.size();
  all_of(source);
  CHECK(state_hash(*early->a().state) == hash);
  CHECK(early->apart.size() == distances);
  REQUIRE(early->a().history.size() == 5);
  for (int i = 0; i < 5; ++i) CHECK(early->a().history[static_cast<std::size_t>(i)].step == i + 1);
}

TEST_CASE("a run that keeps no past has one moment, and goes on to the same bits") {
  const auto scene = two_boxes();
  Run none(scene, 1, kNoPast), all(scene, 1, kPlenty);
  for (int i = 0; i < 100; ++i) {
    REQUIRE(none.advance());
    REQUIRE(all.advance());
    CHECK(none.timeline().size() == 1);
  }
  CHECK(none.timeline().forgotten() == 100);
  CHECK(same_bits(none.state(), all.state()));
  // From the middle of another run, as --from does.
  all.seek(50);
  Run other(scene, 1, kNoPast, all.state());
  for (int i = 0; i < 50; ++i) REQUIRE(other.advance());
  CHECK(same_bits(other.state(), none.state()));
  CHECK_THROWS_AS(Run(scene, 1, kNoPast, State{}), Error);
}

TEST_CASE(
    "what is changed on the way, κ alone as well, is in the frames from "
    "there on") {
  const auto scene = two_boxes();
  Run run(scene, 1, kPlenty);
  const double before = run.kappa();
  for (int i = 0; i < 10; ++i) REQUIRE(run.advance());
  run.set_params(tuned(run.params(), {"contact.kappa=77"}));
  for (int i = 0; i < 10; ++i) REQUIRE(run.advance());
  PastSource source(runs_of(std::move(run)), {-1, -1, 1 / scene->params.h}, false, false);
  int frames = 0;
  while (const auto frame = source.next(never)) {
    CAPTURE(frame->number);
    // Step 11 is the first one with the other stiffness.
    CHECK(frame->a().kappa == (frame->number <= 10 ? before : 77));
    ++frames;
  }
  CHECK(frames == 20);
}

TEST_CASE("a run that leaves the numbers, or is stopped, ends its frames") {
  // The log barrier has no force for boxes that start inside each other.
  const auto scene = std::make_shared<const Scene>(
      load_scene(places::scenes() + "/two_boxes.json", std::vector<std::string>{"contact.barrier=log"}));
  LiveSource lost(runs_of(Run(scene, 1, kNoPast)), {0, 10, 60});
  CHECK(all_of(lost).size() == 1);
  REQUIRE(lost.diverged().size() == 1);
  CHECK(lost.diverged()[0].step.step == 1);
  CHECK(lost.diverged()[0].run == 0);
  LiveSource beside(runs_of(Run(two_boxes(), 1, kNoPast), Run(scene, 1, kNoPast)), {0, 10, 60});
  CHECK(all_of(beside).size() == 1);
  REQUIRE(beside.diverged().size() == 1);
  CHECK(beside.diverged()[0].run == 1);
  LiveSource stopped(runs_of(Run(two_boxes(), 1, kNoPast)), {0, 10, 60});
  REQUIRE(stopped.next(never));
  CHECK_FALSE(stopped.next([] { return true; }));
  CHECK(stopped.diverged().empty());
}

TEST_CASE("in a grid a run that leaves the numbers stays where it was, and the others go on") {
  const auto broken = std::make_shared<const Scene>(
      load_scene(places::scenes() + "/two_boxes.json", std::vector<std::string>{"contact.barrier=log"}));
  const double h = two_boxes()->params.h;
  for (const std::size_t lost : {0U, 1U, 2U}) {
    CAPTURE(lost);
    std::vector<Run> runs;
    for (std::size_t k = 0; k < 3; ++k) {
      runs.emplace_back(k == lost ? broken : two_boxes(), 1, kNoPast);
      if (k == 2 && k != lost) runs.back().set_params(tuned(runs.back().params(), {"time_step=0.025"}));
    }
    std::size_t steps = 0;
    const auto count = [&](const StepSummary&, std::size_t run) { steps += run == lost ? 1 : 0; };
    LiveSource source(std::move(runs), {0, 10, 1 / h}, {}, {}, count, true);
    const std::vector<Frame> frames = all_of(source);
    REQUIRE(frames.size() == 10);
    CHECK(steps == 0);
    REQUIRE(source.diverged().size() == 1);
    CHECK(source.diverged()[0].run == lost);
    for (const Frame& frame : frames) {
      REQUIRE(frame.runs.size() == 3);
      CHECK(frame.b() == nullptr);
      for (std::size_t k = 0; k < 3; ++k) {
        const double time = k == lost ? 0 : frame.number * h, own = k == 2 ? 0.025 : h;
        CHECK(std::abs(frame.runs[k].state->time - own * std::floor(time / own + 1e-6)) < 1e-9);
      }
    }
  }
}

TEST_CASE("a grid has the values of its keys in all combinations, by rows") {
  const RunGrid grid({"contact.N=1,3,8", "gravity=[0,0,-9.8],[0,0,-1.6]"});
  REQUIRE(grid.size() == 6);
  CHECK(grid.settings(0) == std::vector<std::string>{"contact.N=1", "gravity=[0,0,-9.8]"});
  CHECK(grid.settings(2) == std::vector<std::string>{"contact.N=8", "gravity=[0,0,-9.8]"});
  CHECK(grid.settings(3) == std::vector<std::string>{"contact.N=1", "gravity=[0,0,-1.6]"});
  CHECK(grid.columns(100, 1000) == 3);
  CHECK(grid.text() == "contact.N=1,3,8 gravity=[0,0,-9.8],[0,0,-1.6]");
  Params params;
  params.contact.N = 3;
  CHECK(grid.words(4, params, 5).starts_with("*{N} 3, "));
  CHECK(RunGrid({"joints_default.kappa=1,2"}).words(1, params, 5) == "joints_default.kappa 2");

  // Values of one key fill the picture: the shorter side of a cell is as large as it can be.
  const auto columns = [](int values, int width, int height) {
    std::string text = "contact.kappa=1";
    for (int k = 1; k < values; ++k) text += "," + std::to_string(k + 1);
    return RunGrid({text}).columns(width, height);
  };
  CHECK(columns(2, 1280, 720) == 2);
  CHECK(columns(3, 1280, 720) == 3);
  CHECK(columns(4, 1280, 720) == 2);
  CHECK(columns(6, 1280, 720) == 3);
  CHECK(columns(3, 720, 1280) == 1);
  CHECK(RunGrid({}).empty());

  for (const auto& [text, why] :
       std::vector<std::pair<std::string, std::string>>{{"contact.N", "expected KEY=V1,V2"},
                                                        {"=1,2", "expected KEY=V1,V2"},
                                                        {"contact.N=1,,3", "a value is missing"},
                                                        {"contact.N=", "a value is missing"},
                                                        {"contact.N=1,2,1", "1 is there twice"},
                                                        {"contact.N=1", "one run is no grid"}}) {
    CAPTURE(text);
    CHECK_THROWS_WITH(RunGrid({text}), Catch::Matchers::Contains(why));
  }
  std::string many = "contact.kappa=1";
  for (int k = 2; k < 100; ++k) many += "," + std::to_string(k);
  CHECK_THROWS_WITH(RunGrid({many}), Catch::Matchers::Contains("64 at most"));
  CHECK_THROWS_WITH(RunGrid({"a=1,2", "a=3,4"}), Catch::Matchers::Contains("twice"));
}

namespace {

// So many frames without anything in them, and then what goes wrong.
class BrokenSource : public FrameSource {
 public:
  explicit BrokenSource(int frames) : frames_(frames) {}
  std::optional<Frame> next(const Stop&) override {
    if (made == frames_) throw std::runtime_error("lost");
    return make_frame(made++, {});
  }
  int made = 0;

 private:
  int frames_;
};

}  // namespace

TEST_CASE(
    "the thread of a source: in order, a few ahead, and what went wrong "
    "comes last") {
  BrokenSource source(8);
  FrameThread frames(source);
  for (int k = 0; k < 8; ++k) {
    const auto frame = frames.next(true);
    REQUIRE(frame);
    CHECK(frame->number == k);
  }
  CHECK_THROWS_AS(frames.next(true), std::runtime_error);
  BrokenSource endless(1'000'000);
  {
    FrameThread unread(endless);
    REQUIRE(unread.next(true));
  }
  CHECK(endless.made < 10);
}

}  // namespace pabd::test_frame_sources
