// SPDX-License-Identifier: MIT
// A mesh in memory: the hull of what is taken is a solid with its centre of mass inside.
#pragma once

#include "sim/body/hull.h"
#include "sim/body/shape.h"
#include "sim/scene/mesh_library.h"
#include "tests/fuzz/fuzz.h"

namespace pabd::fuzz {

inline void read_mesh(std::string_view bytes, std::string_view ending) {
  accepts([&] {
    const Hull solid = read_mesh_hull(bytes, ending, 1);
    const HullData& hull = *solid.data;
    require(hull.vertices.size() >= 4 && hull.vertices.size() <= kMostHullVertices &&
                hull.faces.size() <= kMostHullFaces && hull.edges.size() <= kMostHullEdges,
            "a hull is within its limits");
    require(hull.vertices.size() + hull.faces.size() == hull.edges.size() + 2, "Euler: V − E + F = 2");
    require(hull.volume > 0 && hull.second_moment.allFinite() && hull.centroid.allFinite(),
            "a hull has a volume");
    for (const HullFace& face : hull.faces)
      require(face.offset > 0, "the centre of mass is inside of every face");
  });
}

}  // namespace pabd::fuzz
