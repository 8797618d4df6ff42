// SPDX-License-Identifier: MIT
// Coulomb friction of a body's surface, and how those of two bodies that touch become one.
#pragma once

#include <cstdint>

namespace pabd {

// Largest friction force over normal force while two surfaces stick and while they slide; 0 ≤ dynamic ≤ static. Largest
// torque over normal force about the normal of a contact, and about what lies in its plane; m.
struct SurfaceFriction {
  double mu_static = 0.5, mu_dynamic = 0.5;
  double torsional = 0, rolling = 0;
  bool operator==(const SurfaceFriction&) const = default;
};

// Each gives μ for two of μ but the product. The field has no common one: geometric_mean is that of Box2D and Jolt,
// average of PhysX, max of MuJoCo, product of Bullet.
enum class FrictionRule : std::uint8_t { geometric_mean, average, min, max, product };

const char* to_string(FrictionRule rule);  // "geometric_mean", …: the words of scene files

// Symmetric. Of restitution, too.
double combined(FrictionRule rule, double a, double b);
// Symmetric; dynamic friction is not above static, as that is so of both.
SurfaceFriction combined(FrictionRule rule, const SurfaceFriction& a, const SurfaceFriction& b);

}  // namespace pabd
