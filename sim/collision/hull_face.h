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

// Appends at most eight contacts for that face of the reference. Returns the smallest d over the face, in
// reach or not; kNone when nothing of the incident face is over it.
double add_hull_face(const HullFaceQuery& q, int face, double reach, Contacts& out);

}  // namespace pabd::narrow
