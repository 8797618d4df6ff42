// SPDX-License-Identifier: MIT
// The constant part of a simulation: what the bodies are. Built and validated once, then never changed.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/body/collision_groups.h"
#include "sim/body/external_force.h"
#include "sim/body/joint.h"
#include "sim/body/shape.h"
#include "sim/body/surface_friction.h"

namespace pabd {

// Structure of arrays, one entry a body. Bodies keep the order of the scene file; generated ones follow.
struct Model {
  std::vector<std::string> name;
  std::vector<Shape> shape;
  std::vector<double> mass;         // kg; 0 for a fixed body
  std::vector<Mat3> J;              // kg m², body frame; zero for a fixed body
  std::vector<std::uint8_t> fixed;  // 1: never moves
  std::vector<Joint> joints;
  std::vector<std::pair<Index, Index>> no_collide;       // pairs a < b that never touch, sorted
  std::vector<std::pair<Index, Index>> stated_apart;     // those of them that stay when joints go, sorted
  CollisionGroups groups;                                // more that never touch
  std::vector<std::optional<SurfaceFriction>> friction;  // of bodies that have their own. Empty: none has
  std::vector<std::optional<double>> restitution;        // the same; 0 … 1
  // m/s, body frame: of surfaces that move of themselves, as belts do. Empty: none does.
  std::vector<std::optional<Vec3>> surface_velocity;
  std::vector<std::optional<ExternalForce>> external;  // of movable bodies that one acts on. Empty: on none

  Index size() const { return static_cast<Index>(shape.size()); }
};

// Calls visit(list, …) for each list of one entry a body, with those of all given models together. Lists that no body needs
// are empty.
template <class Visit, class... Models>
void each_body_list(const Visit& visit, Models&... model) {
  visit(model.name...);
  visit(model.shape...);
  visit(model.mass...);
  visit(model.J...);
  visit(model.fixed...);
  visit(model.friction...);
  visit(model.restitution...);
  visit(model.surface_velocity...);
  visit(model.external...);
  visit(model.groups.of_body...);
  visit(model.groups.avoids...);
}

// Of the movable bodies; kg. All are 0 when there is none.
struct MovableMass {
  double total = 0, heaviest = 0, lightest = 0;
};
MovableMass movable_mass(const Model& model);

// The most that forces from outside press with together, each at its greatest; N.
double most_external_force(const Model& model);

}  // namespace pabd
