// SPDX-License-Identifier: MIT
#include "sim/solver/step_summary.h"

#include <Eigen/LU>
#include <limits>

#include "sim/body/mass_properties.h"
#include "sim/math/extremes.h"
#include "sim/math/levels.h"
#include "sim/solver/couplings.h"
#include "sim/solver/friction.h"
#include "sim/solver/joint_set.h"
#include "sim/solver/sissm.h"

namespace pabd {

double kinetic_energy(const Model& model, Index i, const Mat3& R, const Vec3& v, const Vec3& omega) {
  const Vec3 w = R.transpose() * omega;
  return 0.5 * (model.mass[i] * v.squaredNorm() + w.dot(inertia_tensor(model.J[i]) * w));
}

double kinetic_energy(const Model& model, const State& state) {
  double energy = 0;
  for (Index i = 0; i < model.size(); ++i) {
    if (!model.fixed[i]) energy += kinetic_energy(model, i, state.R[i], state.v[i], state.omega[i]);
  }
  return energy;
}

double potential_energy(const Model& model, const Params& params, const State& state) {
  double energy = 0;
  for (Index i = 0; i < model.size(); ++i) energy -= model.mass[i] * params.gravity.dot(state.c[i]);
  return energy;
}

double spring_energy(const Model& model, const State& state) {
  double energy = 0;
  for (const Joint& joint : model.joints) {
    if (joint.action) energy += spring_energy(joint, place(joint, state));
  }
  return energy;
}

namespace {

// How far friction is above μ f_n, as a part of it. Contacts that carry less than `least` count as if they
// carried that; N.
Lanes friction_excess(const ContactManifold& manifold, Lanes friction, const ContactForce& f, double least) {
  if (manifold.mu == 0) return lanes(0);
  return friction / (manifold.mu * larger(-f.first, lanes(least))) - 1;
}

}  // namespace

PABD_EACH_LEVEL void summarize_contacts(const Problem& p, const Iterate& it, bool with_reports,
                                        StepReport& report) {
  const double least = kLeastLoad * movable_mass(*p.model).heaviest * weight_per_mass(*p.params);
  report.elastic = 0;
  report.friction_excess = 0;
  report.contacts = 0;
  report.max_normal_force = 0;
  report.min_gap = std::numeric_limits<double>::infinity();
  report.contact_reports.clear();
  for (const ContactManifold& manifold : it.manifold) {
    const ContactState s = state_of(it, manifold);
    const ContactLaw law = p.law_of(manifold);
    const ContactForce f = normal_force(law.barrier, manifold, s.d);
    const Lanes energy =
        stored_energy(law.barrier, manifold, f, s.d) + friction_energy(law, manifold.limit, length(s.u));
    const Lanes alpha_t = friction_weight(law, manifold.limit, length(s.u));
    const Lanes excess = friction_excess(manifold, alpha_t * length(s.u), f, least);
    report.elastic += turn_energy(law, manifold, it);
    report.friction_excess =
        larger(report.friction_excess, turn_friction_excess(law, manifold, f, least, it));
    for (int k = 0; k < manifold.count; ++k) {
      report.min_gap = smaller(report.min_gap, s.d[k]);
      report.friction_excess = larger(report.friction_excess, excess[k]);
      if (s.d[k] >= p.law.barrier.d_hat) continue;
      report.elastic += energy[k];
      ++report.contacts;
      report.max_normal_force = larger(report.max_normal_force, -f.first[k]);
      if (!with_reports) continue;
      const Vec3 n = lane(s.n, k), u = lane(s.u, k), y = it.pose[manifold.a].c + lane(s.y, k);
      const Vec3 y_b = y + it.pose[manifold.b].R * lane(manifold.to_surface, k);
      const bool sticking = manifold.limit[k] > 0 && law.k_t * u.norm() <= manifold.limit[k];
      report.contact_reports.push_back({manifold.a, manifold.b, y_b - s.d[k] * n, y_b, n, s.d[k], -f.first[k],
                                        -alpha_t[k] * u, sticking, manifold.mu});
    }
  }
  report.max_penetration = larger(0, -report.min_gap);
}

namespace {

// Half of each contact's energy for each of its two bodies: the sum over bodies is that of the contacts.
void share_contacts(const Problem& p, const Iterate& it, std::vector<BodyReport>& out) {
  for (const ContactManifold& manifold : it.manifold) {
    const ContactState s = state_of(it, manifold);
    const Lanes energy = contact_energy(p.law_of(manifold), manifold, s);
    for (const Index i : {manifold.a, manifold.b})
      out[i].contact_energy += 0.5 * turn_energy(p.law_of(manifold), manifold, it);
    for (int k = 0; k < manifold.count; ++k) {
      if (s.d[k] >= p.law.barrier.d_hat) continue;
      for (const Index i : {manifold.a, manifold.b}) {
        ++out[i].contacts;
        out[i].contact_energy += 0.5 * energy[k];
      }
    }
  }
}

}  // namespace

void report_bodies(const Problem& p, const Islands& islands, const std::vector<IslandReport>& solved,
                   const Iterate& it, const SissmMemory& sissm, std::vector<BodyReport>& out) {
  out.assign(p.model->shape.size(), {});
  share_contacts(p, it, out);
  for (const Index i : islands.solved) {
    BodyReport& body = out[i];
    body.island = islands.of[i];
    body.solver = solved[body.island].solver;
    body.residual = solved[body.island].residual;
    if (body.solver != SolverMethod::sissm) continue;
    body.projection_change = sissm.projected[i];
    body.det_A = sissm.A[i].determinant();
  }
}

void report_joints(const Problem& p, const Iterate& it, const std::vector<Vec3>& solved,
                   const Workers& workers, std::vector<JointReport>& out) {
  out.resize(p.joints.model.size());
  workers.for_each(out.size(), [&](std::size_t k) {
    BondList list;
    const auto number = static_cast<Index>(k);
    const Joint& joint = p.joints[number];
    const PlacedFrame frame = place(joint.on_i, it.pose[it.slot(joint.i)]);
    expand_at(p, it, number, list);
    JointReport report;
    report.axis = frame.F.col(0);
    report.error = result_of_joint(p, it, number).error;
    // A solver that knows the force of a joint with one bond knows it better than its stretch does: that is
    // some rounding steps of a place.
    const bool known = list.count == 1 && !solved[k].isZero(0);
    for (int b = 0; b < list.count; ++b) {
      const PointBond& bond = list.bond[b];
      const Vec3 force = known ? solved[k] : Vec3(-evaluate(p.law_of(number), bond).gradient);
      report.force += force;
      report.moment += (bond.y_b - frame.y).cross(force);
    }
    if (const Index n = coupling_of(p, number); n >= 0) report.coupling = coupling_force(p, it, n);
    out[k] = report;
  });
}

}  // namespace pabd
