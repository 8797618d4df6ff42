// SPDX-License-Identifier: MIT
#include "sim/body/state.h"

#include <algorithm>
#include <bit>

namespace pabd {
namespace {

// Numbers by their bits: 0 is not −0, NaN is NaN.
bool same(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

template <class Derived>
bool same(const Eigen::MatrixBase<Derived>& a, const Eigen::MatrixBase<Derived>& b) {
  return std::equal(a.derived().data(), a.derived().data() + a.size(), b.derived().data(),
                    [](double x, double y) { return same(x, y); });
}

// Every member is named, so that one more does not compile until it is compared as well.
bool same(const ContactMemory& a, const ContactMemory& b) {
  const auto& [pair, feature, stretch, recovers, sliding, restless] = a;
  return pair == b.pair && feature == b.feature && same(stretch, b.stretch) && recovers == b.recovers &&
         sliding == b.sliding && restless == b.restless;
}

bool same(const StepChange& a, const StepChange& b) {
  const auto& [h, velocity, spin, gained] = a;
  return same(h, b.h) && same(velocity, b.velocity) && same(spin, b.spin) && same(gained, b.gained);
}

template <class Entry>
bool same(const std::vector<Entry>& a, const std::vector<Entry>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Entry& x, const Entry& y) { return same(x, y); });
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
  return same(time, b.time) && step == b.step && same(c, b.c) && same(R, b.R) && same(v, b.v) &&
         same(omega, b.omega) && same(contacts, b.contacts) && same(joint_force, b.joint_force) &&
         same(change, b.change) && same(coupling, b.coupling);
}

}  // namespace pabd
