// SPDX-License-Identifier: MIT
// Bodies as triangles with a material each: those that the renderer draws (render/visual), put together to one mesh a
// body in its own frame. Bodies alike share a mesh. Metres, y up; colours are linear-light RGB in 0 … 1.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "render/visual/visual_scene.h"
#include "sim/body/body_look.h"
#include "sim/body/model.h"

namespace pabd {

// Vertices are those of one surface each: a corner of a box has three. `light` and `dark` are triangles, three vertex
// numbers each, anticlockwise from outside; the dark ones are the fields of a checker, empty without one.
struct BodyMesh {
  std::vector<Vec3f> positions;  // body frame; m
  std::vector<Vec3f> normals;    // body frame; unit
  std::vector<std::uint32_t> light, dark;
};

inline constexpr int kNoMesh = -1;

// Of physically based materials: that of the renderer's highlights, about.
inline constexpr double kBodyRoughness = 0.6;

struct MeshedBody {
  std::string name;
  int mesh = kNoMesh;     // of MeshedBodies::meshes; kNoMesh: a plane
  int material = 0;       // of MeshedBodies::materials
  int dark_material = 0;  // of the dark fields, where there are any
  bool fixed = false;
};

struct MeshedBodies {
  std::vector<BodyMesh> meshes;
  std::vector<Vec4f> materials;    // linear RGB, opacity
  std::vector<MeshedBody> bodies;  // one a body of the model
};

// `looks` by number, may be shorter than the list of bodies. `segments`: around round bodies, one of kSegments
// (primitive_mesh.h).
MeshedBodies mesh_bodies(const Model& model, const std::vector<BodyLook>& looks, int segments);

// A plane as two triangles in world coordinates, seen from above: a square around what is nearest to the middle of
// `around`. half: its half edge, m.
BodyMesh plane_mesh(const Plane& plane, const Vec3& around, double half);

}  // namespace pabd
