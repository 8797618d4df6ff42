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

}  // namespace

int main() {
  Run run(fuzz::recording_scene(), 1, std::size_t{1} << 20);
  play(run);
  constexpr std::size_t kHead = 20, kChecksum = 16;
  const std::string bytes = encode_recording(run);
  const std::size_t size = bytes.size() - kHead - kChecksum;
  return std::fwrite(bytes.data() + kHead, 1, size, stdout) == size && std::fflush(stdout) == 0 ? 0 : 1;
}
