// SPDX-License-Identifier: MIT
// A short run, its frames, and files made of them.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/export/exporter.h"
#include "app/export/session_source.h"
#include "sim/scene/scene.h"

namespace pabd::testing {

// Shapes of every kind (a box that looks like another, a checker, one that can be seen through, a hull, a compound of
// two parts), a plane, a fixed body and a hinge.
std::shared_ptr<const Scene> varied_scene();

// A body of that scene that comes from corners, by hand: what the scene's text says of it, and school geometry.
struct Polyhedron {
  const char* name;
  std::size_t body;
  double volume;              // m³
  std::vector<Vec3> corners;  // of all parts, from the centre of mass; m
};
const std::vector<Polyhedron>& polyhedra();  // the hull and the compound

// ∫ dV and ∫ x dV of what triangles enclose, by the divergence theorem, and their area.
struct Measures {
  double volume = 0, area = 0;
  Vec3 first_moment = Vec3::Zero();
};
Measures measure(const std::vector<Vec3>& corners);  // three a triangle, anticlockwise from outside

// Checks that triangles in a body's own frame are the surface of that polyhedron, to `margin` in m.
void check_surface(const Polyhedron& solid, const std::vector<Vec3>& corners, double margin);

// As `pabd export` has them, with contacts and joints in the reports.
std::vector<Frame> frames_of(const std::shared_ptr<const Scene>& scene, int count, double fps);

// Writes them to `out`.
void export_frames(const std::string& out, const Scene& scene, const std::vector<Frame>& frames,
                   ExportSetup setup);

// Largest difference of a rotation from that of a quaternion w, x, y, z, entry by entry.
double rotation_error(const Mat3& R, double w, double x, double y, double z);

}  // namespace pabd::testing
