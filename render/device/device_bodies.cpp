// SPDX-License-Identifier: MIT
// See device_bodies.h. A frame: bounds; then how many there are of each class, the commands, the instances.
#include "render/device/device_bodies.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <deque>
#include <map>
#include <optional>

#include "render/device/device_hiding.h"
#include "render/device/device_layout.h"
#include "render/device/device_solver.h"
#include "render/device/draw_buffers.h"
#include "render/device/draw_programs.h"
#include "render/device/gl_fence.h"
#include "render/device/shader_files.h"
#include "render/device/value_colors.h"
#include "render/gl/draw_list.h"
#include "render/visual/body_parts.h"
#include "sim/base/error.h"

namespace pabd {
namespace {

constexpr std::size_t kMostClasses = 2048;  // whose counts a work group can hold: 24 of 32 KiB
constexpr std::size_t kPrimitiveClasses = kCubeSides + (kPrimitiveCount - 1) * pabd::kLevels;
constexpr std::size_t kLateFrames = 3;
constexpr std::size_t kBodyLists = 3;  // of DeviceList, the first ones
// Lists that have commands: these, near casters, then what is revealed: bodies, casters, near casters.
constexpr std::size_t kCommandLists = 7;

using namespace device;

void store(float (&out)[4], const Vec3f& v, float w = 0) {
  std::copy_n(v.data(), 3, out);
  out[3] = w;
}
void store(float (&out)[4], const Vec4f& v) { std::copy_n(v.data(), 4, out); }

// The planes of what a camera sees: inside is where their values are positive.
void store_clip(const Mat4f& m, DrawView& out) {
  for (int k = 0; k < 6; ++k) {
    const Vec4f plane = m.row(3).transpose() + (k % 2 == 0 ? 1.0f : -1.0f) * m.row(k / 2).transpose();
    store(out.clip[k], Vec4f(plane / std::max(plane.head<3>().norm(), 1e-30f)));
  }
}

// World to the clip space of the shadow map, as shadow.vert.glsl has it.
Mat4f clip_of(const ShadowVolume& shadow) {
  const auto side = static_cast<float>(shadow.texels);
  const Vec4f scale(2 / side, 2 / side, 2 / shadow.depth_range, 1), origin(-1, -1, -1, 0);
  Mat4f out = scale.asDiagonal() * shadow.world_to_shadow;
  out.col(3) += origin;
  return out;
}

// Of the ball around a primitive of these half sizes, in m.
float radius_around(Primitive primitive, const Vec3f& size) {
  const Vec3f s = size.cwiseAbs();
  if (primitive == Primitive::cube) return s.norm();
  if (primitive == Primitive::cylinder || primitive == Primitive::cone)
    return std::hypot(std::max(s.x(), s.z()), s.y());
  return s.maxCoeff();
}

bool has_levels(Primitive primitive) { return primitive != Primitive::cube && primitive != Primitive::mesh; }

// What a result of the bounds belongs to.
struct Question {
  Eigen::Matrix3f light = Eigen::Matrix3f::Identity();
  std::optional<Ground> floor;
  Vec3f centre;
  float radius;

  bool operator==(const Question& other) const {
    const bool same_floor =
        floor.has_value() == other.floor.has_value() &&
        (!floor || (floor->normal == other.floor->normal && floor->offset == other.floor->offset));
    return same_floor && light == other.light && centre == other.centre && radius == other.radius;
  }
};

}  // namespace

struct DeviceBodies::Impl {
  Impl(GlContext& context, const BodyParts& bodies, unsigned pose_buffer, const DeviceBodiesOptions& o);

  void upload_view();
  float largest(unsigned values);
  std::uint32_t class_of(const BodyPart& part);
  ComputeProgram compile(const char* name, const char* define, const ShaderPart& main) const;
  void ask(const Question& question);
  bool take_oldest(bool wait);
  CasterBounds told() const;

  ComputeFunctions gl;
  DeviceBodiesOptions options;
  std::size_t count;  // bodies
  std::vector<std::shared_ptr<const MeshData>> meshes;
  std::vector<InstanceClass> classes;  // of bodies, then of marks
  std::size_t body_classes = 0;
  std::map<std::pair<int, int>, std::uint32_t> known;  // first class of a primitive and its mesh
  DrawBuffers buffers;
  std::optional<ComputeProgram> count_program, commands_program, emit_program, bounds_program,
      largest_program;
  DrawView view{};
  std::optional<DeviceMarks> marks;
  bool shows_marks = false;
  std::vector<MeshRange> places;  // as in DrawSlot::meshes
  using Batches = std::array<DeviceBatches, kDeviceLists>;
  Batches batches, revealed;
  std::optional<DeviceHiding> hiding;
  Mat4f world_to_clip = Mat4f::Identity(), light_to_clip = Mat4f::Identity();

  struct Asked {
    Question question;
    GlBuffer copy;
    GlFence done;
  };
  std::deque<Asked> asked;
  std::optional<Question> answered;
  DrawBounds answer{};
};

DeviceBodies::Impl::Impl(GlContext& context, const BodyParts& bodies, unsigned pose_buffer,
                         const DeviceBodiesOptions& o)
    : gl(context), options(o), count(bodies.of_body.size()), meshes(bodies.meshes), buffers(gl) {
  buffers.lend(DrawSlot::poses, pose_buffer);
  std::vector<DrawPart> parts;
  for (const BodyPart& part : bodies.parts) {
    DrawPart out{};
    store(out.at, part.at, radius_around(part.primitive, part.size) * 1.0001f);
    store(out.size, part.size, part.size.cwiseAbs().maxCoeff());
    out.first_class = class_of(part);
    out.levels = has_levels(part.primitive) ? pabd::kLevels : 1;
    out.reach = part.size.norm();
    out.sides = part.primitive == Primitive::cube ? 1 : 0;
    parts.push_back(out);
  }
  if (classes.size() > kMostClasses) {
    throw Error(
        ErrorKind::no_context,
        fmt::format("{} different hulls are too many to draw from the GPU, which takes {}: --device cpu",
                    meshes.size(), kMostClasses - kPrimitiveClasses));
  }
  std::vector<std::uint32_t> ranges;
  std::vector<Vec4f> colors;
  for (std::size_t i = 0; i < count; ++i) {
    ranges.push_back(bodies.of_body[i].first << 8 | bodies.of_body[i].count);
    colors.push_back(bodies.colors[i]);
    colors.back().w() = bodies.checkers[i] != 0 ? 2.0f : 1.0f;
  }
  body_classes = classes.size();
  const std::size_t counts = kBodyLists * body_classes, commands = kCommandLists * body_classes;
  const std::vector<InstanceClass> of_marks = DeviceMarks::classes();
  classes.insert(classes.end(), of_marks.begin(), of_marks.end());
  buffers.make(DrawSlot::parts, parts.size() * sizeof(DrawPart), parts.data());
  buffers.make(DrawSlot::ranges, ranges.size() * sizeof(ranges[0]), ranges.data());
  buffers.make(DrawSlot::colors, colors.size() * sizeof(Vec4f), colors.data());
  buffers.make(DrawSlot::view, sizeof(DrawView));
  buffers.make(DrawSlot::counts, counts * sizeof(std::uint32_t));
  buffers.make(DrawSlot::meshes, 2 * body_classes * sizeof(MeshRange));
  buffers.make(DrawSlot::commands, commands * kCommandBytes);
  buffers.make(DrawSlot::bounds, sizeof(DrawBounds));
  for (const DrawSlot slot : {DrawSlot::bodies, DrawSlot::casters, DrawSlot::floor_casters})
    buffers.make(slot, bodies.drawn * sizeof(GpuInstance));
  const auto batch = [&](Batches& of, DeviceList list, DrawSlot slot, std::size_t number) {
    of[static_cast<std::size_t>(list)] = {buffers.id(slot), buffers.id(DrawSlot::commands),
                                          number * body_classes * kCommandBytes,
                                          std::span(classes).first(body_classes)};
  };
  batch(batches, DeviceList::bodies, DrawSlot::bodies, 0);
  batch(batches, DeviceList::casters, DrawSlot::casters, 1);
  batch(batches, DeviceList::floor_casters, DrawSlot::floor_casters, 2);
  batch(batches, DeviceList::near_casters, DrawSlot::casters, 3);
  batch(revealed, DeviceList::bodies, DrawSlot::bodies, 4);
  batch(revealed, DeviceList::casters, DrawSlot::casters, 5);
  batch(revealed, DeviceList::near_casters, DrawSlot::casters, 6);
  count_program.emplace(compile("bodies to draw", "", shaders::device_draw_make_comp));
  emit_program.emplace(compile("instances", "#define EMIT\n", shaders::device_draw_make_comp));
  commands_program.emplace(compile("commands", "", shaders::device_draw_commands_comp));
  bounds_program.emplace(compile("bounds of casters", "", shaders::device_draw_bounds_comp));
  hiding.emplace(gl, buffers, count, body_classes);
}

ComputeProgram DeviceBodies::Impl::compile(const char* name, const char* define,
                                           const ShaderPart& main) const {
  return compile_draw_program(gl, name, body_classes, define, std::array{shaders::device_draw_depths, main});
}

// Levels of one primitive are classes side by side.
std::uint32_t DeviceBodies::Impl::class_of(const BodyPart& part) {
  const auto first = static_cast<std::uint32_t>(classes.size());
  const auto [at, fresh] = known.try_emplace({static_cast<int>(part.primitive), part.mesh}, first);
  if (!fresh) return at->second;
  if (has_levels(part.primitive)) {
    for (int level = 0; level < pabd::kLevels; ++level) classes.push_back({part.primitive, level});
  } else if (part.primitive == Primitive::cube) {
    for (int sides = 0; sides < kCubeSides; ++sides) classes.push_back({part.primitive, 0, sides});
  } else {
    classes.push_back({part.primitive, std::max(part.mesh, 0)});
  }
  return first;
}

void DeviceBodies::Impl::upload_view() {
  view.counts[0] = static_cast<std::uint32_t>(count);
  buffers.renew(DrawSlot::view, &view);
}

// --- colours by value ------------------------------------------------------------------------------------

float DeviceBodies::Impl::largest(unsigned values) {
  if (!largest_program) {
    largest_program.emplace(compile("largest value", "", shaders::device_draw_largest_comp));
    buffers.make(DrawSlot::largest, sizeof(std::uint32_t));
  }
  const GLuint before = buffers.id(DrawSlot::values);
  buffers.lend(DrawSlot::values, values);
  upload_view();
  buffers.clear(DrawSlot::largest);
  buffers.bind();
  run_draw_program(gl, *largest_program, count);
  buffers.lend(DrawSlot::values, before);
  std::uint32_t bits = 0;
  gl.MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  gl.BindBuffer(GL_COPY_READ_BUFFER, buffers.id(DrawSlot::largest));
  gl.GetBufferSubData(GL_COPY_READ_BUFFER, 0, sizeof bits, &bits);
  return std::bit_cast<float>(bits);
}

// --- what casters span -----------------------------------------------------------------------------------

void DeviceBodies::Impl::ask(const Question& question) {
  for (int k = 0; k < 3; ++k) store(view.light[k], Vec3f(question.light.row(k).transpose()));
  if (question.floor) {
    const Vec3f n = question.floor->normal.normalized();
    Vec3f u, v;
    plane_axes(n, u, v);
    store(view.floor, n, question.floor->offset);
    store(view.across[0], u);
    store(view.across[1], v);
  }
  store(view.centre, question.centre, question.radius);
  store(view.limits, Vec4f(kCasterDistance, kCasterReach, kNearFloor, question.floor ? 1.0f : 0.0f));
  upload_view();
  buffers.clear(DrawSlot::bounds);
  buffers.bind();
  run_draw_program(gl, *bounds_program, count);
  Asked now{question, GlBuffer(gl), {}};
  gl.MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  gl.BindBuffer(GL_COPY_WRITE_BUFFER, now.copy.id());
  gl.BufferData(GL_COPY_WRITE_BUFFER, sizeof(DrawBounds), nullptr, GL_STREAM_READ);
  gl.BindBuffer(GL_COPY_READ_BUFFER, buffers.id(DrawSlot::bounds));
  gl.CopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0, sizeof(DrawBounds));
  now.done = GlFence(gl);
  asked.push_back(std::move(now));
}

// False: it is not there yet, and `wait` is false.
bool DeviceBodies::Impl::take_oldest(bool wait) {
  Asked& oldest = asked.front();
  if (wait) {
    oldest.done.wait();
  } else if (!oldest.done.passed()) {
    return false;
  }
  gl.BindBuffer(GL_COPY_READ_BUFFER, oldest.copy.id());
  gl.GetBufferSubData(GL_COPY_READ_BUFFER, 0, sizeof answer, &answer);
  answered = oldest.question;
  asked.pop_front();
  return true;
}

CasterBounds DeviceBodies::Impl::told() const {
  CasterBounds out;
  if (answer.casters == 0) return out;
  for (int axis = 0; axis < 3; ++axis) {
    out.lowest[axis] = -from_ordered(answer.edge[2 * axis]);
    out.highest[axis] = from_ordered(answer.edge[2 * axis + 1]);
  }
  for (int axis = 0; axis < 2 && answer.edge[6] != 0; ++axis) {
    out.floor_lowest[axis] = -from_ordered(answer.edge[6 + 2 * axis]);
    out.floor_highest[axis] = from_ordered(answer.edge[7 + 2 * axis]);
  }
  const double units = answer.reach_low + 65536.0 * answer.reach_high;
  out.reach_sum = static_cast<float>(units / kReachUnits * kCasterReach * answered->radius);
  out.count = static_cast<int>(answer.casters);
  return out;
}

CasterBounds DeviceBodies::bounds(const VisualScene& scene) {
  Impl& m = *impl_;
  Question question{light_axes(towards_light(scene)), {}, scene.centre, scene.radius};
  if (!scene.grounds.empty()) question.floor = scene.grounds.front();
  m.ask(question);
  const bool fresh = !m.options.late_bounds || !m.answered || !(*m.answered == question);
  while (!m.asked.empty() && m.take_oldest(fresh || m.asked.size() > kLateFrames)) {
  }
  return m.told();
}

// --- instances -------------------------------------------------------------------------------------------

void DeviceBodies::make(const InstanceFrame& frame, std::span<const MeshRange> places) {
  Impl& m = *impl_;
  DrawView& view = m.view;
  m.world_to_clip = Eigen::Map<const Mat4f>(frame.uniforms.world_to_clip);
  m.light_to_clip = clip_of(frame.shadow);
  store_clip(m.world_to_clip, view);
  const Mat4f eye = eye_matrix(frame.scene);
  store(view.away, Vec4f(-eye.row(2).transpose()));
  for (int level = 0; level < pabd::kLevels - 1; ++level)
    view.rounder[level] = static_cast<float>(frame.tolerance / (1 - std::cos(kPi / kSegments[level])));
  const Camera& camera = frame.scene.camera;
  store(view.eye, camera.orthographic ? Vec3f(eye.row(2).head<3>().transpose()) : camera.eye,
        camera.orthographic ? 0.0f : 1.0f);
  const auto side = static_cast<float>(frame.shadow.texels);
  store(view.sizes, Vec4f(static_cast<float>(frame.height) / (2 * half_height(camera)),
                          camera.orthographic ? 1.0f : 0.0f, frame.shadow.texel, side * frame.shadow.texel));
  for (int row = 0; row < 2; ++row) {
    store(view.shadow[row], Vec4f(frame.shadow.world_to_shadow.row(row).transpose() / side));
    store(view.floor_map[row], Vec4f(frame.floor.world_to_map.row(row).transpose()));
  }
  const float inverse_side = frame.floor.world_to_map.block<1, 3>(0, 0).norm();
  store(view.floor_size, Vec4f(1 / std::max(inverse_side, 1e-30f), frame.floor.exists ? 1.0f : 0.0f, 0, 0));
  m.upload_view();
  if (!std::equal(places.begin(), places.end(), m.places.begin(), m.places.end())) {
    m.places.assign(places.begin(), places.end());
    std::vector<MeshRange> ranges(places.begin(),
                                  places.begin() + static_cast<std::ptrdiff_t>(m.body_classes));
    for (std::size_t k = 0; k < m.body_classes; ++k) {
      const int sides = m.classes[k].sides;
      ranges.push_back(sides < 0 ? places[k]
                                 : places[k + kCubeSides - 1 - 2 * static_cast<std::size_t>(sides)]);
    }
    m.buffers.renew(DrawSlot::meshes, ranges.data());
  }
  m.buffers.clear(DrawSlot::counts);
  m.buffers.bind();
  run_draw_program(m.gl, *m.count_program, m.count);
  run_draw_program(m.gl, *m.commands_program, kBodyLists);
  run_draw_program(m.gl, *m.emit_program, m.count);
  if (m.marks && m.shows_marks) m.marks->make(frame.scene, places.subspan(m.body_classes));
  m.gl.MemoryBarrier(GL_COMMAND_BARRIER_BIT | GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT);
}

DeviceBodies::DeviceBodies(GlContext& context, const BodyParts& bodies, unsigned poses,
                           const DeviceBodiesOptions& options)
    : impl_(std::make_unique<Impl>(context, bodies, poses, options)) {}

DeviceBodies::~DeviceBodies() = default;

std::span<const InstanceClass> DeviceBodies::classes() const { return impl_->classes; }
const std::vector<std::shared_ptr<const MeshData>>& DeviceBodies::meshes() const { return impl_->meshes; }
const DeviceBatches& DeviceBodies::batches(DeviceList list) const {
  if (list == DeviceList::glyphs && impl_->shows_marks) return impl_->marks->batches();
  return impl_->batches[static_cast<std::size_t>(list)];
}

void DeviceBodies::reveal(DeviceList list, const DepthPicture& depth) {
  Impl& m = *impl_;
  m.hiding->reveal(list, depth, list == DeviceList::bodies ? m.world_to_clip : m.light_to_clip);
}

const DeviceBatches& DeviceBodies::revealed(DeviceList list) const {
  return impl_->revealed[static_cast<std::size_t>(list)];
}

void DeviceBodies::draw_from(unsigned poses) { impl_->buffers.lend(DrawSlot::poses, poses); }

void DeviceBodies::color_by(unsigned values, const ValueRange& range) {
  set_value_colors(values, range, impl_->view, impl_->buffers);
}
float DeviceBodies::largest(unsigned values) { return impl_->largest(values); }

void DeviceBodies::mark_contacts(const Model& model, const DeviceContacts& contacts,
                                 const ContactMarks& marks) {
  Impl& m = *impl_;
  m.shows_marks = contacts.told != 0;
  if (!m.shows_marks) return;
  if (!m.marks) m.marks.emplace(m.gl, model, m.buffers.id(DrawSlot::view));
  m.marks->set(contacts, marks);
}

std::size_t DeviceBodies::bytes() const {
  return impl_->buffers.total() + (impl_->marks ? impl_->marks->bytes() : 0);
}

}  // namespace pabd
