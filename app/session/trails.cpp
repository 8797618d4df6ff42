// SPDX-License-Identifier: MIT
// See trails.h.
#include "app/session/trails.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

#include "sim/base/error.h"

namespace pabd {
namespace {

constexpr double kPieces = 400;  // of a trail at most

[[noreturn]] void refuse(const std::string& option, const std::string& text, const std::string& why) {
  throw Error(
      ErrorKind::bad_input,
      fmt::format("{} {}: {}; expected com, or BODY or BODY@x,y,z with a point in the body's frame in m",
                  option, text, why));
}

std::size_t number_of(const Model& model, const std::string& name) {
  return static_cast<std::size_t>(std::find(model.name.begin(), model.name.end(), name) - model.name.begin());
}

Vec3 centre_of_mass(const Model& model, const State& state) {
  Vec3 sum = Vec3::Zero();
  double mass = 0;
  for (std::size_t i = 0; i < model.mass.size(); ++i) {
    sum += model.mass[i] * state.c[i];
    mass += model.mass[i];
  }
  return sum / mass;  // of nothing: no number
}

Vec3 place_of(const TrailPoint& point, const Model& model, const State& state) {
  if (point.body.empty()) return centre_of_mass(model, state);
  const std::size_t i = number_of(model, point.body);
  if (i >= state.c.size()) return Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
  return state.c[i] + state.R[i] * point.at;
}

}  // namespace

TrailPoint parse_trail(const std::string& text, const std::string& option) {
  TrailPoint point;
  if (text == "com") return point;
  const std::size_t at = text.rfind('@');
  point.body = text.substr(0, at);
  if (point.body.empty()) refuse(option, text, "no body is named");
  if (at == std::string::npos) return point;
  const char *next = text.data() + at + 1, *end = text.data() + text.size();
  for (int k = 0; k < 3; ++k) {
    const auto result = std::from_chars(next, end, point.at[k]);
    const bool follows = k < 2 ? result.ptr != end && *result.ptr == ',' : result.ptr == end;
    if (result.ec != std::errc() || !follows || !(std::abs(point.at[k]) <= 1e6))
      refuse(option, text, "behind the @ there are no three numbers up to 1e6");
    next = result.ptr + (k < 2 ? 1 : 0);
  }
  return point;
}

std::string trail_words(const TrailPoint& point) {
  if (point.body.empty()) return "com";
  if (point.at.isZero(0)) return point.body;
  return fmt::format("{}@{},{},{}", point.body, point.at.x(), point.at.y(), point.at.z());
}

void check_trail(const TrailPoint& point, const Model& model, const std::string& option) {
  if (!point.body.empty() && number_of(model, point.body) >= model.name.size())
    refuse(option, trail_words(point), "there is no body of that name");
}

TrailRecorder::TrailRecorder(std::vector<TrailPoint> points, double seconds)
    : points_(std::move(points)), seconds_(seconds) {}

void TrailRecorder::add(const Model& model, const State& state, bool unseen) {
  if (points_.empty()) return;
  // What took the way past here showed it: only a gap that this place lies in stays one.
  bool gap = unseen;
  for (; !moments_.empty() && moments_.back().time >= state.time; moments_.pop_back())
    gap = moments_.back().gap;
  // The last one moves along until it is far enough from the one before.
  const std::size_t count = moments_.size();
  if (count > 1 && !gap && !moments_[count - 1].gap &&
      moments_[count - 1].time - moments_[count - 2].time < seconds_ / kPieces)
    moments_.pop_back();
  Moment now{state.time, gap, {}};
  for (const TrailPoint& point : points_) now.at.push_back(place_of(point, model, state));
  moments_.push_back(std::move(now));
  const auto first = std::find_if(moments_.begin(), moments_.end(),
                                  [&](const Moment& m) { return m.time >= state.time - seconds_; });
  moments_.erase(moments_.begin(), first);
}

std::vector<Trail> TrailRecorder::trails() const {
  std::vector<Trail> out(points_.size());
  for (std::size_t k = 0; k < points_.size(); ++k) {
    for (const Moment& moment : moments_) {
      if (moment.gap && !out[k].path.empty())
        out[k].path.push_back(Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
      out[k].path.push_back(moment.at[k]);
    }
  }
  return out;
}

}  // namespace pabd
