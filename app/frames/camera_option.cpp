// SPDX-License-Identifier: MIT
// Parsing and applying --camera.
#include "app/frames/camera_option.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <string_view>
#include <vector>

#include "app/frames/camera_keys.h"
#include "sim/base/error.h"
#include "sim/math/types.h"

namespace pabd {
namespace {

[[noreturn]] void fail(const std::string& text, const std::string& why) {
  throw Error(ErrorKind::bad_input,
              fmt::format("--camera {}: {}; expected front, side, top, iso, orbit:DEGREES_A_SECOND, "
                          "eye=x,y,z,target=x,y,z,fov=degrees, or a file of camera keys (.json)",
                          text, why));
}

float parse_number(const std::string& text, std::string_view word) {
  float value = 0;
  const auto result = std::from_chars(word.data(), word.data() + word.size(), value);
  if (result.ec != std::errc() || result.ptr != word.data() + word.size() || !(std::abs(value) <= 1e6f)) {
    fail(text, fmt::format("'{}' is not a number up to 1e6", word));
  }
  return value;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  while (true) {
    const auto at = text.find(separator);
    parts.push_back(text.substr(0, at));
    if (at == std::string_view::npos) return parts;
    text.remove_prefix(at + 1);
  }
}

Vec3f to_vector(const std::string& text, std::string_view key, const std::vector<float>& numbers) {
  if (numbers.size() != 3) fail(text, fmt::format("{} has {} numbers and needs 3", key, numbers.size()));
  return {numbers[0], numbers[1], numbers[2]};
}

void set_key(CameraOption& option, const std::string& text, std::string_view key,
             const std::vector<float>& numbers) {
  if (key == "eye" && !option.eye) {
    option.eye = to_vector(text, key, numbers);
  } else if (key == "target" && !option.target) {
    option.target = to_vector(text, key, numbers);
  } else if (key == "fov" && !option.fov) {
    if (numbers.size() != 1 || numbers[0] < 1 || numbers[0] > 170)
      fail(text, "fov is one number, 1 … 170 degrees");
    option.fov = numbers[0];
  } else if (key == "up" && !option.up) {
    option.up = to_vector(text, key, numbers);
    if (!(option.up->norm() > 1e-6f)) fail(text, "up is no direction");
  } else {
    fail(text, fmt::format("'{}' is unknown or given twice", key));
  }
}

}  // namespace

CameraOption parse_camera(const std::string& text) {
  using View = CameraOption::View;
  CameraOption option;
  if (text.empty()) return option;
  if (text == "front") return {View::front, 0, {}, {}, {}, {}, {}};
  if (text == "side") return {View::side, 0, {}, {}, {}, {}, {}};
  if (text == "top") return {View::top, 0, {}, {}, {}, {}, {}};
  if (text == "iso") return {View::iso, 0, {}, {}, {}, {}, {}};
  if (text.starts_with("orbit:")) {
    return {View::orbit, parse_number(text, std::string_view(text).substr(6)), {}, {}, {}, {}, {}};
  }
  if (text.ends_with(".json")) {
    option.keys = read_camera_keys(text).keys;
    return option;
  }

  std::string_view key;
  std::vector<float> numbers;
  for (std::string_view word : split(text, ',')) {
    if (const auto equals = word.find('='); equals != std::string_view::npos) {
      if (!key.empty()) set_key(option, text, key, numbers);
      numbers.clear();
      key = word.substr(0, equals);
      word.remove_prefix(equals + 1);
    } else if (key.empty()) {
      fail(text, fmt::format("'{}' is no view", word));
    }
    numbers.push_back(parse_number(text, word));
  }
  set_key(option, text, key, numbers);
  if (option.eye && option.target && (*option.eye - *option.target).norm() < 1e-6f) {
    fail(text, "eye and target are the same point");
  }
  return option;
}

std::string camera_words(const Camera& camera) {
  const auto three = [](const Vec3f& v) { return fmt::format("{},{},{}", v.x(), v.y(), v.z()); };
  std::string out =
      fmt::format("eye={},target={},fov={}", three(camera.eye), three(camera.target), camera.fov);
  if (camera.up != Vec3f::UnitY()) out += ",up=" + three(camera.up);
  return out;
}

std::string camera_text(const CameraOption& option, const std::string& text) {
  return option.keys.empty() ? text : camera_keys_json({"", option.keys});
}

Camera apply_camera(const CameraOption& option, const Camera& base, double time) {
  using View = CameraOption::View;
  if (!option.keys.empty()) return rounded(camera_at(option.keys, time));
  Camera camera = base;
  const Vec3f offset = base.eye - base.target;
  const float distance = offset.norm();
  switch (option.view) {
    case View::base:
      break;
    case View::front:
      camera.eye = base.target + distance * Vec3f::UnitZ();
      break;
    case View::side:
      camera.eye = base.target + distance * Vec3f::UnitX();
      break;
    case View::top:
      camera.eye = base.target + distance * Vec3f::UnitY();
      camera.up = -Vec3f::UnitZ();
      break;
    case View::iso:
      camera.eye = base.target + distance * Vec3f(1, 1, 1).normalized();
      break;
    case View::orbit: {
      const auto angle = static_cast<float>(std::fmod(option.orbit * time, 360.0) * kPi / 180);
      camera.eye = base.target + Eigen::AngleAxisf(angle, Vec3f::UnitY()) * offset;
      break;
    }
  }
  if (option.eye) camera.eye = *option.eye;
  if (option.target) camera.target = *option.target;
  if (option.fov) camera.fov = *option.fov;
  if (option.up) camera.up = *option.up;
  if ((camera.eye - camera.target).norm() < 1e-6f) {
    throw Error(ErrorKind::bad_input, "--camera: the eye lies in the target; name both eye=… and target=…");
  }
  return camera;
}

}  // namespace pabd
