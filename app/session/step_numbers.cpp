// SPDX-License-Identifier: MIT
// See step_numbers.h.
#include "app/session/step_numbers.h"

#include <array>

namespace pabd {

std::span<const StepNumber> step_numbers() {
#define PABD_NUMBER(name) \
  StepNumber { #name, &StepSummary::name }
  static constexpr std::array kNumbers = {PABD_NUMBER(step),
                                          PABD_NUMBER(time),
                                          PABD_NUMBER(iterations),
                                          PABD_NUMBER(kinetic),
                                          PABD_NUMBER(potential),
                                          PABD_NUMBER(elastic),
                                          PABD_NUMBER(kappa),
                                          PABD_NUMBER(contacts),
                                          PABD_NUMBER(max_penetration),
                                          PABD_NUMBER(min_gap),
                                          PABD_NUMBER(max_joint_error),
                                          PABD_NUMBER(residual),
                                          PABD_NUMBER(left_pairs),
                                          PABD_NUMBER(too_dense),
                                          PABD_NUMBER(drive_work),
                                          PABD_NUMBER(capped_bonds),
                                          PABD_NUMBER(held_bodies),
                                          PABD_NUMBER(halved_bodies),
                                          PABD_NUMBER(halvings),
                                          PABD_NUMBER(friction_excess)};
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
