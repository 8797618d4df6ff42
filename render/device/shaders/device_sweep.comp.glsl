// SPDX-License-Identifier: MIT
// Block coordinate descent, sim/solver/descent.cpp: a team of TEAM threads relaxes a body of a color while all others
// stand still. It minimises a quadratic model of E in the tangent space of SE(3); a step that does not lower the body's
// own energy is halved until it does. The threads share the contacts of their body; the first one, which leads, solves.
uniform uint list_;
uniform int move_limits;  // of friction, on the way

struct Model6 {
  real3 g_c, g_w;
  // Lower triangle: cc (xx, yy, zz, yx, zx, zy), wc by rows, ww as cc.
  real3 cc_diag, cc_off, wc_x, wc_y, wc_z, ww_diag, ww_off;
};

const uint BODIES = SWEEP_GROUP / TEAM;  // of a work group
const uint VALUES = 29u;                 // of a model, its energy, the room around it
shared real value[VALUES * SWEEP_GROUP];  // a thread each; then a team's sum where its first thread's was
shared Place trial_of[BODIES];
shared uint trying;                 // bodies of this group whose step is not accepted yet
shared bool tries_of[BODIES];       // which they are
shared vec2 largest[SWEEP_GROUP];   // way of a body's step over d̂; error of a friction force as a part of μ f_n
float friction_error = 0;

void put(uint k, real x) {
  value[k * SWEEP_GROUP + gl_LocalInvocationID.x] = x;
}
void put(uint k, real3 x) {
  put(k, x.x);
  put(k + 1u, x.y);
  put(k + 2u, x.z);
}
// Of value k over a team, in the order of its threads.
real team_sum(uint k, uint team) {
  const uint first = k * SWEEP_GROUP + team * TEAM;
  real sum = value[first];
  for (uint j = 1u; j < TEAM; ++j) sum += value[first + j];
  return sum;
}
// Of the body that this thread leads.
real got(uint k) {
  return value[k * SWEEP_GROUP + gl_LocalInvocationID.x * TEAM];
}
real3 got3(uint k) {
  return real3(got(k), got(k + 1u), got(k + 2u));
}

// Energy of a trial place, but for the inertia: what the contacts of body i that are this thread's say.
real contact_energy(uint i, Place trial) {
  real energy = 0;
  for (uint e = end_first[i] + gl_LocalInvocationID.x % TEAM; e < end_first[i + 1u]; e += TEAM) {
    const uvec2 end = ends[e];
    const uint k = end.x >> 1;
    const bool is_a = (end.x & 1u) != 0u;
    const Contact c = contacts[k];
    const Place other = place[end.y];
    ContactNow s;
    if (is_a) {
      s = contact_now(c, trial, other);
    } else {
      s = contact_now(c, other, trial);
    }
    const real limit = grips[k].x;
    if (s.d + c.r_b.w >= real(params.d_hat) && !(limit > 0)) continue;
    energy += normal_push(c, s.d).value + friction_energy(limit, norm(s.u));
  }
  return energy;
}

// Adds a contact; `side`: +1 for the body of the point, −1 for the body of the plane.
void add_contact_to(inout Model6 m, ContactNow s, Push f, real weight, real side) {
  const real3 r_n = side > 0 ? s.normal_b : s.normal_a, r_t = side > 0 ? s.surface_b : s.surface_a;
  const real3 arm = cross(r_n, s.n), friction = (side * weight) * s.u;
  const real push = side * f.first, k = f.stiffness - weight;
  m.g_c += push * s.n + friction;
  m.g_w += push * arm + cross(r_t, friction);
  m.cc_diag += weight + k * s.n * s.n;
  m.cc_off += k * real3(s.n.y * s.n.x, s.n.z * s.n.x, s.n.z * s.n.y);
  m.wc_x += (k * arm.x) * s.n + weight * real3(0, -r_t.z, r_t.y);
  m.wc_y += (k * arm.y) * s.n + weight * real3(r_t.z, 0, -r_t.x);
  m.wc_z += (k * arm.z) * s.n + weight * real3(-r_t.y, r_t.x, 0);
  m.ww_diag += weight * (dot(r_t, r_t) - r_t * r_t) + k * arm * arm;
  m.ww_off += k * real3(arm.y * arm.x, arm.z * arm.x, arm.z * arm.y) -
              weight * real3(r_t.y * r_t.x, r_t.z * r_t.x, r_t.z * r_t.y);
}

// H x = −g by H = L D Lᵀ; false: H has no minimum.
bool minimum(Model6 m, out real3 dc, out real3 dw) {
  real H[21];  // lower triangle by rows
  H[0] = m.cc_diag.x;
  H[1] = m.cc_off.x; H[2] = m.cc_diag.y;
  H[3] = m.cc_off.y; H[4] = m.cc_off.z; H[5] = m.cc_diag.z;
  H[6] = m.wc_x.x; H[7] = m.wc_x.y; H[8] = m.wc_x.z; H[9] = m.ww_diag.x;
  H[10] = m.wc_y.x; H[11] = m.wc_y.y; H[12] = m.wc_y.z; H[13] = m.ww_off.x; H[14] = m.ww_diag.y;
  H[15] = m.wc_z.x; H[16] = m.wc_z.y; H[17] = m.wc_z.z; H[18] = m.ww_off.y; H[19] = m.ww_off.z; H[20] = m.ww_diag.z;
  real x[6] = real[6](-m.g_c.x, -m.g_c.y, -m.g_c.z, -m.g_w.x, -m.g_w.y, -m.g_w.z);
  bool definite = true;
  for (int j = 0; j < 6; ++j) {
    const int row_j = j * (j + 1) / 2;
    const real whole = H[row_j + j];
    real pivot = whole;
    for (int k = 0; k < j; ++k) pivot -= H[row_j + k] * H[row_j + k] * H[k * (k + 1) / 2 + k];
    if (!(pivot > 100 * EPSILON * whole)) {  // lost to rounding, or never there
      definite = false;
      pivot = whole > 0 ? whole : real(1);
    }
    H[row_j + j] = pivot;
    for (int i = j + 1; i < 6; ++i) {
      const int row_i = i * (i + 1) / 2;
      real l = H[row_i + j];
      for (int k = 0; k < j; ++k) l -= H[row_i + k] * H[row_j + k] * H[k * (k + 1) / 2 + k];
      H[row_i + j] = l / pivot;
    }
  }
  for (int i = 1; i < 6; ++i) {
    for (int k = 0; k < i; ++k) x[i] -= H[i * (i + 1) / 2 + k] * x[k];
  }
  for (int i = 0; i < 6; ++i) x[i] /= H[i * (i + 1) / 2 + i];
  for (int i = 4; i >= 0; --i) {
    for (int k = i + 1; k < 6; ++k) x[i] -= H[k * (k + 1) / 2 + i] * x[k];
  }
  dc = real3(x[0], x[1], x[2]);
  dw = real3(x[3], x[4], x[5]);
  return definite;
}

Place moved_by(Place at, real3 dc, real3 dw) {
  const real4 q = product(cayley_turn(dw), at.q);
  return Place(real4(at.u.xyz + dc, at.u.w), q / norm(q));
}

// Model of E around the place of body i, and E there: what is this thread's.
void add_contacts(uint i, Place at, inout Model6 m, inout real energy, inout real room) {
  const real d_hat = real(params.d_hat);
  const uint stop = end_first[i + 1u];
  uint e = end_first[i] + gl_LocalInvocationID.x % TEAM;
  if (e >= stop) return;
  // The next one is on its way while one is worked on.
  uvec2 next_end = ends[e];
  Contact next_contact = contacts[next_end.x >> 1];
  Place next_other = place[next_end.y];
  for (; e < stop; e += TEAM) {
    const uvec2 end = next_end;
    const uint k = end.x >> 1;
    const bool is_a = (end.x & 1u) != 0u;
    const Contact c = next_contact;
    const Place other = next_other;
    next_end = ends[min(e + TEAM, stop - 1u)];
    next_contact = contacts[next_end.x >> 1];
    next_other = place[next_end.y];
    ContactNow s;
    if (is_a) {
      s = contact_now(c, at, other);
    } else {
      s = contact_now(c, other, at);
    }
    Grip grip = grips[k];
    const real beyond = s.d - d_hat;
    if (beyond >= 0) room = min(room, beyond);
    // Of the ends that move, the owner of the normal moves the bound.
    const bool mover = is_a || other.u.w == 0;
    const bool nothing = s.d + c.r_b.w >= d_hat && !(grip.x > 0);
    if (nothing && !mover) continue;
    const Push push = normal_push(c, s.d);
    const real slip = norm(s.u);
    if (mover && c.before.w > 0) {
      const real least = real(params.least_share) * (other.u.w > 0 ? min(other.u.w, at.u.w) : at.u.w);
      const real pull = real(params.k_t) * slip, law = -c.before.w * push.first;
      const real error = abs(min(pull, max(grip.x, real(0))) - min(pull, law));
      friction_error = max(friction_error, float(error / max(law, c.before.w * least)));
      if (move_limits != 0) {
        // Each goes its own share of the way: half of the last share where it swings back, half as much again where not.
        const real change = law - grip.x;
        grip.z = change * grip.y < 0 ? grip.z / 2 : min(real(1), grip.z * 3 / 2);
        grip.x += grip.z * change;
        grip.y = change;
        grips[k] = grip;
      }
    }
    if (nothing) continue;
    energy += push.value + friction_energy(grip.x, slip);
    add_contact_to(m, s, push, friction_weight(grip.x, slip), is_a ? real(-1) : real(1));
  }
}

// Of the inertia alone.
void add_inertia(Flight f, Place at, real inv_h2, inout Model6 m) {
  const real3 d = f.W_diag.xyz, o = f.W_off.xyz;
  const real4 e = turn_since_flight(f, at);
  const mat_real3 G = matrix_less(e) * mat_real3(d.x, o.x, o.y, o.x, d.y, o.z, o.y, o.z, d.z);  // (E − 1) W
  const real mass = f.W_diag.w * inv_h2, trace = d.x + d.y + d.z - 2 * dot(e.xyz, inertia_times(f, e.xyz));
  m.g_c += mass * (at.u.xyz - f.u.xyz);
  m.g_w -= inv_h2 * axial_inertia(f, at);
  m.cc_diag += real3(mass);
  m.ww_diag += inv_h2 * (trace - f.W_diag.xyz - real3(G[0][0], G[1][1], G[2][2]));
  m.ww_off -= inv_h2 * (f.W_off.xyz + real3(G[0][1] + G[1][0], G[0][2] + G[2][0], G[1][2] + G[2][1]) / 2);
}

void put_model(Model6 m, real energy, real room) {
  put(0u, m.g_c);
  put(3u, m.g_w);
  put(6u, m.cc_diag);
  put(9u, m.cc_off);
  put(12u, m.wc_x);
  put(15u, m.wc_y);
  put(18u, m.wc_z);
  put(21u, m.ww_diag);
  put(24u, m.ww_off);
  put(27u, energy);
  put(28u, room);
}

// Of all bodies of the group, shared by its threads.
void add_up_values() {
  for (uint n = gl_LocalInvocationID.x; n < VALUES * BODIES; n += SWEEP_GROUP) {
    const uint k = n / BODIES, team = n % BODIES, at = k * SWEEP_GROUP + team * TEAM;
    real all = value[at];
    for (uint j = 1u; j < TEAM; ++j) all = k == VALUES - 1u ? min(all, value[at + j]) : all + value[at + j];
    value[at] = all;
  }
}

Model6 got_model() {
  return Model6(got3(0u), got3(3u), got3(6u), got3(9u), got3(12u), got3(15u), got3(18u), got3(21u), got3(24u));
}

// A step of a body.
struct Attempt {
  real3 dc, dw;
  real factor, moved;  // by which the model's step was lengthened; its way over d̂
  bool accepted;       // without a look at the energy
};

Attempt first_attempt(uint i, Model6 m, real room, real radius) {
  Attempt a;
  const bool definite = minimum(m, a.dc, a.dw);
  const real angle = norm(a.dw);
  if (angle > 1) {  // the tangent model says nothing that far away
    a.dc /= angle;
    a.dw /= angle;
  }
  const real3 last_c = last_step[2u * i].xyz, last_w = last_step[2u * i + 1u].xyz;
  const real last_moved = last_step[2u * i + 1u].w, d_hat = real(params.d_hat);
  a.moved = (norm(a.dc) + radius * norm(a.dw)) / d_hat;

  // A body that keeps moving the same way goes farther.
  const real r2 = radius * radius, squared = dot(a.dc, a.dc) + r2 * dot(a.dw, a.dw);
  const real last_squared = dot(last_c, last_c) + r2 * dot(last_w, last_w);
  const bool same_way = dot(a.dc, last_c) + r2 * dot(a.dw, last_w) > real(0.5lf) * sqrt(squared * last_squared);
  a.factor = same_way ? min(real(1.5lf), last_step[2u * i].w + real(0.2lf)) : real(1);
  last_step[2u * i] = real4(a.dc, a.factor);
  last_step[2u * i + 1u] = real4(a.dw, a.moved);
  a.dc *= a.factor;
  a.dw *= a.factor;
  // So short that Ψ'' hardly changes along it, and that no other contact begins to push: the model is good there, and
  // going up to half as far again lowers it too.
  const real way = a.factor * a.moved;
  const bool is_small = way * max(params.N, 1) < real(0.06lf) && way * d_hat < room;
  a.accepted = definite && a.moved < last_moved && is_small;
  return a;
}

void main() {
  const uint t = gl_LocalInvocationID.x, first = work_group() * BODIES, team = t / TEAM;
  const uint size = arguments[list_].w, order_first = counters.list_first[list_];
  const real h = real(params.h), inv_h2 = 1 / (h * h);
  if (t == 0u) trying = 0u;

  // Contacts: a team of threads a body.
  const bool is_there = first + team < size;
  const uint i = is_there ? order[order_first + first + team] : 0u;
  {
    Model6 m;
    m.g_c = m.g_w = m.cc_diag = m.cc_off = m.wc_x = m.wc_y = m.wc_z = m.ww_diag = m.ww_off = real3(0);
    real energy = 0, room = real(1e30);
    const Place at = place[i];
    if (is_there) add_contacts(i, at, m, energy, room);
    put_model(m, energy, room);
  }
  barrier();
  add_up_values();
  barrier();

  // Solving: the first threads, a body each, so that the others' warps are done.
  const bool leads = t < BODIES && first + t < size;
  const uint led = leads ? order[order_first + first + t] : 0u;
  Attempt attempt;
  attempt.moved = 0;
  real energy = 0;
  const Flight f = flight[led];
  const Place at = place[led];
  if (leads) {
    Model6 m = got_model();
    add_inertia(f, at, inv_h2, m);
    energy = got(27u) + inertia_energy(f, at, inv_h2);
    attempt = first_attempt(led, m, got(28u), f.omega.w);
    trial_of[t] = moved_by(at, attempt.dc, attempt.dw);
    if (attempt.accepted) {
      place[led] = trial_of[t];
    } else {
      atomicAdd(trying, 1u);
    }
  }
  bool tries = leads && !attempt.accepted;
  if (t < BODIES) tries_of[t] = tries;
  bool go_on = true;
  for (int k = 0; k < 8 && go_on; ++k) {
    barrier();
    go_on = trying > 0u;
    if (go_on && is_there && tries_of[team]) put(0u, contact_energy(i, trial_of[team]));
    barrier();
    if (tries && inertia_energy(f, trial_of[t], inv_h2) + team_sum(0u, t) <= energy * (1 + 1000 * EPSILON)) {
      place[led] = trial_of[t];
      tries = tries_of[t] = false;
      atomicAdd(trying, 0xffffffffu);
    } else if (tries) {
      const real shorter = k == 0 && attempt.factor > 1 ? 1 / attempt.factor : real(0.5lf);
      attempt.dc *= shorter;
      attempt.dw *= shorter;
      trial_of[t] = moved_by(at, attempt.dc, attempt.dw);
    }
  }

  const float moved = leads ? float(attempt.moved) : 0;
  largest[t] = isnan(moved) ? vec2(1e30) : vec2(moved, friction_error);
  barrier();
  for (uint reach = SWEEP_GROUP / 2u; reach > 0u; reach /= 2u) {
    if (t < reach) largest[t] = max(largest[t], largest[t + reach]);
    barrier();
  }
  if (t != 0u) return;
  atomicMax(counters.residual, floatBitsToUint(largest[0].x));
  atomicMax(counters.unsettled, floatBitsToUint(largest[0].y));
}
