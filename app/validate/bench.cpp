// SPDX-License-Identifier: MIT
#include "app/validate/bench.h"

#include <fmt/format.h>

#include <cmath>

#include "sim/base/error.h"
#include "sim/solver/step_summary.h"

namespace pabd::validate {

void Bench::clear() {
  builder_ = std::make_unique<SceneBuilder>("validate");
  builder_->params.h = h_;
  scene_.reset();
}

void Bench::add(const std::string& name, const Shape& shape, double mass, const Vec3& at,
                const spec::Orientation& turn) {
  spec::Body body{.name = name, .shape = shape, .fixed = mass == 0, .position = at, .orientation = turn};
  if (mass > 0) body.mass = mass;
  builder_->add(body);
}

void Bench::join(JointType type, const std::string& i, const std::string& j, const Vec3& anchor,
                 const Vec3& axis) {
  spec::Joint joint{.type = type, .i = i, .j = j, .anchor = anchor};
  if (type != JointType::spherical && type != JointType::fixed) joint.axis = axis;
  builder_->add(joint);
}

void Bench::ground(double degrees) {
  const double angle = degrees * kDegree;
  builder_->add(spec::Body{.name = "ground", .shape = Plane{Vec3(std::sin(angle), std::cos(angle), 0), 0}});
}

void Bench::friction(double mu) {
  builder_->params.contact.mu_static = builder_->params.contact.mu_dynamic = mu;
}

void Bench::build() {
  scene_ = std::make_unique<Scene>(builder_->build());
  state_ = scene_->initial;
  workspace_ = StepWorkspace();
}

void Bench::run(double seconds, const std::function<void()>& each) {
  if (!scene_) build();
  StepOptions options;
  options.threads = 1;
  const auto steps = std::llround(seconds / h_);
  for (long long k = 0; k < steps; ++k) {
    if (stop_ && stop_()) throw Stopped();
    step(scene_->model, scene_->params, options, state_, workspace_, report_);
    if (report_.status == StepStatus::non_finite)
      throw Error(ErrorKind::diverged, fmt::format("step {} failed", report_.step));
    if (each) each();
  }
}

std::size_t Bench::body(const std::string& name) const {
  const auto& names = scene_->model.name;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i] == name) return i;
  throw Error(ErrorKind::defect, "no body is called " + name);
}

double Bench::energy() const {
  return kinetic_energy(scene_->model, state_) + potential_energy(scene_->model, scene_->params, state_);
}

}  // namespace pabd::validate
