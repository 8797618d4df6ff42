// SPDX-License-Identifier: MIT
// What barriers are plotted against.
#include "app/plots/figures/barrier_abscissa.h"

#include <algorithm>
#include <cmath>

namespace pabd {

BarrierPoint with_abscissa(BarrierPoint at, BarrierAbscissa abscissa, double x) {
  switch (abscissa) {
    case BarrierAbscissa::gap:
      at.d = x;
      break;
    case BarrierAbscissa::d_hat:
      at.barrier.d_hat = x;
      break;
    case BarrierAbscissa::order:
      at.barrier.N = static_cast<int>(x);
      break;
    case BarrierAbscissa::kappa:
      at.barrier.kappa = x;
      break;
  }
  return at;
}

std::vector<double> barrier_samples(BarrierAbscissa abscissa, const PlotRange& x, int count,
                                    std::span<const double> jumps) {
  std::vector<double> xs;
  if (abscissa == BarrierAbscissa::order) {
    for (int N = 1; N < x.hi; ++N) xs.push_back(N);
    return xs;
  }
  for (int k = 0; k <= count; ++k) xs.push_back(x.lo + (x.hi - x.lo) * k / count);
  for (const double jump : jumps) {
    if (jump > x.lo && jump < x.hi)
      xs.insert(xs.end(), {std::nextafter(jump, x.lo), jump, std::nextafter(jump, x.hi)});
  }
  std::sort(xs.begin(), xs.end());
  return xs;
}

}  // namespace pabd
