// SPDX-License-Identifier: MIT
// See simulation.h.
#include "app/python/simulation.h"

#include <fmt/format.h>
#include <pybind11/pybind11.h>

#include <chrono>
#include <utility>

#include "app/session/diverged.h"
#include "sim/base/available_cpus.h"
#include "sim/base/error.h"
#include "sim/base/input_file.h"
#include "sim/scene/tuning.h"
#include "sim/trace/trace.h"

namespace pabd::python {
namespace {

namespace py = pybind11;
using Clock = std::chrono::steady_clock;

constexpr int kMostThreads = 1024;
constexpr std::int64_t kMostSteps = 1'000'000'000;
// How often Python is asked for signals. Its lock is to be had for that, which another thread may keep for 5 ms.
constexpr auto kBetweenSignals = std::chrono::milliseconds(50);

int checked_threads(int threads) {
  if (threads < 0 || threads > kMostThreads)
    throw Error(ErrorKind::bad_input,
                fmt::format("threads {}: expected a number from 0 (every CPU) to {}", threads, kMostThreads));
  return threads == 0 ? available_cpus() : threads;
}

// Devices are opened by the program.
void check_device(const Params& params) {
  if (params.solver.device == SolverDevice::gpu)
    throw Error(ErrorKind::bad_input,
                "solver.device gpu: steps from Python are made by the processor; expected cpu or auto");
}

bool same_parts(const Model& a, const Model& b) {
  if (a.name != b.name || a.joints.size() != b.joints.size()) return false;
  for (std::size_t k = 0; k < a.joints.size(); ++k)
    if (a.joints[k].name != b.joints[k].name) return false;
  return true;
}

}  // namespace

class Simulation::Away {
 public:
  explicit Away(Simulation& simulation) : mark_(simulation) {}

 private:
  struct Mark {
    explicit Mark(Simulation& s) : simulation(s) { simulation.away_ = true; }
    ~Mark() { simulation.away_ = false; }
    Simulation& simulation;
  };
  Mark mark_;  // with the lock; so made before it is given away, and gone after it is back
  py::gil_scoped_release release_;
};

Simulation::Simulation(NamedScene scene, int threads)
    : scene_(std::move(scene)), session_(scene_.scene, checked_threads(threads)) {
  check_device(session_.params());
  watch();
}

const Session& Simulation::session() const {
  if (away_)
    throw Error(ErrorKind::bad_input,
                "the simulation is in a step or a picture of another thread; wait for it to end");
  return session_;
}

Reports Simulation::history() const {
  session();
  return history_.view();
}

void Simulation::watch() {
  session_.report_contacts(observed_.contacts);
  session_.report_joints(observed_.joints);
  session_.record_iterations(observed_.iterations);
}

void Simulation::observe(const Observed& observed) {
  session();
  observed_ = observed;
  watch();
}

void Simulation::step(std::int64_t count) {
  session();
  if (count < 0 || count > kMostSteps)
    throw Error(ErrorKind::bad_input,
                fmt::format("step({}): expected a number from 0 to {}", count, kMostSteps));
  bool signalled = false, diverged = false;
  {
    const Away away(*this);
    auto asked = Clock::now();
    for (std::int64_t k = 0; k < count && !signalled && !diverged; ++k) {
      diverged = session_.step().status == StepStatus::non_finite;
      if (!diverged) add_report(history_, session_.report());
      if (Clock::now() - asked < kBetweenSignals) continue;
      const py::gil_scoped_acquire lock;
      signalled = PyErr_CheckSignals() != 0;
      asked = Clock::now();
    }
  }
  if (signalled) throw py::error_already_set();
  if (diverged) throw diverged_error(scene_.called, session_.report());
}

void Simulation::reset() {
  session();
  session_.reset();
  history_ = {};
}

void Simulation::set(const std::vector<std::string>& settings) {
  const Params params = tuned(session().params(), settings);
  check_device(params);
  session_.set_params(params);
}

SavedState Simulation::save() const { return {session().shared_model(), session().state()}; }

void Simulation::restore(const SavedState& saved) {
  if (!same_parts(*saved.model, session().model()))
    throw Error(ErrorKind::bad_input,
                "the state is of other bodies or joints than this scene's; use a state of this scene");
  session_.set_state(saved.state);
  history_ = {};
}

void Simulation::load_state(const std::string& path) {
  const Model& model = session().model();
  session_.set_state(
      state_from_json(model, read_file(path, most_state_bytes(model), "a state of this scene"), path));
  history_ = {};
}

Image Simulation::render(const PictureOptions& options) {
  session();
  if (!painter_ || !(painter_->options() == options)) {
    painter_.reset();
    const Away away(*this);
    painter_ = std::make_unique<Painter>(session_.shared_scene(), options);
  }
  if (painter_->needs_iterations() && !observed_.iterations)
    throw Error(ErrorKind::bad_input,
                fmt::format("overlay {}: shows iterations, which are not recorded; call "
                            "observe(iterations=True) before the step",
                            options.overlay));
  const Away away(*this);
  FrameView view = session_.view();
  view.history = history_.view();
  return painter_->draw(std::move(view));
}

}  // namespace pabd::python
