// SPDX-License-Identifier: MIT
// This project, with the defaults of a scene file that says nothing about the solver.
#include "sim/solver/time_step.h"
#include "tests/bench/peers/engine.h"

namespace pabd::peers {

namespace {

class PabdEngine : public Engine {
 public:
  PabdEngine(const Scene& scene, const EngineOptions& options)
      : model_(scene.model), params_(scene.params), state_(scene.initial) {
    options_.threads = options.threads;
    options_.report_contacts = options.record_contacts;
  }

  void step() override { pabd::step(model_, params_, options_, state_, workspace_, report_); }

  void penetrations(std::vector<double>& out) const override {
    out.clear();
    for (const ContactReport& contact : report_.contact_reports) {
      if (contact.d < 0) out.push_back(-contact.d);
    }
  }

  void read(State& state) const override { state = state_; }

 private:
  const Model& model_;
  Params params_;
  State state_;
  StepOptions options_;
  StepWorkspace workspace_;
  StepReport report_;
};

}  // namespace

std::string engine_name() { return "pabd"; }

int engine_threads() { return 1024; }

bool engine_takes(SceneFor) { return true; }

std::unique_ptr<Engine> make_engine(const Scene& scene, const EngineOptions& options) {
  return std::make_unique<PabdEngine>(scene, options);
}

}  // namespace pabd::peers
