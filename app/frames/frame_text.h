// SPDX-License-Identifier: MIT
// The text chunks of every PNG: where the picture came from, so that it can be made again.
//
//   Software      "pabd 0.2.0"
//   Scene         name of the scene
//   Scene hash    16 hex digits over the resolved scene
//   Parameters    JSON: what --set can tune, with the stiffness that "auto" came to
//   Start         hash of the state at frame 0
//   View          JSON: size, frames a second, overlay, camera as on the command line; quality and
//                 colours, unless they are "good", "body" and "gap"; with --grid, what it was given.
//                 Parameters are those of the first run then
//   B patch       with --ab: the patch that leads from A's parameters to B's, and how both are shown
//   B parameters  with --ab: what B has
//   GL_RENDERER   the driver that drew it
//   Frame, Time   number from 0, and simulated seconds of the state that is shown
#pragma once

#include <string>
#include <vector>

#include "app/session/frame_view.h"
#include "render/output/png.h"
#include "sim/scene/scene.h"

namespace pabd {

struct ViewFacts {
  int width = 0, height = 0;
  double fps = 60;
  std::string overlay;
  std::string camera;
  std::string gl_renderer;
  std::string quality = "good";  // as on the command line
  std::string theme = "studio";
  std::string color_by = "body", contacts_by = "gap";
  std::vector<std::string> trails = {};  // as --trail takes them
  std::string grid = {};
};

// {"gravity": …, "time_step": …, "solver": …, "contact": …}; `kappa` is the resolved stiffness in J. With
// `joints`, "joints_default": the law of joints that say nothing of their own, its stiffness resolved too.
std::string parameters_json(const Params& params, double kappa, const BondLaw* joints = nullptr);

// What all frames of one run of `scene` have in common. `a` is what frame 0 shows of it, `b` of the second
// run; null: there is none. `ab_view`: "side" or "ghost". `scene_b`: of B, whose joints may have another law; null: the
// same.
PngText common_text(const Scene& scene, const ViewFacts& facts, const FrameView& a,
                    const FrameView* b = nullptr, const std::string& ab_view = "",
                    const Scene* scene_b = nullptr);

// With the two chunks of frame `frame`; `time` in seconds.
PngText frame_text(const PngText& common, int frame, double time);

// Where a sequence that was cut short goes on: after the last whole frame that this run would have written
// (`common`). Throws Error(bad_input) when frames of another scene, other parameters, view or renderer are
// found.
int find_resume_frame(const std::string& out, int frames, const PngText& common);

}  // namespace pabd
