// SPDX-License-Identifier: MIT
// Mass and second moment of the solid shapes, exact.
//
//   m      mass                                   kg      scalar
//   J      second moment  J = ∫ ρ r rᵀ dV         kg m²   3×3, symmetric; diagonal for all but hulls
//
// J is not the inertia tensor I; the two are related by J = ½ tr(I) 1 − I. The affine mass matrix is
// M = ∫ ρ s sᵀ dV = diag(m, J) with s = [1; r].
#pragma once

#include "sim/body/shape.h"

namespace pabd {

// Of a solid body, about its centre of mass.
struct MassProperties {
  double mass;  // kg
  Mat3 J;       // second moment, body frame; kg m²
};

// Volume in m³; 0 for a plane.
double volume(const Shape& shape);

// Mass properties for a uniform density in kg/m³. Precondition: the shape is solid (not a plane), density >
// 0.
MassProperties mass_properties(const Shape& shape, double density);

// The inertia tensor I = tr(J) 1 − J that belongs to J, and back: J = ½ tr(I) 1 − I.
inline Mat3 inertia_tensor(const Mat3& J) { return J.trace() * Mat3::Identity() - J; }
inline Mat3 second_moment_of(const Mat3& I) { return 0.5 * I.trace() * Mat3::Identity() - I; }

}  // namespace pabd
