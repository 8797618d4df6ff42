// SPDX-License-Identifier: MIT
// The entries of "joints" and their defaults. Internal to sim/scene.
#pragma once

#include "sim/scene/fields.h"
#include "sim/scene/model_builder.h"

namespace pabd {

// The types of joints as words of a file.
std::span<const std::string_view> joint_words();

// "joints_default" of a scene; κ is kAutoKappa for "auto".
BondLaw read_joint_defaults(const ObjectReader& scene);

// Reads every entry of "joints" into `out`, whose bodies are complete.
void read_joints(const ObjectReader& scene, const BodyNames& names, ModelBuilder& out);

// "follows" or "lead" of those entries of `list`, "joints", whose first is joint `first` (read_coupling.cpp). All joints and
// the places of all bodies are known.
void read_couplings(const Node& list, std::size_t first, const std::vector<std::size_t>& coupled,
                    ModelBuilder& out);

}  // namespace pabd
