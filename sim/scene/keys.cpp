// SPDX-License-Identifier: MIT
// See keys.h.
#include "sim/scene/keys.h"

#include <algorithm>

#include "sim/joint/joint_traits.h"
#include "sim/scene/fields.h"
#include "sim/scene/scene.h"

namespace pabd {

JointKeys joint_keys(JointType type) {
  const JointTraits& traits = traits_of(type);
  const JointMeasure* moved = moved_measure(traits);
  return {.points = traits.points,
          .moves = moved != nullptr,
          .angle = moved && moved->of == JointMeasure::Of::angle,
          .twists = measure_with(traits, &Joint::twist_limits) != nullptr,
          .twist_free = traits.twist == Twist::free,
          .screw = turns_freely(traits),
          .turn = traits.turn,
          .damped = may_be_damped(traits),
          .torque = acts_by_torque(traits),
          .axes = traits.axes};
}

std::span<const std::string_view> keys_of_joint(JointType type) {
  static const auto kKeys = [] {
    std::array<std::vector<std::string_view>, kJointTypes.size()> keys;
    for (const JointType each : kJointTypes)
      keys[static_cast<std::size_t>(each)] = keys_of_entry(spec::Joint{.type = each});
    return keys;
  }();
  return kKeys[static_cast<std::size_t>(type)];
}

std::vector<std::string> scene_keys() {
  std::vector<std::string> out{"name", "description", "duration"};
  for (const ParameterRow& row : parameter_table()) out.emplace_back(row.key);
  const auto add = [&out](const std::string& prefix, const std::vector<std::string_view>& keys) {
    for (const std::string_view key : keys) out.push_back(prefix + std::string(key));
  };
  add("joints_default.", keys_of_entry(spec::Law{}));
  add("camera.", keys_of_entry(CameraDesc{}));
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
  for (const Field& field : kSceneKeys) {
    out.push_back(field.key);
    if (field.key != "description") continue;
    const auto parameters = parameter_keys("", table);
    out.insert(out.end(), parameters.begin(), parameters.end());
  }
  return out;
}

}  // namespace pabd
