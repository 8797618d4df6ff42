// SPDX-License-Identifier: MIT
// Collects bodies and joints into a Model and a State, and refuses what no simulation can hold: duplicate
// names, masses and places out of bounds, too many bodies. Internal to sim/scene.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

#include "sim/body/body_look.h"
#include "sim/body/model.h"
#include "sim/body/state.h"
#include "sim/scene/builder.h"
#include "sim/scene/reader.h"

namespace pabd {

inline constexpr double kDefaultDensity = 1000;  // kg/m³

// Mass, or where that is empty the density, of a movable body.
struct MassSpec {
  std::optional<double> mass;        // kg
  double density = kDefaultDensity;  // kg/m³
};

// Of an entry that was read.
MassSpec mass_of(const auto& entry) { return {entry.mass, entry.density.value_or(kDefaultDensity)}; }

// How a body touches others.
struct TouchSpec {
  std::optional<SurfaceFriction> friction;  // of its own
  std::optional<double> restitution;
  std::vector<std::string> groups;  // that it is of
};

// Of an entry that was read.
TouchSpec touch_of(const auto& entry) { return {entry.friction, entry.restitution, entry.groups}; }

struct BodySpec {
  std::string name;
  Shape shape = Box{Vec3::Constant(0.5)};
  MassSpec mass;
  std::optional<Mat3> J;  // second moment, body frame, where it is not that of an even density; kg m²
  bool fixed = false;
  Vec3 c = Vec3::Zero();      // m
  Mat3 R = Mat3::Identity();  // body to world
  Vec3 v = Vec3::Zero();      // m/s
  Vec3 omega = Vec3::Zero();  // rad/s
  BodyLook look = {};
  TouchSpec touch = {};
  std::optional<Vec3> surface_velocity = {};  // body frame; m/s
  std::optional<ExternalForce> external = {};
};

// Where the bodies of an included scene go.
struct Placement {
  std::string prefix;            // of every name
  Vec3 position = Vec3::Zero();  // of its origin; m
  Mat3 R = Mat3::Identity();     // its axes
};

// Refuses a body that would be farther than kFarthest from the origin along an axis.
void require_near(const std::string& name, const Vec3& c, const Node& place);

// Bodies by name; the names are those of the model.
using BodyNames = std::unordered_map<std::string_view, Index>;

// The number of the body that `node` names.
Index body_of(const Node& node, const BodyNames& names, const Model& model);

class ModelBuilder {
 public:
  // `joint_law` holds for joints that say nothing of their own; its κ may be kAutoKappa (builder.h), which finish_joints() resolves.
  explicit ModelBuilder(const BondLaw& law) : joint_law(law) {}

  // Announces `count` more bodies; `place` is blamed when the total is above kMostBodies.
  void reserve(std::int64_t count, const Node& place);
  void add(BodySpec&& body, const Node& place);

  // Gives all bodies from `first` on that surface and those groups. `place` is blamed for too many groups.
  void set_touch(std::size_t first, const TouchSpec& touch, const Node& place);

  // Everything of an included scene but its planes: what holds on to one holds on to the world. `place` is blamed
  // for names that are too long or there already, and for bodies too far away.
  void append(ModelBuilder&& part, const Placement& placement, const Node& place);

  // Call when all bodies are there. Refuses duplicate names; the first `listed` bodies are those of "bodies", and
  // those up to `made` are generated.
  BodyNames names(const ReadContext& context, std::size_t listed, std::size_t made) const;

  // Announces `count` more joints.
  void reserve_joints(std::int64_t count, const Node& place);
  // Without `collide` the two bodies never touch each other.
  void add_joint(Joint&& joint, bool collide);

  // The two bodies never touch each other, whatever joints come and go.
  void keep_apart(Index i, Index j);
  // The bodies of the two groups, which may be one, never touch each other.
  void keep_groups_apart(int g, int h);

  // The first `count` joints move behind the others.
  void move_behind(std::size_t count);

  // Call once at the end. Resolves κ "auto" of all joints and of joint_law.
  void finish(const Vec3& gravity);

  Model model;
  State state;
  BondLaw joint_law;
  BodyLooks looks;
  std::unordered_set<std::string> included_joints;  // their names

 private:
  int group_named(const std::string& name, const Node& place);
  std::vector<Index> append_bodies(ModelBuilder& part, const Placement& placement, const Node& place);
  void append_groups(const CollisionGroups& groups, const std::vector<Index>& to, const Placement& placement,
                     const Node& place);
  void append_joints(ModelBuilder& part, const std::vector<Index>& to, const Placement& placement,
                     const Node& place);

  std::int64_t announced_ = 0, announced_joints_ = 0;
};

}  // namespace pabd
