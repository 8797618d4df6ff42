// SPDX-License-Identifier: MIT
// Parsing and applying --camera.
#include "app/frames/camera_option.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include "app/frames/camera_keys.h"
#include "sim/base/error.h"
#include "sim/math/types.h"

namespace pabd {
namespace {

[[noreturn]] void fail(const std::string& text, const std::string& why) {
  throw Error(ErrorKind::bad_input, fmt::format("--camera {}: {}; expected {}", text, why, camera_help()));
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

// "20" or "8s"; degrees a second.
float orbit_speed(const std::string& text, std::string_view word) {
  if (!word.ends_with('s')) return parse_number(text, word);
  const float turn = parse_number(text, word.substr(0, word.size() - 1));
  if (!(std::abs(turn) >= 0.1f)) fail(text, "a turn takes 0.1 s or more");
  return 360 / turn;
}

// A view, or what is said of it. False when the word is none.
bool take_word(CameraOption& option, const std::string& text, std::string_view word) {
  using View = CameraOption::View;
  static constexpr std::pair<std::string_view, View> kViews[] = {
      {"front", View::front}, {"side", View::side}, {"top", View::top}, {"iso", View::iso}};
  const auto set_view = [&](View view) {
    if (option.view != View::base) fail(text, "two views");
    option.view = view;
  };
  for (const auto& [name, view] : kViews) {
    if (word != name) continue;
    set_view(view);
    return true;
  }
  if (word == "orbit") {
    set_view(View::orbit);
    option.whole_turn = true;
  } else if (word.starts_with("orbit:")) {
    set_view(View::orbit);
    option.orbit = orbit_speed(text, word.substr(6));
  } else if (word == "ortho") {
    option.orthographic = true;
  } else if (word.starts_with("follow:")) {
    option.follow = word.substr(7);
    if (option.follow.empty()) fail(text, "follow: needs the name or number of a body");
  } else if (word.starts_with("fit:")) {
    if (word.size() == 4) fail(text, "fit: needs the name or number of a body");
    option.fit.emplace_back(word.substr(4));
  } else {
    return false;
  }
  return true;
}

}  // namespace

std::string camera_help() {
  return "front, side, top, iso or orbit (once around in the video; orbit:20: degrees a second; orbit:8s: a "
         "turn in "
         "8 s), with ortho (parallel rays), fit:BODY (only these are to be seen; fit:leg*: all that begin "
         "so), "
         "follow:BODY, and any of eye=x,y,z, target=x,y,z, fov=degrees, up=x,y,z, separated by commas; or a "
         "file "
         "of camera keys (.json)";
}

CameraOption parse_camera(const std::string& text) {
  CameraOption option;
  if (text.empty()) return option;
  if (text.ends_with(".json")) {
    option.keys = read_camera_keys(text).keys;
    return option;
  }

  std::string_view key;
  std::vector<float> numbers;
  const auto end_key = [&] {
    if (!key.empty()) set_key(option, text, key, numbers);
    key = {};
    numbers.clear();
  };
  for (std::string_view word : split(text, ',')) {
    if (word.starts_with("follow:") || word.starts_with("fit:") || word.find('=') == std::string_view::npos) {
      if (take_word(option, text, word)) {
        end_key();
        continue;
      }
      if (key.empty()) fail(text, fmt::format("'{}' is no view", word));
    } else {
      end_key();
      const auto equals = word.find('=');
      key = word.substr(0, equals);
      if (key.empty()) fail(text, "a number without a name");
      word.remove_prefix(equals + 1);
    }
    numbers.push_back(parse_number(text, word));
  }
  end_key();
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
  if (camera.orthographic) out += ",ortho";
  return out;
}

std::string camera_text(const CameraOption& option, const std::string& text) {
  return option.keys.empty() ? text : camera_keys_json({"", option.keys});
}

namespace {

// By name, or by number where no body has the name; not a plane.
std::optional<Index> find_body(const Model& model, const std::string& wanted) {
  const auto named = std::find(model.name.begin(), model.name.end(), wanted);
  std::size_t body = static_cast<std::size_t>(named - model.name.begin());
  if (named == model.name.end()) {
    const auto result = std::from_chars(wanted.data(), wanted.data() + wanted.size(), body);
    if (result.ec != std::errc() || result.ptr != wanted.data() + wanted.size()) return std::nullopt;
  }
  if (body >= model.name.size() || is_plane(model.shape[body])) return std::nullopt;
  return static_cast<Index>(body);
}

[[noreturn]] void fail_body(const char* word, const std::string& wanted, const Model& model) {
  throw Error(ErrorKind::bad_input,
              fmt::format("--camera {}:{}: there is no such body; expected its name, or a number below {}",
                          word, wanted, model.name.size()));
}

}  // namespace

std::optional<Index> followed_body(const CameraOption& option, const Model& model) {
  if (option.follow.empty()) return std::nullopt;
  const auto body = find_body(model, option.follow);
  if (!body) fail_body("follow", option.follow, model);
  return body;
}

std::vector<Index> bodies_to_fit(const CameraOption& option, const Model& model) {
  std::vector<std::uint8_t> chosen(model.name.size(), 0);
  for (const std::string& wanted : option.fit) {
    bool any = false;
    if (wanted.ends_with('*')) {
      for (std::size_t i = 0; i < chosen.size(); ++i) {
        if (!model.name[i].starts_with(wanted.substr(0, wanted.size() - 1)) || is_plane(model.shape[i]))
          continue;
        chosen[i] = 1;
        any = true;
      }
    } else if (const auto body = find_body(model, wanted)) {
      chosen[static_cast<std::size_t>(*body)] = 1;
      any = true;
    }
    if (!any) fail_body("fit", wanted, model);
  }
  std::vector<Index> out;
  for (std::size_t i = 0; i < chosen.size(); ++i)
    if (chosen[i]) out.push_back(static_cast<Index>(i));
  return out;
}

Camera apply_camera(const CameraOption& option, const Camera& base, double time, const Vec3& way) {
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
  if (option.orthographic) camera.orthographic = true;
  camera.eye += way.cast<float>();
  camera.target += way.cast<float>();
  if ((camera.eye - camera.target).norm() < 1e-6f) {
    throw Error(ErrorKind::bad_input, "--camera: the eye lies in the target; name both eye=… and target=…");
  }
  return camera;
}

}  // namespace pabd
