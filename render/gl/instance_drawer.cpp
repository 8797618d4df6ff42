// SPDX-License-Identifier: MIT
// Meshes on the GPU and the one instance buffer of a frame.
#include "render/gl/instance_drawer.h"

#include <cstddef>

namespace pabd {
namespace {

const void* offset(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

}  // namespace

InstanceDrawer::InstanceDrawer(const GlFunctions& gl)
    : gl_(gl), array_(gl), vertices_(gl), indices_(gl), instances_(gl), places_{} {
  auto& vertices = primitive_vertices_;
  auto& indices = primitive_indices_;
  for (int kind = 0; kind < kPrimitiveCount; ++kind) {
    for (int level = 0; level < kLevels; ++level) {
      const Mesh mesh = make_mesh(static_cast<Primitive>(kind), level);
      const auto base = static_cast<std::uint32_t>(vertices.size());
      places_[kind][level] = {static_cast<GLsizei>(mesh.indices.size()),
                              indices.size() * sizeof(std::uint32_t)};
      for (const std::uint16_t i : mesh.indices) indices.push_back(base + i);
      vertices.insert(vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
    }
  }
  gl.BindVertexArray(array_.id());
  upload_meshes({});
  gl.VertexAttribPointer(kPositionAttribute, 3, GL_FLOAT, GL_FALSE, sizeof(MeshVertex),
                         offset(offsetof(MeshVertex, position)));
  gl.VertexAttribPointer(kNormalAttribute, 3, GL_FLOAT, GL_FALSE, sizeof(MeshVertex),
                         offset(offsetof(MeshVertex, normal)));
  gl.EnableVertexAttribArray(kPositionAttribute);
  gl.EnableVertexAttribArray(kNormalAttribute);
  for (GLuint a = kRowAttribute; a <= kShadedAttribute; ++a) {
    gl.EnableVertexAttribArray(a);
    gl.VertexAttribDivisor(a, 1);
  }
}

// All vertices and indices anew: meshes come with a scene, not with a frame.
void InstanceDrawer::upload_meshes(const std::vector<std::shared_ptr<const MeshData>>& meshes) {
  std::vector<MeshVertex> vertices = primitive_vertices_;
  std::vector<std::uint32_t> indices = primitive_indices_;
  meshes_ = meshes;
  mesh_places_.clear();
  for (const auto& mesh : meshes_) {
    mesh_places_.push_back(
        {static_cast<GLsizei>(mesh->corners.size()), indices.size() * sizeof(std::uint32_t)});
    for (std::size_t k = 0; k < mesh->corners.size(); ++k) {
      const Vec3f &p = mesh->corners[k], &n = mesh->normals[k];
      indices.push_back(static_cast<std::uint32_t>(vertices.size()));
      vertices.push_back({{p.x(), p.y(), p.z()}, {n.x(), n.y(), n.z()}});
    }
  }
  gl_.BindVertexArray(array_.id());
  gl_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id());
  gl_.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size() * sizeof(indices[0])),
                 indices.data(), GL_STATIC_DRAW);
  gl_.BindBuffer(GL_ARRAY_BUFFER, vertices_.id());
  gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(vertices[0])),
                 vertices.data(), GL_STATIC_DRAW);
}

void InstanceDrawer::upload(const DrawList& list) {
  if (list.meshes != meshes_) upload_meshes(list.meshes);
  const auto bytes = static_cast<GLsizeiptr>(list.instances.size() * sizeof(GpuInstance));
  gl_.BindBuffer(GL_ARRAY_BUFFER, instances_.id());
  gl_.BufferData(GL_ARRAY_BUFFER, bytes, list.instances.data(), GL_STREAM_DRAW);
}

void InstanceDrawer::draw(const DrawList& list, const BatchRange& range, bool (*only)(Primitive)) const {
  gl_.BindVertexArray(array_.id());
  gl_.BindBuffer(GL_ARRAY_BUFFER, instances_.id());
  constexpr GLsizei kStride = sizeof(GpuInstance);
  for (std::size_t i = range.begin; i < range.end; ++i) {
    const Batch& batch = list.batches[i];
    if (only != nullptr && !only(batch.primitive)) continue;
    // GL 3.3 has no base instance: the pointers move instead.
    const std::size_t base = batch.first * sizeof(GpuInstance);
    for (GLuint r = 0; r < 3; ++r) {
      gl_.VertexAttribPointer(kRowAttribute + r, 4, GL_FLOAT, GL_FALSE, kStride,
                              offset(base + offsetof(GpuInstance, rows) + r * sizeof(float[4])));
    }
    gl_.VertexAttribPointer(kColorAttribute, 4, GL_FLOAT, GL_FALSE, kStride,
                            offset(base + offsetof(GpuInstance, color)));
    gl_.VertexAttribPointer(kShadedAttribute, 1, GL_FLOAT, GL_FALSE, kStride,
                            offset(base + offsetof(GpuInstance, shaded)));
    const MeshPlace& mesh = batch.primitive == Primitive::mesh
                                ? mesh_places_[static_cast<std::size_t>(batch.level)]
                                : places_[static_cast<int>(batch.primitive)][batch.level];
    gl_.DrawElementsInstanced(GL_TRIANGLES, mesh.index_count, GL_UNSIGNED_INT, offset(mesh.index_offset),
                              static_cast<GLsizei>(batch.count));
  }
}

}  // namespace pabd
