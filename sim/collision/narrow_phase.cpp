// SPDX-License-Identifier: MIT
// The pairs whose contacts the CPU and the GPU find by the same text.
#include "sim/collision/narrow_phase.h"

#include "sim/collision/pair_text.h"

namespace pabd::narrow {
namespace text {
namespace {

struct SphereSphere : PairText {
  using PairText::PairText;
#include "sim/collision/round_contact.inl"
#include "sim/collision/sphere_sphere.inl"
};

struct CapsuleSphere : PairText {
  using PairText::PairText;
#include "sim/collision/capsule_sphere.inl"
#include "sim/collision/round_contact.inl"
};

struct CapsuleCapsule : PairText {
  using PairText::PairText;
#include "sim/collision/round_contact.inl"
#include "sim/collision/side_by_side.inl"

#include "sim/collision/capsule_capsule.inl"
};

struct PlaneSphere : PairText {
  using PairText::PairText;
#include "sim/collision/plane_sphere.inl"
};

struct PlaneCapsule : PairText {
  using PairText::PairText;
#include "sim/collision/plane_capsule.inl"
};

struct BoxSphere : PairText {
  using PairText::PairText;
#include "sim/collision/box_sphere.inl"
};

struct HullSphere : PairText {
  using PairText::PairText;
#include "sim/collision/hull_distance.inl"
#include "sim/collision/hull_sphere.inl"
};

struct HullCapsule : PairText {
  using PairText::PairText;
#include "sim/collision/hull_distance.inl"
#include "sim/collision/side_by_side.inl"

#include "sim/collision/hull_capsule.inl"
};

template <class Text, class A, class B>
void find(const Placed<A>& a, const Placed<B>& b, double reach, Contacts& out,
          const HullView* hull = nullptr) {
  Text(text_body(a, hull), text_body(b), out).find_contacts(reach);
}

}  // namespace
}  // namespace text

void sphere_sphere(const Placed<Sphere>& a, const Placed<Sphere>& b, double reach, Contacts& out) {
  text::find<text::SphereSphere>(a, b, reach, out);
}

void capsule_sphere(const Placed<Capsule>& capsule, const Placed<Sphere>& sphere, double reach,
                    Contacts& out) {
  text::find<text::CapsuleSphere>(capsule, sphere, reach, out);
}

void capsule_capsule(const Placed<Capsule>& a, const Placed<Capsule>& b, double reach, Contacts& out) {
  text::find<text::CapsuleCapsule>(a, b, reach, out);
}

void sphere_plane(const Placed<Plane>& plane, const Placed<Sphere>& sphere, double reach, Contacts& out) {
  text::find<text::PlaneSphere>(plane, sphere, reach, out);
}

void capsule_plane(const Placed<Plane>& plane, const Placed<Capsule>& capsule, double reach, Contacts& out) {
  text::find<text::PlaneCapsule>(plane, capsule, reach, out);
}

void box_sphere(const Placed<Box>& box, const Placed<Sphere>& sphere, double reach, Contacts& out) {
  text::find<text::BoxSphere>(box, sphere, reach, out);
}

void hull_sphere(const Placed<Hull>& hull, const Placed<Sphere>& sphere, double reach, Contacts& out) {
  const HullView view = view_of(*hull.shape.data);
  text::find<text::HullSphere>(hull, sphere, reach, out, &view);
}

void hull_capsule(const Placed<Hull>& hull, const Placed<Capsule>& capsule, double reach, Contacts& out) {
  const HullView view = view_of(*hull.shape.data);
  text::find<text::HullCapsule>(hull, capsule, reach, out, &view);
}

void box_capsule(const Placed<Box>& box, const Placed<Capsule>& capsule, double reach, Contacts& out) {
  const BoxHull hull(box.shape.half);
  const HullView view = hull.view();
  text::find<text::HullCapsule>(box, capsule, reach, out, &view);
}

}  // namespace pabd::narrow
