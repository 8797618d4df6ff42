// SPDX-License-Identifier: MIT
// Read-outs and warnings about contacts.
#include "app/session/contact_advice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/session/unsolved_steps.h"
#include "sim/base/counted.h"
#include "sim/solver/halving.h"
#include "sim/solver/parameter_table.h"

namespace pabd {
namespace {

constexpr double kComfortable = 0.5;      // d/d̂ that the deepest contact should keep
constexpr double kTenfold = 10;           // a bed of springs that stiffens more at once throws bodies out
constexpr int kWorthAWord = 15;           // unsolved steps of those that are looked at
constexpr double kManyIterations = 1000;  // beyond, another method is the better advice
constexpr double kManySissmIterations = 200;

Barrier barrier_of(const ContactParams& contact, double kappa) {
  return {contact.barrier, contact.N, contact.d_hat, kappa, contact.onset};
}

// Two significant digits, never less than v.
double rounded_up(double v) {
  const double unit = std::pow(10.0, std::floor(std::log10(v)) - 1);
  return std::ceil(v / unit - 1e-9) * unit;
}

std::string number(double v) { return fmt::format("{:.12g}", v); }

double force_at(const ContactParams& contact, double d) { return -evaluate(barrier_of(contact, 1), d).first; }

// What carries a body and what presses on it, along gravity.
struct Carried {
  int supports = 0;
  double pressed = 0;  // from above; N
  double cosines = 0;  // sum over supports of normal · up
};

void add_force(Carried& carried, const Vec3& normal, double force, const Vec3& up) {
  const double c = normal.dot(up);
  if (c > 0.1) {
    ++carried.supports;
    carried.cosines += c;
  } else if (c < 0) {
    carried.pressed -= c * force;
  }
}

std::vector<Carried> carried_bodies(const Model& model, const StepReport& report, const Vec3& up) {
  std::vector<Carried> carried(static_cast<std::size_t>(model.size()));
  for (const ContactReport& c : report.contact_reports) {
    if (!std::isfinite(c.normal_force)) continue;
    add_force(carried[static_cast<std::size_t>(c.b)], c.n, c.normal_force, up);
    add_force(carried[static_cast<std::size_t>(c.a)], -c.n, c.normal_force, up);
  }
  return carried;
}

std::optional<RestGap> rest_gap(const Model& model, const Params& params, const State& state,
                                const StepReport& report) {
  const double g = params.gravity.norm();
  if (!(g > 0)) return std::nullopt;
  const std::vector<Carried> carried = carried_bodies(model, report, -params.gravity / g);
  std::optional<RestGap> best;
  double mass = 0, pressed = 0;
  for (const bool resting : {true, false}) {
    for (Index i = 0; i < model.size(); ++i) {
      const auto k = static_cast<std::size_t>(i);
      if (model.fixed[k]) continue;
      const Carried& c = carried[k];
      if (resting && (c.supports == 0 || state.v[k].norm() > g * params.h)) continue;
      if (best && (model.mass[k] < mass || (model.mass[k] == mass && c.pressed <= pressed))) continue;
      mass = model.mass[k];
      pressed = c.pressed;
      RestGap rest;
      rest.body = i;
      rest.assumed = !resting;
      rest.contacts = resting ? c.supports : 4;
      // Normal forces only: friction carries the rest on a slope.
      rest.load = resting ? (mass * g + pressed) * (c.cosines / c.supports) / c.supports : mass * g / 4;
      best = rest;
    }
    if (best) break;
  }
  if (best) best->gap = gap_under_load(barrier_of(params.contact, report.kappa), best->load);
  return best;
}

std::optional<Advice> overlap(const Model& model, const Params& params, const State& state,
                              const StepReport& report) {
  if (!(report.min_gap < 0) || traits_of(params.contact.barrier).feasible_only) return std::nullopt;
  const ContactParams& contact = params.contact;
  const double target = kComfortable * contact.d_hat;
  // The same force at 0.5 d̂. What still moves brings its inertia as well: it is stopped within a step.
  double force = report.kappa * force_at(contact, report.min_gap);
  const double most = kTenfold * report.kappa;
  std::string where;
  for (const ContactReport& c : report.contact_reports) {
    if (c.d != report.min_gap) continue;
    const auto a = static_cast<std::size_t>(c.a), b = static_cast<std::size_t>(c.b);
    where = fmt::format(" between {} and {}", model.name[a], model.name[b]);
    const double speed = std::max(state.v[a].norm(), state.v[b].norm());
    if (speed > params.gravity.norm() * params.h) {
      force += std::max(model.mass[a], model.mass[b]) * (target - c.d) / (params.h * params.h);
    }
    break;
  }
  // At least half as much again: N = 1 has the same force at every depth.
  const double wanted = std::max(force / force_at(contact, target), 1.5 * report.kappa);
  const double kappa = allowed(&ContactParams::kappa, rounded_up(std::min(wanted, most)));
  return Advice{
      AdviceKind::overlap, fmt::format("bodies overlap: d = {:.3g} m{}", report.min_gap, where),
      fmt::format(
          "κ = {:.3g} J is too soft for the load: the force of {:.3g} N is reached only beyond d = 0. {}",
          report.kappa, force,
          wanted > most
              ? std::string("More than ten times the κ at once would throw the bodies out: repeat it.")
              : fmt::format("With the larger κ it is reached at d = {:g} d̂.", kComfortable)),
      "contact.kappa", number(kappa)};
}

// Does the force begin with more than nothing at d̂, where an onset would ramp it up?
bool force_jumps(const ContactParams& contact) {
  return traits_of(contact.barrier).has_onset &&
         force_at(contact, std::nextafter(contact.d_hat, 0.0)) > 0.5 / contact.d_hat;
}

std::optional<Advice> past_onset(const Params& params, const StepReport& report) {
  const ContactParams& contact = params.contact;
  if (!traits_of(contact.barrier).has_onset || contact.onset == 0 || report.min_gap < 0) {
    return std::nullopt;
  }
  std::vector<double> gaps;
  std::size_t past = 0;
  for (const ContactReport& c : report.contact_reports) {
    gaps.push_back(c.d);
    if (1 - c.d / contact.d_hat > contact.onset) ++past;
  }
  if (2 * past <= gaps.size() || gaps.empty()) return std::nullopt;
  // Three quarters of the contacts, with the forces of now, to within 0.8 of the onset.
  const auto quarter = gaps.begin() + static_cast<std::ptrdiff_t>(gaps.size() / 4);
  std::nth_element(gaps.begin(), quarter, gaps.end());
  const double kappa = report.kappa * force_at(contact, *quarter) /
                       force_at(contact, contact.d_hat * (1 - 0.8 * contact.onset));
  if (!(kappa > report.kappa)) return std::nullopt;
  // Ψ″ on either side of the onset's end.
  const double end = contact.d_hat * (1 - contact.onset), aside = 1e-9 * contact.d_hat;
  const double inner = evaluate(barrier_of(contact, 1), end + aside).second;
  const double outer = evaluate(barrier_of(contact, 1), end - aside).second;
  if (!(outer < inner)) return std::nullopt;
  const std::string softer =
      outer > 0 ? fmt::format("the same extra load sinks it {:.2g} times as far", inner / outer)
                : std::string("its force does not grow at all");
  return Advice{
      AdviceKind::pressed_past_onset,
      fmt::format("{} of {} {} pressed past the onset: d < {:.3g} d̂", past, counted(gaps.size(), "contact"),
                  past == 1 ? "is" : "are", 1 - contact.onset),
      fmt::format("Within the onset a contact is stiffest, beyond it {}. The larger κ carries this load "
                  "within the onset.",
                  softer),
      "contact.kappa", number(allowed(&ContactParams::kappa, rounded_up(kappa)))};
}

// How many iterations the solve would need at the rate of its second half; 0 when that cannot be told.
double needed_iterations(const Params& params, const StepReport& report) {
  const std::size_t n = report.records.size();
  if (n < 4) return 0;
  const double first = report.records[n / 2].residual, last = report.records[n - 1].residual;
  if (!(last > 0) || !(first > 0)) return 0;
  const double steps = static_cast<double>(n - 1 - n / 2);
  const double rate = std::log(last / first) / steps;  // of ln(residual), an iteration
  if (!(rate < -1e-6)) return std::numeric_limits<double>::infinity();
  return static_cast<double>(n) + std::log(params.solver.tolerance / last) / rate;
}

// What a step that ended at the limit was short of. A small residual alone is not all that it has to reach.
std::string unsettled(const Params& params, const StepReport& report) {
  const double tolerance = params.solver.tolerance;
  if (report.residual < tolerance)
    return fmt::format("within the tolerance of {}, but ended before that was confirmed", number(tolerance));
  // Rounded up: what is not below the tolerance does not read so.
  return fmt::format("residual {}, which is not below the tolerance of {}",
                     number(rounded_up(report.residual)), number(tolerance));
}

// What brings a solve to its end: more iterations, or another method.
Advice longer_solve(const Model& model, const Params& params, const StepReport& report, AdviceKind kind,
                    std::string what) {
  const SolverParams& solver = params.solver;
  const double needed = std::max(2.0 * solver.iterations, 1.25 * needed_iterations(params, report));
  Advice advice{kind, std::move(what), "", "solver.iterations", ""};
  const bool slow = solver.method == SolverMethod::sissm && needed > kManySissmIterations;
  const bool stiff = solver.method == SolverMethod::descent && needed > kManyIterations;
  if (slow) {
    advice.why =
        "sissm moves all bodies at once and halfway, which converges slowly; auto takes a faster method.";
    advice.key = "solver.method";
    advice.value = "auto";
  } else if (stiff) {
    advice.why =
        model.joints.empty()
            ? "Body by body a long chain of contacts passes a load on slowly; newton moves all at once."
            : "Body by body a chain of joints passes a load on slowly; newton moves all at once.";
    advice.key = "solver.method";
    advice.value = "newton";
  } else {
    const double most = std::isfinite(needed) ? needed : 4.0 * solver.iterations;
    advice.why = "The step is used as it is, so contacts and joints keep part of their error.";
    advice.value = number(allowed(&SolverParams::iterations, std::ceil(rounded_up(most))));
  }
  return advice;
}

// Of several islands, those that ended at the limit: " for 2 of 14 islands (most of all that of 'brick 3': 37
// bodies, by descent)".
std::string slow_islands(const Model& model, const StepReport& report) {
  if (report.islands.size() < 2) return {};
  const IslandReport* worst = nullptr;
  int slow = 0;
  for (const IslandReport& island : report.islands) {
    if (island.status != StepStatus::iteration_limit) continue;
    ++slow;
    if (!worst || island.residual > worst->residual) worst = &island;
  }
  if (!worst) return {};
  return fmt::format(" for {} of {} islands ({}that of '{}': {} {}, by {})", slow, report.islands.size(),
                     slow > 1 ? "most of all " : "", model.name[static_cast<std::size_t>(worst->first_body)],
                     worst->bodies, worst->bodies == 1 ? "body" : "bodies", to_string(worst->solver));
}

// " in up to 16 parts of the step", where it was made again in halves.
std::string parts(const StepReport& report) {
  return report.halved_bodies > 0 ? fmt::format(" in up to {} parts of the step", 1 << report.halvings) : "";
}

std::optional<Advice> iteration_limit(const Model& model, const Params& params, const StepReport& report) {
  // Tolerance 0 asks for all iterations.
  if (report.status != StepStatus::iteration_limit || params.solver.tolerance == 0) return std::nullopt;
  // What is too little for halves is news where it comes again and again (halving_advice).
  if (may_halve(params.solver) && report.residual <= kUnsolved) return std::nullopt;
  return longer_solve(model, params, report, AdviceKind::iteration_limit,
                      fmt::format("{} {} not enough{}{}: {}", counted(report.iterations, "iteration"),
                                  report.iterations == 1 ? "was" : "were", slow_islands(model, report),
                                  parts(report), unsettled(params, report)));
}

std::optional<Advice> friction_excess(const Model& model, const Params& params, const StepReport& report) {
  constexpr double kSaid = 0.01;
  if (!(report.friction_excess > kSaid)) return std::nullopt;
  return longer_solve(
      model, params, report, AdviceKind::friction_excess,
      fmt::format("friction is up to {:.2g} % above μ f_n: Coulomb's law does not hold in this step",
                  100 * report.friction_excess));
}

}  // namespace

MassRange mass_range(const Model& model) {
  std::vector<double> masses;
  for (std::size_t i = 0; i < model.mass.size(); ++i) {
    if (!model.fixed[i]) masses.push_back(model.mass[i]);
  }
  if (masses.empty()) return {};
  std::sort(masses.begin(), masses.end());
  const std::size_t half = masses.size() / 2;
  return {masses.size() % 2 ? masses[half] : 0.5 * (masses[half - 1] + masses[half]), masses.back()};
}

double gap_under_load(const Barrier& barrier, double force) {
  const auto push = [&](double d) { return -evaluate(barrier, d).first; };
  const double d_hat = barrier.d_hat;
  if (!(force > push(std::nextafter(d_hat, 0.0)))) return d_hat;
  double hi = d_hat, lo = 0;
  if (!traits_of(barrier.kind).feasible_only) {
    double reach = d_hat;
    while (push(lo) < force && reach < 1e9 * d_hat) {
      lo -= reach;
      reach *= 2;
    }
    if (push(lo) < force) return -std::numeric_limits<double>::infinity();
  }
  // −Ψ′ falls with d.
  for (int k = 0; k < 200 && lo < hi; ++k) {
    const double middle = lo + 0.5 * (hi - lo);
    if (middle == lo || middle == hi) break;
    (push(middle) >= force ? lo : hi) = middle;
  }
  return lo;
}

ContactNumbers contact_numbers(const Model& model, const MassRange& masses, const Params& params,
                               const State& state, const StepReport& report) {
  ContactNumbers numbers;
  numbers.rest = rest_gap(model, params, state, report);
  for (const ContactReport& c : report.contact_reports) {
    numbers.largest_force = std::max(numbers.largest_force, c.normal_force);
  }
  const ContactParams& contact = params.contact;
  const double stiffness = report.kappa * params.h * params.h / area_of_kappa(contact.barrier, contact.d_hat);
  if (masses.median > 0) numbers.stiffness_median = stiffness / masses.median;
  if (masses.heaviest > 0) numbers.stiffness_heaviest = stiffness / masses.heaviest;
  return numbers;
}

std::optional<Advice> halving_advice(const Params& params, std::span<const StepSummary> past) {
  const SolverParams& solver = params.solver;
  if (solver.tolerance == 0) return std::nullopt;  // that asks for all iterations
  past = past.last(std::min(past.size(), kStepsLookedAt));
  int unsolved = 0, deepest = 0;
  for (const StepSummary& step : past) {
    if (step.status != StepStatus::iteration_limit || !(step.residual > kUnsolvedWorthTelling)) continue;
    ++unsolved;
    deepest = std::max(deepest, step.halvings);
  }
  if (unsolved < kWorthAWord) return std::nullopt;
  const Remedy remedy = remedy_for_unsolved(params);
  return Advice{AdviceKind::unsolved_halves,
                fmt::format("{} of {} ended unsolved{}", unsolved, counted(past.size(), "step"),
                            deepest > 0 ? fmt::format(", in up to {} parts too", 1 << deepest) : ""),
                remedy.why, remedy.key, remedy.value};
}

std::vector<Advice> contact_advice(const Model& model, const Params& params, const State& state,
                                   const StepReport& report, std::span<const StepSummary> past) {
  std::vector<Advice> advice;
  const ContactParams& contact = params.contact;
  const bool feasible_only = traits_of(contact.barrier).feasible_only;
  if (report.status == StepStatus::non_finite && !feasible_only) {
    const double h = allowed(&Params::h, 0.5 * params.h);
    advice.push_back(
        {AdviceKind::non_finite, fmt::format("step {} left the numbers", report.step),
         "Something moved or turned too far within one step. Half the time step halves every move.",
         "time_step", number(h)});
    return advice;
  }
  if (feasible_only && (report.status == StepStatus::non_finite || report.min_gap <= 0)) {
    advice.push_back({AdviceKind::log_overlap, "bodies overlap, and the log barrier has no force there",
                      "It is infinite for d ≤ 0, so the step cannot be solved. The polynomial barrier pushes "
                      "overlapping bodies apart (its κ is in joules).",
                      "contact.barrier", "polynomial"});
    return advice;
  }
  const auto add = [&](std::optional<Advice> found) {
    if (found) advice.push_back(std::move(*found));
  };
  add(overlap(model, params, state, report));
  if (auto halves = halving_advice(params, past)) {  // of many steps, this one or not
    advice.push_back(*std::move(halves));
  } else {
    add(iteration_limit(model, params, report));
  }
  add(friction_excess(model, params, report));
  add(past_onset(params, report));
  const bool by_body =
      std::any_of(report.islands.begin(), report.islands.end(), [](const IslandReport& island) {
        return island.manifolds > 0 && island.solver == SolverMethod::descent;
      });
  if (by_body && force_jumps(contact) && report.contacts > 0) {
    advice.push_back(
        {AdviceKind::no_onset, "ε = 0: the contact force jumps at d = d̂",
         "Solved body by body, contacts at the jump switch on and off and never settle. An onset of "
         "0.2 d̂ lets the force grow from 0.",
         "contact.onset", "0.2"});
  }
  return advice;
}

}  // namespace pabd
