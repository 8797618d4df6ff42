// SPDX-License-Identifier: MIT
// See step_numbers.h.
#include "sim/solver/step_numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

namespace pabd {

std::span<const StepNumber> step_numbers() {
  using S = StepSummary;
  using enum OfParts;
  // clang-format off
  static constexpr std::array kNumbers = {
    StepNumber{"step", &S::step, false, same, "step", "1", "number of the step; the first is 1"},
    StepNumber{"time", &S::time, false, same, "time", "s", "at the end of the step"},
    StepNumber{"iterations", &S::iterations, false, largest, "iterations", "1", "of the island that needed most; 0 where all rests"},
    StepNumber{"kinetic", &S::kinetic, true, sum, "kinetic energy", "J", "½ m v² + ½ ωᵀ I ω of all movable bodies"},
    StepNumber{"potential", &S::potential, true, sum, "potential energy", "J", "−Σ m g·c"},
    StepNumber{"elastic", &S::elastic, true, sum, "elastic energy", "J", "in contacts, bonds and springs"},
    StepNumber{"contacts", &S::contacts, true, sum, "contacts", "1", "points with d < d̂"},
    StepNumber{"max_penetration", &S::max_penetration, true, largest, "penetration", "m", "largest overlap; 0: none"},
    StepNumber{"min_gap", &S::min_gap, true, smallest, "smallest gap", "m", "smallest d of a contact point; infinite without"},
    StepNumber{"max_normal_force", &S::max_normal_force, true, largest, "largest f_{n}", "N", "largest normal force of a contact point"},
    StepNumber{"max_joint_error", &S::max_joint_error, true, largest, "largest error", "m", "largest distance between the points of a bond"},
    StepNumber{"residual", &S::residual, false, largest, "largest step / d̂", "1", "largest way of a body in the last iteration over d̂"},
    StepNumber{"drive_work", &S::drive_work, true, sum, "work of drives", "J", "of drives, motors, dampers, friction of joints, belts and external forces in this step"},
    StepNumber{"capped_bonds", &S::capped_bonds, false, sum, "softened bonds", "1", "joints and contact points that sissm made softer than asked"},
    StepNumber{"held_bodies", &S::held_bodies, false, sum, "slowed bodies", "1", "that were slowed down so that no energy is made"},
    StepNumber{"halved_bodies", &S::halved_bodies, false, sum, "halved bodies", "1", "whose step was made again in halves"},
    StepNumber{"halvings", &S::halvings, false, largest, "halvings", "1", "how often a step was halved, at most"},
    StepNumber{"friction_excess", &S::friction_excess, true, largest, "friction excess", "1", "largest friction force above μ f_n, as a part of it"},
    StepNumber{"kappa", &S::kappa, false, same, "κ", "J", "the stiffness that \"auto\" came to"},
    StepNumber{"left_pairs", &S::left_pairs, false, sum, "skipped pairs", "1", "pairs of bodies in crowds that were not looked at"},
    StepNumber{"too_dense", &S::too_dense, false, sum, "dense bodies", "1", "bodies that are too dense for newton"}};
  // clang-format on
  return kNumbers;
}

const StepNumber* find_step_number(std::string_view pointer) {
  for (const StepNumber& number : step_numbers()) {
    if (pointer.size() == number.name.size() + 1 && pointer.front() == '/' &&
        pointer.substr(1) == number.name)
      return &number;
  }
  return nullptr;
}

void add_numbers(const StepSummary& of_part, StepSummary& whole) {
  for (const StepNumber& number : step_numbers()) {
    std::visit(
        [&](const auto of) {
          auto& out = whole.*of;
          if (number.of_parts == OfParts::sum) out += of_part.*of;
          if (number.of_parts == OfParts::largest) out = std::max(out, of_part.*of);
          if (number.of_parts == OfParts::smallest) out = std::min(out, of_part.*of);
        },
        number.member);
  }
}

void forget_end(StepSummary& step) {
  for (const StepNumber& number : step_numbers()) {
    if (!number.of_end) continue;
    if (const auto* real = std::get_if<0>(&number.member))
      step.** real = std::numeric_limits<double>::quiet_NaN();
  }
}

std::string step_number_reference() {
  std::string out =
      "# Numbers of a step\n\n"
      "The columns of a trace and of a recording, the keys of Python's reports and `history`, what the "
      "window and "
      "Python plot\nagainst each other, and with a `/` before it what metrics and rules of stopping of a "
      "sweep take. "
      "Unit 1: none.\n\n"
      "| name | unit | |\n|---|---|---|\n";
  for (const StepNumber& number : step_numbers())
    out += fmt::format("| `{}` | {} | {} |\n", number.name, number.unit, number.help);
  return out;
}

}  // namespace pabd
