// SPDX-License-Identifier: MIT
// See body_kinds.h.
#include "render/device/body_kinds.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string_view>
#include <unordered_map>

#include "sim/body/shape_kind.h"

namespace pabd::device {
namespace {

// The axis of the body frame about which J is the same all round, 3 where it is the same about all, −1 for none.
int symmetry_of(const Mat3& J) {
  if (J == Mat3(J(0, 0) * Mat3::Identity())) return 3;
  const double same = 1e-12 * J.trace();
  if (std::abs(J(0, 1)) + std::abs(J(0, 2)) + std::abs(J(1, 2)) > same) return -1;
  for (int k = 0; k < 3; ++k) {
    if (std::abs(J((k + 1) % 3, (k + 1) % 3) - J((k + 2) % 3, (k + 2) % 3)) <= same) return k;
  }
  return -1;
}

void set_sizes(const Shape& shape, BodyKind& out) {
  std::fill(std::begin(out.half), std::end(out.half), out.bounding);
  if (const auto* box = std::get_if<Box>(&shape)) std::copy_n(box->half.data(), 3, out.half);
  if (const auto* capsule = std::get_if<Capsule>(&shape)) {
    out.half[0] = capsule->radius;
    out.half[1] = capsule->length / 2;
  }
  if (const auto* plane = std::get_if<Plane>(&shape)) {
    std::copy_n(plane->normal.data(), 3, out.half);
    out.core = plane->offset;
  }
}

BodyKind kind_of_body(const Model& model, std::size_t i, std::uint32_t shape_row, std::uint32_t form) {
  const Shape& shape = model.shape[i];
  const ShapeKind& kind = pabd::kind_of(shape);
  const Mat3& J = model.J[i];
  BodyKind out{};
  std::copy_n(std::array{J(0, 0), J(1, 1), J(2, 2), J(0, 1), J(0, 2), J(1, 2)}.data(), 6, out.J);
  out.mass = model.mass[i];
  if (!is_plane(shape)) {
    out.bounding = bounding_radius(shape);
    out.inner = inner_radius(shape);
  }
  out.rolling = rolling_radius(shape);
  out.core = kind.core_radius ? kind.core_radius(shape) : out.bounding;
  const auto own = model.friction.empty() ? std::nullopt : model.friction[i];
  out.mu_static = own ? own->mu_static : -1;
  out.mu_dynamic = own ? own->mu_dynamic : -1;
  if (!model.groups.avoids.empty()) {
    out.groups = model.groups.of_body[i];
    out.avoids = model.groups.avoids[i];
  }
  out.shape = static_cast<std::int32_t>(shape_row);
  out.form = static_cast<std::int32_t>(form);
  out.symmetry = symmetry_of(J);
  out.fixed = model.fixed[i];
  out.round_about_y = kind.round_about_y;
  set_sizes(shape, out);
  return out;
}

}  // namespace

BodyKinds make_body_kinds(const Model& model, const ShapeTable& shapes) {
  BodyKinds out;
  std::unordered_map<std::string, std::uint32_t> known;  // bytes of a record
  double smallest = INFINITY;
  for (std::size_t i = 0; i < model.shape.size(); ++i) {
    const std::uint32_t row = shapes.of_body[i];
    const BodyKind kind = kind_of_body(model, i, row, shapes.shapes[row].kind);
    std::string bytes(sizeof kind, '\0');
    std::memcpy(bytes.data(), &kind, sizeof kind);
    const auto [at, fresh] =
        known.try_emplace(std::move(bytes), static_cast<std::uint32_t>(out.kinds.size()));
    if (fresh) out.kinds.push_back(kind);
    out.of_body.push_back(at->second);
    if (is_plane(model.shape[i])) out.planes.push_back(static_cast<std::uint32_t>(i));
    if (model.fixed[i]) continue;
    smallest = std::min(smallest, kind.bounding);
  }
  if (std::isfinite(smallest)) out.smallest_radius = smallest;
  return out;
}

}  // namespace pabd::device
