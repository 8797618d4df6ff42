// SPDX-License-Identifier: MIT
// Instances that the GPU itself makes, where poses are there already: nothing of them comes to the processor. Whoever
// offers some (render/device) implements DeviceInstances; Renderer::draw() takes it beside a VisualScene.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "render/gl/frame_uniforms.h"

namespace pabd {

// What is drawn by one command: instances of one mesh.
struct InstanceClass {
  Primitive primitive;
  int level = 0;   // of detail; of a mesh: its number in DeviceInstances::meshes()
  int sides = -1;  // of a cube: the three whose normals are positive along the axes of its bits; −1: all six
};
inline constexpr int kCubeSides = 8;  // such threes

// Where a mesh lies in the buffer of indices.
struct MeshRange {
  std::uint32_t count = 0, first = 0;
  bool operator==(const MeshRange& other) const { return count == other.count && first == other.first; }
};

inline constexpr std::size_t kCommandBytes = 20;  // of glDrawElementsIndirect()

// What is drawn into one map or picture: one command a class, in order.
struct DeviceBatches {
  unsigned instances = 0;         // GL name of a buffer: GpuInstance (draw_list.h)
  unsigned commands = 0;          // GL name of a buffer
  std::size_t first_command = 0;  // byte of it
  std::span<const InstanceClass> classes;
};

enum class DeviceList {
  bodies,         // opaque
  casters,        // into the shadow map
  floor_casters,  // into the map of the first floor
  near_casters,   // casters, with the sides towards the sun where those have the sides away from it
  glyphs,         // opaque, which show through bodies
};
inline constexpr int kDeviceLists = 5;

// Depths in [0, 1], least at the eye, into which some of a list has been drawn.
struct DepthPicture {
  unsigned texture = 0;  // GL name; of several samples: multisampled
  int width = 0, height = 0, samples = 1;
};

// Of the frame to be drawn.
struct InstanceFrame {
  const VisualScene& scene;
  const FrameUniforms& uniforms;
  const ShadowVolume& shadow;
  const FloorVolume& floor;
  int height;       // pixels
  float tolerance;  // of outlines; pixels
};

class DeviceInstances {
 public:
  virtual ~DeviceInstances() = default;

  virtual std::span<const InstanceClass> classes() const = 0;
  virtual const std::vector<std::shared_ptr<const MeshData>>& meshes() const = 0;

  // Around the casters, for the maps of light. May be that of a frame or two before, so that nobody waits.
  virtual CasterBounds bounds(const VisualScene& scene) = 0;
  // Makes the instances and the commands of all lists, but for bodies and casters that others hid in the frame before.
  // `meshes`: of each class. Throws Error(no_context).
  virtual void make(const InstanceFrame& frame, std::span<const MeshRange> meshes) = 0;
  // As the last make() left it; stays where it is. Without classes where there is nothing.
  virtual const DeviceBatches& batches(DeviceList list) const = 0;

  // Makes those that make() left out and that `depth` does not hide, into which the others have been drawn: together they
  // are all that can be seen. `list`: bodies; or casters, with near_casters. Binds another program, and no framebuffer.
  virtual void reveal(DeviceList list, const DepthPicture& depth) = 0;
  // As the last reveal() left it.
  virtual const DeviceBatches& revealed(DeviceList list) const = 0;
};

}  // namespace pabd
