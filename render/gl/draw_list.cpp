// SPDX-License-Identifier: MIT
// Sorting instances into batches.
#include "render/gl/draw_list.h"

#include <algorithm>
#include <cmath>

#include "render/gl/frame_uniforms.h"

namespace pabd {
namespace {

GpuInstance pack(const Instance& instance) {
  GpuInstance out;
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 4; ++c) out.rows[r][c] = instance.transform(r, c);
  }
  for (int i = 0; i < 4; ++i) out.color[i] = instance.color[i];
  out.shaded = instance.checker ? 2.0f : instance.shaded ? 1.0f : 0.0f;
  return out;
}

float largest_scale(const Mat4f& m) {
  return std::sqrt(m.block<3, 3>(0, 0).colwise().squaredNorm().maxCoeff());
}

}  // namespace

struct DrawList::Eye {
  Mat4f matrix;     // world to eye
  float pixels;     // of a thing of size 1 at distance 1
  float texel;      // of the shadow map, m
  float tolerance;  // of outlines, pixels
  bool parallel;    // rays: a thing is as large at any distance as at 1
};

void DrawList::build(const VisualScene& scene, int height, float texel, float tolerance,
                     GlyphShapes* shapes) {
  instances.clear();
  batches.clear();
  caster_entries_.clear();
  floor_entries_.clear();
  body_entries_.clear();
  glyph_entries_.clear();
  transparent_entries_.clear();
  ghost_entries_.clear();

  const float pixels = static_cast<float>(height) / (2 * half_height(scene.camera));
  const Eye eye{eye_matrix(scene), pixels, texel, tolerance, scene.camera.orthographic};
  for (int kind = 0; kind < kPrimitiveCount; ++kind) {
    for (const Instance& instance : scene.instances[kind])
      add(scene, eye, instance, static_cast<Primitive>(kind), -1);
  }
  meshes.clear();
  for (const MeshInstances& mesh : scene.meshes) {
    const int number = static_cast<int>(meshes.size());
    meshes.push_back(mesh.mesh);
    for (const Instance& instance : mesh.instances) add(scene, eye, instance, Primitive::mesh, number);
  }

  const auto near_first = [](const Entry& a, const Entry& b) { return a.depth < b.depth; };
  const auto far_first = [](const Entry& a, const Entry& b) { return a.depth > b.depth; };
  std::stable_sort(body_entries_.begin(), body_entries_.end(), near_first);
  std::stable_sort(glyph_entries_.begin(), glyph_entries_.end(), far_first);
  if (shapes != nullptr) {
    std::erase_if(glyph_entries_, [&](const Entry& e) {
      const float metre = eye.pixels / (eye.parallel ? 1 : std::max(e.depth, 1e-12f));
      return shapes->add(*e.instance, e.primitive, e.level, metre);
    });
  }
  std::stable_sort(transparent_entries_.begin(), transparent_entries_.end(), far_first);
  casters = near_casters = append(caster_entries_, true);
  floor_casters = append(floor_entries_, true);
  bodies = append(body_entries_, true);
  glyphs = append(glyph_entries_, true);
  transparent = append(transparent_entries_, false);
  ghosts = append(ghost_entries_, true);
}

// `mesh`: its number, or −1 for a primitive.
void DrawList::add(const VisualScene& scene, const Eye& eye, const Instance& instance, Primitive primitive,
                   int mesh) {
  if (!instance.transform.allFinite() || !instance.color.allFinite()) return;
  const bool flat_sided = primitive == Primitive::cube || mesh >= 0;  // one level does for all
  const int only_level = std::max(mesh, 0);
  const float scale = largest_scale(instance.transform);
  const float depth = -(eye.matrix.row(2).dot(instance.transform.col(3)));
  const float radius =
      eye.pixels * scale / (eye.parallel ? 1 : std::max(depth - scale, 1e-3f * scale + 1e-12f));
  const Entry entry{&instance, primitive, flat_sided ? only_level : level_for_radius(radius, eye.tolerance),
                    depth};
  if (instance.color.w() < 1) {
    if (instance.color.w() > 0) transparent_entries_.push_back(entry);
    if (instance.color.w() > 0 && instance.xray) ghost_entries_.push_back(entry);
  } else if (instance.xray) {
    glyph_entries_.push_back(entry);
  } else {
    body_entries_.push_back(entry);
  }
  if (!instance.shadow || instance.color.w() < 1) return;
  // Half a texel is as good as a pixel here: the filter is six texels wide.
  const int level =
      flat_sided ? only_level : std::min(2, level_for_radius(0.5f * scale / eye.texel, eye.tolerance));
  caster_entries_.push_back({&instance, primitive, level, 0});
  if (scene.grounds.empty()) return;
  const Ground& floor = scene.grounds.front();
  const float above = floor.normal.dot(instance.transform.block<3, 1>(0, 3)) - floor.offset;
  if (above >= 3 * scale) return;
  floor_entries_.push_back({&instance, primitive, flat_sided ? only_level : std::min(1, level), 0});
}

// Grouped: one batch a mesh, the order inside kept. Otherwise the order is kept and a batch ends where the
// mesh changes.
BatchRange DrawList::append(std::vector<Entry>& entries, bool grouped) {
  const auto mesh_of = [](const Entry& e) { return static_cast<int>(e.primitive) * kLevels + e.level; };
  if (grouped) {
    std::stable_sort(entries.begin(), entries.end(),
                     [&](const Entry& a, const Entry& b) { return mesh_of(a) < mesh_of(b); });
  }
  BatchRange range{batches.size(), batches.size()};
  for (const Entry& entry : entries) {
    const bool same = batches.size() > range.begin && batches.back().primitive == entry.primitive &&
                      batches.back().level == entry.level;
    if (!same) {
      batches.push_back({entry.primitive, entry.level, static_cast<std::uint32_t>(instances.size()), 0});
    }
    ++batches.back().count;
    instances.push_back(pack(*entry.instance));
  }
  range.end = batches.size();
  return range;
}

}  // namespace pabd
