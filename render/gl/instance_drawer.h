// SPDX-License-Identifier: MIT
// Meshes on the GPU and the one instance buffer of a frame.
#pragma once

#include "render/gl/draw_list.h"
#include "render/gl/gl_objects.h"

namespace pabd {

// Vertex attributes of every program that draws instances, as shaders/instance.glsl has them.
inline constexpr GLuint kPositionAttribute = 0;
inline constexpr GLuint kNormalAttribute = 1;
inline constexpr GLuint kRowAttribute = 2;  // and the two after it
inline constexpr GLuint kColorAttribute = 5;
inline constexpr GLuint kShadedAttribute = 6;

class InstanceDrawer {
 public:
  explicit InstanceDrawer(const GlFunctions& gl);

  void upload(const DrawList& list);
  // Where a mesh that upload() has put on the GPU lies in the buffer of indices. Its level: as in Batch.
  MeshRange place(const InstanceClass& mesh) const;
  // Before a list with batches of the GPU is drawn. Throws Error(no_context) where the context cannot.
  void allow_device(GlContext& context);
  // Draws the batches of `range` with the program in use. `only`: a filter on the primitive, or null.
  void draw(const DrawList& list, const BatchRange& range, bool (*only)(Primitive) = nullptr) const;

 private:
  const GlFunctions& gl_;
  GlVertexArray array_;
  GlBuffer vertices_;
  GlBuffer indices_;
  GlBuffer instances_;
  MeshRange places_[kPrimitiveCount][kLevels];
  MeshRange cube_sides_[kCubeSides];
  std::vector<MeshVertex> primitive_vertices_;
  std::vector<std::uint32_t> primitive_indices_;
  std::vector<std::shared_ptr<const MeshData>> meshes_;  // on the GPU, after the primitives
  std::vector<MeshRange> mesh_places_;

  PFNGLDRAWELEMENTSINDIRECTPROC draw_indirect_ = nullptr;  // of OpenGL 4.3, which only this needs

  void bind_instances(GLuint buffer, std::size_t first) const;
  void draw_device(const DeviceBatches& device, bool (*only)(Primitive)) const;
  void add_cube_sides();
  void upload_meshes(const std::vector<std::shared_ptr<const MeshData>>& meshes);
};

}  // namespace pabd
