// SPDX-License-Identifier: MIT
// Everything that may change between any two steps. parameter_table.cpp has a row for each: meaning, unit, range.
#pragma once

#include <optional>
#include <string>

#include "sim/body/surface_friction.h"
#include "sim/math/types.h"
#include "sim/potential/barrier.h"

namespace pabd {

enum class SolverMethod : std::uint8_t { sissm, descent, newton, automatic };

// How a body's affine model becomes a rigid pose. automatic: weighted for sissm, tangent for descent.
//   polar     nearest rotation to the affine matrix, as the supplement prints it; sissm only (descent reads
//             it as automatic). Nothing bounds it: it runs away where bonds are stiff
//   weighted  exact minimiser of the body's isotropic quadratic model over SE(3) (Deviation D1)
//   tangent   Newton step in the tangent space with separate normal and tangential weights (Deviation D5);
//             descent only
enum class Projection : std::uint8_t { automatic, polar, weighted, tangent };

// Who makes the steps (step_engine.h), where a program can choose; step() of time_step.h ignores it. automatic: a GPU for scenes
// that it takes and that are large enough for it, else the processor.
enum class SolverDevice : std::uint8_t { cpu, gpu, automatic };

// euler: implicit Euler, the paper's. bdf2: of second order where motion is smooth (second_order.h).
enum class Integrator : std::uint8_t { euler, bdf2 };

struct SolverParams {
  SolverMethod method = SolverMethod::automatic;
  int iterations = 20;      // cap per step
  double tolerance = 1e-6;  // relative step at which the solve stops early; 0: never
  int halvings = 6;  // how often a step that ends unsolved is made again in halves (halving.h); 0: never
  Integrator integrator = Integrator::bdf2;
  double relaxation = 0.5;  // of the Jacobi step of sissm
  Projection projection = Projection::automatic;
  SolverDevice device = SolverDevice::cpu;
  bool operator==(const SolverParams&) const = default;
};

struct ContactParams {
  BarrierKind barrier = BarrierKind::polynomial;
  int N = 3;                    // highest order of the polynomial
  double d_hat = 0.01;          // contact thickness d̂; m
  std::optional<double> kappa;  // stiffness κ; J. Empty: "auto", see resolve_kappa
  double onset = 0.2;           // onset width ε
  double damping = 0;           // of normal motion: Ψ' is that of d + τ ḋ, τ in s
  double recovery_speed = 3;    // at which overlap deeper than 2 d̂ comes apart; m/s. 0: no limit
  double mu_static = 0.5;       // friction
  double mu_dynamic = 0.5;      // friction, not above mu_static
  double torsional = 0;         // largest torque over normal force: about the normal; m
  double rolling = 0;           // about what lies in the plane of the contact; m
  FrictionRule friction_rule =
      FrictionRule::geometric_mean;  // where a body has friction or restitution of its own
  double restitution = 0;            // speed after a hit over that before it
  bool operator==(const ContactParams&) const = default;
};

struct Params {
  Vec3 gravity{0, -9.81, 0};  // m/s²
  double h = 1.0 / 60;        // time step; s
  SolverParams solver;
  ContactParams contact;
  bool operator==(const Params&) const = default;
};

// Does `sissm` cap stiffness (Deviation D17)?
inline bool caps_stiffness(const SolverParams& solver) {
  return solver.method == SolverMethod::sissm && solver.projection != Projection::polar;
}

// Empty when every parameter is in range; otherwise one line: scene key, value, what was expected. The key is
// the scene file's JSON pointer ("/contact/d_hat") so that callers can name the place.
struct ParamError {
  std::string pointer;
  std::string message;
};
std::optional<ParamError> check_params(const Params& params);

const char* to_string(SolverMethod method);  // "sissm", "descent", "newton", "auto"
const char* to_string(Projection projection);
const char* to_string(Integrator integrator);
const char* to_string(SolverDevice device);  // "cpu", "gpu", "auto"

}  // namespace pabd
