// SPDX-License-Identifier: MIT
// See state.h.
#include "sim/body/state.h"

#include <algorithm>
#include <bit>

namespace pabd {
namespace {

// Numbers by their bits: 0 is not −0, NaN is NaN.
bool same(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

template <class Matrix>
bool same_entries(const Matrix& a, const Matrix& b) {
  return std::equal(a.data(), a.data() + a.size(), b.data(), [](double x, double y) { return same(x, y); });
}

template <class Matrix>
bool same_list(const std::vector<Matrix>& a, const std::vector<Matrix>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), same_entries<Matrix>);
}

// Every member is named, so that one more does not compile until it is compared as well.
bool same_memory(const ContactMemory& a, const ContactMemory& b) {
  const auto& [pair, feature, stretch, recovers, sliding, restless] = a;
  return pair == b.pair && feature == b.feature && same_entries(stretch, b.stretch) &&
         recovers == b.recovers && sliding == b.sliding && restless == b.restless;
}

bool same_change(const StepChange& a, const StepChange& b) {
  const auto x = numbers_of(a), y = numbers_of(b);
  return std::equal(x.begin(), x.end(), y.begin(), same);
}

}  // namespace

StepChangeNumbers numbers_of(const StepChange& change) {
  const auto& [h, velocity, spin, gained] = change;
  StepChangeNumbers out{h, gained};
  std::size_t k = 2;
  for (const Vec3* x : {&velocity, &spin})
    for (int axis = 0; axis < 3; ++axis) out[k++] = (*x)[axis];
  return out;
}

StepChange step_change(const StepChangeNumbers& numbers) {
  const auto vector = [&](std::size_t k) { return Vec3(numbers[k], numbers[k + 1], numbers[k + 2]); };
  return {numbers[0], vector(2), vector(5), numbers[1]};
}

bool same_bits(const State& a, const State& b) {
  const auto& [time, step, c, R, v, omega, contacts, joint_force, change, coupling] = a;
  return same(time, b.time) && step == b.step && same_list(c, b.c) && same_list(R, b.R) &&
         same_list(v, b.v) && same_list(omega, b.omega) && same_list(joint_force, b.joint_force) &&
         std::equal(contacts.begin(), contacts.end(), b.contacts.begin(), b.contacts.end(), same_memory) &&
         std::equal(coupling.begin(), coupling.end(), b.coupling.begin(), b.coupling.end(), same) &&
         std::equal(change.begin(), change.end(), b.change.begin(), b.change.end(), same_change);
}

}  // namespace pabd
