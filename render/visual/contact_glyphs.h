// SPDX-License-Identifier: MIT
// Glyphs of contacts and bonds: discs, arrows, point pairs.
#pragma once

#include "render/visual/build_visual.h"

namespace pabd {

// Affine transform of a primitive: its y axis along `axis` (unit) scaled by `sy`, the others by `sxz`, moved
// to `p`.
Mat4f place_along(const Vec3& p, const Vec3& axis, double sxz, double sy);

// Radius of a disc in m when the caller gives none: a fraction of the median half width of the movable
// bodies.
double default_glyph_scale(const Model& model);

// The disc and the arrow of one contact; scale and weight as below. Nothing for non-finite numbers.
void add_contact_glyph(const ContactReport& contact, double d_hat, double scale, double weight,
                       VisualScene& out);

// Adds the glyphs of `report` to `out`. `scale` is the radius of a contact disc in m, > 0; `weight` a typical
// weight of a body in N, > 0, against which arrow lengths are measured.
void add_contact_glyphs(const StepReport& report, const VisualOptions& options, double scale, double weight,
                        VisualScene& out);

}  // namespace pabd
