// SPDX-License-Identifier: MIT
// Bodies as instances of primitives; contacts and bonds as glyphs.
//
//   c, R       pose of a body                             State
//   S          scale of the primitive: half edges, radius
//   transform  [R S | c]                                  primitive to world
#include "render/visual/build_visual.h"

#include <cassert>

#include "render/visual/body_marks.h"
#include "render/visual/body_parts.h"
#include "render/visual/bounds.h"
#include "render/visual/contact_glyphs.h"
#include "render/visual/force_chains.h"
#include "render/visual/joint_glyphs.h"
#include "render/visual/line_shapes.h"
#include "render/visual/outline.h"
#include "render/visual/palette.h"
#include "sim/body/shape_kind.h"
#include "sim/joint/expand.h"

namespace pabd {
namespace {

constexpr double kApart = 4;  // pixels between two rings that do not blur into one

// The list of the hull's instances; the mesh is made when it is seen first.
MeshInstances& mesh_of(const Hull& hull, VisualScene& out) {
  for (MeshInstances& mesh : out.meshes) {
    if (mesh.source == hull.data) return mesh;
  }
  out.meshes.push_back({triangles_of(*hull.data), hull.data, {}});
  return out.meshes.back();
}

struct BodyPainter {
  VisualScene& out;
  Vec3 c;
  Mat3 R;
  Vec4f color;
  bool shadow = true;
  bool checker = false;
  bool xray = false;

  void operator()(const SurfacePart& part) const {
    const Primitive primitive = primitive_of(part.form);
    Mat4f m = Mat4f::Identity();
    m.block<3, 1>(0, 3) = (c + R * part.at).cast<float>();
    if (primitive == Primitive::mesh) {
      m.block<3, 3>(0, 0) = (part.hull->data->bounding_radius * R).cast<float>();
      mesh_of(*part.hull, out).instances.push_back({m, color, shadow, true, xray, checker});
      return;
    }
    m.block<3, 3>(0, 0) = (R * scale_of(part).asDiagonal()).cast<float>();
    out.instances[static_cast<int>(primitive)].push_back({m, color, shadow, true, xray, checker});
  }
};

// `parts` is room that is used again for the next body.
void add_body(const Shape& shape, const BodyPainter& painter, std::vector<SurfacePart>& parts) {
  parts.clear();
  kind_of(shape).surface(shape, parts);
  for (const SurfacePart& part : parts) painter(part);
  if (is_plane(shape)) {
    const Plane& plane = as<Plane>(shape);
    painter.out.grounds.push_back({plane.normal.cast<float>(), static_cast<float>(plane.offset)});
  }
}

void add_selection(const Model& model, const State& state, const StepReport& report,
                   const VisualOptions& options, double scale, VisualScene& out) {
  if (const auto body = options.selected_body; body && *body >= 0 && *body < model.size())
    add_outline(model.shape[*body], {state.c[*body], state.R[*body]}, out);
  if (const auto number = options.selected_joint; number && *number < model.joints.size()) {
    const Joint& joint = model.joints[*number];
    if (!options.bonds) add_joint_glyphs(model, state, joint, out);
    const Vec3 y_i = place(joint.on_i, pose_of(state, joint.i)).y;
    const Vec3 y_j = place(joint.on_j, pose_of(state, joint.j)).y;
    add_ring(y_i, 0, out);
    if ((y_j - y_i).norm() > kApart * PixelMeter(out.camera).at(y_i)) add_ring(y_j, 0, out);
  }
  if (const auto number = options.selected_contact; number && *number < report.contact_reports.size()) {
    const ContactReport& contact = report.contact_reports[*number];
    if (!options.contacts) add_contact_glyph(model, contact, options, scale, typical_weight(model), out);
    add_ring(contact.y_a, 1.5 * scale, out);
  }
}

}  // namespace

ContactQuantity contact_quantity(const std::string& name) {
  for (const ContactQuantity one : {ContactQuantity::force, ContactQuantity::friction}) {
    if (name == kContactQuantities[static_cast<std::size_t>(one)]) return one;
  }
  return ContactQuantity::gap;
}

void build_visual(const Model& model, const State& state, const StepReport& report,
                  const VisualOptions& options, VisualScene& out) {
  assert(state.size() == model.size());
  out.clear();
  std::vector<SurfacePart> parts;
  for (Index i = 0; i < model.size(); ++i) {
    if (!has_finite_pose(state, i)) continue;  // nothing sensible can be drawn
    Vec4f color = color_of(model, options, i);
    bool checker = false;
    if (const auto at = static_cast<std::size_t>(i); at < options.looks.size()) {
      color.w() = static_cast<float>(options.looks[at].opacity);
      checker = options.looks[at].checker;
    }
    add_body(model.shape[i], {out, state.c[i], state.R[i], color, color.w() == 1, checker}, parts);
  }
  std::erase_if(out.meshes, [](const MeshInstances& mesh) { return mesh.instances.empty(); });
  const bool scaled = options.bonds || options.contacts || options.selected_contact;
  const double given = options.glyph_scale;
  const double scale = !scaled || given > 0 ? given : default_glyph_scale(model);
  if (options.bonds || options.contacts)
    add_contact_glyphs(model, report, options, scale, typical_weight(model), out);
  if (options.contacts && options.contacts_by == ContactQuantity::force)
    add_force_chains(model, state, report, options.force_range, scale, out);
  if (options.bonds) add_joint_glyphs(model, state, out);
  if (options.boxes) add_boxes(model, state, out);
  if (options.velocities) add_velocity_arrows(model, state, out);
  add_selection(model, state, report, options, scale, out);
  if (const auto around = bounding_sphere(model, state)) set_sphere(*around, out);
}

// A touch smaller: faces that coincide with those of the first state lie behind them, without speckles.
constexpr double kGhostSize = 0.996;

void add_ghost(const Model& model, const State& state, const Vec4f& color, VisualScene& out) {
  const Index count = std::min(model.size(), static_cast<Index>(std::min(state.c.size(), state.R.size())));
  std::vector<SurfacePart> parts;
  for (Index i = 0; i < count; ++i) {
    if (model.fixed[i] || !has_finite_pose(state, i)) continue;
    add_body(model.shape[i],
             {.out = out,
              .c = state.c[i],
              .R = kGhostSize * state.R[i],
              .color = color,
              .shadow = false,
              .xray = true},
             parts);
  }
}

Vec4f ghost_color() {
  Vec4f color = srgb_color(0xd6409f);
  color.w() = 0.5f;
  return color;
}

}  // namespace pabd
