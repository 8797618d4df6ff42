// SPDX-License-Identifier: MIT
// See joint_settings.h.
#include "app/session/joint_settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "sim/base/error.h"
#include "sim/base/ordered_json.h"

namespace pabd {
namespace {

std::string setting(std::string_view key, const std::string& value) {
  return fmt::format("{}.{}={}", kJointSettings, key, value);
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
  for (const auto& [key, value] : joints.items())
    out.push_back(setting(key, value.is_string() ? value.get<std::string>() : value.dump()));
  json.erase(std::string(kJointSettings));
  patch = json.dump();
  return out;
}

bool same_law(const BondLaw& a, const BondLaw& b) {
  const bool hard = a.potential == BondPotential::hard;
  return a.potential == b.potential && a.kappa == b.kappa && (!hard || (a.N == b.N && a.d_hat == b.d_hat));
}

std::vector<std::pair<std::string, std::string>> joint_settings(const BondLaw& law) {
  const bool hard = law.potential == BondPotential::hard;
  const auto key = [](const char* name) { return fmt::format("{}.{}", kJointSettings, name); };
  std::vector<std::pair<std::string, std::string>> out = {{key("potential"), hard ? "hard" : "soft"},
                                                          {key("kappa"), OrderedJson(law.kappa).dump()}};
  if (!hard) return out;
  out.emplace_back(key("N"), std::to_string(law.N));
  out.emplace_back(key("d_hat"), OrderedJson(law.d_hat).dump());
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
  for (const auto& [key, value] : joint_differences(from, to)) {
    const OrderedJson number = OrderedJson::parse(value, nullptr, false);
    json[std::string(kJointSettings)][key.substr(kJointSettings.size() + 1)] =
        number.is_discarded() ? OrderedJson(value) : number;
  }
  return json.dump(2) + "\n";
}

}  // namespace pabd
