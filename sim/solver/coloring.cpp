#include "sim/solver/coloring.h"

#include <algorithm>

namespace pabd {
void list_ends(const Model& model, StepWorkspace::Impl& w) {
  const std::size_t n = model.shape.size();
  w.first_end.assign(n + 1, 0);
  for (const ContactPatch& patch : w.patches) {
    if (!model.fixed[patch.a]) ++w.first_end[patch.a + 1];
    if (!model.fixed[patch.b]) ++w.first_end[patch.b + 1];
  }
  for (std::size_t i = 0; i < n; ++i) w.first_end[i + 1] += w.first_end[i];
  w.ends.resize(static_cast<std::size_t>(w.first_end[n]));
  for (std::size_t k = 0; k < w.patches.size(); ++k) {
    const ContactPatch& patch = w.patches[k];
    const auto number = static_cast<Index>(k);
    if (!model.fixed[patch.a]) w.ends[w.first_end[patch.a]++] = {number, patch.b, true, true};
    if (!model.fixed[patch.b])
      w.ends[w.first_end[patch.b]++] = {number, patch.a, false, model.fixed[patch.a] != 0};
  }
  for (std::size_t i = n; i > 0; --i) w.first_end[i] = w.first_end[i - 1];  // undo the advance
  w.first_end[0] = 0;
}

namespace {

// The smallest colour that no neighbour has.
Index free_color(const Model& model, const StepWorkspace::Impl& w, Index body) {
  std::uint64_t used = 0;
  Index beyond = 0;  // smallest colour above all neighbours, for the rare body with 64 colours around it
  for (const BondEnd& end : w.ends_of(body)) {
    const Index other = end.other;
    if (model.fixed[other] || w.color[other] < 0) continue;
    if (w.color[other] < 64) used |= std::uint64_t{1} << w.color[other];
    beyond = std::max(beyond, w.color[other] + 1);
  }
  for (const Index k : w.joints_of(body)) {
    const Joint& joint = w.all_joints[static_cast<std::size_t>(k)];
    const Index other = joint.i == body ? joint.j : joint.i;
    if (other == kWorld || model.fixed[other] || w.color[other] < 0) continue;
    if (w.color[other] < 64) used |= std::uint64_t{1} << w.color[other];
    beyond = std::max(beyond, w.color[other] + 1);
  }
  for (Index k = 0; k < 64; ++k) {
    if (!(used >> k & 1)) return k;
  }
  return beyond;
}

}  // namespace

void color_bodies(const Model& model, StepWorkspace::Impl& w) {
  const Index n = model.size();
  w.color.assign(static_cast<std::size_t>(n), -1);
  w.first_of_color.clear();
  Index colors = 0;
  for (Index i = 0; i < n; ++i) {
    if (w.is_newton[i] || (w.ends_of(i).empty() && w.joints_of(i).empty())) continue;
    w.color[i] = free_color(model, w, i);
    colors = std::max(colors, w.color[i] + 1);
  }
  w.first_of_color.assign(static_cast<std::size_t>(colors) + 1, 0);
  for (Index i = 0; i < n; ++i) {
    if (w.color[i] >= 0) ++w.first_of_color[w.color[i] + 1];
  }
  for (Index k = 0; k < colors; ++k) w.first_of_color[k + 1] += w.first_of_color[k];
  w.colored.resize(static_cast<std::size_t>(w.first_of_color[colors]));
  for (Index i = 0; i < n; ++i) {
    if (w.color[i] >= 0) w.colored[w.first_of_color[w.color[i]]++] = i;
  }
  for (Index k = colors; k > 0; --k) w.first_of_color[k] = w.first_of_color[k - 1];
  w.first_of_color[0] = 0;
}

}  // namespace pabd
