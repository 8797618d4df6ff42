// SPDX-License-Identifier: MIT
// See keys.h.
#include "sim/scene/keys.h"

#include <algorithm>

#include "sim/body/shape_kind.h"
#include "sim/joint/joint_traits.h"

namespace pabd {

namespace {

std::vector<std::string_view> keys_of(const JointTraits& joint) {
  std::vector<std::string_view> out{"name", "type", "bodies"};
  const auto add = [&out](bool has, std::initializer_list<std::string_view> some) {
    if (has) out.insert(out.end(), some);
  };
  add(joint.points, {"points", "length"});
  add(!joint.points, {"anchor"});
  add(joint.axes > 0, {"axis"});
  add(joint.axes > 1, {"second_axis"});
  add(moved_measure(joint), {"start", "limits", "drive", "motor", "friction", "spring", "follows"});
  add(measure_with(joint, &Joint::twist_limits), {"twist"});
  add(turns_freely(joint), {"lead"});
  add(joint.turn, {"drive", "axes"});
  add(may_be_damped(joint), {"damping"});
  add(!joint.points, {"arm", "symmetric"});
  add(true, {"potential", "kappa", "N", "d_hat", "collide"});
  add(!joint.points, {"anchors", "frames"});
  return out;
}

// The last part of a key.
std::string_view name_of(std::string_view key) { return key.substr(key.rfind('.') + 1); }

// Those of parameters first, whose keys live as long as the program.
std::vector<KeyTable> made_tables() {
  static const std::vector<std::string_view> scene = scene_object_keys(parameter_table());
  static const std::vector<std::vector<std::string_view>> sections = [] {
    std::vector<std::vector<std::string_view>> all;
    for (const std::string_view s : sections_of(parameter_table())) {
      all.push_back(parameter_keys(s, parameter_table()));
    }
    return all;
  }();
  std::vector<KeyTable> tables{{"scene", scene}};
  for (const std::string_view s : sections_of(parameter_table())) {
    tables.push_back({name_of(s), sections[tables.size() - 1]});
  }
  return tables;
}

}  // namespace

std::span<const std::string_view> joint_keys(JointType type) {
  static const auto kKeys = [] {
    std::array<std::vector<std::string_view>, kJointTypes.size()> keys;
    for (const JointType each : kJointTypes) keys[static_cast<std::size_t>(each)] = keys_of(traits_of(each));
    return keys;
  }();
  return kKeys[static_cast<std::size_t>(type)];
}

std::span<const KeyTable> key_tables() {
  static constexpr std::array kFixed{KeyTable{"joints_default", keys::joints_default},
                                     KeyTable{"camera", keys::camera},
                                     KeyTable{"body", keys::body},
                                     KeyTable{"material", keys::material},
                                     KeyTable{"stack", keys::stack},
                                     KeyTable{"wall", keys::wall},
                                     KeyTable{"pyramid", keys::pyramid},
                                     KeyTable{"pile", keys::pile},
                                     KeyTable{"chain", keys::chain},
                                     KeyTable{"net", keys::net},
                                     KeyTable{"axis_angle", keys::axis_angle},
                                     KeyTable{"euler", keys::euler},
                                     KeyTable{"group", keys::group},
                                     KeyTable{"include", keys::include},
                                     KeyTable{"drive", keys::drive},
                                     KeyTable{"twist", keys::twist},
                                     KeyTable{"motor", keys::motor},
                                     KeyTable{"linear_motor", keys::linear_motor},
                                     KeyTable{"spring", keys::spring},
                                     KeyTable{"linear_spring", keys::spring},
                                     KeyTable{"follows", keys::follows},
                                     KeyTable{"friction_anchor", keys::friction_anchor}};
  static const auto kTables = [] {
    std::vector<KeyTable> tables = made_tables();
    tables.insert(tables.end(), kFixed.begin(), kFixed.end());
    for (const ShapeKind* kind : shape_kinds()) {
      if (kind->name != tables.back().object) tables.push_back({kind->name, kind->keys});
    }
    for (const JointType type : kJointTypes) tables.push_back({to_string(type), joint_keys(type)});
    return tables;
  }();
  return kTables;
}

std::vector<std::string> scene_keys() {
  std::vector<std::string> out{"name", "description", "duration"};
  for (const ParameterRow& row : parameter_table()) out.emplace_back(row.key);
  const auto add = [&out](const std::string& prefix, std::span<const std::string_view> table) {
    for (const std::string_view key : table) out.push_back(prefix + std::string(key));
  };
  add("joints_default.", keys::joints_default);
  add("camera.", keys::camera);
  return out;
}

std::vector<std::string_view> parameter_keys(std::string_view section, ParameterTable table) {
  std::vector<std::string_view> out;
  for (const ParameterRow& row : table) {
    std::string_view key = row.key;
    if (!section.empty()) {
      if (!key.starts_with(section) || key.size() <= section.size() || key[section.size()] != '.') continue;
      key.remove_prefix(section.size() + 1);
    }
    key = key.substr(0, key.find('.'));
    if (std::find(out.begin(), out.end(), key) == out.end()) out.push_back(key);
  }
  return out;
}

std::vector<std::string_view> keys_of_number(std::string_view section, ParameterTable table) {
  std::vector<std::string_view> out = parameter_keys(section, table);
  const std::string first = key_below(section, out.front());
  std::erase_if(out, [&](std::string_view part) {
    const ParameterRow* row = find_parameter(key_below(section, part), table);
    return row->key != first && !(row->follows && row->follows == first);
  });
  return out;
}

std::string key_below(std::string_view section, std::string_view part) {
  return std::string(section) + (section.empty() ? "" : ".") + std::string(part);
}

std::vector<std::string_view> sections_of(ParameterTable table) {
  std::vector<std::string_view> out;
  for (const ParameterRow& row : table) {
    const std::string_view key = row.key;
    for (auto dot = key.find('.'); dot != std::string_view::npos; dot = key.find('.', dot + 1)) {
      const std::string_view section = key.substr(0, dot);
      if (std::find(out.begin(), out.end(), section) == out.end()) out.push_back(section);
    }
  }
  return out;
}

std::vector<std::string_view> scene_object_keys(ParameterTable table) {
  std::vector<std::string_view> out;
  for (const std::string_view key : keys::scene) {
    out.push_back(key);
    if (key != "description") continue;
    const auto parameters = parameter_keys("", table);
    out.insert(out.end(), parameters.begin(), parameters.end());
  }
  return out;
}

}  // namespace pabd
