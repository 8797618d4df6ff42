// SPDX-License-Identifier: MIT
// What bodies look like in their own frames, for renderers that place them on the GPU and for exports. build_visual.h
// draws the same from a State.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "render/visual/build_visual.h"
#include "sim/body/shape_kind.h"

namespace pabd {

// A piece of a body, in the body frame.
struct BodyPart {
  Primitive primitive;
  int mesh = -1;      // in BodyParts::meshes
  Vec3f at{0, 0, 0};  // m
  Vec3f size{
      1, 1, 1};  // primitive to body: a scale along each axis, y and z negative where it is turned about x; m
};

struct BodyParts {
  struct Range {
    std::uint32_t first = 0, count = 0;
  };
  std::vector<BodyPart> parts;  // bodies alike share them
  std::vector<Range> of_body;
  std::vector<Vec4f> colors;           // of a body: linear RGB, opacity
  std::vector<std::uint8_t> checkers;  // a body: every other eighth is darker
  std::vector<std::shared_ptr<const MeshData>> meshes;
  std::size_t drawn = 0;  // parts of all bodies together
};

// Bodies that are not opaque have no parts: they are drawn in an order, which takes their poses.
BodyParts body_parts(const Model& model, const VisualOptions& options = {});
// Appends the planes, which have no parts.
void add_grounds(const Model& model, VisualScene& out);

// The primitive that a part of a surface is, `mesh` of a polyhedron.
Primitive primitive_of(SurfaceForm form);
// Of a part that is no polyhedron: primitive to body.
Vec3 scale_of(const SurfacePart& part);
// The triangles of a hull, face by face, scaled to radius 1.
std::shared_ptr<const MeshData> triangles_of(const HullData& hull);
// Colour of a body by the options; opacity 1.
Vec4f color_of(const Model& model, const VisualOptions& options, Index body);

}  // namespace pabd
