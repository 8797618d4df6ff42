// SPDX-License-Identifier: MIT
// Every key of a scene file, as data: the reader refuses others, messages suggest from them, the JSON Schema
// in assets/ is tested against them, and the command line lists them for --set.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/body/joint.h"
#include "sim/solver/parameter_table.h"

namespace pabd {

namespace keys {

using Key = std::string_view;

// Of the scene, without those of parameters, which come after the description: see scene_object_keys.
inline constexpr std::array scene{Key("$schema"),      Key("format"),      Key("version"),
                                  Key("name"),         Key("description"), Key("joints_default"),
                                  Key("bodies"),       Key("joints"),      Key("generate"),
                                  Key("camera"),       Key("duration"),    Key("friction_anchors"),
                                  Key("joint_forces"), Key("no_collide"),  Key("includes")};
inline constexpr std::array joints_default{Key("potential"), Key("kappa"), Key("N"), Key("d_hat")};
inline constexpr std::array camera{Key("eye"), Key("target"), Key("fov")};

inline constexpr std::array body{Key("name"),
                                 Key("shape"),
                                 Key("fixed"),
                                 Key("density"),
                                 Key("mass"),
                                 Key("position"),
                                 Key("orientation"),
                                 Key("velocity"),
                                 Key("angular_velocity"),
                                 Key("color"),
                                 Key("material"),
                                 Key("inertia"),
                                 Key("center_of_mass"),
                                 Key("friction"),
                                 Key("restitution"),
                                 Key("group"),
                                 Key("surface_velocity"),
                                 Key("force"),
                                 Key("torque")};
inline constexpr std::array material{Key("opacity"), Key("checker")};
inline constexpr std::array stack{Key("type"),     Key("name"),    Key("count"),    Key("size"),
                                  Key("position"), Key("density"), Key("mass"),     Key("masses"),
                                  Key("gap"),      Key("rotate"),  Key("friction"), Key("restitution"),
                                  Key("group")};
inline constexpr std::array wall{Key("type"),        Key("name"),     Key("columns"),     Key("rows"),
                                 Key("size"),        Key("position"), Key("density"),     Key("mass"),
                                 Key("gap"),         Key("spacing"),  Key("half_blocks"), Key("friction"),
                                 Key("restitution"), Key("group")};
inline constexpr std::array pyramid{Key("type"),     Key("name"),     Key("base"),        Key("size"),
                                    Key("position"), Key("density"),  Key("mass"),        Key("gap"),
                                    Key("spacing"),  Key("friction"), Key("restitution"), Key("group")};
inline constexpr std::array pile{Key("type"),     Key("name"),        Key("count"),   Key("shape"),
                                 Key("size"),     Key("position"),    Key("density"), Key("mass"),
                                 Key("vary"),     Key("columns"),     Key("spacing"), Key("seed"),
                                 Key("friction"), Key("restitution"), Key("group")};

inline constexpr std::array chain{
    Key("type"), Key("name"),      Key("links"),   Key("shape"),    Key("size"),        Key("position"),
    Key("gap"),  Key("direction"), Key("joint"),   Key("axis"),     Key("fixed"),       Key("density"),
    Key("mass"), Key("end_mass"),  Key("collide"), Key("friction"), Key("restitution"), Key("group")};
inline constexpr std::array net{
    Key("type"),     Key("name"),    Key("rows"),     Key("columns"),     Key("shape"), Key("size"),
    Key("position"), Key("gap"),     Key("upright"),  Key("joint"),       Key("fixed"), Key("density"),
    Key("mass"),     Key("collide"), Key("friction"), Key("restitution"), Key("group")};

inline constexpr std::array axis_angle{Key("axis"), Key("angle")};
inline constexpr std::array euler{Key("euler"), Key("order")};
inline constexpr std::array group{Key("group")};
inline constexpr std::array include{Key("scene"), Key("prefix"), Key("position"), Key("orientation")};

inline constexpr std::array drive{Key("value"), Key("keys")};
inline constexpr std::array twist{Key("limits")};
inline constexpr std::array motor{Key("torque"), Key("speed"), Key("max_torque"), Key("gain")};
inline constexpr std::array linear_motor{Key("force"), Key("speed"), Key("max_force"), Key("gain")};
inline constexpr std::array follows{Key("joint"), Key("ratio"), Key("offset")};
inline constexpr std::array spring{Key("stiffness"), Key("table"), Key("rest")};

// Of state files as well.
inline constexpr std::array friction_anchor{Key("bodies"),  Key("feature"),  Key("stretch"),
                                            Key("sliding"), Key("restless"), Key("recovers")};

}  // namespace keys

// What a joint of that type may say.
std::span<const std::string_view> joint_keys(JointType type);

struct KeyTable {
  std::string_view object;  // what the keys belong to; a definition of that name is in the JSON Schema
  std::span<const std::string_view> keys;
};

// All tables, the scene itself first, then those of parameters.
std::span<const KeyTable> key_tables();

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
