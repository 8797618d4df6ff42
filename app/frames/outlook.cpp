// SPDX-License-Identifier: MIT
// See outlook.h.
#include "app/frames/outlook.h"

#include <algorithm>
#include <cmath>

#include "app/session/session.h"
#include "sim/base/error.h"
#include "sim/body/shape_kind.h"

namespace pabd {
namespace {

constexpr double kLongestStep = 1.0 / 120;  // s: where bodies go by and large does not need more
constexpr double kMostWork = 30'000;        // bodies × steps
constexpr double kMadeEnergy = 0.02;        // of the energy there is, above what drives brought
constexpr int kMoments = 120;               // that are kept of it
constexpr double kWhole = 0.9;              // of the time: from then on it is known where what falls ends
constexpr double kAway = 6;       // radii of the start, from its middle: who ends nearer has not left
constexpr double kFarther = 1.5;  // times as far as half of those at rest: the same
constexpr double kFarthest = 60;  // radii of the start: where all leave, what is nearer is shown
constexpr int kFew = 5;           // fewer bodies all matter
constexpr int kOneOf = 10;        // one of so many may be far away
constexpr double kOutside = 2;    // times as far as the others go: far away

double median_of(std::vector<double> list) {
  if (list.empty()) return 0;
  const auto middle = list.begin() + static_cast<std::ptrdiff_t>(list.size() / 2);
  std::nth_element(list.begin(), middle, list.end());
  return *middle;
}

double way_from(const BoundingSphere& around, const Vec3& c) { return (c - around.centre).norm(); }

bool is_slow(const Model& model, const State& state, Index i) {
  // It would take more than a second to leave its place.
  return state.v[i].norm() < bounding_radius(model.shape[i]);
}

// Whether a plane is below it, on which it is, or will be.
bool is_over_plane(const Model& model, const State& state, Index i, const Vec3& gravity) {
  const auto catches = [&](const Shape& shape) {
    if (!is_plane(shape)) return false;
    const Plane& plane = as<Plane>(shape);
    const double above = plane.normal.dot(state.c[i]) - plane.offset;
    return plane.normal.dot(gravity) < 0 && above > -bounding_radius(model.shape[i]);
  };
  return std::any_of(model.shape.begin(), model.shape.end(), catches);
}

bool moves(const Model& model, const std::vector<std::uint8_t>& seen, Index i) {
  const auto at = static_cast<std::size_t>(i);
  return seen[at] && !model.fixed[at];
}

// Those farthest away, if they are few and the others near.
void drop_outliers(const BoundingSphere& around, const std::vector<double>& way,
                   std::vector<std::uint8_t>& matters) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < matters.size(); ++i)
    if (matters[i]) order.push_back(i);
  const auto count = static_cast<int>(order.size());
  if (count < kFew) return;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return way[a] < way[b]; });
  const int droppable = (count + kOneOf - 1) / kOneOf;
  const double near = std::max(around.radius, way[order[static_cast<std::size_t>(count - droppable - 1)]]);
  for (int k = count - droppable; k < count; ++k) {
    const std::size_t i = order[static_cast<std::size_t>(k)];
    if (way[i] > kOutside * near) matters[i] = 0;
  }
}

// Where bodies are, and how fast they go.
State places_of(const State& state) {
  State out;
  out.time = state.time;
  out.c = state.c;
  out.R = state.R;
  out.v = state.v;
  return out;
}

// Places at the moments, the last one at the end.
std::vector<State> run_ahead(const std::shared_ptr<const Scene>& scene, const FrameView& start,
                             double seconds) {
  std::vector<State> out;
  Session ahead(scene);
  Params params = start.params;
  const double movable =
      static_cast<double>(std::count(start.model->fixed.begin(), start.model->fixed.end(), 0));
  // Its own steps lead where it will go; longer ones nearly there.
  if (seconds / params.h * movable > kMostWork) params.h = std::max(params.h, kLongestStep);
  const double steps = std::min(seconds / params.h, kMostWork / std::max(1.0, movable));
  const int count = static_cast<int>(steps), every = std::max(1, count / kMoments);
  try {
    ahead.restore(start.model, *start.state);
    ahead.set_params(params);
    double allowed = 0, most = 0;  // energy that there may be, and the largest that there was of one kind; J
    for (int step = 1; step <= count; ++step) {
      const StepReport& report = ahead.step();
      if (report.status == StepStatus::non_finite) break;
      // Steps that are too long for the scene make energy: what follows is no way that bodies go.
      const double energy = report.kinetic + report.potential + report.elastic;
      allowed = step == 1 ? energy : allowed + report.drive_work;
      most = std::max({most, report.kinetic, std::abs(report.potential)});
      if (energy - allowed > kMadeEnergy * most) break;
      if (step % every == 0 || step == count) out.push_back(places_of(ahead.state()));
    }
  } catch (const Error&) {  // it has no way to be told
    out.clear();
  }
  return out;
}

// The time from which on half of what matters is farther away than it fell onto what it goes on, or than 60 radii.
double time_near(const Model& model, const BoundingSphere& around, const std::vector<std::uint8_t>& matters,
                 const std::vector<State>& states, const Vec3& gravity) {
  const Vec3 down = gravity.normalized();
  std::vector<double> landed;
  const State& end = states.back();
  for (Index i = 0; i < model.size(); ++i) {
    if (matters[static_cast<std::size_t>(i)] &&
        std::abs(end.v[i].dot(down)) < bounding_radius(model.shape[i]))
      landed.push_back((end.c[i] - around.centre).dot(down));
  }
  const double far = std::max(kFarthest * around.radius, kFarther * median_of(landed));
  for (const State& state : states) {
    std::vector<double> way;
    for (Index i = 0; i < model.size(); ++i)
      if (matters[static_cast<std::size_t>(i)]) way.push_back(way_from(around, state.c[i]));
    if (median_of(way) > far) return state.time;
  }
  return std::numeric_limits<double>::infinity();
}

}  // namespace

std::vector<Spot> Outlook::all() const {
  std::vector<Spot> out = start;
  for (const TimedSpots& moment : moments)
    if (moment.time < until) out.insert(out.end(), moment.spots.begin(), moment.spots.end());
  return out;
}

std::vector<std::uint8_t> who_matters(const Model& model, const BoundingSphere& around,
                                      const std::vector<double>& way, const State& end,
                                      const std::vector<std::uint8_t>& seen, const Vec3& gravity) {
  std::vector<double> at_rest, all;
  for (Index i = 0; i < model.size(); ++i) {
    if (!moves(model, seen, i)) continue;
    all.push_back(way_from(around, end.c[i]));
    if (is_slow(model, end, i)) at_rest.push_back(all.back());
  }
  double far = kAway * around.radius;
  if (!at_rest.empty() && 2 * at_rest.size() >= all.size())
    far = std::max(far, kFarther * median_of(at_rest));
  std::vector<std::uint8_t> matters(seen.size(), 0);
  const auto mark = [&](auto&& stays) {
    bool any = false;
    for (Index i = 0; i < model.size(); ++i) {
      if (!moves(model, seen, i) || !stays(i)) continue;
      matters[static_cast<std::size_t>(i)] = 1;
      any = true;
    }
    return any;
  };
  const bool any = mark([&](Index i) {
    return way_from(around, end.c[i]) <= far || is_slow(model, end, i) ||
           is_over_plane(model, end, i, gravity);
  });
  if (!any) mark([](Index) { return true; });
  drop_outliers(around, way, matters);
  return matters;
}

Outlook look_ahead(const std::shared_ptr<const Scene>& scene, const FrameView& start, double seconds,
                   const std::vector<Index>& only) {
  const Model& model = *start.model;
  Outlook out;
  out.start_time = start.state->time;
  const auto around = bounding_sphere(model, *start.state);
  std::vector<State> states;
  if (seconds > 0 && around) states = run_ahead(scene, start, seconds);
  const bool whole = !states.empty() && states.back().time > out.start_time + kWhole * seconds;
  const std::vector<std::uint8_t> seen = bodies_in_picture(model, *start.state);
  std::vector<std::uint8_t> matters(seen.size(), only.empty() ? 1 : 0);
  for (const Index i : only) {
    matters[static_cast<std::size_t>(i)] = 1;
    add_spots(model.shape[i], {start.state->c[i], start.state->R[i]}, out.start);
  }
  if (only.empty()) out.start = whole ? body_spots(model, *start.state) : spots_of(model, *start.state);
  if (states.empty()) return out;
  if (only.empty()) {
    std::vector<double> way(seen.size(), 0);
    for (const State& state : states)
      for (std::size_t i = 0; i < way.size(); ++i) way[i] = std::max(way[i], way_from(*around, state.c[i]));
    matters = who_matters(model, *around, way, states.back(), seen, start.params.gravity);
  }
  std::vector<double> radii;
  out.far.resize(seen.size(), 0);
  for (Index i = 0; i < model.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    const bool movable = moves(model, seen, i);
    out.far[at] = only.empty() && movable && !matters[at] ? 1 : 0;
    if (!movable) matters[at] = 0;
    if (matters[at]) radii.push_back(bounding_radius(model.shape[i]));
  }
  out.body = median_of(radii);
  if (radii.empty()) return out;
  const auto middle_of = [&](const State& state) {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < matters.size(); ++i)
      if (matters[i]) sum += state.c[i];
    return Vec3(sum / static_cast<double>(radii.size()));
  };
  out.start_middle = middle_of(*start.state);
  for (const State& state : states) {
    TimedSpots& moment = out.moments.emplace_back(TimedSpots{state.time, middle_of(state), {}});
    for (Index i = 0; i < model.size(); ++i)
      if (matters[static_cast<std::size_t>(i)])
        add_spots(model.shape[i], {state.c[i], state.R[i]}, moment.spots);
  }
  out.until = time_near(model, *around, matters, states, start.params.gravity);
  return out;
}

Outlook look_ahead(const std::shared_ptr<const Scene>& scene, double seconds) {
  FrameView start;
  start.model = {scene, &scene->model};
  start.params = scene->params;
  start.state = {scene, &scene->initial};
  return look_ahead(scene, start, seconds);
}

}  // namespace pabd
