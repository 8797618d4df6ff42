// SPDX-License-Identifier: MIT
// See no_collide.h.
#include "sim/scene/no_collide.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/scene/fields.h"
#include "sim/scene/text.h"

namespace pabd {
namespace {

constexpr std::size_t kMostPairs = 8'000'000;  // as joints

// One of the two of an entry of "no_collide".
struct Side {
  Index body = kWorld;
  int group = -1;
};

struct PairReader {
  const ObjectReader& scene;
  const BodyNames& names;
  ModelBuilder& out;
  std::size_t pairs = 0;  // of bodies, so far

  int group(const Node& node) const {
    static const auto kKeys = keys_of_entry(spec::Group{});
    const ObjectReader in(node, kKeys);
    const Node named = in.require("group", "the name of a group");
    const std::string name = named.name();
    const auto& all = out.model.groups.name;
    const auto at = std::find(all.begin(), all.end(), name);
    if (at == all.end()) {
      const std::vector<std::string_view> known(all.begin(), all.end());
      named.fail(fmt::format("no body is of a group {}{}", in_quotes(name), did_you_mean(name, known)));
    }
    scene.record("no_collide", name);
    return static_cast<int>(at - all.begin());
  }

  Side side(const Node& node) const {
    if (node.value().is_object()) return {kWorld, group(node)};
    if (!node.value().is_string()) node.fail_expected("the name of a body, or { \"group\": its name }");
    const Index body = body_of(node, names, out.model);
    scene.record("no_collide", static_cast<double>(body));
    return {body, -1};
  }

  void keep_apart(const Node& pair, Index i, Index j) {
    if (++pairs > kMostPairs) pair.fail(fmt::format("more than {} pairs; expected two groups", kMostPairs));
    out.keep_apart(i, j);
  }

  void read(const Node& pair) {
    if (pair.array_size() != 2) pair.fail_expected("two names of bodies");
    Side a = side(pair.element(0)), b = side(pair.element(1));
    if (a.group >= 0) std::swap(a, b);
    if (a.group >= 0) return out.keep_groups_apart(a.group, b.group);
    if (b.group < 0) {
      if (a.body == b.body) pair.fail("a body never touches itself; expected two different bodies");
      return keep_apart(pair, a.body, b.body);
    }
    const auto& of_body = out.model.groups.of_body;
    for (std::size_t i = 0; i < of_body.size(); ++i) {
      if ((of_body[i] >> b.group & 1) != 0 && static_cast<Index>(i) != a.body)
        keep_apart(pair, a.body, static_cast<Index>(i));
    }
  }
};

}  // namespace

void read_no_collide(const ObjectReader& scene, const BodyNames& names, ModelBuilder& out) {
  const auto list = scene.find("no_collide");
  if (!list) return;
  const std::size_t count = list->array_size();
  if (count > kMostPairs) list->fail(fmt::format("{} pairs; expected at most {}", count, kMostPairs));
  scene.record("no_collide", static_cast<double>(count));
  PairReader reader{scene, names, out};
  for (std::size_t k = 0; k < count; ++k) reader.read(list->element(k));
}

}  // namespace pabd
