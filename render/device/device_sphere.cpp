// SPDX-License-Identifier: MIT
// See device_sphere.h. The GPU looks at what moves, the processor at what is fixed.
#include "render/device/device_sphere.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <tuple>

#include "render/device/compute_program.h"
#include "render/device/draw_buffers.h"
#include "render/device/shader_files.h"
#include "render/visual/body_parts.h"
#include "sim/body/mass_properties.h"

namespace pabd {
namespace {

using namespace device;

constexpr unsigned kSphereThreads = 256;  // of a work group

struct Piece {
  float at[4], size[4];
  std::uint32_t form, first, count, pad;
};
struct Span {
  double centre[4];
  std::uint32_t bodies, radius, edge[6];
};
static_assert(sizeof(Piece) == 48 && sizeof(Span) == 64);

struct Corner {
  float at[4];
};

ComputeProgram compile(const ComputeFunctions& gl, const char* name, const char* define) {
  std::string defines = fmt::format("#define GROUP {}u\n{}", kSphereThreads, define);
  for (const auto& [word, slot] : {std::pair("POSES", DrawSlot::poses),
                                   {"PARTS", DrawSlot::parts},
                                   {"RANGES", DrawSlot::ranges},
                                   {"REACHES", DrawSlot::reaches},
                                   {"MESHES", DrawSlot::meshes},
                                   {"BOUNDS", DrawSlot::bounds}})
    defines += fmt::format("#define DRAW_{} {}\n", word, static_cast<unsigned>(slot));
  for (const auto& [word, form] : {std::pair("CUBE", Primitive::cube),
                                   {"SPHERE", Primitive::sphere},
                                   {"HEMISPHERE", Primitive::hemisphere},
                                   {"CONE", Primitive::cone},
                                   {"MESH", Primitive::mesh}})
    defines += fmt::format("#define {} {}u\n", word, static_cast<unsigned>(form));
  return {gl, name, defines, std::array{shaders::device_draw_pose, shaders::device_sphere_comp}};
}

// What the GPU told of the bodies that move, with those that are fixed.
struct Wide {
  Vec3 lo = Vec3::Constant(std::numeric_limits<double>::infinity()), hi = -lo;

  void take_in(const Aabb& box) {
    lo = lo.cwiseMin(box.lo);
    hi = hi.cwiseMax(box.hi);
  }
  bool empty() const { return !(lo.array() <= hi.array()).all(); }
  Vec3 centre() const { return 0.5 * (lo + hi); }
};

}  // namespace

struct DeviceSphere::Impl {
  Impl(GlContext& context, const Model& model, const State& start, const BodyParts& bodies, unsigned poses);

  Span ask(const ComputeProgram& program, const Vec3& centre);
  double radius_around(const Vec3& centre);

  // Of those that are fixed.
  struct Fixed {
    Aabb box;
    Vec3 c;
    double radius;
  };

  ComputeFunctions gl;
  std::uint32_t count;
  std::vector<Fixed> fixed;
  DrawBuffers buffers;
  ComputeProgram edges, radius;
};

DeviceSphere::Impl::Impl(GlContext& context, const Model& model, const State& start, const BodyParts& bodies,
                         unsigned poses)
    : gl(context),
      count(static_cast<std::uint32_t>(model.size())),
      buffers(gl),
      edges(compile(gl, "what bodies span", "")),
      radius(compile(gl, "how far bodies are", "#define RADIUS\n")) {
  std::vector<Corner> corners;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> of_mesh;  // first corner, and how many
  for (const auto& mesh : bodies.meshes) {
    of_mesh.emplace_back(static_cast<std::uint32_t>(corners.size()),
                         static_cast<std::uint32_t>(mesh->corners.size()));
    for (const Vec3f& at : mesh->corners) corners.push_back({{at.x(), at.y(), at.z(), 0}});
  }
  std::vector<Piece> pieces;
  for (const BodyPart& part : bodies.parts) {
    Piece out{};
    std::copy_n(part.at.data(), 3, out.at);
    std::copy_n(part.size.data(), 3, out.size);
    out.form = static_cast<std::uint32_t>(part.primitive);
    if (part.primitive == Primitive::mesh)
      std::tie(out.first, out.count) = of_mesh[static_cast<std::size_t>(part.mesh)];
    pieces.push_back(out);
  }
  std::vector<std::uint32_t> ranges;
  std::vector<float> reaches;
  for (Index i = 0; i < model.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    const bool moves = !model.fixed[at];
    ranges.push_back(bodies.of_body[at].first << 8 | bodies.of_body[at].count);
    reaches.push_back(moves ? static_cast<float>(bounding_radius(model.shape[at])) : 0.0f);
    if (moves || is_plane(model.shape[at]) || !has_finite_pose(start, i)) continue;
    fixed.push_back(
        {bounds(model.shape[at], start.c[at], start.R[at]), start.c[at], bounding_radius(model.shape[at])});
  }
  buffers.lend(DrawSlot::poses, poses);
  buffers.make(DrawSlot::parts, pieces.size() * sizeof(Piece), pieces.data());
  buffers.make(DrawSlot::ranges, ranges.size() * sizeof(ranges[0]), ranges.data());
  buffers.make(DrawSlot::reaches, reaches.size() * sizeof(float), reaches.data());
  buffers.make(DrawSlot::meshes, corners.size() * sizeof(Corner), corners.data());
  buffers.make(DrawSlot::bounds, sizeof(Span));
}

Span DeviceSphere::Impl::ask(const ComputeProgram& program, const Vec3& centre) {
  Span span{};
  std::copy_n(centre.data(), 3, span.centre);
  span.bodies = count;
  buffers.renew(DrawSlot::bounds, &span);
  buffers.bind();
  program.use();
  gl.DispatchCompute((count + kSphereThreads - 1) / kSphereThreads, 1, 1);
  gl.MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  gl.BindBuffer(GL_COPY_READ_BUFFER, buffers.id(DrawSlot::bounds));
  gl.GetBufferSubData(GL_COPY_READ_BUFFER, 0, sizeof span, &span);
  return span;
}

// Of what moves, 0 where nothing does.
double DeviceSphere::Impl::radius_around(const Vec3& centre) {
  return static_cast<double>(std::bit_cast<float>(ask(radius, centre).radius));
}

DeviceSphere::DeviceSphere(GlContext& context, const Model& model, const State& start,
                           const BodyParts& bodies, unsigned poses)
    : impl_(std::make_unique<Impl>(context, model, start, bodies, poses)) {}
DeviceSphere::~DeviceSphere() = default;

void DeviceSphere::look_at(unsigned poses) { impl_->buffers.lend(DrawSlot::poses, poses); }

std::optional<BoundingSphere> DeviceSphere::operator()() {
  Impl& m = *impl_;
  Wide wide;
  const Span span = m.ask(m.edges, Vec3::Zero());
  if (span.edge[0] != 0) {
    for (int axis = 0; axis < 3; ++axis) {
      wide.lo[axis] = -static_cast<double>(from_ordered(span.edge[2 * axis]));
      wide.hi[axis] = static_cast<double>(from_ordered(span.edge[2 * axis + 1]));
    }
  }
  const bool moves = !wide.empty();
  const Vec3 middle = wide.centre();
  const double around = moves ? m.radius_around(middle) : 0;
  std::vector<const Impl::Fixed*> seen;
  for (const Impl::Fixed& body : m.fixed) {
    if (moves && is_scenery({middle, around}, body.c, body.radius)) continue;
    seen.push_back(&body);
    wide.take_in(body.box);
  }
  if (wide.empty()) return std::nullopt;
  const Vec3 centre = wide.centre();
  double radius = 0;
  if (moves) radius = centre == middle ? around : m.radius_around(centre);
  for (const Impl::Fixed* body : seen) radius = std::max(radius, (body->c - centre).norm() + body->radius);
  return BoundingSphere{centre, std::max(radius, 1e-6)};
}

}  // namespace pabd
