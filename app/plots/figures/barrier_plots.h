// SPDX-License-Identifier: MIT
// The barrier that contacts see, as a plot to tune on: curves of several variants, every contact at its d,
// and where d̂ and κ can be taken hold of. And how the contacts are spread over d/d̂.
//
//   d, d̂    signed distance, thickness                                  m
//   Ψ       contact potential κ B_N(d), S(5); Ψ′, Ψ″ its derivatives     J, N, N/m
//   B_N     Ψ/κ                                                          1, 1/m, 1/m²
//   κ       stiffness, resolved; J (log barrier: J/m²)
//   ε       onset width (deviation D2)
//
// The log barrier S(4) carries a factor in m²; beside the others it is drawn as B/d̂², a number as B_N is.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/plots/plot.h"
#include "sim/potential/barrier.h"
#include "sim/solver/params.h"
#include "sim/solver/report.h"

namespace pabd {

enum class BarrierQuantity : std::uint8_t { value, slope, curvature };  // Ψ, Ψ′, Ψ″

// Which curves stand beside the one in use, which is always shown. Those that would equal it are left out.
struct BarrierVariants {
  bool printed = false;  // ε = 0
  bool onset = false;    // ε of the parameters
  bool even = false;
  bool log = false;
};

struct BarrierPanelOptions {
  BarrierQuantity quantity = BarrierQuantity::value;
  bool log_y = false;  // of Ψ, −Ψ′ (the normal force), Ψ″
  bool energy = true;  // Ψ in J, with a handle for κ; false: B_N = Ψ/κ
  BarrierVariants variants;
  // Ranges held fixed, as a drag needs it: otherwise the axes would follow the hand. Empty: fitted.
  std::optional<PlotRange> x, y;
  std::size_t most_markers = 2000;
};

// What a plot shows of a barrier where it has these values.
double shown_of(const BarrierValue& value, const BarrierPanelOptions& options);

struct KappaHandle {
  double d, y;       // data coordinates of the handle: on the curve in use at d
  double per_kappa;  // y at κ = 1
};

struct BarrierPanel {
  Plot plot;                  // with the ranges that were used: plot.x.lo … plot.y.hi
  std::size_t contacts = 0;   // with d < d̂
  std::size_t markers = 0;    // of these drawn: every k-th in order of d, the deepest always
  std::size_t unbounded = 0;  // log barrier: contacts with d ≤ 0, where it is infinite; drawn at the edge
  double d_hat = 0;           // x of the vertical line that can be dragged
  std::optional<KappaHandle> kappa;  // absent without energies, or where the quantity does not depend on κ
};

// The axis of what is plotted, with its unit: Ψ or −B_{N}′.
std::string barrier_label(const BarrierPanelOptions& options);

// `kappa` is the resolved one. `color` gives a contact's colour from d/d̂. Parameters must pass check_params.
BarrierPanel barrier_panel(const ContactParams& contact, double kappa,
                           const std::vector<ContactReport>& contacts,
                           const std::function<Color(double)>& color, const BarrierPanelOptions& options);

// The d̂ that a drag of the line to x asks for, within what check_params accepts; `now` when x is no number.
double dragged_d_hat(double x, double now);
// The κ for which the curve passes the height y at the handle, within what check_params accepts; a height on
// the wrong side of zero asks for the smallest. `now` when y is no number.
double dragged_kappa(const KappaHandle& handle, double y, double now);

struct ContactHistogram {
  Plot plot;  // bars: twenty from 0 to 1, and one left of 0 for all d < 0; lines at the median and the onset
  std::size_t contacts = 0;     // with d < d̂
  std::size_t overlapping = 0;  // with d < 0
  double median = 0;            // of d/d̂; NaN without contacts
};
ContactHistogram contact_histogram(const ContactParams& contact, const std::vector<ContactReport>& contacts,
                                   const std::function<Color(double)>& color);

}  // namespace pabd
