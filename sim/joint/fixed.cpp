// Fixed joint: a ball S(7) and, for each of the three rotations, points on both sides of the anchor S(8–10).
#include "sim/joint/expand.h"

namespace pabd {

void expand_fixed(const Joint& joint, const PlacedFrame& fi, const PlacedFrame& fj, BondList& out) {
  out.add(fi.y, fj.y);
  for (int k = 0; k < 3; ++k) {
    for (const double side : {1.0, -1.0}) {
      if (side < 0 && !joint.symmetric) break;
      out.add(fi.y + side * joint.arm * fi.F.col(k), fj.y + side * joint.arm * fj.F.col(k));
    }
  }
}

}  // namespace pabd
