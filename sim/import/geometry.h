// SPDX-License-Identifier: MIT
// Geoms of robots: their corners and their mass. Internal to sim/import.
#pragma once

#include <optional>
#include <vector>

#include "sim/import/robot.h"

namespace pabd {

// Corners of a convex polyhedron that stands for the geom, in its own frame. Round ones are inscribed: sphere and
// ellipsoid with 162 corners, capsules with 16 sides, cylinders with 32. Empty for a plane.
std::vector<Vec3> corners_of(const RobotGeom& geom);

// Of the geom as solid matter, in the link's frame. Closed forms; a mesh by its surface.
RobotInertia solid_of(const RobotGeom& geom, double density);
// The same for what the geom itself says of its mass.
RobotInertia inertia_of(const RobotGeom& geom);

// In the frame that `pose` leads to.
RobotInertia moved(const RobotInertia& inertia, const LinkPose& pose);
// Both as one body (parallel axes).
RobotInertia together(const RobotInertia& a, const RobotInertia& b);

// Does a body have these moments: positive, none more than the other two together?
bool is_physical(const Mat3& I);
// The same with the least moments raised until one does.
Mat3 made_physical(const Mat3& I);

}  // namespace pabd
