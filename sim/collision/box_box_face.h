// SPDX-License-Identifier: MIT
// Face contacts of two boxes: the incident face, clipped against the sides of the reference face.
#pragma once

#include "sim/collision/narrow_phase.h"

namespace pabd::narrow {

inline constexpr int kNext[3] = {1, 2, 0};  // the axis after one

// The incident box as the reference box sees it.
struct FaceQuery {
  const Placed<Box>& reference;
  const Placed<Box>& incident;
  double C[3][3];       // C[i][j]: component i, in the reference frame, of axis j of the incident box
  double t[3];          // centre of the incident box in the reference frame; m
  std::uint32_t owner;  // 0 when the reference is the first body, else 1: keeps features apart
};

// Appends up to 8 contacts for the reference face across `axis`. Returns the smallest d over the face, in
// reach or not; kNone when nothing of the incident face is over it.
double add_face_contacts(const FaceQuery& q, int axis, double reach, Contacts& out);

}  // namespace pabd::narrow
