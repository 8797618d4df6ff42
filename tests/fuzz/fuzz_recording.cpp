// SPDX-License-Identifier: MIT
// A recording, with a head and a checksum that fit it, as somebody makes them who means harm: what is taken
// can be wound back and written again.
#include "app/session/byte_stream.h"
#include "app/session/recording.h"
#include "sim/base/hash.h"
#include "tests/fuzz/fuzz.h"
#include "tests/fuzz/recording_scene.h"

using namespace pabd;

namespace {

std::string sealed(std::string_view payload) {
  std::string bytes;
  ByteWriter file([&](std::string_view part) { bytes += part; });
  file.raw("pabd-rec");
  file.u32(1);
  file.u64(payload.size());
  file.raw(payload);
  file.flush();
  Hash64 hash;
  hash.add_text(bytes);
  return bytes + hash.hex();
}

}  // namespace

PABD_FUZZ_TARGET(recording, bytes) {
  static const auto scene = fuzz::recording_scene();
  constexpr std::size_t kMemory = 1 << 20;
  fuzz::accepts([&] { decode_recording(std::string(bytes), "r.rec", scene, kMemory); });
  fuzz::accepts([&] {
    Timeline timeline = decode_recording(sealed(bytes), "r.rec", scene, kMemory);
    const Run run(scene, 1, std::move(timeline));
    const Timeline again = decode_recording(encode_recording(run), "r.rec", scene, kMemory);
    fuzz::require(again.size() == run.timeline().size(), "a recording that is written is read back");
  });
}
