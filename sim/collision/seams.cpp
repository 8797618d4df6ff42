// SPDX-License-Identifier: MIT
// See seams.h.
#include "sim/collision/seams.h"

#include <algorithm>

#include "sim/body/compound.h"
#include "sim/body/hull.h"

namespace pabd {
namespace {

// A contact as its round body sees it.
struct Touched {
  Index round, flat;
  Vec3 n, y;  // from the flat body towards the round one; the flat one's point
  double d;
};

bool is_of_round_and_flat(const ContactPoint& p) { return (p.round_a > 0) != (p.round_b > 0); }

Touched touched(const ContactPoint& p) {
  if (p.round_a > 0) return {p.a, p.b, -p.n, p.y_b, p.d};
  return {p.b, p.a, p.n, p.y_a, p.d};
}

bool is_near_zero(double height, double flush) { return std::abs(height) < flush; }

bool is_on(const HullData& hull, const Vec3& x, double flush) {
  double highest = -hull.bounding_radius;
  for (const HullFace& face : hull.faces) highest = std::max(highest, face.normal.dot(x) - face.offset);
  return is_near_zero(highest, flush);
}

// On the surfaces of how many convex parts of a shape x lies, in its frame.
struct SurfacesAt {
  const Vec3& x;
  double flush;

  int operator()(const Box& box) const { return is_near_zero((x.cwiseAbs() - box.half).maxCoeff(), flush); }
  int operator()(const Plane& plane) const { return is_near_zero(plane.normal.dot(x) - plane.offset, flush); }
  int operator()(const Hull& hull) const { return is_on(*hull.data, x, flush); }
  int operator()(const Compound& compound) const {
    if (const CompoundPart* part = off_centre(compound))
      return std::visit(SurfacesAt{x - part->offset, flush}, part->shape);
    return static_cast<int>(std::count_if(
        compound.data->parts.begin(), compound.data->parts.end(),
        [&](const CompoundPart& part) { return is_on(*part.hull().data, x - part.offset, flush); }));
  }
  int operator()(const Sphere&) const { return 0; }
  int operator()(const Capsule&) const { return 0; }
  int operator()(const Solid&) const { return 0; }
};

}  // namespace

void remove_hidden(const Model& model, const std::vector<Vec3>& c, const std::vector<Mat3>& R, double flush,
                   std::vector<std::size_t>& by_body, std::vector<ContactPoint>& points) {
  constexpr double kSameNormal = 1 - 1e-12;
  // Every two contacts of a body are compared. What so many touch does not roll over tiles.
  constexpr std::size_t kMostTouched = 2000;
  by_body.clear();
  for (std::size_t k = 0; k < points.size(); ++k)
    if (is_of_round_and_flat(points[k])) by_body.push_back(k);
  std::sort(by_body.begin(), by_body.end(), [&](std::size_t k, std::size_t l) {
    return std::pair(touched(points[k]).round, k) < std::pair(touched(points[l]).round, l);
  });
  const auto hides = [&](const Touched& near, const Touched& far) {
    if (near.round != far.round || !(near.d <= far.d) || near.n.dot(far.n) > kSameNormal) return false;
    const auto i = static_cast<std::size_t>(near.flat);
    const Vec3 x = R[i].transpose() * (far.y - c[i]);
    return std::visit(SurfacesAt{x, flush}, model.shape[i]) > (near.flat == far.flat ? 1 : 0);
  };
  bool some = false;
  for (std::size_t first = 0, last = 0; first < by_body.size(); first = last) {
    const Index round = touched(points[by_body[first]]).round;
    while (last < by_body.size() && touched(points[by_body[last]]).round == round) ++last;
    if (last - first == 1 || last - first > kMostTouched) continue;
    for (std::size_t k = first; k < last; ++k) {
      const Touched far = touched(points[by_body[k]]);
      for (std::size_t l = first; l < last; ++l) {
        if (l == k || !hides(touched(points[by_body[l]]), far)) continue;
        points[by_body[k]].part = -1;
        some = true;
        break;
      }
    }
  }
  if (some) std::erase_if(points, [](const ContactPoint& p) { return p.part < 0; });
}

}  // namespace pabd
