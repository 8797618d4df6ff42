// SPDX-License-Identifier: MIT
// Edges and corners that a neighbour hides: what rolls over a floor of tiles feels a floor.
//
// Of several bodies together only the nearest point counts. The edge of a tile ahead lies in the surface of the tile
// under a wheel as well, which is nearer: by itself, the edge would push the wheel back.
#pragma once

#include <vector>

#include "sim/body/model.h"
#include "sim/collision/detect.h"

namespace pabd {

// Removes from `points`, contacts of bodies at the poses c, R, those of round bodies and flat ones where the flat one's
// point lies in the surface of a third body, or of another part of its compound, that touches the round one along another
// normal and is no farther.
//   flush    what is closer than this to a surface lies in it; m
//   by_body  memory: numbers of contacts
void remove_hidden(const Model& model, const std::vector<Vec3>& c, const std::vector<Mat3>& R, double flush,
                   std::vector<std::size_t>& by_body, std::vector<ContactPoint>& points);

}  // namespace pabd
