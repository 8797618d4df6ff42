// SPDX-License-Identifier: MIT
// See export_helpers.h.
#include "tests/export/export_helpers.h"

#include <cmath>

namespace pabd::testing {

std::shared_ptr<const Scene> varied_scene() {
  static constexpr const char* kText = R"({ "format": "pabd-scene", "version": 1, "name": "varied",
  "bodies": [
    { "name": "ground", "shape": { "type": "plane", "normal": [0, 1, 0], "offset": 0 }, "fixed": true },
    { "name": "post", "shape": { "type": "box", "size": [0.2, 2, 0.2] }, "fixed": true, "position": [3, 1, 0] },
    { "name": "crate", "shape": { "type": "box", "size": [1, 1, 1] }, "position": [0, 0.6, 0],
      "velocity": [1, 0, 0], "angular_velocity": [0, 9, 1] },
    { "name": "crate \"2\" é", "shape": { "type": "box", "size": [1, 1, 1] }, "position": [0, 2.1, 0.2],
      "color": "#336699", "material": { "opacity": 0.5 } },
    { "name": "ball", "shape": { "type": "sphere", "radius": 0.4 }, "position": [-2, 0.5, 0],
      "angular_velocity": [0, 0, 5], "material": { "checker": true } },
    { "name": "pill", "shape": { "type": "capsule", "radius": 0.2, "length": 0.6 }, "position": [-2, 2, 0] },
    { "name": "can", "shape": { "type": "cylinder", "radius": 0.3, "height": 0.5 }, "position": [-4, 1, 0] },
    { "name": "hat", "shape": { "type": "cone", "radius": 0.3, "height": 0.5 }, "position": [-4, 2, 0] },
    { "name": "arm", "shape": { "type": "box", "size": [1, 0.2, 0.2] }, "position": [3.6, 1.5, 0] } ],
  "joints": [ { "name": "pivot", "type": "hinge", "bodies": ["post", "arm"], "anchor": [3.1, 1.5, 0],
                "axis": [0, 0, 1] } ] })";
  return std::make_shared<const Scene>(parse_scene(kText, "varied", "."));
}

std::vector<Frame> frames_of(const std::shared_ptr<const Scene>& scene, int count, double fps) {
  Session session(scene, 1);
  session.report_contacts(true);
  session.report_joints(true);
  SessionSource source(std::move(session), count, fps);
  std::vector<Frame> out;
  while (auto frame = source.next([] { return false; })) out.push_back(*std::move(frame));
  return out;
}

void export_frames(const std::string& out, const Scene& scene, const std::vector<Frame>& frames,
                   ExportSetup setup) {
  setup.frames = static_cast<std::int64_t>(frames.size());
  const auto exporter = make_exporter(out, scene, frames.front().a, setup);
  for (const Frame& frame : frames) exporter->add(frame.number, frame.a);
  exporter->finish();
}

double rotation_error(const Mat3& R, double w, double x, double y, double z) {
  // Written out, so that it does not share a mistake with what it checks.
  Mat3 Q;
  Q << 1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y),  //
      2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x),   //
      2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y);
  return (R - Q).cwiseAbs().maxCoeff();
}

}  // namespace pabd::testing
