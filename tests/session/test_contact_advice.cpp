// SPDX-License-Identifier: MIT
// Read-outs against closed forms, and every warning: it comes, its suggestion is valid, and taking it in a
// running simulation makes the warning go.
#include "app/session/contact_advice.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "app/session/session.h"
#include "tests/support/places.h"
#include "tests/support/scenario.h"

namespace pabd::test_contact_advice {

using testing::World;

namespace {

const Advice* find(const std::vector<Advice>& all, AdviceKind kind) {
  const auto it = std::find_if(all.begin(), all.end(), [&](const Advice& a) { return a.kind == kind; });
  return it == all.end() ? nullptr : &*it;
}

// A shipped scene that runs, and takes advice as a person would: by --set, on the parameters of now.
struct Run {
  explicit Run(const std::string& scene, const std::vector<std::string>& overrides = {})
      : name(scene),
        taken(overrides),
        session(load_scene(places::scenes() + "/" + scene + ".json", overrides)) {
    session.record_iterations(true);
    session.report_contacts(true);
  }
  void steps(int count) {
    for (int k = 0; k < count; ++k) session.step();
  }
  std::vector<Advice> advice() const {
    return contact_advice(session.model(), session.params(), session.state(), session.report());
  }
  bool warned(AdviceKind kind) const {
    const auto all = advice();
    return find(all, kind) != nullptr;
  }
  // Throws what the scene reader throws when the suggestion is not valid.
  void take(const Advice& advice) {
    taken.push_back(advice.key + "=" + advice.value);
    session.set_params(load_scene(places::scenes() + "/" + name + ".json", taken).params);
  }

  std::string name;
  std::vector<std::string> taken;
  Session session;
};

// Takes the suggestion until the warning has gone, `clicks` times at most; `steps` between. Returns the
// clicks.
int clicks_until_gone(Run& run, AdviceKind kind, int clicks, int steps) {
  for (int k = 1; k <= clicks; ++k) {
    const auto all = run.advice();
    const Advice* advice = find(all, kind);
    REQUIRE(advice);
    CHECK_FALSE(advice->what.empty());
    CHECK_FALSE(advice->why.empty());
    INFO(advice->what << "; " << advice->key << "=" << advice->value);
    run.take(*advice);
    run.steps(steps);
    if (!run.warned(kind)) return k;
  }
  return clicks + 1;
}

constexpr int kSecond = 60;  // steps

// Lets it come to rest with the κ at which four contacts carry the whole scene where −B_N′ d̂ = `slope`.
void rest_with_slope(Run& run, double slope) {
  double weight = 0;
  for (const double mass : run.session.model().mass) weight += mass * 9.81;
  const double kappa = weight / 4 * run.session.params().contact.d_hat / slope;
  run.take({AdviceKind::overlap, "", "", "contact.kappa", std::to_string(kappa)});
  run.steps(6 * kSecond);
}

}  // namespace

TEST_CASE("gap under a load solves Ψ′(d) = −F") {
  // N = 1, ε: −Ψ′ = κ u/(ε d̂) up to κ/d̂.
  const Barrier ramp{BarrierKind::polynomial, 1, 0.01, 50, 0.2};
  CHECK(gap_under_load(ramp, 2500) == Approx(0.01 * (1 - 0.1)).epsilon(1e-12));
  CHECK(gap_under_load(ramp, 5001) == -std::numeric_limits<double>::infinity());
  CHECK(gap_under_load(ramp, 0) == 0.01);
  // N = 2 printed: κ(1 + u)/d̂; below the jump κ/d̂ nothing presses the contact in.
  const Barrier printed{BarrierKind::polynomial, 2, 0.01, 50, 0};
  CHECK(gap_under_load(printed, 4000) == 0.01);
  CHECK(gap_under_load(printed, 7500) == Approx(0.005).epsilon(1e-12));
  CHECK(gap_under_load(printed, 50000) == Approx(-0.08).epsilon(1e-12));
  for (const BarrierKind kind : {BarrierKind::polynomial, BarrierKind::even, BarrierKind::log}) {
    for (const double force : {1e-3, 1.0, 1e3, 1e6}) {
      const Barrier barrier{kind, 4, 0.02, 30, 0.2};
      CHECK(-evaluate(barrier, gap_under_load(barrier, force)).first == Approx(force).epsilon(1e-6));
    }
  }
}

TEST_CASE("the equilibrium gap of a resting cube is the gap it rests at") {
  World world;
  world.params.contact.kappa = 40;
  world.add_ground();
  world.add_cube(1, 1000, {0, 0.51, 0});
  StepReport last;
  testing::run(world, 120, {true, true, 1}, [&](const StepReport& r) { last = r; });
  const ContactNumbers n =
      contact_numbers(world.model, mass_range(world.model), world.params, world.state, last);
  REQUIRE(n.rest);
  CHECK(n.rest->body == 1);
  CHECK(n.rest->contacts == 4);
  CHECK_FALSE(n.rest->assumed);
  CHECK(n.rest->load == Approx(1000 * 9.81 / 4).epsilon(1e-6));
  CHECK(n.rest->gap == Approx(last.min_gap).epsilon(1e-6));
  CHECK(n.largest_force == Approx(1000 * 9.81 / 4).epsilon(1e-4));
}

TEST_CASE("in a stack the lowest of equal bodies is meant, with everything that lies on it") {
  Run run("stack");
  run.steps(3 * kSecond);
  const Session& s = run.session;
  const ContactNumbers n =
      contact_numbers(s.model(), mass_range(s.model()), s.params(), s.state(), s.report());
  REQUIRE(n.rest);
  double weight = 0;
  for (Index i = 0; i < s.model().size(); ++i) weight += s.model().mass[static_cast<std::size_t>(i)] * 9.81;
  CHECK(n.rest->load * n.rest->contacts == Approx(weight).epsilon(1e-3));
  CHECK(n.rest->gap == Approx(s.report().min_gap).epsilon(1e-3));
}

TEST_CASE("without a resting body: the heaviest one on four contacts; without gravity nothing") {
  World world;
  world.params.contact.kappa = 40;
  world.add_ground();
  world.add_cube(1, 500, {0, 5, 0});
  world.add_cube(1, 700, {3, 5, 0});
  StepReport last;
  testing::run(world, 2, {true, true, 1}, [&](const StepReport& r) { last = r; });
  const auto numbers = [&] {
    return contact_numbers(world.model, mass_range(world.model), world.params, world.state, last);
  };
  REQUIRE(numbers().rest);
  CHECK(numbers().rest->body == 2);
  CHECK(numbers().rest->assumed);
  CHECK(numbers().rest->load == Approx(700 * 9.81 / 4));
  CHECK(numbers().largest_force == 0);
  world.params.gravity.setZero();
  CHECK_FALSE(numbers().rest);
  // κ h²/(m d̂²) with κ = 40 J, h = 1/60 s, d̂ = 0.01 m.
  CHECK(numbers().stiffness_median == Approx(40 / 3600.0 / (600 * 1e-4)));
  CHECK(numbers().stiffness_heaviest == Approx(40 / 3600.0 / (700 * 1e-4)));
  world.params.contact.barrier = BarrierKind::log;
  CHECK(numbers().stiffness_heaviest == Approx(40 / 3600.0 / 700));
  CHECK(mass_range(Model{}).heaviest == 0);
}

TEST_CASE("a scene with its own parameters gives no warning once it rests") {
  for (const char* scene : {"two_boxes", "stack"}) {
    Run run(scene);
    run.steps(4 * kSecond);
    CAPTURE(scene);
    for (const Advice& advice : run.advice()) {
      CAPTURE(advice.what);
      CHECK(advice.what.empty());
    }
  }
}

TEST_CASE("overlap: the larger kappa lifts the deepest contact to half of d̂") {
  // Within a quarter: stiffer contacts share an uneven load differently.
  for (const char* scene : {"two_boxes", "stack"}) {
    Run run(scene);
    rest_with_slope(run, 4.75);  // −B₃′ d̂ at d = −d̂/2
    CAPTURE(scene, run.session.report().min_gap);
    REQUIRE(run.session.report().min_gap < 0);
    CHECK(clicks_until_gone(run, AdviceKind::overlap, 1, 6 * kSecond) == 1);
    CHECK(run.session.report().min_gap == Approx(0.5 * run.session.params().contact.d_hat).epsilon(0.25));
  }
}

TEST_CASE("deep overlap: kappa rises tenfold a click, so that nothing is thrown out") {
  Run run("stack");
  rest_with_slope(run, 200);
  CAPTURE(run.session.report().min_gap);
  REQUIRE(run.session.report().min_gap < -5 * run.session.params().contact.d_hat);
  const int clicks = clicks_until_gone(run, AdviceKind::overlap, 4, 6 * kSecond);
  CHECK(clicks > 1);
  CHECK(clicks <= 4);
  CHECK(run.session.report().min_gap > 0);
  CHECK(std::isfinite(run.session.report().min_gap));
}

TEST_CASE("overlap of bodies in flight: a few clicks, and the same fall stays clear") {
  std::vector<std::string> taken{"contact.kappa=1"};
  double gap = -1;
  int clicks = 0;
  for (; clicks < 6 && gap < 0; ++clicks) {
    Run run("two_boxes", taken);
    gap = 1;
    std::vector<Advice> advice;
    for (int k = 0; k < 2 * kSecond; ++k) {
      run.steps(1);
      if (run.session.report().min_gap >= gap) continue;
      gap = run.session.report().min_gap;
      advice = run.advice();
    }
    if (const Advice* overlap = find(advice, AdviceKind::overlap)) {
      taken.push_back(overlap->key + "=" + overlap->value);
    }
  }
  CAPTURE(taken.back());
  CHECK(gap > 0);
  CHECK(clicks > 1);
  CHECK(clicks <= 5);
}

TEST_CASE("contacts pressed past the onset: the larger kappa carries them within it") {
  // κ at which the lowest contacts rest near d = 0, where −B₃′ d̂ is 3, and most others past the onset as
  // well.
  const std::pair<const char*, double> cases[] = {{"two_boxes", 2.0}, {"stack", 2.6}};
  for (const auto& [scene, slope] : cases) {
    Run run(scene);
    rest_with_slope(run, slope);
    CAPTURE(scene, run.session.report().min_gap);
    REQUIRE(run.session.report().min_gap > 0);
    CHECK(clicks_until_gone(run, AdviceKind::pressed_past_onset, 1, 4 * kSecond) == 1);
  }
}

TEST_CASE("iteration limit: more iterations or a faster method end it") {
  for (const char* scene : {"two_boxes", "stack"}) {
    for (const char* method : {"sissm", "descent"}) {
      Run run(scene, {std::string("solver.method=") + method, "solver.iterations=5", "solver.tolerance=1e-6",
                      "solver.halvings=0"});
      for (int k = 0; k < kSecond && !run.warned(AdviceKind::iteration_limit); ++k) run.steps(1);
      CAPTURE(scene, method);
      REQUIRE(run.warned(AdviceKind::iteration_limit));
      const int clicks = clicks_until_gone(run, AdviceKind::iteration_limit, 5, kSecond / 2);
      CAPTURE(run.taken.back());
      CHECK(clicks <= 5);
    }
  }
  // Asked for all iterations: that is no warning.
  Run asked("two_boxes", {"solver.tolerance=0"});
  asked.steps(10);
  CHECK_FALSE(asked.warned(AdviceKind::iteration_limit));
}

TEST_CASE("friction above its bound: it is said by how much, and more iterations end it") {
  Run run("incline", {"solver.iterations=1", "solver.method=descent"});
  for (int k = 0; k < kSecond && run.session.report().friction_excess <= 0.1; ++k) run.steps(1);
  REQUIRE(run.warned(AdviceKind::friction_excess));
  CHECK(clicks_until_gone(run, AdviceKind::friction_excess, 5, kSecond / 2) <= 5);
  for (int k = 0; k < 10; ++k) {  // in every step: one iteration is too few in every second
    run.steps(1);
    CHECK_FALSE(run.warned(AdviceKind::friction_excess));
  }

  const Run calm("incline");
  StepReport report = calm.session.report();
  const auto advice = [&](double excess) {
    report.friction_excess = excess;
    return contact_advice(calm.session.model(), calm.session.params(), calm.session.state(), report);
  };
  const auto said = advice(0.25);
  const Advice* found = find(said, AdviceKind::friction_excess);
  REQUIRE(found);
  CHECK(found->what == "friction is up to 25 % above μ f_n: Coulomb's law does not hold in this step");
  CHECK(find(advice(0.0101), AdviceKind::friction_excess));
  CHECK_FALSE(find(advice(0.01), AdviceKind::friction_excess));
}

namespace {

// What the advice says of a step that ended at its iteration limit.
std::string limit_text(const Run& run, const Params& params, StepReport report) {
  report.status = StepStatus::iteration_limit;
  report.iterations = 20;
  const auto advice = contact_advice(run.session.model(), params, run.session.state(), report);
  const Advice* found = find(advice, AdviceKind::iteration_limit);
  REQUIRE(found);
  return found->what;
}

}  // namespace

TEST_CASE("a warning does not contradict its numbers") {
  const Run run("two_boxes", {"solver.halvings=0"});
  Params params = run.session.params();
  StepReport report = run.session.report();
  const auto what = [&](double residual, double tolerance) {
    report.residual = residual;
    params.solver.tolerance = tolerance;
    return limit_text(run, params, report);
  };
  // The last number of the text is the tolerance, the one before it the residual, if it is told.
  CHECK(what(7.4e-10, 1e-9) ==
        "20 iterations were not enough: within the tolerance of 1e-09, but ended before that was confirmed");
  CHECK(what(9.99e-7, 1e-6) ==
        "20 iterations were not enough: within the tolerance of 1e-06, but ended before that was confirmed");
  for (const double tolerance : {1e-9, 1.04e-6, 3e-4}) {
    for (const double above : {1.0, 1.000001, 1.004, 1.04, 7.0, 1e6}) {
      const std::string text = what(above * tolerance, tolerance);
      CAPTURE(text);
      const std::string words = ", which is not below the tolerance of ";
      const auto at = text.find(words);
      REQUIRE(at != text.npos);
      const auto residual = text.rfind(' ', at) + 1;
      CHECK(std::stod(text.substr(residual, at - residual)) >= std::stod(text.substr(at + words.size())));
    }
  }
}

TEST_CASE("of several islands the advice names those that were slow, and the worst") {
  const Run run("two_boxes");
  StepReport report = run.session.report();
  report.residual = 0.5;
  const auto what = [&](std::vector<IslandReport> islands) {
    report.islands = std::move(islands);
    const std::string text = limit_text(run, run.session.params(), report);
    return text.substr(0, text.find(": residual"));
  };
  const std::string first = run.session.model().name[0], second = run.session.model().name[1];
  const IslandReport settled{0, 3, 4, 0, SolverMethod::newton, StepStatus::converged, 4, 0},
      slow{0, 1, 2, 0, SolverMethod::descent, StepStatus::iteration_limit, 20, 0.1},
      worst{1, 37, 80, 0, SolverMethod::newton, StepStatus::iteration_limit, 20, 0.5};
  CHECK(what({worst}) == "20 iterations were not enough");
  CHECK(what({settled, slow}) ==
        "20 iterations were not enough for 1 of 2 islands (that of '" + first + "': 1 body, by descent)");
  CHECK(what({slow, worst, settled}) ==
        "20 iterations were not enough for 2 of 3 islands (most of all that of '" + second +
            "': 37 bodies, by newton)");
}

TEST_CASE("no onset with descent: 0.2 is suggested and the contacts come to rest") {
  Run run("stack",
          {"contact.onset=0", "solver.method=descent", "solver.iterations=200", "solver.tolerance=1e-9"});
  run.steps(4 * kSecond);
  CHECK(clicks_until_gone(run, AdviceKind::no_onset, 1, 4 * kSecond) == 1);
  CHECK(run.session.report().kinetic < 1e-9);
  CHECK_FALSE(run.warned(AdviceKind::iteration_limit));
  Run other("two_boxes", {"contact.onset=0", "solver.method=sissm"});
  other.steps(kSecond);
  CHECK_FALSE(other.warned(AdviceKind::no_onset));
}

TEST_CASE("overlap with the log barrier: only the polynomial one gets out of it") {
  World world;
  world.params.contact.barrier = BarrierKind::log;
  world.add_ground();
  world.add_cube(1, 1000, {0, 0.499, 0});
  const StepOptions options{true, true, 1};
  StepReport last;
  testing::run(world, 1, options, [&](const StepReport& r) { last = r; });
  const auto advice = contact_advice(world.model, world.params, world.state, last);
  REQUIRE(advice.size() == 1);
  CHECK(advice[0].kind == AdviceKind::log_overlap);
  CHECK(advice[0].key == "contact.barrier");
  CHECK(advice[0].value == "polynomial");
  world.params.contact.barrier = BarrierKind::polynomial;
  testing::run(world, 120, options, [&](const StepReport& r) { last = r; });
  CHECK(contact_advice(world.model, world.params, world.state, last).empty());
  CHECK(last.min_gap > 0);
}

TEST_CASE("a step that leaves the numbers: half the time step stays within them") {
  World world;
  world.params.h = 1;
  world.params.gravity.setZero();
  world.add(Sphere{0.5}, 1, Vec3::Zero());
  world.state.omega[0] = {2e154, 0, 0};  // its square is no number any more; that of half of it is one
  StepReport last;
  testing::run(world, 1, {}, [&](const StepReport& r) { last = r; });
  REQUIRE(last.status == StepStatus::non_finite);
  const auto advice = contact_advice(world.model, world.params, world.state, last);
  REQUIRE(advice.size() == 1);
  CHECK(advice[0].kind == AdviceKind::non_finite);
  CHECK(advice[0].key == "time_step");
  CHECK(advice[0].value == "0.5");
  world.params.h = std::stod(advice[0].value);
  testing::run(world, 1, {}, [&](const StepReport& r) { last = r; });
  CHECK(last.status != StepStatus::non_finite);
  // Never below the smallest step there is.
  world.params.h = 1.5e-6;
  last.status = StepStatus::non_finite;
  CHECK(contact_advice(world.model, world.params, world.state, last)[0].value == "1e-06");
}

}  // namespace pabd::test_contact_advice
