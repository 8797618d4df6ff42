// SPDX-License-Identifier: MIT
// A scene that a case builds and runs with the default settings.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "sim/scene/builder.h"
#include "sim/solver/time_step.h"

namespace pabd::validate {

inline constexpr double kG = 9.81;  // m/s²

// Thrown by Bench::run() when it is asked to stop.
struct Stopped {};

class Bench {
 public:
  // `stop` is asked before every step.
  Bench(double h, std::function<bool()> stop) : h_(h), stop_(std::move(stop)) { clear(); }

  double h() const { return h_; }
  SceneBuilder& builder() { return *builder_; }
  // Another empty scene, for a case that looks for a limit.
  void clear();

  // Bodies by name; a mass of 0 is a fixed one.
  void add(const std::string& name, const Shape& shape, double mass, const Vec3& at,
           const spec::Orientation& turn = {1, 0, 0, 0});
  void join(JointType type, const std::string& i, const std::string& j, const Vec3& anchor,
            const Vec3& axis = Vec3::UnitZ());  // "": the world
  void ground(double degrees = 0);              // through the origin, downhill +x
  void friction(double mu);

  // Builds the scene; what follows may change velocities.
  void build();
  // Builds it first where that has not been done. `each` is called after every step. Throws Stopped, and
  // Error(diverged) where a step fails.
  void run(double seconds, const std::function<void()>& each = {});

  // Of the last step, or the start.
  double time() const { return state_.time; }
  std::size_t body(const std::string& name) const;
  Vec3& v(const std::string& name) { return state_.v[body(name)]; }
  Vec3& omega(const std::string& name) { return state_.omega[body(name)]; }
  const Vec3& c(const std::string& name) const { return state_.c[body(name)]; }
  const Mat3& R(const std::string& name) const { return state_.R[body(name)]; }
  double energy() const;  // T + U; J
  const Scene& scene() const { return *scene_; }
  const StepReport& report() const { return report_; }

 private:
  double h_;
  std::function<bool()> stop_;
  std::unique_ptr<SceneBuilder> builder_;
  std::unique_ptr<Scene> scene_;
  State state_;
  StepWorkspace workspace_;
  StepReport report_;
};

}  // namespace pabd::validate
