// SPDX-License-Identifier: MIT
// See step_numbers.h.
#include "sim/trace/step_numbers.h"

#include <array>

namespace pabd {

std::span<const StepNumber> step_numbers() {
#define PABD_NUMBER(name, of_end) \
  StepNumber { #name, &StepSummary::name, of_end }
  static constexpr std::array kNumbers = {
      PABD_NUMBER(step, false),           PABD_NUMBER(time, false),
      PABD_NUMBER(iterations, false),     PABD_NUMBER(kinetic, true),
      PABD_NUMBER(potential, true),       PABD_NUMBER(elastic, true),
      PABD_NUMBER(contacts, true),        PABD_NUMBER(max_penetration, true),
      PABD_NUMBER(min_gap, true),         PABD_NUMBER(max_joint_error, true),
      PABD_NUMBER(residual, false),       PABD_NUMBER(drive_work, true),
      PABD_NUMBER(capped_bonds, false),   PABD_NUMBER(held_bodies, false),
      PABD_NUMBER(halved_bodies, false),  PABD_NUMBER(halvings, false),
      PABD_NUMBER(friction_excess, true), PABD_NUMBER(kappa, false),
      PABD_NUMBER(left_pairs, false),     PABD_NUMBER(too_dense, false)};
#undef PABD_NUMBER
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

}  // namespace pabd
