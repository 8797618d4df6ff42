// SPDX-License-Identifier: MIT
// See shape_table.h.
#include "render/device/shape_table.h"

#include <array>
#include <bit>
#include <map>
#include <unordered_map>

#include "sim/base/counted.h"
#include "sim/base/hash.h"
#include "sim/body/compound.h"
#include "sim/body/frustum.h"
#include "sim/body/shape_kind.h"
#include "sim/collision/hull_view.h"

namespace pabd {
namespace {

static_assert(std::is_same_v<std::variant_alternative_t<kDeviceBox, Shape>, Box>);
static_assert(std::is_same_v<std::variant_alternative_t<kDeviceSphere, Shape>, Sphere>);
static_assert(std::is_same_v<std::variant_alternative_t<kDeviceCapsule, Shape>, Capsule>);
static_assert(std::is_same_v<std::variant_alternative_t<kDevicePlane, Shape>, Plane>);
static_assert(std::is_same_v<std::variant_alternative_t<kDeviceHull, Shape>, Hull>);
static_assert(std::is_same_v<std::variant_alternative_t<kDeviceCompound, Shape>, Compound>);

using Words = std::vector<std::uint64_t>;

// Two 32-bit numbers, the first in the low half: a uvec2 of the shaders, as a double is.
std::uint64_t pair_of(std::uint32_t x, std::uint32_t y) { return x | static_cast<std::uint64_t>(y) << 32; }

void add_vector(const Vec3& v, Words& out) {
  for (int k = 0; k < 3; ++k) out.push_back(std::bit_cast<std::uint64_t>(v[k]));
}

Words words_of(const narrow::HullView& hull) {
  Words out;
  for (const Vec3& v : hull.vertices) add_vector(v, out);
  for (const HullFace& face : hull.faces) {
    add_vector(face.normal, out);
    out.push_back(std::bit_cast<std::uint64_t>(face.offset));
    out.push_back(pair_of(face.first, face.count));
  }
  for (std::size_t k = 0; k < hull.loop.size(); ++k) out.push_back(pair_of(hull.loop[k], hull.loop_edge[k]));
  for (const HullEdge& edge : hull.edges) {
    out.push_back(pair_of(edge.from, edge.to));
    out.push_back(pair_of(edge.left, edge.right));
  }
  return out;
}

void count_parts(const narrow::HullView& hull, ShapeRecord& record) {
  record.vertices = static_cast<std::uint32_t>(hull.vertices.size());
  record.faces = static_cast<std::uint32_t>(hull.faces.size());
  record.corners = static_cast<std::uint32_t>(hull.loop.size());
  record.edges = static_cast<std::uint32_t>(hull.edges.size());
}

using Key = std::array<std::uint64_t, 5>;  // kind and sizes, bit by bit
struct KeyHash {
  std::size_t operator()(const Key& key) const {
    std::uint64_t x = 0;
    for (const std::uint64_t word : key) x = mixed(x ^ word);
    return x;
  }
};

class TableMaker {
 public:
  TableMaker() { table_.hulls = words_of(box_.view()); }

  void add(const Shape& shape) { table_.of_body.push_back(number_of(shape)); }
  ShapeTable take() { return std::move(table_); }

 private:
  std::uint32_t number_of(const Shape& shape) {
    if (const auto* box = std::get_if<Box>(&shape)) {
      const Vec3& h = box->half;
      return simple(kDeviceBox, {h.x(), h.y(), h.z(), h.minCoeff()});
    }
    if (const auto* sphere = std::get_if<Sphere>(&shape)) return simple(kDeviceSphere, {sphere->radius});
    if (const auto* capsule = std::get_if<Capsule>(&shape)) {
      return simple(kDeviceCapsule, {capsule->radius, capsule->length});
    }
    if (const auto* plane = std::get_if<Plane>(&shape)) {
      const Vec3& n = plane->normal;
      return simple(kDevicePlane, {n.x(), n.y(), n.z(), plane->offset});
    }
    if (std::holds_alternative<Solid>(shape)) return solid(shape);
    if (const auto* compound = std::get_if<Compound>(&shape)) return compound_of(*compound->data);
    return hull(*std::get_if<Hull>(&shape)->data);
  }

  // Its facets, and its ends behind them.
  std::uint32_t solid(const Shape& shape) {
    table_.has_solids = true;
    const Frustum f = frustum_of(shape);
    return hull(*as<Hull>(as<Solid>(shape).data->facets).data, {f.low, f.r_low, f.high, f.r_high});
  }

  std::uint32_t simple(DeviceShape kind, const std::array<double, 4>& size) {
    Key key{static_cast<std::uint64_t>(kind)};
    for (std::size_t k = 0; k < 4; ++k) key[k + 1] = std::bit_cast<std::uint64_t>(size[k]);
    const auto [at, is_new] = simple_.try_emplace(key, next());
    if (!is_new) return at->second;
    ShapeRecord record{};
    std::copy(size.begin(), size.end(), record.size);
    record.kind = static_cast<std::uint32_t>(kind);
    if (kind == kDeviceBox) count_parts(box_.view(), record);
    table_.shapes.push_back(record);
    return at->second;
  }

  // Copies share their data; of what was made twice the data are equal.
  std::uint32_t hull(const HullData& data, std::initializer_list<double> ends = {}) {
    const auto [at, is_new] = hulls_.try_emplace(&data, 0);
    if (!is_new) return at->second;
    Words words = words_of(narrow::view_of(data));
    for (const double end : ends) words.push_back(std::bit_cast<std::uint64_t>(end));
    const auto [same, is_first] = words_.try_emplace(std::move(words), next());
    at->second = same->second;
    if (!is_first) return at->second;
    ShapeRecord record{{data.bounding_radius, 0, 0, data.inner_radius}, kDeviceHull, 0, 0, 0, 0, 0, 0, 0};
    count_parts(narrow::view_of(data), record);
    table_.hull_vertices = std::max(table_.hull_vertices, record.vertices);
    for (const HullFace& face : data.faces)
      table_.face_corners = std::max(table_.face_corners, std::uint32_t{face.count});
    record.first = static_cast<std::uint32_t>(table_.hulls.size());
    table_.hulls.insert(table_.hulls.end(), same->first.begin(), same->first.end());
    if (ends.size() > 0) record.ends = static_cast<std::uint32_t>(table_.hulls.size() - ends.size());
    table_.shapes.push_back(record);
    return at->second;
  }

  // Where its parts are, and the rows of their hulls.
  std::uint32_t compound_of(const CompoundData& data) {
    const auto [at, is_new] = compounds_.try_emplace(&data, 0);
    if (!is_new) return at->second;
    Words words;
    for (const CompoundPart& part : data.parts) {
      add_vector(part.offset, words);
      words.push_back(hull(*part.hull().data));
    }
    const auto [same, is_first] = compound_words_.try_emplace(std::move(words), next());
    at->second = same->second;
    if (!is_first) return at->second;
    ShapeRecord record{{data.bounding_radius, 0, 0, data.inner_radius}, kDeviceCompound, 0, 0, 0, 0, 0, 0, 0};
    record.first = static_cast<std::uint32_t>(table_.hulls.size());
    record.parts = static_cast<std::uint32_t>(data.parts.size());
    table_.hulls.insert(table_.hulls.end(), same->first.begin(), same->first.end());
    table_.shapes.push_back(record);
    return at->second;
  }

  std::uint32_t next() const { return static_cast<std::uint32_t>(table_.shapes.size()); }

  // Of half edges 1: every box that meets a hull is this one, scaled.
  narrow::BoxHull box_{Vec3::Ones()};
  ShapeTable table_;
  std::unordered_map<Key, std::uint32_t, KeyHash> simple_;
  std::unordered_map<const HullData*, std::uint32_t> hulls_;
  std::unordered_map<const CompoundData*, std::uint32_t> compounds_;
  std::map<Words, std::uint32_t> words_, compound_words_;
};

// Of a hull, or of one part of a compound.
std::size_t most_faces(const Shape& shape) {
  if (const auto* hull = std::get_if<Hull>(&shape)) return hull->data->faces.size();
  std::size_t most = 0;
  if (const auto* compound = std::get_if<Compound>(&shape)) {
    for (const CompoundPart& part : compound->data->parts)
      most = std::max(most, part.hull().data->faces.size());
  }
  return most;
}

}  // namespace

ShapeTable make_shape_table(const Model& model) {
  TableMaker maker;
  for (const Shape& shape : model.shape) maker.add(shape);
  return maker.take();
}

std::string why_not_on_device(const Model& model) {
  for (std::size_t i = 0; i < model.shape.size(); ++i) {
    const Shape& shape = model.shape[i];
    const std::string body = "body '" + model.name[i] + "' ";
    if (off_centre(shape))
      return body + "has its centre of mass beside that of its shape, which the GPU does not take";
    const std::size_t faces = most_faces(shape);
    if (faces > kMostDeviceHullFaces) {
      return body + "has " + counted(faces, "face") +
             (std::holds_alternative<Compound>(shape) ? " in one part" : "") + ", the GPU takes at most " +
             std::to_string(kMostDeviceHullFaces);
    }
  }
  return {};
}

}  // namespace pabd
