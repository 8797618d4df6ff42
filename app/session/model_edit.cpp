// SPDX-License-Identifier: MIT
// See model_edit.h.
#include "app/session/model_edit.h"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_set>

#include "sim/base/error.h"
#include "sim/body/mass_properties.h"
#include "sim/body/shape_kind.h"
#include "sim/joint/attach.h"
#include "sim/joint/joint_traits.h"
#include "sim/joint/sliding_end.h"
#include "sim/scene/model_builder.h"
#include "sim/scene/text.h"

namespace pabd {
namespace {

[[noreturn]] void refuse(const std::string& message) { throw Error(ErrorKind::bad_input, message); }

void require(bool holds, const char* what, const std::string& expected) {
  if (!holds) refuse(fmt::format("{}: expected {}", what, expected));
}

// `name`, or where it is empty the first of "stem 0", "stem 1", … from `count` on that is free.
template <class List, class NameOf>
std::string free_name(const std::string& name, const char* stem, const List& list, const NameOf& name_of) {
  std::unordered_set<std::string_view> used;
  for (const auto& item : list) used.insert(name_of(item));
  if (!name.empty()) {
    if (used.contains(name))
      refuse(fmt::format("name: there is already a {}; choose another", in_quotes(name)));
    return name;
  }
  for (std::size_t k = list.size();; ++k) {
    std::string made_up = fmt::format("{} {}", stem, k);
    if (!used.contains(made_up)) return made_up;
  }
}

MassProperties mass_of(const AddBody& body) {
  if (body.fixed) return {0, Mat3::Zero()};
  const double density = body.mass ? *body.mass / volume(body.shape) : body.density;
  MassProperties p = mass_properties(body.shape, density);
  if (body.mass) p.mass = *body.mass;
  require(kMassRange.contains(p.mass), "mass",
          fmt::format("{}, got {}; change the size or the density", kMassRange.text(), p.mass));
  return p;
}

void carry_out(const AddBody& body, const BondLaw&, Model& model, State& state) {
  require(model.size() < kMostBodies, "bodies", fmt::format("at most {}", kMostBodies));
  const MassProperties p = mass_of(body);
  std::string name =
      free_name(body.name, "body", model.name, [](const std::string& n) { return std::string_view(n); });

  model.name.push_back(std::move(name));
  model.shape.push_back(body.shape);
  model.mass.push_back(p.mass);
  model.J.push_back(p.J);
  model.fixed.push_back(body.fixed ? 1 : 0);
  const auto give = [&](const auto& own, auto& of_bodies) {
    if (!own && of_bodies.empty()) return;
    of_bodies.resize(model.name.size());
    of_bodies.back() = own;
  };
  give(body.friction, model.friction);
  give(body.restitution, model.restitution);
  give(std::optional<Vec3>(), model.surface_velocity);
  give(std::optional<ExternalForce>(), model.external);
  for (auto* bits : {&model.groups.of_body, &model.groups.avoids})
    if (!bits->empty()) bits->push_back(0);
  state.c.push_back(body.position);
  state.R.push_back(body.orientation);
  state.v.push_back(body.velocity);
  state.omega.push_back(body.omega);
}

template <class T>
void erase_at(std::vector<T>& list, Index i) {
  list.erase(list.begin() + i);
}

// A joint, and the force it had.
void erase_joint(Index k, Model& model, State& state) {
  // What followed it moves freely from now on.
  Index coupling = 0, left = 0;
  for (std::size_t n = 0; n < model.joints.size(); ++n) {
    auto& follows = model.joints[n].follows;
    if (!follows) continue;
    const bool goes = static_cast<Index>(n) == k || follows->leader == k;
    if (!state.coupling.empty() && !goes) state.coupling[left] = state.coupling[coupling];
    left += goes ? 0 : 1;
    ++coupling;
    if (goes)
      follows.reset();
    else if (follows->leader > k)
      --follows->leader;
  }
  if (!state.coupling.empty()) state.coupling.resize(left);
  erase_at(model.joints, k);
  if (!state.joint_force.empty()) erase_at(state.joint_force, k);
}

// Body numbers in the order they had, without the body that is gone: what was sorted stays sorted.
struct Renumber {
  Index gone;
  Index operator()(Index i) const { return i > gone ? i - 1 : i; }
};

void carry_out(const RemoveBody& edit, const BondLaw&, Model& model, State& state) {
  const Index gone = edit.body;
  require(gone >= 0 && gone < model.size(), "body",
          fmt::format("a number from 0 to {}, got {}", model.size() - 1, gone));
  if (model.size() == 1) refuse("body: it is the only one; a scene without bodies cannot run");
  const Renumber moved{gone};

  for (auto k = static_cast<Index>(model.joints.size()) - 1; k >= 0; --k) {
    const Joint& joint = model.joints[static_cast<std::size_t>(k)];
    if (joint.i == gone || joint.j == gone) erase_joint(k, model, state);
  }
  for (Joint& joint : model.joints) {
    joint.i = moved(joint.i);
    joint.j = moved(joint.j);
  }
  for (auto* pairs : {&model.no_collide, &model.stated_apart}) {
    std::erase_if(*pairs, [&](const auto& pair) { return pair.first == gone || pair.second == gone; });
    for (auto& [a, b] : *pairs) {
      a = moved(a);
      b = moved(b);
    }
  }
  std::erase_if(state.contacts, [&](const ContactMemory& contact) {
    const auto [a, b] = bodies_of_pair(contact.pair);
    return a == gone || b == gone;
  });
  for (ContactMemory& contact : state.contacts) {
    const auto [a, b] = bodies_of_pair(contact.pair);
    contact.pair = pair_key(moved(a), moved(b));
  }
  const auto erase = [&](auto& list) {
    if (!list.empty()) erase_at(list, gone);
  };
  each_body_list(erase, model);
  each_body_array(erase, state);
}

void check_ends(const AddJoint& edit, const Model& model) {
  bool movable = false;
  for (const Index end : {edit.i, edit.j}) {
    require(end >= kWorld && end < model.size(), "bodies",
            fmt::format("numbers from 0 to {}, or the world, got {}", model.size() - 1, end));
    movable = movable || (end != kWorld && !model.fixed[static_cast<std::size_t>(end)]);
  }
  require(edit.i != edit.j, "bodies", "two different ones");
  require(movable, "bodies", "at least one that can move");
}

void carry_out(const AddJoint& edit, const BondLaw& joint_law, Model& model, State& state) {
  check_ends(edit, model);
  require(static_cast<std::int64_t>(model.joints.size()) < kMostJoints, "joints",
          fmt::format("at most {}", kMostJoints));
  Joint joint;
  joint.type = edit.type;
  joint.i = edit.i;
  joint.j = edit.j;
  joint.law = edit.law.value_or(joint_law);
  const JointTraits& traits = traits_of(edit.type);
  joint.twist = traits.twist;
  const Vec3 axis = edit.axis.stableNormalized();
  if (traits.axes > 1 && edit.second_axis) {
    require(axis.cross(edit.second_axis->stableNormalized()).norm() >= 1e-6, "second_axis",
            "a direction across the axis");
  }
  const Mat3 F = joint_frame(edit.type, axis, edit.second_axis);
  if (traits.points) {
    joint.length = edit.length.value_or((edit.anchor_j - edit.anchor).norm());
    require(joint.length <= 1e6, "length", fmt::format("0 … 1e6 m, got {}", joint.length));
    joint.on_i = frame_on(state, joint.i, edit.anchor, F);
    joint.on_j = frame_on(state, joint.j, edit.anchor_j, F);
  } else {
    attach(state, edit.anchor, F, joint);
    joint.arm = default_arm(model, joint.i, joint.j);
    joint.usual_arm = true;
  }
  joint.name =
      free_name(edit.name, "joint", model.joints, [](const Joint& k) { return std::string_view(k.name); });

  model.joints.push_back(std::move(joint));
  settle_sliding_ends(model, model.joints.size() - 1);
  if (!state.joint_force.empty()) state.joint_force.emplace_back(Vec3::Zero());
  if (edit.i == kWorld || edit.j == kWorld) return;
  const std::pair<Index, Index> pair = std::minmax(edit.i, edit.j);
  const auto place = std::lower_bound(model.no_collide.begin(), model.no_collide.end(), pair);
  if (place == model.no_collide.end() || *place != pair) model.no_collide.insert(place, pair);
}

void carry_out(const RemoveJoint& edit, const BondLaw&, Model& model, State& state) {
  const auto count = static_cast<Index>(model.joints.size());
  if (count == 0) refuse("joint: there is none");
  require(edit.joint >= 0 && edit.joint < count, "joint",
          fmt::format("a number from 0 to {}, got {}", count - 1, edit.joint));
  const auto ends = [](const Joint& joint) -> std::pair<Index, Index> {
    return std::minmax(joint.i, joint.j);
  };
  const auto pair = ends(model.joints[static_cast<std::size_t>(edit.joint)]);
  erase_joint(edit.joint, model, state);
  const bool apart = std::binary_search(model.stated_apart.begin(), model.stated_apart.end(), pair) ||
                     std::any_of(model.joints.begin(), model.joints.end(),
                                 [&](const Joint& joint) { return !joint.collide && ends(joint) == pair; });
  if (!apart) std::erase(model.no_collide, pair);
}

}  // namespace

std::string sized_shapes() {
  std::vector<std::string_view> words;
  for (const ShapeKind* kind : shape_kinds())
    if (kind->make) words.push_back(kind->name);
  return one_of(words);
}

void set_axes(const Vec3& normal, AddJoint& joint) {
  const Mat3 F = frame_about(normal);
  const bool two = traits_of(joint.type).axes > 1;
  joint.axis = two ? Vec3(F.col(1)) : normal;
  if (two) joint.second_axis = F.col(2);
}

void apply_edit(const ModelEdit& edit, const BondLaw& joint_law, Model& model, State& state) {
  state.change.clear();  // what changes is not smooth
  std::visit([&](const auto& e) { carry_out(e, joint_law, model, state); }, edit);
}

}  // namespace pabd
