// SPDX-License-Identifier: MIT
// Edits of a simulation that is under way: bodies and joints that come and go. An edit is plain data, so that
// it can be sent, kept and written to a file.
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "sim/body/model.h"
#include "sim/body/state.h"

namespace pabd {

// A body as scene files have it, of a shape that is given by its sizes: no plane and no mesh. It gets the
// highest number.
struct AddBody {
  std::string name;  // empty: one is made up
  Shape shape = Box{Vec3::Constant(0.5)};
  std::optional<double> mass;           // kg; else by density
  double density = 1000;                // kg/m³
  Vec3 position = Vec3::Zero();         // of the centre of mass, world; m
  Mat3 orientation = Mat3::Identity();  // body to world
  Vec3 velocity = Vec3::Zero();         // m/s
  Vec3 omega = Vec3::Zero();            // rad/s
  bool fixed = false;
  std::optional<SurfaceFriction> friction = {};  // of its own
  std::optional<double> restitution = {};
};

// Its joints go with it; higher numbers move down by one.
struct RemoveBody {
  Index body = 0;
};

// A joint at the present pose: angles and offsets count from here. The two bodies no longer collide. It gets
// the highest number.
struct AddJoint {
  std::string name;  // empty: one is made up
  JointType type = JointType::spherical;
  Index i = kWorld, j = kWorld;
  Vec3 anchor = Vec3::Zero();       // world; m. Of a distance joint the point on i
  Vec3 axis = Vec3::UnitZ();        // world, any length but 0; of a joint with an axis
  std::optional<Vec3> second_axis;  // world; of a joint with two. Else some direction square to `axis`
  Vec3 anchor_j = Vec3::Zero();     // world; m. Distance joint only: the point on j
  std::optional<double> length;     // distance joint only; m. Else as far as the points are apart
  std::optional<BondLaw> law;       // else that of the scene's joints
};

// The axes of a joint that stands on a face with that normal: an axis along it, two axes across it.
void set_axes(const Vec3& normal, AddJoint& joint);

// The bodies collide again, unless another joint or the scene itself keeps them apart. Higher numbers move down by one.
struct RemoveJoint {
  Index joint = 0;
};

// `"box", "sphere" or "capsule"`: the shapes that a new body may have.
std::string sized_shapes();

using ModelEdit = std::variant<AddBody, RemoveBody, AddJoint, RemoveJoint>;

// Carries `edit` out on a model and a state of it. `joint_law` is for joints without a law of their own. Precondition:
// its numbers are in range, as edit_from_json leaves them. Throws Error(bad_input), in one line, when it cannot be done:
// then nothing has changed. Bodies that an edit does not touch keep every bit of their state.
void apply_edit(const ModelEdit& edit, const BondLaw& joint_law, Model& model, State& state);

// {"do": "add_body", "shape": {"type": "sphere", "radius": 0.5}, "position": [0, 3, 0]}: keys and units of a
// scene file, bodies and joints by number, null for the world.
//   add_body     a body of a scene file
//   remove_body  body
//   add_joint    name, type, bodies, anchor (points for a distance), axis, second_axis, length; potential, kappa, N, d_hat
//   remove_joint joint
// Throws Error(bad_input) for an orientation that is no rotation.
std::string to_json(const ModelEdit& edit);

// Throws Error(bad_input) naming `source` and the place: unknown keys, wrong types, numbers out of range.
ModelEdit edit_from_json(const std::string& text, const std::string& source);

}  // namespace pabd
