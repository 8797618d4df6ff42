// SPDX-License-Identifier: MIT
// See run_summary.h.
#include "app/cli/run_summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "sim/base/counted.h"
#include "sim/base/ordered_json.h"
#include "sim/solver/step_summary.h"
#include "sim/trace/trace.h"

namespace pabd::cli {
namespace {

constexpr double kFrictionSaid = 0.01;  // of μ f_n; what is below is no news

double ms_a_step(const RunFacts& facts) {
  return facts.steps > 0 ? 1e3 * facts.seconds / static_cast<double>(facts.steps) : 0;
}

OrderedJson times_json(const PhaseTimes& sums, std::int64_t steps) {
  const auto mean = [&](double ms) { return steps > 0 ? ms / static_cast<double>(steps) : 0; };
  return {{"detect", mean(sums.detect)},
          {"set_up", mean(sums.set_up)},
          {"solve", mean(sums.solve)},
          {"velocities", mean(sums.velocities)}};
}

std::string device_text(const RunFacts& facts) {
  return facts.device.words() +
         (facts.device.gpu ? fmt::format(", ready after {:.1f} s", facts.device.preparing) : "");
}

}  // namespace

void Extremes::add(const StepSummary& report) {
  if (report.status == StepStatus::non_finite) return;  // it ended nowhere
  gap = std::min(gap, report.min_gap);
  joint_error = std::max(joint_error, report.max_joint_error);
  friction = std::max(friction, report.friction_excess);
  left_pairs = std::max(left_pairs, report.left_pairs);
  too_dense = std::max(too_dense, report.too_dense);
  capped = std::max(capped, report.capped_bonds);
  if (report.held_bodies > 0) ++held;
  if (report.halved_bodies > 0) ++halved;
  halvings = std::max(halvings, report.halvings);
  if (report.friction_excess > kFrictionSaid) ++lawless;
}

std::string summary_text(const Session& session, const RunFacts& facts) {
  const Extremes& worst = facts.worst;
  const std::string gap = std::isfinite(worst.gap) ? fmt::format("{:.4g} m", worst.gap) : "none";
  const std::string joints =
      session.model().joints.empty() ? "" : fmt::format(" · largest joint error {:.2g} m", worst.joint_error);
  const std::int64_t unsolved =
      facts.statistics.statuses[static_cast<std::size_t>(StepStatus::iteration_limit)];
  const std::string limit = unsolved > 0 ? fmt::format(", {} at the iteration limit", unsolved) : "";
  std::string left;
  if (worst.halved > 0)
    left +=
        fmt::format(" · {} made again in up to {} parts", counted(worst.halved, "step"), 1 << worst.halvings);
  if (worst.lawless > 0)
    left += fmt::format(" · friction up to {:.2g} % above μ f_n in {}", 100 * worst.friction,
                        counted(worst.lawless, "step"));
  if (worst.left_pairs > 0)
    left +=
        fmt::format(" · up to {} of bodies deep in each other left out", counted(worst.left_pairs, "pair"));
  if (worst.too_dense > 0)
    left += fmt::format(" · {} too dense for newton", counted(worst.too_dense, "body", "bodies"));
  if (worst.capped > 0) left += fmt::format(" · up to {} softened for sissm", counted(worst.capped, "bond"));
  if (worst.held > 0)
    left +=
        fmt::format(" · bodies slowed down in {}, which would have made energy", counted(worst.held, "step"));
  return fmt::format(
      "{} to t = {:.6g} s{}, {:.3f} ms a step · smallest gap {}{} · kinetic energy {:.4g} J{}{} · state {}\n",
      counted(facts.steps, "step"), session.state().time, limit, ms_a_step(facts), gap, joints,
      kinetic_energy(session.model(), session.state()), left, device_text(facts),
      state_hash(session.state()));
}

nlohmann::ordered_json summary_json(const Session& session, const RunFacts& facts) {
  const Extremes& worst = facts.worst;
  const StepStatistics& s = facts.statistics;
  const auto or_null = [](bool there, double value) { return there ? OrderedJson(value) : OrderedJson(); };
  return {{"format", "pabd-run-summary"},
          {"version", 1},
          {"program", "pabd " PABD_VERSION},
          {"scene", session.scene().name},
          {"scene_hash", session.scene().hash},
          {"status", facts.status},
          {"bodies", session.model().size()},
          {"joints", session.model().joints.size()},
          {"threads", facts.threads},
          {"device", facts.device.name},
          {"steps", facts.steps},
          {"time", session.state().time},
          {"wall_time", facts.seconds},
          {"ms_a_step", ms_a_step(facts)},
          {"phases_ms", times_json(s.times, s.steps)},
          {"solvers", to_json(s.solvers())},
          {"outcomes", to_json(s.outcomes())},
          {"iterations_a_step", s.iterations_a_step()},
          {"contacts_a_step", s.contacts_a_step()},
          {"min_gap", or_null(std::isfinite(worst.gap), worst.gap)},
          {"max_penetration", s.max_penetration},
          {"max_joint_error", or_null(!session.model().joints.empty(), worst.joint_error)},
          {"friction_excess", worst.friction},
          {"friction_steps", worst.lawless},
          {"left_pairs", worst.left_pairs},
          {"too_dense", worst.too_dense},
          {"capped_bonds", worst.capped},
          {"held_steps", worst.held},
          {"halved_steps", worst.halved},
          {"halvings", worst.halvings},
          {"kinetic", kinetic_energy(session.model(), session.state())},
          {"state", state_hash(session.state())},
          {"notes", facts.notes}};
}

}  // namespace pabd::cli
