// SPDX-License-Identifier: MIT
// See read_memory.h.
#include "sim/scene/read_memory.h"

#include <fmt/format.h>

namespace pabd {
namespace {

ContactMemory read_contact(const Node& node, Index count) {
  static const auto kKeys = keys_of_entry(FrictionAnchor{});
  const ObjectReader in(node, kKeys);
  FrictionAnchor entry;
  entry.fields(FieldReader(in), count);
  const auto [a, b] = entry.bodies;
  if (a >= b) in.fail_key("bodies", "expected two body numbers in rising order");
  ContactMemory contact;
  contact.pair = (static_cast<std::uint64_t>(a) << 32) | static_cast<std::uint64_t>(b);
  contact.feature = static_cast<std::uint32_t>(entry.feature);
  contact.stretch = entry.stretch;
  contact.sliding = entry.sliding;
  contact.recovers = entry.recovers;
  contact.restless = entry.restless;
  return contact;
}

bool before(const ContactMemory& a, const ContactMemory& b) {
  return a.pair != b.pair ? a.pair < b.pair : a.feature < b.feature;
}

}  // namespace

void read_memory_of_contacts(const Node& list, Index count, std::vector<ContactMemory>& out) {
  const std::size_t n = list.array_size();
  for (std::size_t i = 0; i < n; ++i) {
    const Node node = list.element(i);
    out.push_back(read_contact(node, count));
    if (i > 0 && !before(out[i - 1], out[i])) {
      node.fail("expected anchors in rising order of bodies and feature, each once");
    }
  }
}

void read_joint_forces(const Node& list, std::size_t joints, std::vector<Vec3>& out) {
  const std::size_t n = list.array_size();
  if (n != joints) list.fail(fmt::format("expected a force for each of {} joints, got {}", joints, n));
  for (std::size_t k = 0; k < n; ++k) out.push_back(list.element(k).vec3(Range{}));
}

}  // namespace pabd
