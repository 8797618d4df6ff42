// SPDX-License-Identifier: MIT
// Where loads go: what two bodies press each other with, as bars between their centres of mass.
#pragma once

#include "render/visual/build_visual.h"

namespace pabd {

// The largest normal force of two bodies with one normal in a step; N. 0: there is none.
double largest_force(const Model& model, const StepReport& report);

// The range for such forces: three decades below the next of 1, 2, 5, 10, … times a power of ten.
ValueRange force_range(double largest);

// Of two bodies with one normal, a bar from either centre of mass to where their load is, in front of all bodies; a fixed body
// has none, and a foot there. Colour and width grow with the place of the force in `range`; none where that is 0. `scale`: of
// glyphs of contacts, m; bars are never much wider. out.camera must be set before.
void add_force_chains(const Model& model, const State& state, const StepReport& report,
                      const ValueRange& range, double scale, VisualScene& out);

}  // namespace pabd
