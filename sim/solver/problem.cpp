// See problem.h.
#include "sim/solver/problem.h"

namespace pabd {

void list_bonds(Problem& p, const Iterate& it) {
  const auto bodies = p.model->shape.size();
  p.ends.fill(bodies, [&](const auto& visit) {
    for (std::size_t k = 0; k < it.patch.size(); ++k) {
      const ContactPatch& patch = it.patch[k];
      const auto number = static_cast<Index>(k);
      const bool a = p.movable(patch.a), b = p.movable(patch.b);
      if (a) visit(patch.a, PatchEnd{number, patch.b, true, true});
      if (b) visit(patch.b, PatchEnd{number, patch.a, false, !a});
    }
  });
  p.joints_at.fill(bodies, [&](const auto& visit) {
    for (std::size_t k = 0; k < p.joints.size(); ++k) {
      const auto number = static_cast<Index>(k);
      for (const Index i : {p.joints[number].i, p.joints[number].j}) {
        if (p.movable(i)) visit(i, number);
      }
    }
  });
}

}  // namespace pabd
