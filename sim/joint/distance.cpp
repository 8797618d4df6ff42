// Distance joint S(1): ‖y_i − y_j‖ = l. Soft it is a spring.
#include "sim/joint/expand.h"

namespace pabd {

void expand_distance(const Joint& joint, const PlacedFrame& fi, const PlacedFrame& fj, BondList& out) {
  out.add(fi.y, fj.y);
  out.bond[0].length = joint.length;
}

}  // namespace pabd
