// Spherical joint S(7): ‖y_i0 − y_j0‖ = 0.
#include "sim/joint/expand.h"

namespace pabd {

void expand_spherical(const Joint&, const PlacedFrame& fi, const PlacedFrame& fj, BondList& out) {
  out.add(fi.y, fj.y);
}

}  // namespace pabd
