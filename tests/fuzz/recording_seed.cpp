// SPDX-License-Identifier: MIT
// Writes what a recording holds between its head and its checksum, for the fuzzer to start from: steps,
// changed parameters, a hand, bodies and a joint that come and go.
#include <cstdio>

#include "app/session/recording.h"
#include "sim/scene/tuning.h"
#include "tests/fuzz/recording_scene.h"

using namespace pabd;

namespace {

void play(Run& run) {
  run.advance();
  run.set_params(tuned(run.params(), {"contact.kappa=123.5"}));
  run.set_pulls({{1, {0.1, 0.2, 0.3}, {0.3, 2, 0.1}, 432.1}});
  run.advance();
  AddBody ball;
  ball.shape = Sphere{0.2};
  ball.position = {0.1, 3, 0.3};
  run.edit(ball);
  AddJoint joint;
  joint.type = JointType::hinge;
  joint.i = 2;
  joint.anchor = {0.2, 2.5, 0.4};
  run.edit(joint);
  run.advance();
  run.edit(RemoveBody{1});
  run.advance();
}

// What the fuzzer starts from is taken: else it would try heads and nothing else.
bool is_taken(std::string_view payload) {
  return decode_recording(fuzz::sealed(payload), "seed", fuzz::recording_scene(), std::size_t{1} << 20)
             .size() > 1;
}

}  // namespace

int main() {
  Run run(fuzz::recording_scene(), 1, std::size_t{1} << 20);
  play(run);
  const std::string bytes = encode_recording(run);
  const std::string_view payload = std::string_view(bytes).substr(
      kRecordHeadBytes, bytes.size() - kRecordHeadBytes - kRecordChecksumBytes);
  const bool written = std::fwrite(payload.data(), 1, payload.size(), stdout) == payload.size();
  return is_taken(payload) && written && std::fflush(stdout) == 0 ? 0 : 1;
}
