// SPDX-License-Identifier: MIT
// See step_quantities.h.
#include "app/plots/figures/step_quantities.h"

#include "app/plots/quantities.h"

namespace pabd {
namespace {

using S = const StepSummary&;

StepQuantity row(const char* key, const Quantity& what, double (*value)(S), bool integer = false) {
  return {key, what.words, what.axis, value, integer};
}

}  // namespace

std::span<const StepQuantity> step_quantities() {
  static const StepQuantity kRows[] = {
      row("time", quantities::time, [](S s) { return s.time; }),
      row(
          "step", quantities::step, [](S s) { return static_cast<double>(s.step); }, true),
      row("gap", quantities::least_gap, [](S s) { return s.min_gap; }),
      row("penetration", quantities::penetration, [](S s) { return s.max_penetration; }),
      row("kinetic", quantities::kinetic, [](S s) { return s.kinetic; }),
      row("potential", quantities::potential_energy, [](S s) { return s.potential; }),
      row("elastic", quantities::elastic, [](S s) { return s.elastic; }),
      row("total", quantities::total, [](S s) { return s.kinetic + s.potential + s.elastic; }),
      row("drive_work", quantities::drive_work, [](S s) { return s.drive_work; }),
      row("joint_error", quantities::joint_error, [](S s) { return s.max_joint_error; }),
      row(
          "contacts", quantities::contacts, [](S s) { return static_cast<double>(s.contacts); }, true),
      row(
          "iterations", quantities::iterations, [](S s) { return static_cast<double>(s.iterations); }, true),
      row("residual", quantities::step_size, [](S s) { return s.residual; }),
      row("kappa", quantities::stiffness, [](S s) { return s.kappa; }),
      row("friction_excess", quantities::friction_excess, [](S s) { return s.friction_excess; }),
      row("milliseconds", quantities::wall_clock, [](S s) { return s.times.total; }),
      row("solve", quantities::solve_time, [](S s) { return s.times.solve; }),
      row("collision", quantities::collision_time, [](S s) { return s.times.detect + s.times.set_up; })};
  return kRows;
}

const StepQuantity* find_step_quantity(std::string_view key) {
  for (const StepQuantity& quantity : step_quantities()) {
    if (key == quantity.key) return &quantity;
  }
  return nullptr;
}

std::string step_quantity_words() {
  std::string out;
  for (const StepQuantity& quantity : step_quantities()) {
    if (!out.empty()) out += ", ";
    out += quantity.key;
  }
  return out;
}

}  // namespace pabd
