// See read_memory.h.
#include "sim/scene/read_memory.h"

#include <fmt/format.h>

#include "sim/scene/keys.h"

namespace pabd {
namespace {

FrictionAnchor read_anchor(const Node& node, Index count) {
  const ObjectReader in(node, keys::friction_anchor);
  const Node pair = in.require("bodies", "two body numbers");
  if (pair.array_size() != 2) pair.fail_expected("two body numbers");
  const std::int64_t a = pair.element(0).integer(0, count - 1);
  const std::int64_t b = pair.element(1).integer(0, count - 1);
  if (a >= b) pair.fail("expected two body numbers in rising order");
  FrictionAnchor anchor;
  anchor.pair = (static_cast<std::uint64_t>(a) << 32) | static_cast<std::uint64_t>(b);
  anchor.feature = static_cast<std::uint32_t>(in.integer("feature", 0, 0xffffffff));
  anchor.stretch = in.vec3("stretch", Range{});
  anchor.sliding = in.boolean("sliding", false);
  anchor.recovers = in.boolean("recovers", false);
  anchor.restless = in.boolean("restless", false);
  return anchor;
}

bool before(const FrictionAnchor& a, const FrictionAnchor& b) {
  return a.pair != b.pair ? a.pair < b.pair : a.feature < b.feature;
}

}  // namespace

void read_anchors(const Node& list, Index count, std::vector<FrictionAnchor>& out) {
  const std::size_t n = list.array_size();
  for (std::size_t i = 0; i < n; ++i) {
    const Node node = list.element(i);
    out.push_back(read_anchor(node, count));
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
