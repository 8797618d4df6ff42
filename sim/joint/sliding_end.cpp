// SPDX-License-Identifier: MIT
#include "sim/joint/sliding_end.h"

#include <algorithm>
#include <limits>

#include "sim/joint/joint_traits.h"
#include "sim/math/row_list.h"

namespace pabd {
namespace {

constexpr int kFloats = std::numeric_limits<int>::max();

bool slides(const Joint& joint) {
  const auto measures = traits_of(joint.type).measures;
  return std::any_of(measures.begin(), measures.end(),
                     [](const JointMeasure& m) { return m.of == JointMeasure::Of::offset; });
}

// How many joints each body is from one that cannot move, or the world. Rods and springs hold no direction.
std::vector<int> distances(const Model& model) {
  const std::size_t n = model.shape.size();
  std::vector<int> out(n, kFloats);
  RowList<Index> neighbours;
  neighbours.fill(n, [&](const auto& visit) {
    for (const Joint& joint : model.joints) {
      if (traits_of(joint.type).points) continue;
      if (joint.i != kWorld && joint.j != kWorld) {
        visit(joint.i, joint.j);
        visit(joint.j, joint.i);
      } else {
        out[joint.i == kWorld ? joint.j : joint.i] = 1;
      }
    }
  });

  std::vector<std::size_t> queue;
  for (const int far : {0, 1}) {
    for (std::size_t i = 0; i < n; ++i) {
      if (far == 0 && model.fixed[i]) out[i] = 0;
      if (out[i] == far) queue.push_back(i);
    }
  }
  // Those of 1 come after what is a joint from a fixed body: in the order of distances all the same.
  for (std::size_t k = 0; k < queue.size(); ++k) {
    const std::size_t a = queue[k];
    for (const Index b : neighbours[static_cast<Index>(a)]) {
      int& distance = out[b];
      if (distance <= out[a] + 1) continue;
      distance = out[a] + 1;
      queue.push_back(static_cast<std::size_t>(b));
    }
  }
  return out;
}

}  // namespace

void settle_sliding_ends(Model& model, std::size_t first) {
  const auto begin = model.joints.begin() + static_cast<std::ptrdiff_t>(first);
  if (std::none_of(begin, model.joints.end(), slides)) return;
  const std::vector<int> far = distances(model);
  const auto distance = [&](Index body) { return body == kWorld ? 0 : far[body]; };
  const auto size = [&](Index body) {
    return body == kWorld ? std::numeric_limits<double>::infinity() : bounding_radius(model.shape[body]);
  };
  for (auto joint = begin; joint != model.joints.end(); ++joint) {
    if (!slides(*joint)) continue;
    const int i = distance(joint->i), j = distance(joint->j);
    const double size_i = size(joint->i), size_j = size(joint->j);
    joint->on_second = i != j ? j > i : size_i != size_j ? size_j < size_i : joint->j > joint->i;
    if (joint->usual_arm)
      joint->arm = std::max(joint->arm, (joint->on_second ? joint->on_j : joint->on_i).r.norm());
  }
}

}  // namespace pabd
