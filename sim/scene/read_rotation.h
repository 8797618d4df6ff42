// SPDX-License-Identifier: MIT
// Orientations, in each of the ways a scene may say them. Internal to sim/scene.
#pragma once

#include "sim/scene/reader.h"

namespace pabd {

// A rotation matrix, to world, from one of
//   [w, x, y, z]                            unit quaternion; normalised within 1e-3 of length 1
//   { "axis": [x, y, z], "angle": a }       a degrees about an axis of any length but 0, by the right-hand rule
//   { "euler": [a, b, c], "order": "xyz" }  degrees about x, then about the body's new y, then about its new z:
//                                           R = Rx(a) Ry(b) Rz(c). "order": any of the twelve, xyz by default
// and records what the file says in the hash. Multiples of 90 degrees about x, y and z are exact.
Mat3 read_rotation(const Node& node, const ObjectReader& in, std::string_view key);

}  // namespace pabd
