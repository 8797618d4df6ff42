// SPDX-License-Identifier: MIT
// See camera_keys.h.
#include "app/frames/camera_keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "sim/base/error.h"
#include "sim/base/input_file.h"
#include "sim/base/ordered_json.h"
#include "sim/scene/document.h"

namespace pabd {
namespace {

constexpr double kSameTime = 1e-6;  // s
constexpr double kLargest = 1e6;    // of every number
constexpr std::size_t kMostKeys = 10000;
constexpr std::size_t kMostBytes = std::size_t{4} << 20;

[[noreturn]] void refuse(const std::string& source, const std::string& place, const std::string& expected) {
  throw Error(ErrorKind::bad_input, fmt::format("{}: {}: expected {}", source, place, expected));
}

OrderedJson vec(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

double number(const Json& json, const std::string& source, const std::string& place, double lo, double hi) {
  const double value = json.is_number() ? json.get<double>() : std::nan("");
  if (!(value >= lo && value <= hi)) refuse(source, place, fmt::format("a number, {:g} to {:g}", lo, hi));
  return value;
}

Vec3 vec(const Json& key, const char* field, const std::string& source, const std::string& place) {
  const std::string at = place + "/" + field;
  if (!key.contains(field) || !key[field].is_array() || key[field].size() != 3)
    refuse(source, at, "three numbers");
  Vec3 out;
  for (std::size_t i = 0; i < 3; ++i)
    out[static_cast<Eigen::Index>(i)] = number(key[field][i], source, at, -kLargest, kLargest);
  return out;
}

CameraKey key_from(const Json& json, const std::string& source, const std::string& place) {
  if (!json.is_object()) refuse(source, place, "an object");
  CameraKey key;
  key.time =
      number(json.contains("time") ? json["time"] : Json(), source, place + "/time", -kLargest, kLargest);
  key.pose.eye = vec(json, "eye", source, place);
  key.pose.target = vec(json, "target", source, place);
  if (json.contains("up")) key.pose.up = vec(json, "up", source, place);
  if (json.contains("ortho")) {
    if (!json["ortho"].is_boolean()) refuse(source, place + "/ortho", "true or false");
    key.pose.orthographic = json["ortho"].get<bool>();
  }
  if (json.contains("fov")) key.pose.fov = number(json["fov"], source, place + "/fov", 1, 170);
  if (!(key.pose.distance() > 1e-6)) refuse(source, place, "\"eye\" and \"target\" at different places");
  if (!(key.pose.up.norm() > 1e-6)) refuse(source, place + "/up", "a direction");
  return key;
}

}  // namespace

std::string camera_keys_json(const CameraKeys& keys) {
  std::string out = "{\n  \"format\": \"pabd-camera\",\n  \"version\": 1,\n  \"scene\": ";
  out += OrderedJson(keys.scene).dump(-1, ' ', false, OrderedJson::error_handler_t::replace) +
         ",\n  \"keys\": [";
  for (std::size_t i = 0; i < keys.keys.size(); ++i) {
    const CameraKey& key = keys.keys[i];
    OrderedJson json = {{"time", key.time}, {"eye", vec(key.pose.eye)}, {"target", vec(key.pose.target)}};
    if (key.pose.up != Vec3(0, 1, 0)) json["up"] = vec(key.pose.up);
    json["fov"] = key.pose.fov;
    if (key.pose.orthographic) json["ortho"] = true;
    out += (i > 0 ? ",\n    " : "\n    ") + json.dump();
  }
  return out + "\n  ]\n}\n";
}

CameraKeys read_camera_keys(const std::string& path) {
  return parse_camera_keys(read_file(path, kMostBytes, "a file of camera keys"), path);
}

CameraKeys parse_camera_keys(const std::string& text, const std::string& source) {
  const Json json = parse_document(text, source);
  if (!json.is_object() || !json.contains("format") || json["format"] != "pabd-camera")
    refuse(source, "/format", "\"pabd-camera\": a camera that was saved by 'pabd view'");
  if (!json.contains("version") || json["version"] != 1) refuse(source, "/version", "1");
  CameraKeys out;
  if (json.contains("scene") && json["scene"].is_string()) out.scene = json["scene"].get<std::string>();
  if (!json.contains("keys") || !json["keys"].is_array() || json["keys"].empty() ||
      json["keys"].size() > kMostKeys)
    refuse(source, "/keys", fmt::format("1 to {} keys", kMostKeys));
  for (std::size_t i = 0; i < json["keys"].size(); ++i)
    add_camera_key(out.keys, key_from(json["keys"][i], source, fmt::format("/keys/{}", i)));
  return out;
}

void add_camera_key(std::vector<CameraKey>& keys, const CameraKey& key) {
  const auto at = std::find_if(keys.begin(), keys.end(),
                               [&](const CameraKey& k) { return k.time > key.time - kSameTime; });
  if (at != keys.end() && at->time < key.time + kSameTime) {
    *at = key;
  } else {
    keys.insert(at, key);
  }
}

}  // namespace pabd
