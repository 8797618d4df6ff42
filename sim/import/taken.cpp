// SPDX-License-Identifier: MIT
// See taken.h.
#include "sim/import/taken.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/scene/text.h"

namespace pabd {
namespace {

constexpr std::string_view kNothingMoves = "moves no body";

constexpr ImportRow kMjcf[] = {
    {"mujoco", "model", "", ""},
    {"compiler",
     "angle eulerseq meshdir assetdir autolimits inertiafromgeom strippath coordinate settotalmass",
     "texturedir discardvisual fusestatic usethread fitaabb alignfree saveinertial exactmeshinertia", ""},
    {"option", "timestep gravity", "", ""},
    {"flag", "gravity contact constraint equality limit",
     "energy fwdinv sensornoise sensor island sleep warmstart multiccd nativeccd midphase autoreset", ""},
    {"default", "class", "", ""},
    {"body", "name pos quat axisangle euler xyaxes zaxis childclass gravcomp", "user sleep", ""},
    {"replicate", "count offset sep quat axisangle euler xyaxes zaxis", "", ""},
    {"frame", "name pos quat axisangle euler xyaxes zaxis childclass", "", ""},
    {"inertial", "pos quat axisangle euler xyaxes zaxis mass diaginertia fullinertia", "", ""},
    {"geom",
     "name class type size fromto pos quat axisangle euler xyaxes zaxis mesh mass density friction condim "
     "contype "
     "conaffinity "
     "rgba material",
     "group user", ""},
    {"joint",
     "name class type pos axis range limited ref damping frictionloss stiffness springref joint1 joint2 "
     "polycoef active",
     "group user actuatorfrclimited", ""},
    {"freejoint", "name", "group align", ""},
    {"mesh", "name class file scale vertex refpos refquat",
     "texcoord smoothnormal normal content_type maxhullvert", ""},
    {"material", "name rgba class",
     "texture texrepeat texuniform specular shininess reflectance emission metallic roughness", ""},
    {"exclude", "body1 body2", "name", ""},
    {"position", "name class joint gear kp kv ctrlrange ctrllimited", "group user inheritrange", ""},
    {"general", "name class joint gear ctrlrange ctrllimited biastype gainprm biasprm gaintype", "group user",
     ""},
    {"motor", "name class joint gear ctrlrange ctrllimited", "group user", ""},
    {"velocity", "name class joint gear kv ctrlrange ctrllimited forcerange forcelimited", "group user", ""},
    {"connect", "name class body1 body2 anchor active", "", ""},
    {"weld", "name class body1 body2 active", "", ""},
    {"include", "file", "", ""},
    // Not taken.
    {"damper", "", "", "does not damp"},
    {"intvelocity", "", "", "no torque acts"},
    {"cylinder", "", "", "no force acts"},
    {"muscle", "", "", "no force acts"},
    {"adhesion", "", "", "no force acts"},
    {"plugin", "", "", "does nothing"},
    {"pair", "", "", "the two collide by their groups, with the friction of their bodies"},
    {"tendon", "", "", "joints that it couples move freely"},
    {"distance", "", "", "does not hold"},
    {"hfield", "", "", "the ground that uses it is missing"},
    {"composite", "", "", "its bodies are missing"},
    {"flexcomp", "", "", "its bodies are missing"},
    {"flex", "", "", "its bodies are missing"},
    {"skin", "", "", kNothingMoves},
    {"attach", "", "", "its bodies are missing"},
    {"model", "", "", "its bodies are missing"},
    {"deformable", "", "", "its bodies are missing"},
    {"extension", "", "", "does nothing"},
    {"key", "name qpos ctrl", "", ""},
    {"lengthrange", "", "", kNothingMoves},
    {"site", "", "", kNothingMoves},
    {"camera", "", "", kNothingMoves},
    {"light", "", "", kNothingMoves},
    {"sensor", "", "", kNothingMoves},
    {"texture", "", "", kNothingMoves},
    {"layer", "", "", kNothingMoves},
    {"visual", "", "", kNothingMoves},
    {"statistic", "", "", kNothingMoves},
    {"size", "", "", kNothingMoves},
    {"custom", "", "", kNothingMoves},
};

constexpr ImportRow kUrdf[] = {
    {"robot", "name", "version xmlns:xacro xmlns:controller xmlns:interface xmlns:sensor xmlns:xi", ""},
    {"link", "name", "type", ""},
    {"inertial", "", "", ""},
    {"visual", "name", "", ""},
    {"collision", "name", "group", ""},
    {"mass", "value", "", ""},
    {"inertia", "ixx ixy ixz iyy iyz izz", "", ""},
    {"origin", "xyz rpy", "", ""},
    {"box", "size", "", ""},
    {"sphere", "radius", "", ""},
    {"cylinder", "radius length", "", ""},
    {"capsule", "radius length", "", ""},
    {"mesh", "filename scale", "", ""},
    {"joint", "name type", "", ""},
    {"axis", "xyz", "", ""},
    {"limit", "lower upper", "effort velocity", ""},
    {"parent", "link", "", ""},
    {"child", "link", "", ""},
    {"dynamics", "damping friction", "", ""},
    {"material", "name", "", ""},
    {"color", "rgba", "", ""},
    {"mimic", "joint multiplier offset", "", ""},
    // Not taken.
    {"safety_controller", "", "", kNothingMoves},
    {"calibration", "", "", kNothingMoves},
    {"texture", "", "", kNothingMoves},
    {"transmission", "", "", "joints move freely"},
    {"gazebo", "", "", "what it says to Gazebo is not known here"},
    {"mujoco", "", "", "what it says to MuJoCo is not read in URDF"},
    {"sensor", "", "", kNothingMoves},
    {"ros2_control", "", "", "joints move freely"},
    {"verbose", "", "", kNothingMoves},
    {"contact_coefficients", "", "", "friction is the scene's"},
    {"contact", "", "", ""},
    {"lateral_friction", "value", "", ""},
    {"rolling_friction", "value", "", ""},
    {"spinning_friction", "value", "", ""},
};

bool has_word(std::string_view words, std::string_view word) {
  for (std::size_t at = 0; at < words.size();) {
    const std::size_t end = std::min(words.find(' ', at), words.size());
    if (words.substr(at, end - at) == word) return true;
    at = end + 1;
  }
  return false;
}

const ImportRow* row_of(std::span<const ImportRow> rows, std::string_view element) {
  const auto found =
      std::find_if(rows.begin(), rows.end(), [&](const ImportRow& r) { return r.element == element; });
  return found == rows.end() ? nullptr : &*found;
}

bool all_zero(const std::string& value) {
  const auto list = numbers_of(value, 100);
  return list && std::all_of(list->begin(), list->end(), [](double x) { return x == 0; });
}

}  // namespace

std::span<const ImportRow> mjcf_rows() { return kMjcf; }
std::span<const ImportRow> urdf_rows() { return kUrdf; }

void note_attributes(const XmlElement& element, std::span<const ImportRow> rows, ImportNotes& notes) {
  const ImportRow* row = row_of(rows, element.name());
  for (const std::string& name : element.attribute_names()) {
    if (row != nullptr && (has_word(row->taken, name) || has_word(row->no_effect, name))) continue;
    if (all_zero(element.find(name).value_or(""))) continue;
    element.note(notes, fmt::format("<{}> {}: not taken", printable(element.name()), printable(name)));
  }
}

void note_element(const XmlElement& element, std::span<const ImportRow> rows, ImportNotes& notes) {
  const ImportRow* row = row_of(rows, element.name());
  if (row != nullptr && !row->why.empty()) {
    element.note(notes, fmt::format("<{}>: not taken: {}", printable(element.name()), row->why));
  } else {
    element.note(notes, fmt::format("<{}>: not known here", printable(element.name())));
  }
}

}  // namespace pabd
