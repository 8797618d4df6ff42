// SPDX-License-Identifier: MIT
// Glyphs of contacts and bonds.
//
//   y_a, y_b   the two points of a contact                    m
//   n          contact normal, from a to b                    unit
//   d          (y_b − y_a)·n                                  m
//   f_n        normal force                                   N
//   s          glyph scale: radius of a disc                  m
//   L          arrow length  s (3 + 2 log₁₀(1 + 9 f_n/W))     m; W a body's weight: 5 s at f_n = W,
//                                                             7 s at 10 W
#include "render/visual/contact_glyphs.h"

#include <algorithm>
#include <cmath>

#include "render/visual/palette.h"

namespace pabd {
namespace {

constexpr double kShaft = 0.19;       // radius of the shaft, × s
constexpr double kHead = 0.52;        // radius of the head, × s
constexpr double kHeadLength = 1.35;  // × s
constexpr double kLongest = 9.0;      // longest arrow, × s

auto& list(VisualScene& out, Primitive primitive) { return out.instances[static_cast<int>(primitive)]; }

void add(VisualScene& out, Primitive primitive, const Mat4f& transform, const Vec4f& color, bool shaded) {
  list(out, primitive).push_back({transform, color, false, shaded, true});
}

bool is_finite(const ContactReport& contact) {
  return contact.y_a.allFinite() && contact.y_b.allFinite() && contact.n.allFinite();
}

double arrow_length(double normal_force, double scale, double weight) {
  const double f = std::isfinite(normal_force) ? std::max(0.0, normal_force) : 0.0;
  return scale * std::min(kLongest, 2.5 + 1.5 * std::log10(1.0 + 9.0 * f / weight));
}

void add_contact(const ContactReport& contact, double d_hat, double s, double weight, VisualScene& out) {
  const Vec4f color = contact_color(contact.d / d_hat);
  const double length = arrow_length(contact.normal_force, s, weight);
  const double head = kHeadLength * s;
  const Vec3& n = contact.n;
  add(out, Primitive::disc, place_along(contact.y_a, n, s, s), color, false);
  add(out, Primitive::cylinder,
      place_along(contact.y_a + 0.5 * (length - head) * n, n, kShaft * s, 0.5 * (length - head)), color,
      false);
  add(out, Primitive::cone, place_along(contact.y_a + (length - head) * n, n, kHead * s, head), color, false);
}

void add_bond(const ContactReport& contact, double s, VisualScene& out) {
  // Points as close as d̂ would hide each other: as large as their distance allows, but wider than an arrow's
  // shaft.
  const double gap = (contact.y_b - contact.y_a).norm();
  const double r = std::clamp(0.45 * gap, 0.34 * s, 0.5 * s);
  add(out, Primitive::sphere, place_along(contact.y_a, Vec3::UnitY(), r, r), bond_point_i_color(), true);
  add(out, Primitive::sphere, place_along(contact.y_b, Vec3::UnitY(), r, r), bond_point_j_color(), true);
  out.lines.push_back({contact.y_a.cast<float>(), contact.y_b.cast<float>(), bond_line_color(), 2.0f, true});
}

}  // namespace

Mat4f place_along(const Vec3& p, const Vec3& axis, double sxz, double sy) {
  const Vec3 across = std::abs(axis.x()) < 0.9 ? Vec3::UnitX() : Vec3::UnitZ();
  const Vec3 z = across.cross(axis).normalized();
  const Vec3 x = axis.cross(z);
  Mat4f m = Mat4f::Identity();
  m.block<3, 1>(0, 0) = (sxz * x).cast<float>();
  m.block<3, 1>(0, 1) = (sy * axis).cast<float>();
  m.block<3, 1>(0, 2) = (sxz * z).cast<float>();
  m.block<3, 1>(0, 3) = p.cast<float>();
  return m;
}

double default_glyph_scale(const Model& model) {
  std::vector<double> widths;
  for (Index i = 0; i < model.size(); ++i) {
    const double r = inner_radius(model.shape[i]);
    if (!model.fixed[i] && std::isfinite(r)) widths.push_back(r);
  }
  if (widths.empty()) return 0.05;
  const auto middle = widths.begin() + static_cast<std::ptrdiff_t>(widths.size() / 2);
  std::nth_element(widths.begin(), middle, widths.end());
  return 0.26 * *middle;
}

void add_contact_glyph(const ContactReport& contact, double d_hat, double scale, double weight,
                       VisualScene& out) {
  if (is_finite(contact)) add_contact(contact, d_hat, scale, weight, out);
}

void add_contact_glyphs(const StepReport& report, const VisualOptions& options, double scale, double weight,
                        VisualScene& out) {
  for (const ContactReport& contact : report.contact_reports) {
    if (!is_finite(contact)) continue;
    if (options.contacts) add_contact(contact, options.d_hat, scale, weight, out);
    if (options.bonds) add_bond(contact, scale, out);
  }
}

}  // namespace pabd
