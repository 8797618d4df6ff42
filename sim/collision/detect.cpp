// SPDX-License-Identifier: MIT
// Contact detection: bounds → pairs → contact points.
//
// Pairs are sorted before the narrow phase runs over them in order, so the contacts come out sorted as well;
// threads take ranges of pairs and their buckets are joined in order.
#include "sim/collision/detect.h"

#include <algorithm>

#include "sim/body/compound.h"
#include "sim/body/hull.h"
#include "sim/body/shape_kind.h"
#include "sim/collision/narrow_phase.h"
#include "sim/collision/seams.h"

namespace pabd {
namespace {

using narrow::Contacts;
using narrow::Placed;

struct Poses {
  const Model& model;
  const std::vector<Vec3>& c;
  const std::vector<Mat3>& R;
  const Passage& passage;
  const std::vector<double>& reach;

  Placed<Shape> placed(Index i) const {
    const auto k = static_cast<std::size_t>(i);
    return {model.shape[k], c[k], R[k], i};
  }
};

enum Kind : unsigned {
  kBox,
  kSphere,
  kCapsule,
  kPlane,
  kHull,
  kCompound,
  kKinds,
  kSolid = kKinds  // comes as a hull
};                 // the order of the alternatives of Shape
static_assert(std::is_same_v<std::variant_alternative_t<kBox, Shape>, Box>);
static_assert(std::is_same_v<std::variant_alternative_t<kSphere, Shape>, Sphere>);
static_assert(std::is_same_v<std::variant_alternative_t<kCapsule, Shape>, Capsule>);
static_assert(std::is_same_v<std::variant_alternative_t<kPlane, Shape>, Plane>);
static_assert(std::is_same_v<std::variant_alternative_t<kHull, Shape>, Hull>);
static_assert(std::is_same_v<std::variant_alternative_t<kCompound, Shape>, Compound>);
static_assert(std::is_same_v<std::variant_alternative_t<kSolid, Shape>, Solid>);
static_assert(std::variant_size_v<Shape> == kKinds + 1);

constexpr unsigned both(unsigned i, unsigned j) { return kKinds * i + j; }

template <class T>
Placed<T> placed_as(const Placed<Shape>& body) {
  return {*std::get_if<T>(&body.shape), body.c, body.R, body.number, body.first};
}

// Contacts of one pair, `first` goes first; no solids.
void collide(const Placed<Shape>& first, const Placed<Shape>& second, double reach, Contacts& out) {
  auto kind_i = static_cast<unsigned>(first.shape.index());
  auto kind_j = static_cast<unsigned>(second.shape.index());
  const bool same = kind_i == kind_j;
  // Mixed pairs: compound before plane before hull before box before capsule before sphere, the order in
  // which they own the normal.
  constexpr unsigned kRank[kKinds] = {3, 5, 4, 1, 2, 0};
  const bool swapped = !same && kRank[kind_j] < kRank[kind_i];
  if (swapped) std::swap(kind_i, kind_j);
  const Placed<Shape>&i = swapped ? second : first, &j = swapped ? first : second;
  using namespace narrow;
  if (kind_i == kCompound) return compound_shape(placed_as<Compound>(i), j, reach, out);
  switch (both(kind_i, kind_j)) {
    case both(kBox, kBox):
      return box_box(placed_as<Box>(i), placed_as<Box>(j), reach, out);
    case both(kBox, kSphere):
      return box_sphere(placed_as<Box>(i), placed_as<Sphere>(j), reach, out);
    case both(kBox, kCapsule):
      return box_capsule(placed_as<Box>(i), placed_as<Capsule>(j), reach, out);
    case both(kSphere, kSphere):
      return sphere_sphere(placed_as<Sphere>(i), placed_as<Sphere>(j), reach, out);
    case both(kCapsule, kSphere):
      return capsule_sphere(placed_as<Capsule>(i), placed_as<Sphere>(j), reach, out);
    case both(kCapsule, kCapsule):
      return capsule_capsule(placed_as<Capsule>(i), placed_as<Capsule>(j), reach, out);
    case both(kPlane, kBox):
      return box_plane(placed_as<Plane>(i), placed_as<Box>(j), reach, out);
    case both(kPlane, kSphere):
      return sphere_plane(placed_as<Plane>(i), placed_as<Sphere>(j), reach, out);
    case both(kPlane, kCapsule):
      return capsule_plane(placed_as<Plane>(i), placed_as<Capsule>(j), reach, out);
    case both(kPlane, kHull):
      return hull_plane(placed_as<Plane>(i), placed_as<Hull>(j), reach, out);
    case both(kHull, kBox):
      return hull_box(placed_as<Hull>(i), placed_as<Box>(j), reach, out);
    case both(kHull, kCapsule):
      return hull_capsule(placed_as<Hull>(i), placed_as<Capsule>(j), reach, out);
    case both(kHull, kSphere):
      return hull_sphere(placed_as<Hull>(i), placed_as<Sphere>(j), reach, out);
    case both(kHull, kHull):
      return hull_hull(placed_as<Hull>(i), placed_as<Hull>(j), reach, out);
    default:
      return;  // two planes
  }
}

const Shape& facets(const Shape& shape) {
  const auto* solid = std::get_if<Solid>(&shape);
  return solid ? solid->data->facets : shape;
}

// Where a shape is that is off its centre of mass; `c` has room for it.
Placed<Shape> at_own_centre(const Placed<Shape>& body, Vec3& c) {
  const CompoundPart* part = body.shape.index() == kCompound ? off_centre(body.shape) : nullptr;
  if (!part) return body;
  c = body.c + body.R * part->offset;
  return {part->shape, c, body.R, body.number, body.first};
}

// The same of any two; hulls stand for solids. In the order of their features.
void collide_any(const Placed<Shape>& body, const Placed<Shape>& other_body, double reach, Contacts& out) {
  Vec3 c, other_c;
  const Placed<Shape> one = at_own_centre(body, c), other = at_own_centre(other_body, other_c);
  const bool ordered = narrow::goes_first(one, other);
  Placed<Shape> a = ordered ? one : other;
  const Placed<Shape>& b = ordered ? other : one;
  a.first = true;
  if (narrow::side_on_plane(a, b, reach, out) || narrow::side_on_plane(b, a, reach, out)) return;
  const auto start = static_cast<std::ptrdiff_t>(out.size());
  const bool solids = a.shape.index() == kSolid || b.shape.index() == kSolid;
  if (solids) {
    const Mat3 R_a = narrow::facing(a, b), R_b = narrow::facing(b, a);
    const double near = reach + narrow::facet_depth(a.shape) + narrow::facet_depth(b.shape);
    collide({facets(a.shape), a.c, R_a, a.number, true}, {facets(b.shape), b.c, R_b, b.number}, near, out);
  } else {
    collide(a, b, reach, out);
  }
  const double round_a = rolling_radius(a.shape), round_b = rolling_radius(b.shape);
  for (auto p = out.begin() + start; p != out.end(); ++p) {
    if (round_a > 0) (p->a == a.number ? p->round_a : p->round_b) = round_a;
    if (round_b > 0) (p->a == b.number ? p->round_a : p->round_b) = round_b;
  }
  narrow::round_off(a, b, static_cast<std::size_t>(start), out);
  if (solids)
    out.erase(
        std::remove_if(out.begin() + start, out.end(), [&](const ContactPoint& p) { return !(p.d < reach); }),
        out.end());
  std::sort(out.begin() + start, out.end(),
            [](const ContactPoint& p, const ContactPoint& q) { return p.feature < q.feature; });
}

// Contacts of a pair where its bodies are on their way; the nearest of them tells how far they are apart.
double collide_on_the_way(const Poses& poses, Index i, Index j, double part, double near, std::size_t first,
                          Contacts& out) {
  out.resize(first);
  const Passage& passage = poses.passage;
  const Vec3 c_i = passage.c_at(i, part), c_j = passage.c_at(j, part);
  const Mat3 R_i = passage.R_at(i, part), R_j = passage.R_at(j, part);
  collide_any({poses.placed(i).shape, c_i, R_i, i}, {poses.placed(j).shape, c_j, R_j, j}, near, out);
  double nearest = narrow::kNone;
  for (std::size_t k = first; k < out.size(); ++k) {
    out[k].part = part;
    nearest = std::min(nearest, out[k].d);
  }
  return nearest;
}

// Does a plane at the end of their way say that the two overlap where they come from?
bool overlap_behind(const Poses& poses, std::span<const ContactPoint> points) {
  const Passage& passage = poses.passage;
  const auto back = [&](Index i, const Vec3& x) -> Vec3 {
    const auto k = static_cast<std::size_t>(i);
    return passage.c[k] + passage.R[k] * (poses.R[k].transpose() * (x - poses.c[k]));
  };
  return std::any_of(points.begin(), points.end(), [&](const ContactPoint& p) {
    const auto a = static_cast<std::size_t>(p.a);
    const Vec3 n = p.round_a > 0 ? p.n : Vec3(passage.R[a] * (poses.R[a].transpose() * p.n));
    const Vec3 apart = back(p.b, p.y_b + p.round_b * p.n) - back(p.a, p.y_a - p.round_a * p.n);
    return n.dot(apart) < p.round_a + p.round_b;
  });
}

// Where the way of the two ends; where they first touch if they may pass each other, or if at the end they touch another side
// of each other. To there they go in steps by which they cannot come to touch.
void collide_pair(const Poses& poses, Index i, Index j, Contacts& out) {
  constexpr int kMostSteps = 64;
  const double near = poses.reach[static_cast<std::size_t>(i)] + poses.reach[static_cast<std::size_t>(j)];
  const Passage& passage = poses.passage;
  const std::size_t first = out.size();
  const auto inner = [&](Index k) { return inner_radius(poses.model.shape[static_cast<std::size_t>(k)]); };
  const double farthest = passage.c.empty() ? 0 : passage.farthest(i, j);
  double gap = -narrow::kNone;  // where they come from, as far as it is known
  const auto told = [&] {
    for (std::size_t k = first; k < out.size(); ++k) out[k].least_start_d = gap;
  };
  const auto first_touch = [&](const auto& may_touch) {
    double part = 0, nearest = collide_on_the_way(poses, i, j, part, near, first, out);
    gap = std::min(nearest, passage.touching);
    for (int k = 0; k < kMostSteps && may_touch(); ++k) {
      if (passage.from_start || nearest < passage.touching) return true;
      part += (nearest - 0.5 * passage.touching) / farthest;
      if (!(part < 1)) break;
      nearest = collide_on_the_way(poses, i, j, part, near, first, out);
    }
    return passage.from_start;
  };
  const auto at_the_end = [&] {
    out.resize(first);
    collide_any(poses.placed(i), poses.placed(j), near, out);
  };
  const bool far = farthest > 0.5 * std::min(inner(i), inner(j));
  if (passage.from_start || far) {
    const auto may = [&] { return may_pass(poses.model, passage, std::span(out).subspan(first)); };
    if (first_touch(may)) return told();
  }
  at_the_end();
  const auto found = std::span(out).subspan(first);
  const bool came_near =
      std::any_of(found.begin(), found.end(), [&](const ContactPoint& p) { return p.d < farthest; });
  if (farthest > 0 && !far && came_near && overlap_behind(poses, found)) {
    if (first_touch([&] { return gap >= 0; })) return told();
    at_the_end();
  }
  told();
}

// Planes meet every body whose bounds reach below them.
void add_plane_pairs(const Model& model, const std::vector<Aabb>& boxes, const std::vector<double>& reach,
                     std::vector<IndexPair>& pairs) {
  const Index n = model.size();
  for (Index p = 0; p < n; ++p) {
    const auto* plane = std::get_if<Plane>(&model.shape[static_cast<std::size_t>(p)]);
    if (!plane) continue;
    const double height = plane->offset + reach[static_cast<std::size_t>(p)];
    for (Index i = 0; i < n; ++i) {
      const auto k = static_cast<std::size_t>(i);
      if (model.fixed[k] || is_plane(model.shape[k])) continue;
      if (keeps_apart(model.groups, p, i)) continue;
      const Vec3 lowest = (plane->normal.array() > 0).select(boxes[k].lo, boxes[k].hi);
      if (plane->normal.dot(lowest) < height) pairs.emplace_back(std::min(p, i), std::max(p, i));
    }
  }
}

// Of a compound its stoutest part has it: what is between parts may be nobody's.
InnerBall core_of(const Poses& poses, Index i) {
  const auto& [shape, c, R, number, first] = poses.placed(i);
  if (is_plane(shape)) return {c, 0};
  const auto* compound = std::get_if<Compound>(&shape);
  if (!compound) return {c, inner_radius(shape)};
  const auto& parts = compound->data->parts;
  const auto stoutest =
      std::max_element(parts.begin(), parts.end(), [](const CompoundPart& x, const CompoundPart& y) {
        return inner_radius(x.shape) < inner_radius(y.shape);
      });
  return {c + R * stoutest->offset, inner_radius(stoutest->shape)};
}

// Of two that are in crowds, and as deep in each other as it comes, the deepest contact is enough.
void keep_deepest(std::size_t first, Contacts& out) {
  if (out.size() <= first) return;
  const auto begin = out.begin() + static_cast<std::ptrdiff_t>(first);
  const auto deepest = std::min_element(
      begin, out.end(), [](const ContactPoint& p, const ContactPoint& q) { return p.d < q.d; });
  *begin = *deepest;
  begin->crowded = true;
  out.resize(first + 1);
}

// Contacts of the pairs [begin, end).
void collide_range(const Poses& poses, const std::vector<IndexPair>& skip, CollisionWorkspace& workspace,
                   std::size_t begin, std::size_t end, Contacts& out) {
  if (begin == end) return;
  const std::vector<IndexPair>& pairs = workspace.pairs;
  auto skipped = std::lower_bound(skip.begin(), skip.end(), pairs[begin]);
  std::size_t next = 0;
  for (std::size_t k = begin; k != end; ++k) {
    const IndexPair& pair = pairs[k];
    if ((k - begin) % 256 == 255 && workspace.stop.requested()) return;
    while (skipped != skip.end() && *skipped < pair) ++skipped;
    if (skipped != skip.end() && *skipped == pair) continue;
    const std::size_t first = out.size();
    const bool crowded = workspace.broad_phase.in_crowds(pair);
    const auto kept = workspace.kept.find(pair, next);
    if (kept && !crowded) {
      out.insert(out.end(), kept->begin(), kept->end());
    } else {
      collide_pair(poses, pair.first, pair.second, out);
      if (crowded) keep_deepest(first, out);
    }
    workspace.counts[k] = {static_cast<std::uint32_t>(out.size() - first), !crowded};
  }
}

void collide_all(const Poses& poses, const std::vector<IndexPair>& skip, int threads,
                 CollisionWorkspace& workspace, std::vector<ContactPoint>& out) {
  const std::size_t pairs = workspace.pairs.size();
  workspace.counts.assign(pairs, {});
  out.clear();
  constexpr std::size_t kPairs = 32;  // some ten microseconds
  const std::size_t chunks = workspace.team.ranges(threads, pairs, kPairs);
  if (chunks == 1) return collide_range(poses, skip, workspace, 0, pairs, out);
  auto& partial = workspace.partial;
  if (partial.size() < chunks) partial.resize(chunks);
  workspace.team.for_each(threads, chunks, 1, [&](std::size_t k) {
    partial[k].clear();
    collide_range(poses, skip, workspace, pairs * k / chunks, pairs * (k + 1) / chunks, partial[k]);
  });
  for (std::size_t k = 0; k < chunks; ++k) out.insert(out.end(), partial[k].begin(), partial[k].end());
}

}  // namespace

bool narrow::goes_first(const Placed<Shape>& a, const Placed<Shape>& b) {
  constexpr double kAlike = 1e-6;
  const double size_a = bounding_radius(a.shape), size_b = bounding_radius(b.shape);
  if (std::abs(size_a - size_b) > kAlike * std::max(size_a, size_b)) return size_a > size_b;
  const Vec3 apart = b.c - a.c, along(0.31, 0.9, 0.17);
  const double ahead = apart.dot(a.R * along + b.R * along);
  return std::abs(ahead) > kAlike * apart.norm() ? ahead > 0 : a.number < b.number;
}

void detect(const Model& model, const std::vector<Vec3>& c, const std::vector<Mat3>& R,
            const Passage& passage, const std::vector<double>& reach,
            const std::vector<std::pair<Index, Index>>& skip, int threads, CollisionWorkspace& workspace,
            std::vector<ContactPoint>& out) {
  const auto n = static_cast<std::size_t>(model.size());
  auto& boxes = workspace.boxes;
  boxes.resize(n);
  workspace.kept.begin(model, c, R, passage, reach);
  workspace.team.for_each(threads, n, 64, [&](std::size_t i) {
    if (workspace.kept.still(static_cast<Index>(i))) return;
    boxes[i] = bounds(model.shape[i], c[i], R[i]);
    boxes[i].lo.array() -= reach[i];
    boxes[i].hi.array() += reach[i];
  });
  auto& pairs = workspace.pairs;
  const Poses poses{model, c, R, passage, reach};
  workspace.broad_phase.find(
      {boxes, model.fixed, [&poses](Index i) { return core_of(poses, i); }, model.groups}, threads,
      workspace.team, pairs);
  workspace.left_pairs = workspace.broad_phase.left;
  const auto without_planes = static_cast<std::ptrdiff_t>(pairs.size());
  add_plane_pairs(model, boxes, reach, pairs);
  if (without_planes < static_cast<std::ptrdiff_t>(pairs.size())) {
    auto& merged = workspace.merged;
    merged.resize(pairs.size());
    std::sort(pairs.begin() + without_planes, pairs.end());
    std::merge(pairs.begin(), pairs.begin() + without_planes, pairs.begin() + without_planes, pairs.end(),
               merged.begin());
    pairs.swap(merged);
  }

  collide_all(poses, skip, threads, workspace, out);
  workspace.kept.end(pairs, workspace.counts, out);
  constexpr double kFlush = 0.1;  // of what touches
  remove_hidden(model, c, R, kFlush * passage.touching, workspace.by_body, out);
}

}  // namespace pabd
