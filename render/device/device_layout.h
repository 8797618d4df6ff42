// SPDX-License-Identifier: MIT
// The records of shaders/device_layout.glsl that both sides read or write, and the numbers of its buffers. std430.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

#include "render/device/shape_table.h"
#include "sim/potential/barrier.h"

namespace pabd::device {

inline constexpr std::uint32_t kLevels = 16, kColors = 128;
inline constexpr std::uint32_t kShares = 3, kSweepLists = kShares * kColors;  // as in device_layout.glsl
inline constexpr std::uint32_t kTwoKinds = kDeviceShapes * kDeviceShapes;     // of shapes, in either order
// Of the narrow phase (shaders/device_lists.glsl): most pairs need one, fast ones some more, in steps along their way.
inline constexpr std::uint32_t kRounds = 6;
inline constexpr std::uint32_t kPairLists = 2 * kRounds + 1;

// Those that barrier_sum of shaders/device_barrier.glsl knows. Any other one is refused.
inline constexpr std::array kDeviceBarriers = {BarrierKind::polynomial, BarrierKind::even,
                                               BarrierKind::quadratic};
constexpr bool is_on_device(BarrierKind kind) {
  return std::find(kDeviceBarriers.begin(), kDeviceBarriers.end(), kind) != kDeviceBarriers.end();
}

// Binding of each array of shaders/device_buffers.glsl.
enum class Slot : std::uint32_t {
  params,
  counters,
  kinds,
  kind_of,
  poses,
  motions,
  flights,
  places,
  bounds,
  cell_first,
  cell_bodies,
  pair_first,
  pairs,
  raw,
  contacts,
  grips,
  contact_first,
  end_first,
  ends,
  color_of,
  order,
  arguments,
  cursors,
  steps,
  kept_first,
  kept_pairs,
  kept_stretch,
  kept_feature,
  values,
  sums,
  shapes,
  hulls,
  plane_bodies,
  skips,
  huge,
  parts,
  told,
  raw_geometry,
  kept_geometry,
  touching,
  body_values,
  outcomes,
  count
};

struct StepParams {
  double gravity[3];
  double least_load, weight_per_mass;
  double least_share, h, d_hat, kappa, k_t, mu_static, mu_dynamic, onset, recovery_speed, cell;
  std::int32_t N, barrier, first_step, color_limit;
  std::uint32_t bodies, buckets, planes, skips;
  std::uint32_t pair_room, contact_room;
  std::int32_t friction_rule;  // a FrictionRule; -1: no body has friction of its own
  std::uint32_t groups;        // 1: some keep bodies apart
  std::uint32_t shares;        // a bit each: those that are dispatched
  std::uint32_t halves;        // 1: a step that ends unsolved is not made
  std::uint32_t second_order;  // 1: what feels nothing flies along a parabola
};
static_assert(sizeof(StepParams) == 184);

enum Overflow : std::uint32_t {
  too_many_pairs = 1,
  too_many_contacts = 2,
  too_many_colors = 4,
  too_few_rounds = 8,
  share_unexpected = 16,  // shifted by the share
  ended_unsolved = 128,   // it asks for halves, not for room
  loops_cut = 256         // the driver left contacts unfound; nothing helps
};

struct Counters {
  std::uint32_t overflow;
  std::uint32_t pairs, contacts, raw;
  std::uint32_t level[kLevels];
  std::uint32_t huge_next, uncolored, colors, rounds, crowded;
  std::uint32_t list_size[kSweepLists], list_first[kSweepLists], list_next[kSweepLists];
  std::uint32_t residual, unsettled;
  std::uint32_t done, sweeps, pushing, min_gap, force, friction_excess, friction_error, bad;
  std::uint32_t kept;
  std::uint32_t touched, unsolved, unsettled_contacts, late;
  std::uint32_t touch_size[kTwoKinds], touch_first[kTwoKinds], touch_next[kTwoKinds];
  std::uint32_t again_size[2 * kRounds * kTwoKinds];
  std::uint32_t width[6], opening, fastest;
  double gained;
  double stored, rise;
  double kinetic, potential, elastic;
};
static_assert(sizeof(Counters) == 7008);

struct BodyKind {
  double J[6];
  double half[3];
  double mass, bounding, inner, rolling, core;
  double mu_static, mu_dynamic;
  std::int32_t shape, form, symmetry, fixed, round_about_y, pad;
  std::uint64_t groups, avoids;
};
static_assert(sizeof(BodyKind) == 168);

struct Pose {
  double c[4], q[4];  // q: x, y, z, w
};

// Real: float or double, as the shaders compute.
template <class Real>
struct Pair {
  std::uint32_t emitter, other, first, count;
  alignas(4 * sizeof(Real)) Real seen[4], turned[4];
};
static_assert(sizeof(Pair<float>) == 48 && sizeof(Pair<double>) == 96);

struct ContactTold {
  std::uint32_t ends[4], pad[4];
  double y_b[4], n[4], friction[4];
};
static_assert(sizeof(ContactTold) == 128);

// A float that a shader keeps as bits in the order of the values.
inline float from_ordered(std::uint32_t bits) {
  return std::bit_cast<float>((bits & 0x80000000u) != 0 ? bits & 0x7fffffffu : ~bits);
}

}  // namespace pabd::device
