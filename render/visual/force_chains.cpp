// SPDX-License-Identifier: MIT
// Bars as lines in front of bodies: the weak ones first, each over a dark rim.
#include "render/visual/force_chains.h"

#include <algorithm>

#include "render/visual/bounds.h"
#include "render/visual/contact_glyphs.h"
#include "render/visual/line_shapes.h"
#include "render/visual/palette.h"

namespace pabd {
namespace {

constexpr int kForceDecades = 3;
constexpr double kLeastForce = 1e-6;  // N; a range ends above it
// Pixels at 720 px frame height.
constexpr double kWidestBar = 11, kThinnestBar = 1.2, kBarRim = 1.2;
constexpr double kBarShare = 2.4;  // widest, × scale

bool anywhere(const Vec3&, const Vec3&) { return true; }

}  // namespace

double largest_force(const Model& model, const StepReport& report) {
  double out = 0;
  for (const ContactGlyph& glyph : merged_contacts(model, report, anywhere)) out = std::max(out, glyph.force);
  return out;
}

ValueRange force_range(double largest) { return round_range(largest, kLeastForce, true, kForceDecades); }

void add_force_chains(const Model& model, const State& state, const StepReport& report,
                      const ValueRange& range, double scale, VisualScene& out) {
  std::vector<ContactGlyph> glyphs = merged_contacts(model, report, anywhere);
  std::erase_if(glyphs, [&](const ContactGlyph& glyph) { return !(range.place(glyph.force) > 0); });
  std::stable_sort(glyphs.begin(), glyphs.end(),
                   [](const ContactGlyph& x, const ContactGlyph& y) { return x.force < y.force; });
  const PixelMeter meter(out.camera);
  for (const ContactGlyph& load : glyphs) {
    const double place = range.place(load.force), px = meter.at(load.at);
    const double width = std::max(kThinnestBar, place * place * std::min(kWidestBar, kBarShare * scale / px));
    const Vec4f color = value_color(place), rim = srgb_color(glyph::kRimInk);
    for (const bool under : {true, false}) {
      const Pen pen{under ? rim : color, under ? width + 2 * kBarRim : width};
      for (const Index body : {load.a, load.b}) {
        if (body < 0 || body >= model.size() || !has_finite_pose(state, body)) continue;
        if (model.fixed[body]) {
          const Vec3 across =
              load.towards.cross(meter.to_eye(load.at)).stableNormalized() * (0.9 * width * px);
          add_line(out, load.at - across, load.at + across, pen);
        } else {
          const Vec3 way = state.c[body] - load.at;
          // Square ends, so that bars meet without a notch.
          const Vec3 more = 0.5 * width * px * way.stableNormalized();
          add_line(out, load.at - more, state.c[body] + more, pen);
        }
      }
    }
  }
}

}  // namespace pabd
