// SPDX-License-Identifier: MIT
// See joint_settings.h.
#include "app/session/joint_settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "sim/base/error.h"
#include "sim/base/ordered_json.h"
#include "sim/scene/write_values.h"

namespace pabd {
namespace {

std::string setting(std::string_view key, const std::string& value) {
  return fmt::format("{}.{}={}", kJointSettings, key, value);
}

OrderedJson json_of_law(const BondLaw& law) {
  OrderedJson out;
  add_law(law, out);
  return out;
}

std::string text_of(const OrderedJson& value) {
  return value.is_string() ? value.get<std::string>() : value.dump();
}

bool sets(const std::vector<std::string>& settings, std::string_view key) {
  const std::string begin = setting(key, "");
  return std::any_of(settings.begin(), settings.end(),
                     [&](const std::string& s) { return s.starts_with(begin); });
}

}  // namespace

bool is_joint_setting(std::string_view key) {
  if (!key.starts_with(kJointSettings)) return false;
  key.remove_prefix(kJointSettings.size());
  return key.empty() || key[0] == '.' || key[0] == '=';
}

std::vector<std::string> take_joint_settings(std::vector<std::string>& settings) {
  std::vector<std::string> out;
  std::copy_if(settings.begin(), settings.end(), std::back_inserter(out), is_joint_setting);
  std::erase_if(settings, is_joint_setting);
  return out;
}

std::vector<std::string> take_joint_settings(std::string& patch, const std::string& source) {
  OrderedJson json = OrderedJson::parse(patch, nullptr, false);
  std::vector<std::string> out;
  if (!json.is_object() || !json.contains(kJointSettings)) return out;
  const OrderedJson joints = json[std::string(kJointSettings)];
  if (!joints.is_object())
    throw Error(ErrorKind::bad_input, fmt::format("{}: {}: expected an object", source, kJointSettings));
  for (const auto& [key, value] : joints.items()) out.push_back(setting(key, text_of(value)));
  json.erase(std::string(kJointSettings));
  patch = json.dump();
  return out;
}

bool same_law(const BondLaw& a, const BondLaw& b) { return json_of_law(a) == json_of_law(b); }

std::vector<std::pair<std::string, std::string>> joint_settings(const BondLaw& law) {
  std::vector<std::pair<std::string, std::string>> out;
  const OrderedJson json = json_of_law(law);
  for (const auto& [key, value] : json.items())
    out.emplace_back(fmt::format("{}.{}", kJointSettings, key), text_of(value));
  return out;
}

std::vector<std::pair<std::string, std::string>> joint_differences(const BondLaw& from, const BondLaw& to) {
  const auto before = joint_settings(from);
  std::vector<std::pair<std::string, std::string>> out;
  for (const auto& one : joint_settings(to)) {
    if (std::find(before.begin(), before.end(), one) == before.end()) out.push_back(one);
  }
  return out;
}

std::vector<std::string> joint_settings_after(const BondLaw& scene, const BondLaw& now,
                                              const std::vector<std::string>& settings) {
  std::vector<std::string> out;
  if (!same_law(scene, now)) {
    for (const auto& [key, value] : joint_settings(now)) out.push_back(key + "=" + value);
  }
  const std::string other = now.potential == BondPotential::hard ? "soft" : "hard";
  const std::string changed = setting("potential", other);
  const bool another = std::find(settings.begin(), settings.end(), changed) != settings.end();
  if (another && !sets(settings, "kappa")) out.push_back(setting("kappa", "auto"));
  out.insert(out.end(), settings.begin(), settings.end());
  return out;
}

std::string patch_with_joints(const std::string& patch, const BondLaw& from, const BondLaw& to) {
  if (same_law(from, to)) return patch;
  OrderedJson json = OrderedJson::parse(patch);
  const OrderedJson before = json_of_law(from), after = json_of_law(to);
  for (const auto& [key, value] : after.items())
    if (!before.contains(key) || before[key] != value) json[std::string(kJointSettings)][key] = value;
  return json.dump(2) + "\n";
}

}  // namespace pabd
