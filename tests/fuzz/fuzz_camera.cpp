// SPDX-License-Identifier: MIT
// Key frames of a camera: what is taken is written and read again, and gives finite poses between its keys.
#include "app/frames/camera_keys.h"
#include "tests/fuzz/fuzz.h"

using namespace pabd;

PABD_FUZZ_TARGET(camera, bytes) {
  fuzz::accepts([&] {
    const CameraKeys keys = parse_camera_keys(std::string(bytes), "camera.json");
    const CameraKeys again = parse_camera_keys(camera_keys_json(keys), "camera.json");
    fuzz::require(again.keys.size() == keys.keys.size(), "keys that are written are read back");
    for (std::size_t i = 0; i < keys.keys.size(); ++i) {
      fuzz::require(again.keys[i].time == keys.keys[i].time, "keys that are written are read back");
      for (const double ahead : {-1.0, 0.0, 1e-3, 0.5}) {
        const CameraPose pose = camera_at(keys.keys, keys.keys[i].time + ahead);
        fuzz::require(pose.eye.allFinite() && pose.target.allFinite() && pose.up.allFinite() &&
                          pose.fov >= 1 && pose.fov <= 170,
                      "a pose between keys is finite");
      }
    }
  });
}
