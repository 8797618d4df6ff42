// SPDX-License-Identifier: MIT
// The keys of a scene itself, of its parameters (sim/solver/parameter_table.h) and of joints by their type: the reader
// refuses others, and messages suggest from them. Internal to sim/scene.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/scene/joint_entry.h"
#include "sim/solver/parameter_table.h"

namespace pabd {

inline constexpr Field kDuration =
    may("duration", "How long run and render go on when they are not told", {1e-6, 1e6, "s"}).or_else("5 s");

// Those of parameters come after "description".
inline constexpr Field kSceneKeys[] = {
    may("$schema", "Where this schema is, for editors; ignored"),
    need("format", "Always \"pabd-scene\""),
    need("version", "Version of the format"),
    may("name", "Name of the scene").or_else("the file's name without ending"),
    may("description", "One line for lists of scenes"),
    may("joints_default", spec::Law::help),
    may("bodies", "Bodies one by one; with generated ones at most 4,000,000"),
    may("joints",
        "What holds two bodies, or a body and the world, together; with generated ones at most 8,000,000"),
    may("generate", "Generators: each stands for many bodies, which follow those of \"bodies\""),
    may("camera",
        "From which side the picture is taken: how far away, and what is in the middle, follows from the "
        "bodies"),
    kDuration,
    may("friction_anchors",
        "What touching contacts remember from the step before. Scenes that were saved in mid-run have it"),
    may("joint_forces",
        "Force of each joint on the second of its bodies in the step before; N. Scenes that were saved in "
        "mid-run "
        "have it"),
    may("no_collide",
        "Pairs that never touch each other: each of the two is the name of a body, or { \"group\": name } "
        "for all bodies "
        "of a group. A group twice: its bodies never touch each other. Two that a joint connects need no "
        "entry"),
    may("includes",
        "Other scenes whose bodies and joints become part of this one, behind its own; at most 8 inside each "
        "other, "
        "1000 and 64 MiB in all")};

// What a joint of that type may say.
std::span<const std::string_view> keys_of_joint(JointType type);

// The settings of a scene in the form that --set takes: "time_step", "contact.kappa", "camera.fov", ….
std::vector<std::string> scene_keys();

// The keys of the object `section` that holds parameters: "contact" has "barrier", …, "friction". An empty
// section is the scene itself.
std::vector<std::string_view> parameter_keys(std::string_view section, ParameterTable table);

// "contact" and "barrier" as one key: "contact.barrier". An empty section adds nothing.
std::string key_below(std::string_view section, std::string_view part);

// Of these keys those that one number in place of the section is about: the first, and what follows it.
std::vector<std::string_view> keys_of_number(std::string_view section, ParameterTable table);

// The objects that hold parameters: "solver", "contact", "contact.friction".
std::vector<std::string_view> sections_of(ParameterTable table);

// Every key of the scene itself.
std::vector<std::string_view> scene_object_keys(ParameterTable table);

}  // namespace pabd
