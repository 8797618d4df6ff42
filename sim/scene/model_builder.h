// SPDX-License-Identifier: MIT
// Collects bodies and joints into a Model and a State, and refuses what no simulation can hold: duplicate
// names, masses and places out of bounds, too many bodies. Internal to sim/scene.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

#include "sim/body/body_look.h"
#include "sim/body/model.h"
#include "sim/body/state.h"
#include "sim/scene/builder.h"
#include "sim/scene/reader.h"

namespace pabd {

inline constexpr std::int64_t kMostBodies = 4'000'000;
inline constexpr std::int64_t kMostJoints = 8'000'000;
inline constexpr double kFarthest = 1e6;         // |coordinate| of a position; m
inline constexpr double kDefaultDensity = 1000;  // kg/m³

inline constexpr Range kSizeRange{1e-6, 1e6, "m"};
inline constexpr Range kPositionRange{-kFarthest, kFarthest, "m"};
inline constexpr Range kDensityRange{1e-6, 1e9, "kg/m³"};
inline constexpr Range kMassRange{1e-9, 1e12, "kg"};
inline constexpr Range kVelocityRange{-1e6, 1e6, "m/s"};
inline constexpr Range kSpinRange{-1e7, 1e7, "degrees/s"};

// Mass, or where that is empty the density, of a movable body.
struct MassSpec {
  std::optional<double> mass;        // kg
  double density = kDefaultDensity;  // kg/m³
};

// Reads "mass" or "density"; both together are refused.
MassSpec read_mass(const ObjectReader& in);

struct BodySpec {
  std::string name;
  Shape shape = Box{Vec3::Constant(0.5)};
  MassSpec mass;
  bool fixed = false;
  Vec3 c = Vec3::Zero();      // m
  Mat3 R = Mat3::Identity();  // body to world
  Vec3 v = Vec3::Zero();      // m/s
  Vec3 omega = Vec3::Zero();  // rad/s
  BodyLook look = {};
};

// Bodies by name; the names are those of the model.
using BodyNames = std::unordered_map<std::string_view, Index>;

class ModelBuilder {
 public:
  // `joint_law` holds for joints that say nothing of their own; its κ may be kAutoKappa (builder.h), which finish_joints() resolves.
  explicit ModelBuilder(const BondLaw& law) : joint_law(law) {}

  // Announces `count` more bodies; `place` is blamed when the total is above kMostBodies.
  void reserve(std::int64_t count, const Node& place);
  void add(BodySpec&& body, const Node& place);

  // Call when all bodies are there. Refuses duplicate names; the first `listed` bodies are those of "bodies".
  BodyNames names(const ReadContext& context, std::size_t listed) const;

  // Announces `count` more joints.
  void reserve_joints(std::int64_t count, const Node& place);
  // Without `collide` the two bodies never touch each other.
  void add_joint(Joint&& joint, bool collide);

  // Call once at the end. Resolves κ "auto" of all joints and of joint_law; the first `generated` joints move
  // behind the others.
  void finish_joints(const Vec3& gravity, std::size_t generated);

  Model model;
  State state;
  BondLaw joint_law;
  BodyLooks looks;

 private:
  std::int64_t announced_ = 0, announced_joints_ = 0;
};

}  // namespace pabd
