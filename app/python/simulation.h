// SPDX-License-Identifier: MIT
// A session as Python has it: steps are made without the interpreter's lock, so that other threads of Python go on
// meanwhile, and arrays stay where they are, so that Python may look at them.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/python/painter.h"
#include "app/session/session.h"

namespace pabd::python {

// A state and the model that it is of. Nobody changes it.
struct SavedState {
  std::shared_ptr<const Model> model;
  State state;
};

// A scene, and how it was called: for messages.
struct NamedScene {
  std::shared_ptr<const Scene> scene;
  std::string called;
};

struct Observed {
  bool contacts = true, joints = true, iterations = false;
};

// Calls are made with the interpreter's lock. While one of them is without it, others throw Error(bad_input).
class Simulation {
 public:
  // `threads`: 0: of every CPU that may be used.
  Simulation(NamedScene scene, int threads);

  // Throws Error(bad_input) while a step is being made.
  const Session& session() const;
  // The arrays of the state, at any time: they stay where they are until this goes. In a step of another thread they
  // have some of its numbers.
  const State& state() const { return session_.state(); }
  const Model& model() const { return session_.model(); }
  const NamedScene& scene() const { return scene_; }
  Reports history() const;
  const Observed& observed() const { return observed_; }

  // So many steps, 0 to 10⁹. Throws Error(diverged) where the state left all bounds: it is that before the step. When
  // Python has a signal waiting (Ctrl-C) it ends between two steps with what the signal throws; what was made stays.
  void step(std::int64_t count);
  void reset();

  // "key=value" as --set takes them, all or none. Throws Error(bad_input).
  void set(const std::vector<std::string>& settings);
  void observe(const Observed& observed);

  SavedState save() const;
  // Throws Error(bad_input) where the state is of other bodies or joints.
  void restore(const SavedState& saved);
  void load_state(const std::string& path);  // throws Error(file), Error(bad_input)

  // As `pabd render` draws it.
  Image render(const PictureOptions& options);

 private:
  // While it lives the interpreter's lock is not held, and no other call comes in.
  class Away;

  void watch();

  NamedScene scene_;
  Session session_;
  ReportList history_;
  Observed observed_;
  std::unique_ptr<Painter> painter_;
  bool away_ = false;  // under the interpreter's lock
};

}  // namespace pabd::python
