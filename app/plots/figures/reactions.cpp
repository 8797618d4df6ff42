// SPDX-License-Identifier: MIT
// What joints carry over time.
#include "app/plots/figures/reactions.h"

#include <algorithm>
#include <utility>

#include "app/plots/quantities.h"
#include "app/plots/theme.h"

namespace pabd {

void keep_strongest(std::vector<JointSeries>& joints, std::size_t most) {
  const auto largest = [](const JointSeries& joint) {
    return joint.force.empty() ? 0 : *std::max_element(joint.force.begin(), joint.force.end());
  };
  std::stable_sort(joints.begin(), joints.end(),
                   [&](const JointSeries& a, const JointSeries& b) { return largest(a) > largest(b); });
  if (joints.size() > most) joints.resize(most);
}

Figure reactions_figure(const std::vector<double>& time, const std::vector<JointSeries>& joints) {
  Figure figure;
  figure.title = "Joint reactions over time";
  figure.columns = 2;
  Plot force, error;
  force.title = "Force through the joint";
  force.y.label = quantities::any_force.axis;
  error.title = "Distance of the points it holds together";
  error.y.label = quantities::error.axis;
  error.y.log = true;
  error.none = "no error";
  force.x.label = error.x.label = quantities::time.axis;
  for (std::size_t k = 0; k < joints.size(); ++k) {
    const auto add = [&](Plot& plot, const std::vector<double>& values) {
      Series series;
      series.name = joints[k].name;
      series.x = time;
      series.y = values;
      series.color = static_cast<int>(k % kPaletteSize);
      series.dash = static_cast<int>(k / kPaletteSize);
      plot.series.push_back(std::move(series));
    };
    add(force, joints[k].force);
    add(error, joints[k].error);
  }
  figure.plots = {std::move(force), std::move(error)};
  return figure;
}

}  // namespace pabd
