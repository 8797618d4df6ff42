// SPDX-License-Identifier: MIT
// A recording, with a head and a checksum that fit it, as somebody makes them who means harm: what is taken
// can be wound back and written again.
#include "app/session/recording.h"
#include "tests/fuzz/fuzz.h"
#include "tests/fuzz/recording_scene.h"

using namespace pabd;

PABD_FUZZ_TARGET(recording, bytes) {
  static const auto scene = fuzz::recording_scene();
  constexpr std::size_t kMemory = 1 << 20;
  fuzz::accepts([&] { decode_recording(std::string(bytes), "r.rec", scene, kMemory); });
  fuzz::accepts([&] {
    Timeline timeline = decode_recording(fuzz::sealed(bytes), "r.rec", scene, kMemory);
    const Run run(scene, 1, std::move(timeline));
    const Timeline again = decode_recording(encode_recording(run), "r.rec", scene, kMemory);
    fuzz::require(again.size() == run.timeline().size(), "a recording that is written is read back");
  });
}
