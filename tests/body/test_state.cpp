// SPDX-License-Identifier: MIT
// When two states are the same to the last bit.
#include <catch2/catch.hpp>
#include <functional>
#include <limits>

#include "sim/body/state.h"

namespace pabd::test_state {

namespace {

State some_state() {
  State state;
  state.time = 0.3;
  state.step = 18;
  state.c = {{1, 0, 3}, {4, 5, 6}};
  state.R = {Mat3::Identity(), Mat3::Identity()};
  state.v = {{7, 8, 9}, {0, 0, 0}};
  state.omega = {{0, 1, 0}, {2, 0, 0}};
  state.joint_force = {{0, -0.0, 1}};
  state.contacts = {{3, 4, {0, 1, 2}, false, false}, {3, 5, {0, 1, 2}, false, true}};
  return state;
}

}  // namespace

TEST_CASE("states differ where any number does that the next step depends on") {
  REQUIRE(same_bits(some_state(), some_state()));
  const std::function<void(State&)> changes[] = {
      [](State& s) { s.time = std::nextafter(s.time, 1); },
      [](State& s) { ++s.step; },
      [](State& s) { s.c[0].y() = -0.0; },
      [](State& s) { s.c.pop_back(); },
      [](State& s) { s.R[1](2, 1) = 1e-300; },
      [](State& s) { s.v[0].z() = std::nextafter(9.0, 10); },
      [](State& s) { s.v[1].x() = std::numeric_limits<double>::denorm_min(); },
      [](State& s) { s.omega[1].x() = 3; },
      [](State& s) { s.contacts[0].pair = 2; },
      [](State& s) { s.contacts[0].feature = 3; },
      [](State& s) { s.contacts[1].stretch.y() = std::nextafter(1.0, 2); },
      [](State& s) { s.contacts[1].sliding = false; },
      [](State& s) { s.contacts[1].restless = true; },
      [](State& s) { s.contacts[0].recovers = true; },
      [](State& s) { s.contacts.pop_back(); },
      [](State& s) { s.joint_force[0].z() = std::nextafter(1.0, 2); },
      [](State& s) { s.joint_force.clear(); },
  };
  for (std::size_t k = 0; k < std::size(changes); ++k) {
    State changed = some_state();
    changes[k](changed);
    INFO("change " << k);
    CHECK_FALSE(same_bits(some_state(), changed));
    CHECK(same_bits(changed, changed));
  }
}

TEST_CASE("the same bits are the same, also where they are no number") {
  State a = some_state();
  a.c[1].x() = std::numeric_limits<double>::quiet_NaN();
  const State b = a;
  CHECK(same_bits(a, b));
}

}  // namespace pabd::test_state
