// SPDX-License-Identifier: MIT
// See device_marks.h. A frame: which glyphs there are of each mesh, where each begins, the instances.
#include "render/device/device_marks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>

#include "render/device/compute_program.h"
#include "render/device/device_solver.h"
#include "render/device/draw_buffers.h"
#include "render/device/shader_files.h"
#include "render/gl/draw_list.h"
#include "render/visual/contact_glyphs.h"
#include "render/visual/line_shapes.h"
#include "render/visual/palette.h"

namespace pabd {
namespace {

using namespace device;

constexpr unsigned kThreads = 256;  // of a work group
constexpr std::array kMeshes = {Primitive::disc, Primitive::cylinder, Primitive::cone};
constexpr std::size_t kClasses = kMeshes.size() * pabd::kLevels;

struct GlyphRecord {
  double eye[3], d_hat, forward[3], scale, weight, slope;
  std::uint32_t work_groups, parallel, pad[2];
};
static_assert(sizeof(GlyphRecord) == 96);

struct KnotRecord {
  double x, rgb[3];
};

std::string defines() {
  using namespace glyph;
  constexpr std::pair<const char*, DrawSlot> kBindings[] = {
      {"VIEW", DrawSlot::view},     {"TOLD", DrawSlot::told},     {"COUNTERS", DrawSlot::counters},
      {"FIXED", DrawSlot::fixed},   {"GLYPHS", DrawSlot::glyphs}, {"GLYPH_CLASSES", DrawSlot::glyph_classes},
      {"COUNTS", DrawSlot::counts}, {"MESHES", DrawSlot::meshes}, {"COMMANDS", DrawSlot::commands},
      {"KNOTS", DrawSlot::knots},   {"BODIES", DrawSlot::bodies}};
  std::string out = fmt::format("#define GROUP {}u\n", kThreads);
  for (const auto& [word, slot] : kBindings)
    out += fmt::format("#define DRAW_{} {}\n", word, static_cast<unsigned>(slot));
  constexpr std::pair<const char*, double> kNumbers[] = {{"SHAFT", kShaft},
                                                         {"HEAD", kHead},
                                                         {"HEAD_LENGTH", kHeadLength},
                                                         {"LONGEST", kLongest},
                                                         {"SHORTEST", kShortest},
                                                         {"RIM", kRim},
                                                         {"LEAST_SCALE", kLeastScale},
                                                         {"MOST_GROWN", kMostGrown},
                                                         {"BLUNTEST", kBluntest},
                                                         {"MARK_WIDTH", kMarkWidth},
                                                         {"SIDE", kSide},
                                                         {"SAME_NORMAL", kSameNormal},
                                                         {"NO_FORCE", kNoForce}};
  for (const auto& [word, number] : kNumbers) out += fmt::format("#define {} {:.17e}lf\n", word, number);
  constexpr std::pair<const char*, std::size_t> kCounters[] = {{"OVERFLOW", offsetof(Counters, overflow)},
                                                               {"CONTACTS", offsetof(Counters, contacts)},
                                                               {"PUSHING", offsetof(Counters, pushing)}};
  for (const auto& [word, at] : kCounters) out += fmt::format("#define {} {}u\n", word, at / 4);
  const Vec4f ink = srgb_color(kRimInk);
  out += fmt::format("#define MANY {}u\n#define KNOTS {}u\n#define RIM_INK vec3({:.9e}, {:.9e}, {:.9e})\n",
                     kManyContacts, contact_knots().size(), ink.x(), ink.y(), ink.z());
  return out;
}

}  // namespace

struct DeviceMarks::Impl {
  Impl(const ComputeFunctions& functions, const Model& model, unsigned view);

  ComputeProgram compile(const char* name, const char* pass) const {
    return {gl, name, defines() + "#define " + pass + "\n",
            std::array{shaders::device_draw_view, shaders::device_draw_marks_comp}};
  }
  void run(const ComputeProgram& program, std::size_t work_groups) const {
    program.use();
    gl.DispatchCompute(static_cast<GLuint>(work_groups), 1, 1);
    gl.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  }

  void make_room();
  std::size_t places() const { return kClasses * record.work_groups; }  // where those of work groups begin

  const ComputeFunctions& gl;
  DrawBuffers buffers;
  ComputeProgram count, starts, emit;
  double scale, weight;  // of the model
  GlyphRecord record{};
  std::size_t room = 0;         // of contacts
  std::size_t instances = 256;  // that there is room for
  std::vector<InstanceClass> classes = DeviceMarks::classes();
  DeviceBatches batches;
};

DeviceMarks::Impl::Impl(const ComputeFunctions& functions, const Model& model, unsigned view)
    : gl(functions),
      buffers(gl),
      count(compile("contact glyphs", "COUNT")),
      starts(compile("commands of contact glyphs", "STARTS")),
      emit(compile("instances of contact glyphs", "EMIT")),
      scale(default_glyph_scale(model)),
      weight(typical_weight(model)) {
  buffers.lend(DrawSlot::view, view);
  std::vector<std::uint32_t> fixed(static_cast<std::size_t>(model.size()) / 32 + 1);
  for (std::size_t i = 0; i < model.fixed.size(); ++i)
    if (model.fixed[i] != 0) fixed[i / 32] |= 1u << i % 32;
  std::vector<KnotRecord> knots;
  for (const ContactKnot& k : contact_knots()) knots.push_back({k.x, {k.r, k.g, k.b}});
  buffers.make(DrawSlot::fixed, fixed.size() * sizeof(fixed[0]), fixed.data());
  buffers.make(DrawSlot::knots, knots.size() * sizeof(knots[0]), knots.data());
  buffers.make(DrawSlot::glyphs, sizeof(GlyphRecord));
  buffers.make(DrawSlot::meshes, kClasses * sizeof(MeshRange));
  buffers.make(DrawSlot::commands, kClasses * kCommandBytes);
  buffers.make(DrawSlot::bodies, instances * sizeof(GpuInstance));
  batches = {buffers.id(DrawSlot::bodies), buffers.id(DrawSlot::commands), 0, classes};
}

// For all that were counted: their number comes back.
void DeviceMarks::Impl::make_room() {
  std::uint32_t found = 0;
  gl.MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  gl.BindBuffer(GL_COPY_READ_BUFFER, buffers.id(DrawSlot::counts));
  gl.GetBufferSubData(GL_COPY_READ_BUFFER, static_cast<GLintptr>(places() * sizeof found), sizeof found,
                      &found);
  if (found <= instances) return;
  instances = found + found / 2;
  buffers.make(DrawSlot::bodies, instances * sizeof(GpuInstance));
  buffers.bind();
}

DeviceMarks::DeviceMarks(const ComputeFunctions& gl, const Model& model, unsigned view)
    : impl_(std::make_unique<Impl>(gl, model, view)) {}
DeviceMarks::~DeviceMarks() = default;

std::vector<InstanceClass> DeviceMarks::classes() {
  std::vector<InstanceClass> out;
  for (const Primitive mesh : kMeshes)
    for (int level = 0; level < pabd::kLevels; ++level) out.push_back({mesh, level});
  return out;
}

void DeviceMarks::set(const DeviceContacts& contacts, const ContactMarks& marks) {
  Impl& m = *impl_;
  m.buffers.lend(DrawSlot::told, contacts.told);
  m.buffers.lend(DrawSlot::counters, contacts.counters);
  m.record.d_hat = marks.d_hat;
  m.record.scale = marks.scale > 0 ? marks.scale : m.scale;
  m.record.weight = marks.weight > 0 ? marks.weight : m.weight;
  if (contacts.room == m.room) return;
  m.room = contacts.room;
  m.record.work_groups = static_cast<std::uint32_t>((m.room + kThreads - 1) / kThreads);
  m.buffers.make(DrawSlot::glyph_classes, m.room * sizeof(std::uint32_t));
  m.buffers.make(DrawSlot::counts, (m.places() + 1) * sizeof(std::uint32_t));
}

void DeviceMarks::make(const VisualScene& scene, std::span<const MeshRange> meshes) {
  Impl& m = *impl_;
  const PixelMeter meter(scene.camera);
  std::copy_n(meter.eye().data(), 3, m.record.eye);
  std::copy_n(meter.forward().data(), 3, m.record.forward);
  m.record.slope = meter.slope();
  m.record.parallel = meter.parallel() ? 1 : 0;
  m.buffers.renew(DrawSlot::glyphs, &m.record);
  m.buffers.renew(DrawSlot::meshes, meshes.data());
  m.buffers.bind();
  m.run(m.count, m.record.work_groups);
  m.run(m.starts, 1);
  m.make_room();
  m.run(m.emit, m.record.work_groups);
}

const DeviceBatches& DeviceMarks::batches() const { return impl_->batches; }
std::size_t DeviceMarks::bytes() const { return impl_->buffers.total(); }

}  // namespace pabd
