// SPDX-License-Identifier: MIT
// What the benchmark asks of an engine. Each program of this folder links exactly one implementation, so that
// the peak memory of its process is that engine's alone.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "sim/scene/scene.h"
#include "tests/bench/peers/peer_scenes.h"

namespace pabd::peers {

struct EngineOptions {
  int threads = 1;
  bool record_contacts = false;  // make `penetrations` available; may cost time
};

class Engine {
 public:
  virtual ~Engine() = default;
  virtual void step() = 0;  // advances by params.h
  // Depth of every contact point of the last step that the engine itself reports as overlapping; m, > 0.
  virtual void penetrations(std::vector<double>& out) const = 0;
  // c, R, v, omega of every body, in the order of the model.
  virtual void read(State& state) const = 0;
};

std::string engine_name();  // with its version
int engine_threads();       // the most that it can use
bool engine_takes(SceneFor scene);
// Throws Error(bad_input) for a shape or joint that the engine's adapter does not know.
std::unique_ptr<Engine> make_engine(const Scene& scene, const EngineOptions& options);

}  // namespace pabd::peers
