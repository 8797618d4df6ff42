// SPDX-License-Identifier: MIT
// The entries of "joints" and their defaults. Internal to sim/scene.
#pragma once

#include "sim/scene/model_builder.h"

namespace pabd {

inline constexpr double kMostForce = 1e12;  // N, N m
inline constexpr Range kAngleRange{-180, 180, "degrees"};
inline constexpr Range kMotorTurnsRange{-1e7, 1e7, "degrees/s"};  // as bodies turn

// The types of joints as words of a file.
std::span<const Choice> joint_choices();

// "joints_default" of a scene; κ is kAutoKappa for "auto".
BondLaw read_joint_defaults(const ObjectReader& scene);

// Reads every entry of "joints" into `out`, whose bodies are complete.
void read_joints(const ObjectReader& scene, const BodyNames& names, ModelBuilder& out);

// "follows" or "lead" of those entries of `list`, "joints", whose first is joint `first` (read_coupling.cpp). All joints and
// the places of all bodies are known.
void read_couplings(const Node& list, std::size_t first, const std::vector<std::size_t>& coupled,
                    ModelBuilder& out);

// Parts of a joint (read_drive.cpp). `range` and `unit` are those of the file; the result is in rad or m.
// Limits must include `stands_at`, the place where the joint starts, where it is known; in the unit of the file.
JointRange read_limits(const ObjectReader& in, std::string_view key, const Range& range, double unit,
                       std::optional<double> stands_at);
Profile read_drive(const Node& node, const Range& range, double unit);
TurnProfile read_turn(const Node& node);  // rotation vectors in degrees
Keyed<Vec3> read_vectors(const Node& node, const Range& range);

// "motor", "damping", "friction" and "spring" of a joint whose type may have them (read_action.cpp).
void read_action(const ObjectReader& in, Joint& joint);

}  // namespace pabd
