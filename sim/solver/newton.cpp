// SPDX-License-Identifier: MIT
#include "sim/solver/newton.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/math/extremes.h"
#include "sim/math/levels.h"
#include "sim/solver/friction.h"
#include "sim/solver/joint_actions.h"
#include "sim/solver/linear_bonds.h"
#include "sim/solver/newton_matrix.h"

namespace pabd {
namespace {

constexpr int kPatience = 8, kPatienceDamped = 4;  // iterations in which E may stay above its lowest value
constexpr int kHalvings = 30;

// Damping: what inertia is raised by, times itself. It starts higher where steps went in circles than where the matrix is
// indefinite.
constexpr double kOfCircles = 10, kOfIndefinite = 1, kRaise = 8, kEase = 0.25, kLeast = 0.1, kMost = 1e12;
constexpr int kRaises = 3;  // in an iteration

// By `share` of the largest entry of each block: what is lost to cancellation is that small.
void raise_diagonal(double share, NewtonSystem& system) {
  for (Index p = 0; p < system.matrix.rows(); ++p) {
    Block<6>& block = system.matrix.diagonal(p);
    double largest = 0;
    for (int c = 0; c < 6; ++c) largest = std::max(largest, std::abs(block.column[c][c]));
    for (int c = 0; c < 6; ++c) block.column[c][c] += share * largest;
  }
}

void raise_damping(double least, NewtonSystem& system) {
  system.damping = std::clamp(kRaise * system.damping, least, kMost);
}

// Newton direction from the assembled matrix. Pushed bonds and contacts may have made it indefinite: then damped, since
// pulled ones hold what else would jump; then without their geometric stiffness, and where rounding or a large turn left
// that indefinite too, with a raised diagonal.
bool find_direction(const Problem& p, const Island& island, bool geometric, const Stop& stop,
                    NewtonSystem& system, Iterate& it) {
  bool solvable = system.matrix.factorize(stop);
  const double damping = system.damping;
  for (int k = 0; geometric && !solvable && k < kRaises && !stop.requested(); ++k) {
    raise_damping(kOfIndefinite, system);
    assemble(p, island, geometric, system, it);
    solvable = system.matrix.factorize(stop);
  }
  if (!solvable) system.damping = damping;
  for (double raise = 0; !solvable && raise < 1e4; raise = raise == 0 ? 1e-12 : raise * 1e3) {
    if (stop.requested()) break;
    if (raise == 0 && !geometric && !system.curved) continue;
    system.curved = false;
    assemble(p, island, false, system, it);
    raise_diagonal(raise, system);
    solvable = system.matrix.factorize(stop);
  }
  if (!solvable) return false;
  for (std::size_t k = 0; k < system.motion.g.size(); ++k) system.motion.step[k] = -system.motion.g[k];
  system.matrix.solve(system.motion.step);
  return std::isfinite(largest_move(p, island, system.motion.step));
}

// The forces at the iterate itself would be off by stiffness times the curvature of the way there.
void predict_forces(const Problem& p, const Island& island, const Iterate& it, NewtonSystem& system) {
  const auto step_of = [&](Index slot, const Vec3& r) -> Vec3 {
    const Index row = island.row[slot];
    if (row < 0) return Vec3::Zero();
    return system.motion.step[row].head<3>() + system.motion.step[row].tail<3>().cross(r);
  };
  system.force.assign(island.joints.size() * BondList::kMost, Vec3::Zero());
  each_joint_bond(p, island, it, [&](const LinearBond& bond) {
    system.force[bond.force] =
        bond.gradient + bond.K * (step_of(bond.b, bond.r_b) - step_of(bond.a, bond.r_a));
  });
}

// Friction bounds have moved, and E with them: how low the best iterate is now.
void measure_best(const Problem& p, const Island& island, NewtonSystem& system, Iterate& it) {
  if (!(system.motion.lowest < std::numeric_limits<double>::infinity())) return;
  swap_with_best(p, island, system.motion, it);
  system.motion.lowest = energy_of(p, island, it);
  swap_with_best(p, island, system.motion, it);
}

// The step of all bodies, with friction bounds and holds of motors moved to its end. `other_E`: E is another one since. False
// where there is no step.
bool find_step(const Problem& p, const Island& island, bool geometric, const Stop& stop, NewtonSystem& system,
               Iterate& it, bool& other_E) {
  if (!find_direction(p, island, geometric, stop, system, it)) return false;
  other_E = p.friction && follow_bounds(p, island, system.matrix, system.sliding, system.motion.step, it);
  foresee_actions(p, island, system.motion.step, it);
  return true;
}

void take_full_step(const Problem& p, const Island& island, bool other_E, NewtonSystem& system, Iterate& it) {
  predict_forces(p, island, it, system);
  if (other_E) measure_best(p, island, system, it);
  move(p, island, system.motion, longest_step(system.motion), it);
}

// Short moves are made in full where bounds follow: the levers of friction on round bodies leave out the curvature of the
// step's turn, and E no longer decides whether they are good.
void search_along_step(const Problem& p, const Island& island, bool other_E, NewtonSystem& system,
                       Iterate& it) {
  constexpr double kSmall = 0.01;  // d̂
  double t = longest_step(system.motion);
  if (!system.bounds_stay && largest_move(p, island, system.motion.step) < kSmall)
    return move(p, island, system.motion, t, it);
  if (other_E) system.motion.lowest = energy_of(p, island, it);
  for (int k = 0; k < kHalvings; ++k, t *= 0.5) {
    move(p, island, system.motion, t, it);
    if (p.params->solver.iterations == 1 || is_lower(energy_of(p, island, it), system.motion)) return;
    restore_best(p, island, system.motion, it);
  }
  system.stuck = true;
}

// False where there is no step.
bool iterate_by_moves(const Problem& p, const Island& island, const Stop& stop, NewtonSystem& system,
                      Iterate& it) {
  IslandStep& motion = system.motion;
  const bool keeps = p.params->solver.iterations > 1;
  bool geometric = !system.force.empty() && island.jointed;
  double energy = assemble(p, island, geometric, system, it);
  bool other_E = false;
  if (!island.jointed) {
    if (keeps) keep_best(island, it, energy, motion);
    system.stuck = false;
    if (!find_step(p, island, false, stop, system, it, other_E)) return false;
    search_along_step(p, island, other_E, system, it);
    return true;
  }
  if (is_lower(energy, motion)) {
    if (keeps) keep_best(island, it, energy, motion);
    system.damping *= system.damping > kLeast ? kEase : 0;
  } else if (++motion.rises > (system.damping > 0 ? kPatienceDamped : kPatience)) {
    swap_with_best(p, island, motion, it);
    raise_damping(kOfCircles, system);
    system.force.clear();
    geometric = false;
    energy = assemble(p, island, geometric, system, it);  // anew: friction bounds may have moved since
    keep_best(island, it, energy, motion);
  }
  if (!find_step(p, island, geometric, stop, system, it, other_E)) return false;
  take_full_step(p, island, other_E, system, it);
  return true;
}

// False where the bodies' system has to take over.
bool iterate_by_forces(const Problem& p, const Island& island, const Stop& stop, NewtonSystem& system,
                       Iterate& it) {
  double energy = 0;
  if (!dual_step(p, island, it, stop, system.by_forces, system.motion, energy)) return false;
  if (p.params->solver.iterations > 1) {
    if (is_lower(energy, system.motion)) {
      keep_best(island, it, energy, system.motion);
    } else if (++system.motion.rises > kPatience) {
      return false;
    }
  }
  move(p, island, system.motion, longest_step(system.motion), it);
  return true;
}

// What the dual iterations found, for the bodies' system.
void recall_forces(NewtonSystem& system) {
  const std::vector<Vec3>& found = system.by_forces.force;
  system.force.assign(found.size() * BondList::kMost, Vec3::Zero());
  for (std::size_t k = 0; k < found.size(); ++k) system.force[k * BondList::kMost] = found[k];
}

bool find_body_structure(const Problem& p, const Island& island, const Iterate& it, NewtonSystem& system) {
  system.pairs.clear();
  const auto couple = [&](std::size_t slot_a, std::size_t slot_b) {
    const Index a = island.row[slot_a], b = island.row[slot_b];
    if (a >= 0 && b >= 0 && a != b) system.pairs.emplace_back(std::min(a, b), std::max(a, b));
  };
  for (const Index k : island.joints) couple(it.slot(p.joint_ends[k].first), it.slot(p.joint_ends[k].second));
  for (const Index k : island.manifolds) couple(it.slot(it.manifold[k].a), it.slot(it.manifold[k].b));
  if (!std::is_sorted(system.pairs.begin(), system.pairs.end()))
    std::sort(system.pairs.begin(), system.pairs.end());
  system.pairs.erase(std::unique(system.pairs.begin(), system.pairs.end()), system.pairs.end());
  return system.matrix.analyze(static_cast<Index>(island.bodies.size()), system.pairs, system.most_products);
}

}  // namespace

bool find_structure(const Problem& p, const Island& island, const Iterate& it, double most_products,
                    NewtonSystem& system) {
  system.most_products = most_products;
  system.dual = island.jointed && find_dual_structure(p, island, it, most_products, system.by_forces);
  return system.dual || find_body_structure(p, island, it, system);
}

void start_newton(const Problem& p, const Island& island, const Iterate& it, NewtonSystem& system) {
  start(p, island, it, system.motion);
  system.force.clear();
  system.stuck = false;
  system.damping = 0;
  system.iterations = 0;
  system.bounds_stay = false;
  system.nearest_move = std::numeric_limits<double>::infinity();
  system.nearest_at = 0;
  if (system.dual) start_dual(p, island, system.by_forces);
}

namespace {

// What is solved in a few iterations needs no more. Hits press so hard that turns of bodies under that force count as much as
// their inertia. And bounds that follow may go in circles: some contacts begin to slide, which lets others hold. So they stay
// in every other turn, and go part of the way to μ f_n only where the bodies nearly rest under them. A turn ends where moves
// have not come to half of the shortest for too long.
void take_turns(const Problem& p, const Island& island, NewtonSystem& system, Iterate& it) {
  constexpr int kPlain = 6, kTurn = 20;
  constexpr double kNearly = 0.1;  // d̂
  const int k = system.iterations++;
  system.curved = k >= kPlain;
  if (!p.friction || k == 0) return;
  const double moved = largest_moved(island, it);
  const bool turn_ends = k - system.nearest_at >= kTurn;
  if (turn_ends) system.bounds_stay = !system.bounds_stay;
  if (turn_ends || moved < 0.5 * system.nearest_move) {
    system.nearest_move = moved;
    system.nearest_at = k;
  }
  if (!system.bounds_stay || !(moved < kNearly)) return;
  approach_friction_limits(p, island, it);
  forget_best(system);
}

}  // namespace

bool newton_iteration(const Problem& p, const Island& island, const Workers& workers, NewtonSystem& system,
                      Iterate& it) {
  take_turns(p, island, system, it);
  if (system.dual && !iterate_by_forces(p, island, workers.stop, system, it)) {
    if (workers.stop.requested()) return true;
    if (!find_body_structure(p, island, it, system)) return false;
    system.dual = false;
    recall_forces(system);
  }
  if (!system.dual && !iterate_by_moves(p, island, workers.stop, system, it)) return workers.stop.requested();
  store_moves(p, island, system.motion, it);
  for (const Index i : island.bodies) it.moved[i] *= 1 + system.damping;  // the way they would have made
  return true;
}

void store_joint_forces(const Problem& p, const Island& island, const NewtonSystem& system, Iterate& it) {
  const std::size_t bonds = system.dual ? 1 : BondList::kMost;
  const std::vector<Vec3>& force = system.dual ? system.by_forces.force : system.force;
  for (std::size_t k = 0; k < island.joints.size(); ++k) {
    const auto joint = static_cast<std::size_t>(island.joints[k]);
    if (joint >= p.joints.model.size() || force.empty()) break;  // pulls come last
    Vec3 sum = Vec3::Zero();
    for (std::size_t b = 0; b < bonds; ++b) sum -= force[k * bonds + b];
    it.joint_force[joint] = sum;
  }
}

void forget_best(NewtonSystem& system) { system.motion.lowest = std::numeric_limits<double>::infinity(); }

void finish_newton(const Problem& p, const Island& island, NewtonSystem& system, Iterate& it) {
  constexpr double kCalm = 0.03;  // d̂: with its friction, the last iterate is the better one
  if (p.params->solver.iterations == 1 || largest_move(p, island, system.motion.step) < kCalm) return;
  if (!is_lower(energy_of(p, island, it), system.motion)) swap_with_best(p, island, system.motion, it);
}

}  // namespace pabd
