// SPDX-License-Identifier: MIT
// Glyphs of contacts and bonds: discs, arrows, point pairs.
#pragma once

#include "render/visual/build_visual.h"

namespace pabd {

// What glyphs of contacts look like, for all who make them.
namespace glyph {
inline constexpr double kShaft = 0.19;       // radius of the shaft, × s
inline constexpr double kHead = 0.52;        // radius of the head, × s
inline constexpr double kHeadLength = 1.35;  // × s
inline constexpr double kLongest = 10.0;     // longest arrow, × s
inline constexpr double kShortest = 0.5;     // a shorter one says nothing, × s
inline constexpr double kRim = 0.16;         // width of the dark rim, × s
inline constexpr double kSide = 0.05;        // a normal that is less steep has no upper body
inline constexpr double kSameNormal = 0.9;   // cosine
inline constexpr double kNoForce = 1e-9;     // so that contacts without any have a middle as well; N
inline constexpr std::uint32_t kRimInk = 0x1b1f27;
}  // namespace glyph

// A typical weight in N: the mean over movable bodies; 1 when nothing moves.
double typical_weight(const Model& model);

// Affine transform of a primitive: its y axis along `axis` (unit) scaled by `sy`, the others by `sxz`, moved
// to `p`.
Mat4f place_along(const Vec3& p, const Vec3& axis, double sxz, double sy);

// Radius of a disc in m when the caller gives none: a fraction of the median half width of the movable
// bodies.
double default_glyph_scale(const Model& model);

// Beyond so many contacts those of two bodies that share a normal are one glyph: where their load is, with all of
// it, in the colour of the deepest.
inline constexpr std::size_t kManyContacts = 300;

// What is drawn of one contact, or of several in one place.
struct ContactGlyph {
  Index a, b;
  Vec3 at;       // on the body that the arrow pushes; m
  Vec3 towards;  // unit
  double d;      // m
  double force;  // normal force, ≥ 0; N
  double slip;   // ‖f_t‖/(μ f_n) of all together; NaN without friction or force
};

// Those of the same two bodies with the same normal as one.
std::vector<ContactGlyph> merged_contacts(const Model& model, const StepReport& report);

// The disc and the arrow of one contact; scale and weight as below. Nothing for non-finite numbers.
void add_contact_glyph(const Model& model, const ContactReport& contact, const VisualOptions& options,
                       double scale, double weight, VisualScene& out);

// Adds the glyphs of `report` to `out`. `scale` is the radius of a contact disc in m, > 0; `weight` a typical
// weight of a body in N, > 0, against which arrow lengths are measured. An arrow is the force on the movable body, of
// two movable ones on the upper, so that neighbours point the same way; none where there is next to no force. Discs
// and arrows have a dark rim as out.camera sees them, which must be set before.
void add_contact_glyphs(const Model& model, const StepReport& report, const VisualOptions& options,
                        double scale, double weight, VisualScene& out);

}  // namespace pabd
