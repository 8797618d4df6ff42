// SPDX-License-Identifier: MIT
// Meshes on the GPU and the one instance buffer of a frame.
#include "render/gl/instance_drawer.h"

#include <cstddef>

#include "sim/base/error.h"

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
      places_[kind][level] = {static_cast<std::uint32_t>(mesh.indices.size()),
                              static_cast<std::uint32_t>(indices.size())};
      for (const std::uint16_t i : mesh.indices) indices.push_back(base + i);
      vertices.insert(vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
    }
  }
  add_cube_sides();
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

// Three sides of a cube, at whose corner all eyes are that see no others: the same triangles in the same order.
void InstanceDrawer::add_cube_sides() {
  const MeshRange cube = places_[static_cast<int>(Primitive::cube)][0];
  for (int sides = 0; sides < kCubeSides; ++sides) {
    const auto first = static_cast<std::uint32_t>(primitive_indices_.size());
    for (std::uint32_t k = cube.first; k < cube.first + cube.count; ++k) {
      const std::uint32_t index = primitive_indices_[k];
      const float(&n)[3] = primitive_vertices_[index].normal;
      const int axis = n[0] != 0 ? 0 : n[1] != 0 ? 1 : 2;
      if ((n[axis] > 0) == ((sides >> axis & 1) != 0)) primitive_indices_.push_back(index);
    }
    cube_sides_[sides] = {static_cast<std::uint32_t>(primitive_indices_.size()) - first, first};
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
        {static_cast<std::uint32_t>(mesh->corners.size()), static_cast<std::uint32_t>(indices.size())});
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

MeshRange InstanceDrawer::place(const InstanceClass& mesh) const {
  if (mesh.primitive == Primitive::mesh) return mesh_places_[static_cast<std::size_t>(mesh.level)];
  return mesh.sides >= 0 ? cube_sides_[mesh.sides] : places_[static_cast<int>(mesh.primitive)][mesh.level];
}

void InstanceDrawer::allow_device(GlContext& context) {
  if (draw_indirect_ != nullptr) return;
  draw_indirect_ =
      reinterpret_cast<PFNGLDRAWELEMENTSINDIRECTPROC>(context.proc_address("glDrawElementsIndirect"));
  const int version = 10 * gl_.integer(GL_MAJOR_VERSION) + gl_.integer(GL_MINOR_VERSION);
  if (draw_indirect_ != nullptr && version >= 43) return;
  draw_indirect_ = nullptr;
  throw Error(ErrorKind::no_context, context.name() + ": " + gl_.string(GL_RENDERER) +
                                         " cannot draw what is on the GPU, which takes OpenGL 4.3: --device "
                                         "cpu, or: " +
                                         driver_remedy());
}

// `first`: byte of the buffer.
void InstanceDrawer::bind_instances(GLuint buffer, std::size_t first) const {
  constexpr GLsizei kStride = sizeof(GpuInstance);
  gl_.BindBuffer(GL_ARRAY_BUFFER, buffer);
  for (GLuint r = 0; r < 3; ++r) {
    gl_.VertexAttribPointer(kRowAttribute + r, 4, GL_FLOAT, GL_FALSE, kStride,
                            offset(first + offsetof(GpuInstance, rows) + r * sizeof(float[4])));
  }
  gl_.VertexAttribPointer(kColorAttribute, 4, GL_FLOAT, GL_FALSE, kStride,
                          offset(first + offsetof(GpuInstance, color)));
  gl_.VertexAttribPointer(kShadedAttribute, 1, GL_FLOAT, GL_FALSE, kStride,
                          offset(first + offsetof(GpuInstance, shaded)));
}

void InstanceDrawer::draw(const DrawList& list, const BatchRange& range, bool (*only)(Primitive)) const {
  gl_.BindVertexArray(array_.id());
  for (std::size_t i = range.begin; i < range.end; ++i) {
    const Batch& batch = list.batches[i];
    if (only != nullptr && !only(batch.primitive)) continue;
    // GL 3.3 has no base instance: the pointers move instead.
    bind_instances(instances_.id(), batch.first * sizeof(GpuInstance));
    const MeshRange mesh = place({batch.primitive, batch.level});
    gl_.DrawElementsInstanced(GL_TRIANGLES, static_cast<GLsizei>(mesh.count), GL_UNSIGNED_INT,
                              offset(mesh.first * sizeof(std::uint32_t)), static_cast<GLsizei>(batch.count));
  }
  if (range.device != nullptr) draw_device(*range.device, only);
}

void InstanceDrawer::draw_device(const DeviceBatches& device, bool (*only)(Primitive)) const {
  bind_instances(device.instances, 0);
  gl_.BindBuffer(GL_DRAW_INDIRECT_BUFFER, device.commands);
  for (std::size_t k = 0; k < device.classes.size(); ++k) {
    if (only != nullptr && !only(device.classes[k].primitive)) continue;
    draw_indirect_(GL_TRIANGLES, GL_UNSIGNED_INT, offset(device.first_command + k * kCommandBytes));
  }
}

}  // namespace pabd
