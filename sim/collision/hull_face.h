// SPDX-License-Identifier: MIT
// Face contacts of two hulls: the incident face, clipped against the sides of the reference face. Internal.
#pragma once

#include "sim/collision/hull_view.h"
#include "sim/collision/narrow_phase.h"

namespace pabd::narrow {

// Kinds of features of two hulls, in the bits above the place.
enum class HullFeature : std::uint32_t {
  incident_corner,
  reference_corner,
  crossing,
  edge_pair,
  corner,
  low_end,  // of a pair of edges that run side by side
  high_end
};

inline std::uint32_t hull_feature(HullFeature kind, std::size_t face, std::size_t place) {
  return static_cast<std::uint32_t>(kind) << 28 | static_cast<std::uint32_t>(face & 255) << 20 |
         static_cast<std::uint32_t>(place);
}

struct HullFaceQuery {
  const HullView& reference;  // in its own frame
  const HullView& incident;   // in the frame of the reference
  const Vec3& c;              // pose of the reference
  const Mat3& R;
  Index reference_number, incident_number;
};

// The face that looks most nearly against n, of all and of those with the vertex that is lowest along n.
int facing(const HullView& hull, const Vec3& n);
int facing_with_lowest(const HullView& hull, const Vec3& n);

// Appends at most eight contacts for that face of the reference and that one of the incident hull. Returns the
// smallest d over the face, in reach or not; kNone when nothing of the incident face is over it.
double add_hull_face(const HullFaceQuery& q, int face, int incident_face, double reach, Contacts& out);

}  // namespace pabd::narrow
