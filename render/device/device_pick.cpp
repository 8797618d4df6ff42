// SPDX-License-Identifier: MIT
// See device_pick.h.
#include "render/device/device_pick.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "render/device/compute_program.h"
#include "render/device/draw_buffers.h"
#include "render/device/shader_files.h"
#include "sim/body/mass_properties.h"

namespace pabd {
namespace {

using namespace device;

constexpr unsigned kPickThreads = 256;  // of a work group
constexpr std::uint32_t kFirst = 128;   // bodies that are read at once with their number

struct RayRecord {
  double origin[4], direction[4];
  std::uint32_t bodies, room, pad[6];
};
struct MetHead {
  std::uint32_t count, pad[7];
};
struct Met {
  std::uint32_t body, pad[7];
  device::Pose at;
};
static_assert(sizeof(MetHead) == 32 && sizeof(Met) == 96);

// The next float above.
float rounded_up(double x) {
  return std::nextafter(static_cast<float>(x), std::numeric_limits<float>::infinity());
}

ComputeProgram compile(const ComputeFunctions& gl) {
  const auto number = [](DrawSlot slot) { return static_cast<unsigned>(slot); };
  const std::string defines = fmt::format(
      "#define GROUP {}u\n#define DRAW_POSES {}\n#define DRAW_REACHES {}\n#define DRAW_RAY {}\n"
      "#define DRAW_MET {}\n",
      kPickThreads, number(DrawSlot::poses), number(DrawSlot::reaches), number(DrawSlot::ray),
      number(DrawSlot::met));
  return {gl, "bodies along a ray", defines,
          std::array{shaders::device_draw_pose, shaders::device_pick_comp}};
}

}  // namespace

struct DevicePick::Impl {
  Impl(GlContext& context, const Model& m, unsigned poses)
      : gl(context), model(m), buffers(gl), program(compile(gl)) {
    buffers.lend(DrawSlot::poses, poses);
    std::vector<float> reaches;
    for (const Shape& shape : model.shape) reaches.push_back(rounded_up(bounding_radius(shape)));
    buffers.make(DrawSlot::reaches, reaches.size() * sizeof(float), reaches.data());
    buffers.make(DrawSlot::ray, sizeof(RayRecord));
    make_room(kFirst);
  }

  void make_room(std::uint32_t bodies) {
    room = bodies;
    buffers.make(DrawSlot::met, sizeof(MetHead) + bodies * sizeof(Met));
  }
  std::uint32_t find(const Ray& ray);
  void read(std::size_t offset, std::size_t bytes, void* out);

  ComputeFunctions gl;
  const Model& model;
  DrawBuffers buffers;
  ComputeProgram program;
  std::uint32_t room = 0;
  struct {
    MetHead head;
    Met met[kFirst];
  } first;
  std::vector<Met> met;
  std::size_t bytes = 0;
};

void DevicePick::Impl::read(std::size_t offset, std::size_t size, void* out) {
  gl.BindBuffer(GL_COPY_READ_BUFFER, buffers.id(DrawSlot::met));
  gl.GetBufferSubData(GL_COPY_READ_BUFFER, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(size), out);
  bytes += size;
}

// How many there are; the first of them are in `first`.
std::uint32_t DevicePick::Impl::find(const Ray& ray) {
  const Vec3 u = ray.direction / ray.direction.stableNorm();
  RayRecord record{};
  std::copy_n(ray.origin.data(), 3, record.origin);
  std::copy_n(u.data(), 3, record.direction);
  record.bodies = static_cast<std::uint32_t>(model.size());
  record.room = room;
  buffers.renew(DrawSlot::ray, &record);
  buffers.clear(DrawSlot::met);
  buffers.bind();
  program.use();
  gl.DispatchCompute((record.bodies + kPickThreads - 1) / kPickThreads, 1, 1);
  gl.MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  read(0, sizeof first, &first);
  return first.head.count;
}

DevicePick::DevicePick(GlContext& context, const Model& model, unsigned poses)
    : impl_(std::make_unique<Impl>(context, model, poses)) {}
DevicePick::~DevicePick() = default;

std::optional<RayHit> DevicePick::operator()(const Ray& ray) {
  Impl& m = *impl_;
  m.bytes = 0;
  if (!ray.origin.allFinite() || !ray.direction.allFinite() || !(ray.direction.stableNorm() > 0))
    return std::nullopt;
  std::uint32_t count = m.find(ray);
  if (count > m.room) {
    m.make_room(2 * count);
    count = m.find(ray);
  }
  m.met.assign(m.first.met, m.first.met + std::min(count, kFirst));
  if (count > kFirst) {
    m.met.resize(count);
    m.read(sizeof m.first, (count - kFirst) * sizeof(Met), m.met.data() + kFirst);
  }
  std::sort(m.met.begin(), m.met.end(), [](const Met& x, const Met& y) { return x.body < y.body; });
  std::vector<PlacedBody> some;
  for (const auto& [body, pad, at] : m.met) {
    const auto& [c, q] = at;
    some.push_back(
        {static_cast<Index>(body), Vec3(c[0], c[1], c[2]), Quat(q[3], q[0], q[1], q[2]).toRotationMatrix()});
  }
  return ray_cast(m.model, some, ray);
}

std::size_t DevicePick::bytes_read() const { return impl_->bytes; }

}  // namespace pabd
