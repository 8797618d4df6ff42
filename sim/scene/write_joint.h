// SPDX-License-Identifier: MIT
// One joint as an entry of "joints". Internal to sim/scene.
#pragma once

#include "sim/body/model.h"
#include "sim/body/state.h"
#include "sim/scene/write_values.h"

namespace pabd {

// What a quantity over time says from `now` on, in another unit.
template <class Value>
Keyed<Value> keys_from(double now, const Keyed<Value>& profile, double unit) {
  Keyed<Value> out{{{0.0, Value(profile.at(now) * unit)}}};
  for (const auto& [time, value] : profile.keys)
    if (time > now) out.keys.emplace_back(time - now, Value(value * unit));
  return out;
}

// A joint of the model at the poses and the time of `state`. `name` is for the entry; `joint_law` is what
// "joints_default" will say.
spec::Joint entry_of(const Model& model, const State& state, const Joint& joint, const std::string& name,
                     const BondLaw& joint_law);

// What the joint follows, which is `error` off (State::coupling). `names`: of all joints. The offset is that of the bodies
// as they stand, so that whole turns need not be counted again.
void add_coupling(const Model& model, const State& state, const Joint& joint, double error,
                  const std::vector<std::string>& names, spec::Joint& out);

}  // namespace pabd
