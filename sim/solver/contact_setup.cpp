#include "sim/solver/contact_setup.h"

#include <algorithm>
#include <tuple>

#include "sim/math/so3.h"
#include "sim/solver/friction.h"

namespace pabd {
namespace {

// Distance a body's surface may travel in the step. A ball that spins stays where it is, and so does a
// capsule that spins about its axis.
double travel(const Shape& shape, const State& state, const StepWorkspace::Impl& w, Index i) {
  double turn = w.turn[i].norm() * w.radius[i];
  if (std::holds_alternative<Sphere>(shape)) turn = 0;
  if (const auto* capsule = std::get_if<Capsule>(&shape))
    turn = w.turn[i].cross(state.R[i].col(1)).norm() * 0.5 * capsule->length;
  return (w.star[i].c - state.c[i]).norm() + turn;
}

// Poses and reach for detection. A body that flies farther than half its own thickness could come out on the
// other side of what it meets: it is looked at where the step starts, with its whole way as reach (Deviation
// D7). So is every body under the log barrier, which needs the contacts of a feasible pose.
void place_for_detection(const Model& model, const Params& params, const State& state,
                         StepWorkspace::Impl& w) {
  const auto n = model.shape.size();
  w.reach.assign(n, 0.5 * params.contact.d_hat);
  w.c_detect = state.c;
  w.R_detect = state.R;
  for (Index i = 0; i < model.size(); ++i) {
    if (model.fixed[i]) continue;
    const double way = travel(model.shape[i], state, w, i);
    w.reach[i] += way;
    if (way > 0.5 * inner_radius(model.shape[i]) || params.contact.barrier == BarrierKind::log) continue;
    w.c_detect[i] = w.star[i].c;
    w.R_detect[i] = w.star[i].R;
  }
}

// As stiff as the barrier is where it begins to act: then the static branch is the supplement's test ‖u_t‖ <
// μ ‖u_n‖. At least κ/d̂² (κ for the log barrier, where it is in J/m²), for barriers that begin with no
// stiffness.
double tangential_stiffness(const Barrier& barrier) {
  const double unit = barrier.kind == BarrierKind::log ? 1.0 : barrier.d_hat * barrier.d_hat;
  return std::max(barrier.kappa / unit, evaluate(barrier, barrier.d_hat * (1 - 1e-9)).second);
}

auto sort_key(const ContactPoint& p) {
  return std::make_tuple(pair_key(p.a, p.b), owned_feature(p.a, p.b, p.feature));
}

// Radius of a round shape, 0 of a flat one.
double roundness(const Shape& shape) {
  if (const auto* sphere = std::get_if<Sphere>(&shape)) return sphere->radius;
  if (const auto* capsule = std::get_if<Capsule>(&shape)) return capsule->radius;
  return 0;
}

ContactPatch empty_patch(const Model& model, Index a, Index b) {
  const Vec3x zero = spread(Vec3::Zero());
  const bool flat_a = roundness(model.shape[a]) == 0;
  const bool flat = flat_a && roundness(model.shape[b]) == 0;
  return {a,    b,           0,     flat_a, !flat,    nullptr,  {},       zero, zero,     zero,       zero,
          zero, lanes(1e30), false, 0,      lanes(0), lanes(0), lanes(1), zero, lanes(1), lanes(0.02)};
}

// Puts the point into the next lane, in the frames of the bodies.
void add_point(const Model& model, const ContactPoint& p, const State& start, const StepWorkspace::Impl& w,
               ContactPatch& patch) {
  const int k = patch.count++;
  const auto in_a = [&](const Vec3& y) -> Vec3 {
    return w.R_detect[p.a].transpose() * (y - w.c_detect[p.a]);
  };
  const auto in_b = [&](const Vec3& y) -> Vec3 {
    return w.R_detect[p.b].transpose() * (y - w.c_detect[p.b]);
  };
  const double radius_a = roundness(model.shape[p.a]), radius_b = roundness(model.shape[p.b]);
  const Vec3 n = patch.turns ? Vec3(w.R_detect[p.a].transpose() * p.n) : p.n;
  const Vec3 normal_b = in_b(p.y_b + radius_b * p.n);
  // From the centre of a to the normal point of b at the start of the step.
  const Vec3 at_start = start.c[p.b] + start.R[p.b] * normal_b - start.c[p.a];
  patch.feature[k] = owned_feature(p.a, p.b, p.feature);
  set_lane(patch.n, k, n);
  set_lane(patch.normal_b, k, normal_b);
  if (patch.turns) {
    const Vec3 normal_a = start.R[p.a].transpose() * at_start;
    const Mat3 half_way = exp_so3(0.5 * w.turn[p.a]) * start.R[p.a];
    const Vec3 turn = half_way.transpose() * (w.turn[p.b] - w.turn[p.a]);
    set_lane(patch.normal_a, k, normal_a);
    set_lane(patch.rolled, k, radius_b * n.cross(turn));
    patch.gap[k] = n.dot(normal_a - in_a(p.y_a)) - radius_b;
  } else {
    const Vec3 normal_a = in_a(p.y_a - radius_a * p.n);
    const Vec3 moved = at_start - start.R[p.a] * normal_a;
    const Vec3 turn = radius_b * w.turn[p.b] + radius_a * w.turn[p.a];
    set_lane(patch.normal_a, k, normal_a);
    set_lane(patch.rolled, k, n.cross(turn) - (moved - n * n.dot(moved)));
    patch.gap[k] = -radius_a - radius_b;
  }
}

// What the slip of the separate patches is measured from.
void set_rolling(const Model& model, StepWorkspace::Impl& w) {
  w.rolling.clear();
  w.roll.assign(w.star.size(), {});
  w.rolls.assign(w.star.size(), 0);
  for (const ContactPatch& p : w.patches) {
    if (!p.separate) continue;
    w.rolls[p.a] = w.rolls[p.b] = 1;
    w.rolling.push_back(
        {&w.roll[p.a], &w.roll[p.b], roundness(model.shape[p.a]), roundness(model.shape[p.b])});
  }
  const Rolling* next = w.rolling.data();
  for (ContactPatch& p : w.patches) {
    if (p.separate) p.rolling = next++;
  }
}

void make_patches(const Model& model, const State& start, StepWorkspace::Impl& w) {
  const auto before = [](const ContactPoint& x, const ContactPoint& y) { return sort_key(x) < sort_key(y); };
  if (!std::is_sorted(w.points.begin(), w.points.end(), before))
    std::sort(w.points.begin(), w.points.end(), before);
  w.patches.clear();
  for (const ContactPoint& p : w.points) {
    const bool fits = !w.patches.empty() && w.patches.back().a == p.a && w.patches.back().b == p.b &&
                      w.patches.back().count < kLanes;
    if (!fits) w.patches.push_back(empty_patch(model, p.a, p.b));
    add_point(model, p, start, w, w.patches.back());
  }
  set_rolling(model, w);
}

}  // namespace

void find_contacts(const Model& model, const Params& params, const State& state, int threads,
                   StepWorkspace::Impl& w) {
  const ContactParams& contact = params.contact;
  w.law.barrier = {contact.barrier, contact.N, contact.d_hat, resolve_kappa(model, params), contact.onset};
  w.law.k_t = tangential_stiffness(w.law.barrier);
  w.law.mu_static = contact.mu_static;
  w.law.mu_dynamic = contact.mu_dynamic;
  place_for_detection(model, params, state, w);
  detect(model, w.c_detect, w.R_detect, w.reach, model.no_collide, threads, w.collision, w.points);
  make_patches(model, state, w);
  recall_friction(state.anchors, w);
}

void initial_guess(const Model& model, const Params& params, const State& state, StepWorkspace::Impl& w) {
  w.pose = w.star;
  w.pose.push_back({Vec3::Zero(), Mat3::Identity()});
  if (params.contact.barrier == BarrierKind::log) {
    for (const Index i : w.solved) {
      w.pose[i] = {state.c[i], state.R[i]};
      w.set_roll(i, state.R[i]);
    }
    return;
  }
  const Vec3 fall = params.h * params.h * params.gravity;
  for (const ContactPatch& patch : w.patches) {
    const ContactState start =
        contact_state(patch, {state.c[patch.a], state.R[patch.a]}, {state.c[patch.b], state.R[patch.b]});
    double gap = start.d[0];
    for (int k = 1; k < patch.count; ++k) gap = std::min(gap, start.d[k]);
    if (gap >= w.law.barrier.d_hat) continue;
    for (const Index i : {patch.a, patch.b}) {
      if (!model.fixed[i]) w.pose[i].c = w.star[i].c - fall;
    }
  }
}

}  // namespace pabd
