// SPDX-License-Identifier: MIT
// Paths of points of a run: of a body, or of the centre of mass of all that moves.
#pragma once

#include <string>
#include <vector>

#include "sim/body/model.h"
#include "sim/body/state.h"

namespace pabd {

inline constexpr double kTrailTime = 2;  // s of the past, if nobody says so

struct TrailPoint {
  std::string body;        // name; empty: the centre of mass of all movable bodies
  Vec3 at = Vec3::Zero();  // on it; body frame, m
  bool operator==(const TrailPoint&) const = default;
};

// "NAME", "NAME@x,y,z", or "com". `option` is named in messages. Throws Error(bad_input).
TrailPoint parse_trail(const std::string& text, const std::string& option);
// parse_trail gives it back.
std::string trail_words(const TrailPoint& point);
// Throws Error(bad_input) when the model has no such body.
void check_trail(const TrailPoint& point, const Model& model, const std::string& option);

struct Trail {
  std::vector<Vec3> path;  // oldest first; world, m. Where one is no number the trail is broken
};

class TrailRecorder {
 public:
  TrailRecorder() = default;
  TrailRecorder(std::vector<TrailPoint> points, double seconds);

  const std::vector<TrailPoint>& points() const { return points_; }
  // Adds where the points are now, and drops what is later (the run was wound back) or older than the recorder's time. The
  // trail of a removed body ends. `unseen`: the way from the last place to this one was not shown; the trail has a gap.
  void add(const Model& model, const State& state, bool unseen = false);
  std::vector<Trail> trails() const;

 private:
  struct Moment {
    double time;  // s
    bool gap;     // before it
    std::vector<Vec3> at;
  };
  std::vector<TrailPoint> points_;
  double seconds_ = kTrailTime;
  std::vector<Moment> moments_;
};

}  // namespace pabd
