// SPDX-License-Identifier: MIT
// The buffers of a step: how large they are, and more room where a step needs it.
#include <algorithm>

#include "render/device/device_state.h"
#include "render/device/device_step.h"
#include "sim/base/error.h"

namespace pabd::device {
namespace {

constexpr double kMoreRoom = 1.3;  // than a step needed

}  // namespace

std::size_t DeviceStep::contact_bytes() const {  // of struct Contact
  const std::size_t head = precision_ == Precision::single ? 16 : 32;
  return head + (any_round(shapes_, table_) ? 6 : 4) * vec4();
}

void DeviceStep::make_body_buffers() {
  const std::size_t n = bodies_;
  buffers.make(Slot::params, sizeof(StepParams));
  buffers.make(Slot::counters, sizeof(Counters));
  buffers.make(Slot::kinds, kinds_.kinds);
  buffers.make(Slot::kind_of, kinds_.of_body);
  buffers.make(Slot::poses, n * sizeof(device::Pose));
  buffers.make(Slot::motions, n * 2 * vec4());
  buffers.make(Slot::flights, n * 7 * vec4());
  buffers.make(Slot::places, n * 2 * vec4());
  buffers.make(Slot::bounds, n * 2 * 16);
  buffers.make(Slot::cell_first, (buckets_ + 1) * sizeof(std::uint32_t));
  buffers.make(Slot::cell_bodies, n * 16);
  buffers.make(Slot::pair_first, (n + 1) * sizeof(std::uint32_t));
  buffers.make(Slot::end_first, (n + 1) * sizeof(std::uint32_t));
  buffers.make(Slot::color_of, n * sizeof(std::uint32_t));
  buffers.make(Slot::order, n * sizeof(std::uint32_t));
  buffers.make(Slot::arguments, (kSweepLists + kPairLists * kTwoKinds) * 16);
  buffers.make(Slot::cursors, std::max<std::size_t>(n, buckets_) * sizeof(std::uint32_t));
  buffers.make(Slot::steps, n * 2 * vec4());
  buffers.make(Slot::outcomes, n * 4 * vec4());
  buffers.make(Slot::kept_first, (n + 1) * sizeof(std::uint32_t));
  buffers.make(Slot::values, n * sizeof(std::uint32_t));
  buffers.make(Slot::shapes, table_.shapes);
  buffers.make(Slot::hulls, table_.hulls);
  buffers.make(Slot::plane_bodies, kinds_.planes);
  std::vector<std::uint32_t> skips;
  for (const auto& [a, b] : model_.no_collide) {
    skips.push_back(static_cast<std::uint32_t>(a));
    skips.push_back(static_cast<std::uint32_t>(b));
  }
  buffers.make(Slot::skips, skips);
  buffers.make(Slot::huge, n * sizeof(std::uint32_t));
}

void DeviceStep::make_pair_buffers(std::uint32_t room) {
  pair_room_ = room;
  buffers.make(Slot::pairs, room * pair_size(precision_));
  buffers.make(Slot::touching, (kRounds + 2) * std::size_t{room} * sizeof(std::uint32_t));
  buffers.make(Slot::contact_first, (std::size_t{room} + 1) * sizeof(std::uint32_t));
  buffers.make(
      Slot::sums,
      (groups(std::max({std::size_t{room}, std::size_t{bodies_}, std::size_t{buckets_}}) + 1, kScanned) + 1) *
          sizeof(std::uint32_t));
  buffers.grow(Slot::kept_pairs, room * pair_size(precision_));
}

void DeviceStep::make_contact_buffers(std::uint32_t room) {
  contact_room_ = room;
  buffers.make(Slot::raw, room * contact_bytes());
  buffers.make(Slot::contacts, room * contact_bytes());
  buffers.make(Slot::raw_geometry, room * 2 * vec4());
  buffers.make(Slot::grips, room * vec4());
  buffers.make(Slot::ends, std::size_t{room} * 2 * 2 * sizeof(std::uint32_t));
  buffers.make(Slot::parts, std::size_t{groups(std::max(room, bodies_), kGroup)} * 4 * sizeof(double));
  if (options_.report_contacts) buffers.make(Slot::told, room * sizeof(ContactTold));
  buffers.grow(Slot::kept_stretch, room * vec4());
  buffers.grow(Slot::kept_geometry, room * 2 * vec4());
  buffers.grow(Slot::kept_feature, room * sizeof(std::uint32_t));
}

// Larger buffers for what was too small; the GPU may go on then.
void DeviceStep::make_room(const Counters& c) {
  const auto more = [](std::uint32_t needed, std::uint32_t room) {
    return static_cast<std::uint32_t>(kMoreRoom * std::max(needed, room / 2)) + 1024;
  };
  if ((c.overflow & loops_cut) != 0) {
    throw Error(ErrorKind::no_context,
                "this OpenGL driver ends a shader's loops before all contacts are found, as software drivers "
                "do where "
                "shapes have many faces: --device cpu");
  }
  if ((c.overflow & too_many_pairs) != 0) make_pair_buffers(std::max(pair_room_, more(c.pairs, pair_room_)));
  if ((c.overflow & too_many_contacts) != 0)
    make_contact_buffers(std::max(contact_room_, more(c.raw, contact_room_)));
  if ((c.overflow & too_many_colors) != 0) {
    if (color_limit_ == kColors) {
      throw Error(ErrorKind::no_context, "the bodies that touch each other need more than " +
                                             std::to_string(kColors) + " colors: --device cpu");
    }
    color_limit_ = kColors;
  }
  if ((c.overflow & too_few_rounds) != 0) rounds_ *= 2;
  for (std::uint32_t share = 0; share < kShares; ++share)
    if ((c.overflow & share_unexpected << share) != 0) make_sweep(share);
  buffers.clear(Slot::counters, 0, sizeof(Counters::overflow));
}

}  // namespace pabd::device
