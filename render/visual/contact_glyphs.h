// SPDX-License-Identifier: MIT
// Glyphs of contacts and bonds: discs, arrows, point pairs.
#pragma once

#include <functional>

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
// An arrow is at least as thick as one of this scale would be in a frame 720 px high (head 9 px, shaft 3 px), but at most so
// many times thicker than its own scale has it. Nearer to each other than its width, contacts of a pair are one mark.
inline constexpr double kLeastScale = 8.7;  // px
inline constexpr double kMostGrown = 3;
inline constexpr double kBluntest = 1.9;    // a short head is so many times wider than of its shape
inline constexpr double kLeastPoint = 1.6;  // radius of the point of a bond, px; also of joints
inline constexpr double kMarkWidth = 2 * (kHead + kRim);  // × s
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

// Beyond so many contacts those of two bodies that share a normal are one glyph, and of fewer those that are closer together
// than a mark: where their load is, with all of it, in the colour of the deepest.
inline constexpr std::size_t kManyContacts = 300;

// What is drawn of one contact, or of several in one place.
struct ContactGlyph {
  Index a, b;
  Vec3 y_a, y_b;      // m
  Vec3 at;            // on the body that the arrow pushes; m
  Vec3 towards;       // unit
  double d;           // m
  double force;       // normal force, ≥ 0; N
  double slip;        // ‖f_t‖/(μ f_n) of all together; NaN without friction or force
  std::size_t first;  // of the reports
};

// Those of the same two bodies with the same normal as one if `together` says so of the mark so far and the next place, in the
// order of the first of each.
using Together = std::function<bool(const Vec3& mark, const Vec3& next)>;
std::vector<ContactGlyph> merged_contacts(const Model& model, const StepReport& report,
                                          const Together& together);

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
