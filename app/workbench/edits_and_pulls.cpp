// SPDX-License-Identifier: MIT
// Edits and pulls, the same in both simulations: see workbench.h.
#include <fmt/format.h>

#include <cmath>

#include "app/workbench/workbench.h"
#include "sim/base/error.h"
#include "sim/collision/ray_cast.h"

namespace pabd {
namespace {

constexpr double kSwing = 2 * 3.141592653589793 * 2;  // of a pulled body on its spring; rad/s
constexpr double kMostSpeed = 1e4;                    // of a ball; m/s

Vec3 three(const std::vector<double>& v, const char* what) {
  if (v.size() != 3 || !std::isfinite(v[0]) || !std::isfinite(v[1]) || !std::isfinite(v[2])) {
    throw Error(ErrorKind::bad_input, fmt::format("\"{}\": expected three numbers", what));
  }
  return {v[0], v[1], v[2]};
}

// What an edit is called where it can be undone.
struct Words {
  const Model& model;
  std::string operator()(const AddBody& e) const { return e.name.empty() ? "new body" : "new " + e.name; }
  std::string operator()(const RemoveBody& e) const {
    const auto i = static_cast<std::size_t>(e.body);
    return "removal of " + (e.body >= 0 && i < model.name.size() ? model.name[i] : "a body");
  }
  std::string operator()(const AddJoint& e) const { return fmt::format("new {} joint", to_string(e.type)); }
  std::string operator()(const RemoveJoint& e) const {
    const auto k = static_cast<std::size_t>(e.joint);
    const bool named = e.joint >= 0 && k < model.joints.size() && !model.joints[k].name.empty();
    return "removal of " + (named ? model.joints[k].name : "a joint");
  }
};

}  // namespace

void Workbench::carry_out(const command::Edit& c) {
  const ModelEdit edit = edit_from_json(c.edit, "edit");
  edit_here(edit, std::visit(Words{a_->model()}, edit));
}

// In both or in none.
Workbench::Change Workbench::make_edit(const ModelEdit& edit, const std::string& what) {
  std::shared_ptr<GivenUp> given_up;
  if (!a_->at_end() || (b_ && !b_->at_end())) given_up = heads(true, b_.has_value());
  Change change{Change::Kind::edit, Side::a, what, a_->params(), a_->params(), a_->edit(edit), nullptr, edit};
  if (b_) {
    try {
      change.edit_b = b_->edit(edit);
    } catch (const Error&) {
      if (given_up) {
        exchange(*given_up);
      } else {
        a_->undo_edit(*change.edit_a);
      }
      throw;
    }
  }
  change.given_up = std::move(given_up);
  shown_.diverged = false;
  return change;
}

void Workbench::edit_here(const ModelEdit& edit, const std::string& what) {
  keep(make_edit(edit, what));
  redo_.clear();
}

// Back to before it. False when the timeline does not hold it any more.
bool Workbench::undo_edit(const Change& change) {
  const bool played = a_->timeline().back().edit != change.edit_a;
  if (!a_->undo_edit(*change.edit_a)) {
    tell(Severity::warning,
         change.what + ": cannot be undone, the moment of it is no longer in the timeline");
    return false;
  }
  if (b_ && change.edit_b) b_->undo_edit(*change.edit_b);
  shown_.diverged = false;
  tell(Severity::note, played ? fmt::format("undone: {}; back at t = {:.4g} s, where it was made",
                                            change.what, a_->state().time)
                              : "undone: " + change.what);
  return true;
}

void Workbench::carry_out(const command::Pull& c) {
  pabd::Pull pull{static_cast<Index>(c.body), three(c.point, "point"), three(c.target, "target"), c.kappa};
  const Model& model = a_->model();
  if (c.kappa == 0 && c.body >= 0 && c.body < model.size()) {
    // A fixed body has no mass; set_pulls says so.
    pull.kappa = std::max(model.mass[static_cast<std::size_t>(c.body)], 1e-9) * kSwing * kSwing;
  }
  this->pull({pull});
  ++hands_;
}

void Workbench::carry_out(const command::Release&) {
  if (a_->pulls() || (b_ && b_->pulls())) pull({});
}

// In the past a hand starts a branch, which can be undone.
void Workbench::pull(const std::vector<pabd::Pull>& pulls) {
  std::shared_ptr<GivenUp> given_up;
  if (!a_->at_end()) given_up = heads(true, b_.has_value());
  a_->set_pulls(pulls);
  if (b_ && (pulls.empty() || pulls[0].body < b_->model().size())) b_->set_pulls(pulls);
  if (given_up && a_->at_end()) keep_exchange("hand in the past", std::move(given_up));
}

void Workbench::carry_out(const command::Shoot& c) {
  AddBody ball;
  ball.shape = Sphere{c.radius};
  ball.density = c.density;
  ball.position = three(c.from, "from");
  const Vec3 direction = three(c.direction, "direction");
  if (!(direction.stableNorm() > 1e-9))
    throw Error(ErrorKind::bad_input, "shoot: \"direction\": expected a vector that is not zero");
  if (!(std::abs(c.speed) <= kMostSpeed)) {
    throw Error(ErrorKind::bad_input,
                fmt::format("shoot: \"speed\": expected up to {:g} m/s, got {:g}", kMostSpeed, c.speed));
  }
  ball.velocity = c.speed * direction.stableNormalized();
  const auto hit = ray_cast(a_->model(), a_->state(), {ball.position, direction});
  if (hit && hit->normal.dot(direction) > 0) {
    throw Error(ErrorKind::bad_input, fmt::format("a ball cannot start inside {}; look from outside",
                                                  a_->model().name[static_cast<std::size_t>(hit->body)]));
  }
  edit_here(ball, "ball");
}

}  // namespace pabd
