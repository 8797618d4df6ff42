#include "sim/solver/contact_setup.h"

#include <algorithm>
#include <tuple>

#include "sim/solver/parallel.h"
#include "sim/solver/solve.h"

namespace pabd {
namespace {

// Distance a body's surface may travel in the step.
double travel(const Model& model, const State& state, const StepWorkspace::Impl& w, double h, Index i) {
  if (model.fixed[i]) return 0;
  return (w.c_star[i] - state.c[i]).norm() + h * w.omega[i].norm() * bounding_radius(model.shape[i]);
}

std::uint64_t pair_key(Index a, Index b) {
  const auto [lo, hi] = std::minmax(a, b);
  return static_cast<std::uint64_t>(lo) << 32 | static_cast<std::uint32_t>(hi);
}

// The top bit tells which body owns the normal: an anchor is lost when the owner changes, its frame being
// another.
std::uint32_t owned_feature(Index a, Index b, std::uint32_t feature) {
  return (feature & 0x7fffffffu) | (a > b ? 0x80000000u : 0u);
}

void match_anchors(const std::vector<FrictionAnchor>& anchors, const ContactLaw& law,
                   std::vector<ContactBond>& bonds) {
  auto next = anchors.begin();
  for (ContactBond& bond : bonds) {
    const auto key = std::make_tuple(pair_key(bond.a, bond.b), owned_feature(bond.a, bond.b, bond.feature));
    while (next != anchors.end() && std::make_tuple(next->pair, next->feature) < key) ++next;
    if (next == anchors.end()) return;
    if (std::make_tuple(next->pair, next->feature) != key) continue;
    bond.stretch = next->stretch - bond.n * bond.n.dot(next->stretch);
    bond.mu = next->sliding ? law.mu_dynamic : law.mu_static;
  }
}

// As stiff as the barrier is where it begins to act: then the static branch is the supplement's test ‖u_t‖ <
// μ ‖u_n‖. At least κ/d̂² (κ for the log barrier, where it is in J/m²), for barriers that begin with no
// stiffness.
double tangential_stiffness(const Barrier& barrier) {
  const double unit = barrier.kind == BarrierKind::log ? 1.0 : barrier.d_hat * barrier.d_hat;
  return std::max(barrier.kappa / unit, evaluate(barrier, barrier.d_hat * (1 - 1e-9)).second);
}

ContactBond make_bond(const ContactPoint& p, const Pose& a, const Pose& b, const Pose& a0, const Pose& b0) {
  ContactBond bond;
  bond.a = p.a;
  bond.b = p.b;
  bond.feature = p.feature;
  bond.n = a.R.transpose() * p.n;
  bond.r_b = b.R.transpose() * (p.y_b - b.c);
  bond.r_a = a0.R.transpose() * (b0.c + b0.R * bond.r_b - a0.c);
  bond.gap = bond.n.dot(bond.r_a - a.R.transpose() * (p.y_a - a.c));
  bond.stretch.setZero();
  bond.mu = -1;  // not known yet
  bond.limit = 0;
  bond.last_change = 0;
  return bond;
}

}  // namespace

void find_contacts(const Model& model, const Params& params, const State& state, int threads,
                   StepWorkspace::Impl& w) {
  const Index n = model.size();
  const ContactParams& contact = params.contact;
  w.law = {Barrier{contact.barrier, contact.N, contact.d_hat, resolve_kappa(model, params), contact.onset}, 0,
           contact.mu_static, contact.mu_dynamic};
  w.law.k_t = tangential_stiffness(w.law.barrier);

  // A body that flies farther than half its own thickness could come out on the other side of what it meets:
  // it is looked at where the step starts, with its whole way as reach (Deviation D7).
  w.reach.resize(static_cast<std::size_t>(n));
  w.c = w.c_star;
  w.R = w.R_star;
  for (Index i = 0; i < n; ++i) {
    const double way = travel(model, state, w, params.h, i);
    w.reach[i] = 0.5 * contact.d_hat + way;
    if (!model.fixed[i] &&
        (way > 0.5 * inner_radius(model.shape[i]) || contact.barrier == BarrierKind::log)) {
      w.c[i] = state.c[i];
      w.R[i] = state.R[i];
    }
  }
  detect(model, w.c, w.R, w.reach, model.no_collide, threads, w.collision, w.points);

  w.bonds.clear();
  for (const ContactPoint& p : w.points) {
    w.bonds.push_back(make_bond(p, {w.c[p.a], w.R[p.a]}, {w.c[p.b], w.R[p.b]}, {state.c[p.a], state.R[p.a]},
                                {state.c[p.b], state.R[p.b]}));
  }
  std::sort(w.bonds.begin(), w.bonds.end(), [](const ContactBond& x, const ContactBond& y) {
    return std::make_tuple(pair_key(x.a, x.b), owned_feature(x.a, x.b, x.feature)) <
           std::make_tuple(pair_key(y.a, y.b), owned_feature(y.a, y.b, y.feature));
  });
  match_anchors(state.anchors, w.law, w.bonds);
}

void initial_guess(const Model& model, const Params& params, const State& state, StepWorkspace::Impl& w) {
  w.c = w.c_star;
  w.R = w.R_star;
  if (params.contact.barrier == BarrierKind::log) {
    for (const Index i : w.colored) {
      w.c[i] = state.c[i];
      w.R[i] = state.R[i];
    }
    return;
  }
  const Vec3 fall = params.h * params.h * params.gravity;
  for (const ContactBond& bond : w.bonds) {
    if (bond.gap >= w.law.barrier.d_hat) continue;
    if (!model.fixed[bond.a]) w.c[bond.a] = w.c_star[bond.a] - fall;
    if (!model.fixed[bond.b]) w.c[bond.b] = w.c_star[bond.b] - fall;
  }
}

void start_friction(int threads, StepWorkspace::Impl& w) {
  if (w.law.mu_static == 0) return;
  parallel_for(threads, w.bonds.size(), [&](std::size_t k) {
    ContactBond& bond = w.bonds[k];
    const ContactState s = state_of(w, bond);
    if (bond.mu < 0) {
      const double f_n = -evaluate(w.law.barrier, s.d).first;
      bond.mu = w.law.k_t * s.u.norm() <= w.law.mu_static * f_n ? w.law.mu_static : w.law.mu_dynamic;
    }
    update_limit(w.law, bond, s);
    bond.last_change = 0;
  });
}

void update_friction_limits(int threads, StepWorkspace::Impl& w) {
  if (w.law.mu_static == 0) return;
  parallel_for(threads, w.bonds.size(),
               [&](std::size_t k) { update_limit(w.law, w.bonds[k], state_of(w, w.bonds[k])); });
}

void store_anchors(const StepWorkspace::Impl& w, std::vector<FrictionAnchor>& anchors) {
  anchors.clear();
  for (const ContactBond& bond : w.bonds) {
    if (!(bond.limit > 0)) continue;
    const ContactState s = state_of(w, bond);
    const double u = s.u.norm();
    const double scale = friction_weight(w.law, bond.limit, u) / w.law.k_t;  // 1 while it sticks
    anchors.push_back({pair_key(bond.a, bond.b), owned_feature(bond.a, bond.b, bond.feature),
                       scale * (w.R[bond.a].transpose() * s.u), w.law.k_t * u > bond.limit});
  }
}

}  // namespace pabd
