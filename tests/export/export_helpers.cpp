// SPDX-License-Identifier: MIT
// See export_helpers.h.
#include "tests/export/export_helpers.h"

#include <catch2/catch.hpp>
#include <cmath>

namespace pabd::testing {
namespace {

// The eight corners of a box from `lo` to `hi`, with `origin` taken off.
void add_box(const Vec3& lo, const Vec3& hi, const Vec3& origin, std::vector<Vec3>& corners) {
  for (int k = 0; k < 8; ++k)
    corners.push_back(Vec3(k & 1 ? hi.x() : lo.x(), k & 2 ? hi.y() : lo.y(), k & 4 ? hi.z() : lo.z()) -
                      origin);
}

}  // namespace

std::shared_ptr<const Scene> varied_scene() {
  static constexpr const char* kText = R"({ "format": "pabd-scene", "version": 1, "name": "varied",
  "bodies": [
    { "name": "ground", "shape": { "type": "plane", "normal": [0, 1, 0], "offset": 0 }, "fixed": true },
    { "name": "post", "shape": { "type": "box", "size": [0.2, 2, 0.2] }, "fixed": true, "position": [3, 1, 0] },
    { "name": "crate", "shape": { "type": "box", "size": [1, 1, 1] }, "position": [0, 0.6, 0],
      "velocity": [1, 0, 0], "angular_velocity": [0, 9, 1] },
    { "name": "crate \"2\" é", "shape": { "type": "box", "size": [1, 1, 1] }, "position": [0, 2.1, 0.2],
      "color": "#336699", "material": { "opacity": 0.5 } },
    { "name": "ball", "shape": { "type": "sphere", "radius": 0.4 }, "position": [-2, 0.5, 0],
      "angular_velocity": [0, 0, 5], "material": { "checker": true } },
    { "name": "pill", "shape": { "type": "capsule", "radius": 0.2, "length": 0.6 }, "position": [-2, 2, 0] },
    { "name": "can", "shape": { "type": "cylinder", "radius": 0.3, "height": 0.5 }, "position": [-4, 1, 0] },
    { "name": "hat", "shape": { "type": "cone", "radius": 0.3, "height": 0.5 }, "position": [-4, 2, 0] },
    { "name": "arm", "shape": { "type": "box", "size": [1, 0.2, 0.2] }, "position": [3.6, 1.5, 0] },
    { "name": "wedge", "shape": { "type": "mesh", "parts": [
      [[1, 0, 0], [1.6, 0, 0], [1, 0.9, 0], [1, 0, 0.5], [1.6, 0, 0.5], [1, 0.9, 0.5]] ] },
      "position": [-6, 0.7, 0], "angular_velocity": [90, 60, 0] },
    { "name": "angle", "shape": { "type": "mesh", "parts": [
      [[0, 0, 0], [1, 0, 0], [0, 0.2, 0], [1, 0.2, 0], [0, 0, 0.4], [1, 0, 0.4], [0, 0.2, 0.4], [1, 0.2, 0.4]],
      [[0, 0.2, 0], [0.2, 0.2, 0], [0, 0.7, 0], [0.2, 0.7, 0],
       [0, 0.2, 0.4], [0.2, 0.2, 0.4], [0, 0.7, 0.4], [0.2, 0.7, 0.4]] ] },
      "position": [-9, 0.8, 0], "angular_velocity": [0, 45, 90] } ],
  "joints": [ { "name": "pivot", "type": "hinge", "bodies": ["post", "arm"], "anchor": [3.1, 1.5, 0],
                "axis": [0, 0, 1] } ] })";
  return std::make_shared<const Scene>(parse_scene(kText, "varied", "."));
}

const std::vector<Polyhedron>& polyhedra() {
  static const std::vector<Polyhedron> all = [] {
    Polyhedron wedge{"wedge", 9, 0.6 * 0.9 / 2 * 0.5, {}}, angle{"angle", 10, 0.08 + 0.04, {}};
    const Vec3 third(1.2, 0.3, 0.25);  // where the medians of the triangle meet
    for (const double z : {0.0, 0.5})
      for (const Vec3& corner : {Vec3(1, 0, z), Vec3(1.6, 0, z), Vec3(1, 0.9, z)})
        wedge.corners.push_back(corner - third);
    // Two thirds of the matter are about (0.5, 0.1), one about (0.1, 0.45).
    const Vec3 middle(1.1 / 3, 0.65 / 3, 0.2);
    add_box(Vec3(0, 0, 0), Vec3(1, 0.2, 0.4), middle, angle.corners);
    add_box(Vec3(0, 0.2, 0), Vec3(0.2, 0.7, 0.4), middle, angle.corners);
    return std::vector{wedge, angle};
  }();
  return all;
}

Measures measure(const std::vector<Vec3>& corners) {
  Measures out;
  REQUIRE(corners.size() % 3 == 0);
  for (std::size_t k = 0; k < corners.size(); k += 3) {
    const Vec3 &a = corners[k], &b = corners[k + 1], &c = corners[k + 2];
    const double six = a.dot(b.cross(c));
    out.volume += six / 6;
    out.first_moment += six / 24 * (a + b + c);
    out.area += 0.5 * (b - a).cross(c - a).norm();
  }
  return out;
}

void check_surface(const Polyhedron& solid, const std::vector<Vec3>& corners, double margin) {
  CAPTURE(solid.name);
  const Measures all = measure(corners);
  CHECK(all.volume == Approx(solid.volume).margin(margin * all.area));
  CHECK(all.first_moment.norm() < margin * all.area);
  // Each corner is one of the other's.
  const auto farthest = [](const std::vector<Vec3>& from, const std::vector<Vec3>& to) {
    double most = 0;
    for (const Vec3& p : from) {
      double least = HUGE_VAL;
      for (const Vec3& q : to) least = std::min(least, (p - q).norm());
      most = std::max(most, least);
    }
    return most;
  };
  CHECK(farthest(corners, solid.corners) < margin);
  CHECK(farthest(solid.corners, corners) < margin);
}

std::vector<Frame> frames_of(const std::shared_ptr<const Scene>& scene, int count, double fps) {
  Session session(scene, 1);
  session.report_contacts(true);
  session.report_joints(true);
  SessionSource source(std::move(session), count, fps);
  std::vector<Frame> out;
  while (auto frame = source.next([] { return false; })) out.push_back(*std::move(frame));
  return out;
}

void export_frames(const std::string& out, const Scene& scene, const std::vector<Frame>& frames,
                   ExportSetup setup) {
  setup.frames = static_cast<std::int64_t>(frames.size());
  const auto exporter = make_exporter(out, scene, frames.front().a(), setup);
  for (const Frame& frame : frames) exporter->add(frame.number, frame.a());
  exporter->finish();
}

double rotation_error(const Mat3& R, double w, double x, double y, double z) {
  // Written out, so that it does not share a mistake with what it checks.
  Mat3 Q;
  Q << 1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y),  //
      2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x),   //
      2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y);
  return (R - Q).cwiseAbs().maxCoeff();
}

}  // namespace pabd::testing
