// SPDX-License-Identifier: MIT
// What a picture of a scene has to show: its bodies, and where they go.
#pragma once

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "app/session/frame_view.h"
#include "render/visual/bounds.h"
#include "render/visual/eased_camera.h"
#include "sim/scene/scene.h"

namespace pabd {

// Time that is looked ahead where nobody says how long a run is to be; s.
inline constexpr double kLookAhead = 5;
inline double look_ahead_time(const Scene& scene) { return scene.duration.value_or(kLookAhead); }

struct Outlook {
  double start_time = 0;             // s
  Vec3 start_middle = Vec3::Zero();  // of the movable bodies that matter; m
  std::vector<Spot>
      start;  // what there is, fixed bodies too; the floor below where it is not known what falls
  std::vector<TimedSpots> moments;  // after the start, in order: the movable bodies that matter
  double until = std::numeric_limits<double>::infinity();  // s: from then on all that matters is far away
  std::vector<std::uint8_t> far;  // 1: a movable body that does not matter; one a body, empty: none
  double body = 0;                // radius of a body, the median of those that matter; m

  // For a camera that stands still: all spots until then.
  std::vector<Spot> all() const;
};

// Bodies that do not matter are at most a tenth of five or more, and farther away than all others: one of them would make
// the others small. Neither do bodies that leave for good, unless all do: they end far away, in motion and above no plane.
// 1: matters. `way`: of each body, how far from `around` it goes; m. `end`: where they are then. `seen`: see bounds.h.
std::vector<std::uint8_t> who_matters(const Model& model, const BoundingSphere& around,
                                      const std::vector<double>& way, const State& end,
                                      const std::vector<std::uint8_t>& seen, const Vec3& gravity);

// What is to be seen of `start` and of `seconds` after it, found by simulating ahead, with longer steps if there would be
// too many. With many bodies that ends early, and the floor below them is shown. `only`: the
// bodies to be shown, all of which matter; empty: all that are in the picture.
Outlook look_ahead(const std::shared_ptr<const Scene>& scene, const FrameView& start, double seconds,
                   const std::vector<Index>& only = {});
// The same of the start of a scene, with its parameters.
Outlook look_ahead(const std::shared_ptr<const Scene>& scene, double seconds);

}  // namespace pabd
