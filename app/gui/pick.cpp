// SPDX-License-Identifier: MIT
// See pick.h. A shot falls on its way: with distance D, flight time T and gravity g it starts with
// v = D/T − ½ g T, which meets the place whatever T is.
#include "app/gui/pick.h"

#include <algorithm>
#include <cmath>

#include "render/visual/joint_glyphs.h"
#include "sim/body/mass_properties.h"
#include "sim/collision/ray_cast.h"

namespace pabd {
namespace {

constexpr double kFlight = 0.6;                             // of a ball, at least; s
constexpr double kLeastDensity = 1e-3, kMostDensity = 1e6;  // kg/m³

// The nearest of several glyphs that is within reach and in sight.
class Nearest {
 public:
  Nearest(const UiState& ui, const Viewport& port, double x, double y, double reach, double hidden)
      : ui_(ui), port_(port), x_(x), y_(y), best_(reach), hidden_(hidden) {}

  void offer(const Vec3& p, const Selection& what) {
    if (!p.allFinite()) return;
    const PixelPoint at = to_pixel(ui_.camera, port_, p);
    if (!(at.depth > 0) || at.depth > hidden_) return;
    const double distance = std::hypot(at.x - x_, at.y - y_);
    if (distance > best_) return;
    best_ = distance;
    found_ = what;
  }
  const Selection& found() const { return found_; }

 private:
  const UiState& ui_;
  const Viewport& port_;
  double x_, y_, best_, hidden_;
  Selection found_;
};

// Number of the first name like that; −1 without one.
template <class List, class NameOf>
Index number_of(const List& list, const std::string& name, const NameOf& name_of) {
  const auto found =
      std::find_if(list.begin(), list.end(), [&](const auto& item) { return name_of(item) == name; });
  return found == list.end() ? -1 : static_cast<Index>(found - list.begin());
}

Selection follow_contact(const Selection& s, const RunView& before, const RunView& after) {
  Selection out = s;
  out.index = -1;
  const auto& old = before.report.contact_reports;
  const bool known = s.index >= 0 && static_cast<std::size_t>(s.index) < old.size();
  double best = std::numeric_limits<double>::infinity();
  const auto& contacts = after.report.contact_reports;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const ContactReport& c = contacts[i];
    if (c.a != s.a || c.b != s.b) continue;
    const double order = known ? (c.y_b - old[static_cast<std::size_t>(s.index)].y_b).squaredNorm() : c.d;
    if (order >= best) continue;
    best = order;
    out.index = static_cast<Index>(i);
  }
  return out;
}

template <class List>
double median(List list, double otherwise) {
  if (list.empty()) return otherwise;
  const auto middle = list.begin() + static_cast<std::ptrdiff_t>(list.size() / 2);
  std::nth_element(list.begin(), middle, list.end());
  return *middle;
}

}  // namespace

std::optional<PickedBody> pick_body(const RunView& run, const CameraPose& camera, const Viewport& port,
                                    double x, double y) {
  if (run.poses) return std::nullopt;
  const ViewRay ray = ray_through(camera, port, x, y);
  const auto hit = ray_cast(*run.model, *run.state, Ray{ray.origin, ray.direction});
  if (!hit) return std::nullopt;
  return PickedBody{hit->body, hit->point, hit->normal, to_pixel(camera, port, hit->point).depth};
}

JointPoints joint_points(const State& state, const Joint& joint) {
  const Pose i = pose_of(state, joint.i), j = pose_of(state, joint.j);
  return {i.c + i.R * joint.on_i.r, j.c + j.R * joint.on_j.r};
}

Selection pick(const RunView& run, const UiState& ui, const Viewport& port, double x, double y,
               double reach) {
  const auto body = pick_body(run, ui.camera, port, x, y);
  double hidden = std::numeric_limits<double>::infinity();
  if (body) {
    const double radius = bounding_radius(run.model->shape[static_cast<std::size_t>(body->body)]);
    hidden = body->depth + (std::isfinite(radius) ? 0.7 * radius : 0.05 * body->depth);
  }
  Nearest nearest(ui, port, x, y, reach, hidden);
  if (ui.bonds) {
    for (std::size_t k = 0; k < run.model->joints.size(); ++k) {
      const JointPoints p = joint_points(*run.state, run.model->joints[k]);
      const Selection what{Selection::Kind::joint, static_cast<Index>(k)};
      nearest.offer(p.on_i, what);
      nearest.offer(p.on_j, what);
    }
  }
  if (ui.contacts) {
    const auto& contacts = run.report.contact_reports;
    for (std::size_t k = 0; k < contacts.size(); ++k) {
      nearest.offer(contacts[k].y_b,
                    {Selection::Kind::contact, static_cast<Index>(k), contacts[k].a, contacts[k].b});
    }
  }
  if (nearest.found().kind != Selection::Kind::none || !body) return nearest.found();
  Selection out{Selection::Kind::body, body->body};
  const auto i = static_cast<std::size_t>(body->body);
  out.at = run.state->R[i].transpose() * (body->point - run.state->c[i]);
  out.normal = run.state->R[i].transpose() * body->normal;
  return out;
}

Selection follow(const Selection& s, const RunView& before, const RunView& after) {
  Selection out = s;
  const bool same = before.model == after.model;
  const auto renumbered = [&](Index body) {
    if (same || body < 0 || body >= before.model->size()) return body;
    const auto i = static_cast<std::size_t>(body);
    if (i < after.model->name.size() && after.model->name[i] == before.model->name[i]) return body;
    return number_of(after.model->name, before.model->name[i], [](const std::string& n) { return n; });
  };
  switch (s.kind) {
    case Selection::Kind::none:
      return s;
    case Selection::Kind::body:
      out.index = renumbered(s.index);
      break;
    case Selection::Kind::joint:
      if (!same && s.index >= 0 && static_cast<std::size_t>(s.index) < before.model->joints.size()) {
        const Joint& joint = before.model->joints[static_cast<std::size_t>(s.index)];
        const Index i = renumbered(joint.i), j = renumbered(joint.j);
        out.index = -1;
        for (std::size_t k = after.model->joints.size(); k-- > 0;) {
          const Joint& other = after.model->joints[k];
          if (other.name == joint.name && other.i == i && other.j == j) out.index = static_cast<Index>(k);
        }
      }
      break;
    case Selection::Kind::contact:
      out.a = renumbered(s.a);
      out.b = renumbered(s.b);
      if (out.a < 0 || out.b < 0) return {};
      return follow_contact(out, before, after);
  }
  const std::size_t count =
      s.kind == Selection::Kind::body ? after.model->shape.size() : after.model->joints.size();
  if (out.index < 0 || static_cast<std::size_t>(out.index) >= count) return {};
  return out;
}

command::Shoot aim(const RunView& run, const CameraPose& camera, const Viewport& port, double x, double y) {
  std::vector<double> sizes, masses;
  for (std::size_t i = 0; i < run.model->shape.size(); ++i) {
    if (run.model->fixed[i]) continue;
    sizes.push_back(bounding_radius(run.model->shape[i]));
    masses.push_back(run.model->mass[i]);
  }
  const auto hit = pick_body(run, camera, port, x, y);
  const ViewRay ray = ray_through(camera, port, x, y);
  const double distance =
      std::max(hit ? (hit->point - ray.origin).norm() : camera.distance(), 1e-3 * camera.distance());
  command::Shoot shot;
  shot.radius = std::min(0.4 * median(sizes, 0.05 * distance), 0.1 * distance);
  const double mass = median(masses, 0);
  if (mass > 0) {
    shot.density = std::clamp(mass / volume(Sphere{shot.radius}), kLeastDensity, kMostDensity);
  }
  const double start = std::min(std::max(4 * shot.radius, 0.1 * distance), 0.5 * distance);
  const Vec3 from = ray.origin + start * ray.direction;
  const Vec3 way = (distance - start) * ray.direction;
  // No further in a step than the ball is thick, so that it meets what is thin.
  const double flight = std::max(kFlight, way.norm() * run.params.h / (2 * shot.radius));
  const Vec3 velocity = way / flight - 0.5 * flight * run.params.gravity;
  shot.from = {from.x(), from.y(), from.z()};
  shot.direction = {velocity.x(), velocity.y(), velocity.z()};
  shot.speed = velocity.norm();
  return shot;
}

}  // namespace pabd
