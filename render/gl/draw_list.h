// SPDX-License-Identifier: MIT
// Instances in the order they are drawn, cut into batches of one mesh each. Plain numbers, no GL.
#pragma once

#include <vector>

#include "render/gl/device_instances.h"
#include "render/gl/glyph_shapes.h"
#include "render/visual/primitive_mesh.h"
#include "render/visual/visual_scene.h"

namespace pabd {

// One instance as the shaders see it.
struct GpuInstance {
  float rows[3][4];  // the affine transform, row by row
  float color[4];
  float shaded;  // 1: lit, 2: lit and with a checker, 0: flat colour
};

struct Batch {
  Primitive primitive;
  int level;  // of detail; of a mesh: its number in DrawList::meshes
  std::uint32_t first;
  std::uint32_t count;
};

struct BatchRange {
  std::size_t begin = 0;
  std::size_t end = 0;
  const DeviceBatches* device = nullptr;  // drawn after them; not owned
};

// Everything that is drawn from instances in one frame; one upload.
struct DrawList {
  std::vector<GpuInstance> instances;
  std::vector<Batch> batches;
  std::vector<std::shared_ptr<const MeshData>> meshes;
  BatchRange casters;        // into the shadow map
  BatchRange near_casters;   // the same; of the GPU: their sides towards the sun
  BatchRange floor_casters;  // those near the first floor
  BatchRange bodies;         // opaque, near ones first so that what they hide costs nothing
  BatchRange glyphs;         // opaque glyphs that show through bodies
  BatchRange transparent;    // far ones first
  BatchRange ghosts;         // those of them that show through bodies

  // Fills the list from the scene; `height` is that of the frame in pixels, `texel` that of a shadow texel in
  // m, `tolerance` that of outlines in pixels. `shapes`, if any, gets the glyphs that it can take in place of `glyphs`.
  void build(const VisualScene& scene, int height, float texel, float tolerance = kOutlineTolerance,
             GlyphShapes* shapes = nullptr);

 private:
  struct Entry {
    const Instance* instance;
    Primitive primitive;
    int level;
    float depth;  // distance from the eye plane
  };
  struct Eye;  // how large and how far things are
  void add(const VisualScene& scene, const Eye& eye, const Instance& instance, Primitive primitive, int mesh);
  BatchRange append(std::vector<Entry>& entries, bool grouped);

  std::vector<Entry> caster_entries_, floor_entries_, body_entries_, glyph_entries_, transparent_entries_,
      ghost_entries_;
};

}  // namespace pabd
