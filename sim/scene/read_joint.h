// SPDX-License-Identifier: MIT
// The entries of "joints" and their defaults. Internal to sim/scene.
#pragma once

#include "sim/scene/model_builder.h"

namespace pabd {

inline constexpr Range kAngleRange{-180, 180, "degrees"};

// The types of joints as words of a file.
std::span<const Choice> joint_choices();

// "joints_default" of a scene; κ is kAutoKappa for "auto".
BondLaw read_joint_defaults(const ObjectReader& scene);

// Reads every entry of "joints" into `out`, whose bodies are complete.
void read_joints(const ObjectReader& scene, const BodyNames& names, ModelBuilder& out);

// Parts of a joint (read_drive.cpp). `range` and `unit` are those of the file; the result is in rad or m.
// `at_zero`: limits must include 0, where the joint stands.
JointRange read_limits(const ObjectReader& in, std::string_view key, const Range& range, double unit,
                       bool at_zero);
Profile read_drive(const Node& node, const Range& range, double unit);
TurnProfile read_turn(const Node& node);  // rotation vectors in degrees

}  // namespace pabd
