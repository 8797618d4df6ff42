// SPDX-License-Identifier: MIT
// Glyphs of contacts and bonds.
//
//   y_a, y_b   the two points of a contact                    m
//   n          contact normal, from a to b                    unit
//   d          (y_b − y_a)·n                                  m
//   f_n        normal force                                   N
//   s          glyph scale: radius of a disc                  m
//   L          arrow length, 4.5 s log₁₀(1 + 9 f_n/W)         m; W a body's weight: 4.5 s at f_n = W, 9 s at 10 W
#include "render/visual/contact_glyphs.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

#include "render/visual/line_shapes.h"
#include "render/visual/palette.h"

namespace pabd {
namespace {

using namespace glyph;

auto& list(VisualScene& out, Primitive primitive) { return out.instances[static_cast<int>(primitive)]; }

void add(VisualScene& out, Primitive primitive, const Mat4f& transform, const Vec4f& color, bool shaded) {
  list(out, primitive).push_back({transform, color, false, shaded, true});
}

bool is_finite(const ContactReport& contact) {
  return contact.y_a.allFinite() && contact.y_b.allFinite() && contact.n.allFinite();
}

double arrow_length(double force, double scale, double weight) {
  return scale * std::min(kLongest, 4.5 * std::log10(1.0 + 9.0 * force / weight));
}

// Whether the force on b is shown; else that on a.
bool pushes_b(const Model& model, const ContactReport& contact) {
  const auto fixed = [&](Index i) { return i < 0 || i >= model.size() || model.fixed[i] != 0; };
  if (fixed(contact.a) != fixed(contact.b)) return fixed(contact.a);
  const Vec3& n = contact.n;
  if (std::abs(n.y()) > kSide) return n.y() > 0;
  return std::abs(n.x()) > kSide ? n.x() > 0 : n.z() > 0;
}

double loaded(const ContactReport& contact) {
  return std::isfinite(contact.normal_force) ? std::max(0.0, contact.normal_force) : 0.0;
}

ContactGlyph glyph_of(const Model& model, const ContactReport& contact, std::size_t number = 0) {
  const bool b = pushes_b(model, contact);
  const double force = loaded(contact);
  return {contact.a,
          contact.b,
          contact.y_a,
          contact.y_b,
          b ? contact.y_b : contact.y_a,
          b ? contact.n : Vec3(-contact.n),
          contact.d,
          force,
          contact.friction.norm() / (contact.mu * force),
          number};
}

Vec4f mark_color(const ContactGlyph& glyph, const VisualOptions& options) {
  switch (options.contacts_by) {
    case ContactQuantity::force:
      return value_color(options.force_range.place(glyph.force));
    case ContactQuantity::friction:
      return value_color(ValueRange{}.place(glyph.slip));
    default:
      return contact_color(glyph.d / options.d_hat);
  }
}

void add_contact(const ContactGlyph& glyph, const VisualOptions& options, double s, double weight,
                 VisualScene& out) {
  const PixelMeter meter(out.camera);
  const Vec4f color = mark_color(glyph, options), rim = srgb_color(kRimInk);
  const Vec3& n = glyph.towards;
  const Vec3 away = -meter.to_eye(glyph.at);
  double r = kRim * s;
  // What is a little larger, and far enough behind, shows as a rim.
  add(out, Primitive::disc, place_along(glyph.at + 0.3 * r * away, n, s + r, s + r), rim, false);
  add(out, Primitive::disc, place_along(glyph.at, n, s, s), color, false);
  const double length = arrow_length(glyph.force, s, weight);
  if (length < kShortest * s) return;
  // Its width is that of another scale; a head that has to be short keeps it.
  const double g = std::clamp(kLeastScale * meter.at(glyph.at), s, kMostGrown * s);
  r = kRim * g;
  const double head = std::min(kHeadLength * g, 0.6 * length);
  const double half = std::min(kHead * g, kHead / kHeadLength * head * std::min(g / s, kBluntest));
  const Vec3 base = glyph.at + (length - head) * n, middle = glyph.at + 0.5 * (length - head) * n;
  const double shaft = std::min(kShaft * g, 0.6 * half);
  add(out, Primitive::cylinder,
      place_along(middle + 2 * (shaft + r) * away, n, shaft + 0.6 * r, 0.5 * (length - head)), rim, false);
  add(out, Primitive::cylinder, place_along(middle, n, shaft, 0.5 * (length - head)), color, false);
  add(out, Primitive::cone,
      place_along(base - 0.6 * r * n + 2 * (half + r) * away, n, half + 0.9 * r, head + 1.6 * r), rim, false);
  add(out, Primitive::cone, place_along(base, n, half, head), color, false);
}

void add_bond(const ContactGlyph& contact, double s, VisualScene& out) {
  // Points as close as d̂ would hide each other: as large as their distance allows, but wider than an arrow's
  // shaft.
  const double gap = (contact.y_b - contact.y_a).norm();
  const double least = std::min(kLeastPoint * PixelMeter(out.camera).at(contact.at), s);
  const double r = std::max(std::clamp(0.45 * gap, 0.34 * s, 0.5 * s), least);
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

constexpr double kStandardGravity = 9.81;  // m/s²

double typical_weight(const Model& model) {
  double mass = 0;
  int count = 0;
  for (Index i = 0; i < model.size(); ++i) {
    if (model.fixed[i]) continue;
    mass += model.mass[i];
    ++count;
  }
  return mass > 0 ? kStandardGravity * mass / count : 1.0;
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

std::vector<ContactGlyph> merged_contacts(const Model& model, const StepReport& report,
                                          const Together& together) {
  std::vector<const ContactReport*> contacts;
  for (const ContactReport& contact : report.contact_reports) {
    if (is_finite(contact)) contacts.push_back(&contact);
  }
  std::stable_sort(contacts.begin(), contacts.end(), [](const ContactReport* x, const ContactReport* y) {
    return std::tie(x->a, x->b) < std::tie(y->a, y->b);
  });
  std::vector<ContactGlyph> out;
  double load = 0, allowed = 0, slipping = 0;
  for (const ContactReport* contact : contacts) {
    const ContactGlyph next =
        glyph_of(model, *contact, static_cast<std::size_t>(contact - report.contact_reports.data()));
    const bool one = !out.empty() && next.a == out.back().a && next.b == out.back().b &&
                     next.towards.dot(out.back().towards) > kSameNormal && together(out.back().at, next.at);
    if (!one) {
      out.push_back(next);
      load = allowed = slipping = 0;
    }
    ContactGlyph& all = out.back();
    load += next.force + kNoForce;
    allowed += contact->mu * next.force;
    slipping += contact->friction.norm();
    all.slip = slipping / allowed;
    if (!one) continue;
    const double share = (next.force + kNoForce) / load;
    all.y_a += share * (next.y_a - all.y_a);
    all.y_b += share * (next.y_b - all.y_b);
    all.at += share * (next.at - all.at);
    all.d = std::min(all.d, next.d);
    all.force += next.force;
  }
  std::sort(out.begin(), out.end(),
            [](const ContactGlyph& x, const ContactGlyph& y) { return x.first < y.first; });
  return out;
}

void add_contact_glyph(const Model& model, const ContactReport& contact, const VisualOptions& options,
                       double scale, double weight, VisualScene& out) {
  if (is_finite(contact)) add_contact(glyph_of(model, contact), options, scale, weight, out);
}

void add_contact_glyphs(const Model& model, const StepReport& report, const VisualOptions& options,
                        double scale, double weight, VisualScene& out) {
  const bool shown = options.contacts && options.contacts_by != ContactQuantity::force;
  const bool many = report.contact_reports.size() > kManyContacts;
  const PixelMeter meter(out.camera);
  const auto together = [&](const Vec3& mark, const Vec3& next) {
    return many || (next - mark).norm() < kMarkWidth * std::max(scale, kLeastScale * meter.at(mark));
  };
  for (const ContactGlyph& glyph : merged_contacts(model, report, together)) {
    if (shown) add_contact(glyph, options, scale, weight, out);
    if (options.bonds) add_bond(glyph, scale, out);
  }
}

}  // namespace pabd
