// SPDX-License-Identifier: MIT
// Scenes as a user would write them, with the program's default settings, and what a run of one shows.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sim/scene/builder.h"
#include "sim/solver/time_step.h"

namespace pabd::world {

inline constexpr double kG = 9.81;  // m/s²

// A scene that is being written. Only the step, the friction and the distance of contacts are chosen: the solver's
// settings are never touched.
struct Setting {
  explicit Setting(double h = 1.0 / 60, double friction = 0.5, double d_hat = 0.01);

  // Gives back the name of what it added: "b0", "b1" and so on. A mass of 0 is a fixed body.
  std::string add(const Shape& shape, double mass, const Vec3& at,
                  const spec::Orientation& turn = {1, 0, 0, 0});
  std::string add(spec::Body body);
  std::string add_hull(const std::vector<Vec3>& corners, double mass,
                       const Vec3& origin);  // corners from `origin`
  std::string ground();                      // y = 0, mass 0
  std::string slope(double degrees);         // through the origin, downhill +x
  void join(JointType type, const std::string& i, const std::string& j, const Vec3& anchor,
            const Vec3& axis = Vec3::UnitZ());  // "": the world

  SceneBuilder builder;
  int bodies = 0;
};

// Along a slope of so many degrees and square to it.
Vec3 downhill(double degrees);
Vec3 uphill_normal(double degrees);

// Degrees about the z axis, so that +x turns towards +y.
spec::Orientation about_z(double degrees);
// The axis of a cylinder, cone or capsule along x or z in place of y.
spec::Orientation along_x();
spec::Orientation along_z();

// A run of a scene and the worst that was seen of it.
struct Run {
  explicit Run(Scene of);
  explicit Run(Setting& setting) : Run(setting.builder.build()) {}

  // Requires of every step that it succeeds; `each` is called after it.
  void go(double seconds, const std::function<void()>& each = {});

  // What was seen so far is forgotten: energy counts from here, for a body that is sent off after it has come to rest.
  void send(const std::string& name, const Vec3& v, const Vec3& omega = Vec3::Zero());

  Index operator[](const std::string& name) const;  // a body's number
  const Vec3& c(const std::string& name) const { return state.c[static_cast<std::size_t>((*this)[name])]; }
  const Vec3& v(const std::string& name) const { return state.v[static_cast<std::size_t>((*this)[name])]; }
  const Vec3& omega(const std::string& name) const {
    return state.omega[static_cast<std::size_t>((*this)[name])];
  }
  const Mat3& R(const std::string& name) const { return state.R[static_cast<std::size_t>((*this)[name])]; }
  Vec3 start(const std::string& name) const {
    return scene.initial.c[static_cast<std::size_t>((*this)[name])];
  }
  Vec3 way(const std::string& name) const { return c(name) - start(name); }

  double kinetic() const;  // J
  double weight() const;   // of all movable bodies; N
  Vec3 momentum() const;   // of all movable bodies; kg m/s
  // Upward force of the fixed bodies on all others in the last step; N.
  double carried() const;

  Scene scene;
  State state;
  StepReport report;         // of the last step
  double begin = 0;          // energy at the start; J
  double work = 0;           // of drives so far; J
  double rise = 0;           // most that the energy was above that at the start and the work of drives; J
  double joint_error = 0;    // m
  double overlap = 0;        // m
  double fastest = 0;        // largest speed of a body; m/s
  int held = 0, halved = 0;  // steps in which bodies were slowed down, or their step was halved
  int steps = 0, iterations = 0, at_limit = 0;  // all, and those that did not converge
  int unsolved = 0;                             // of the latter: a body still moved by 0.001 d̂ and more

 private:
  StepWorkspace workspace_;
};

}  // namespace pabd::world
