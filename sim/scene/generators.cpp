// SPDX-License-Identifier: MIT
// Picks the generator of each entry of "generate". See generators.h.
#include "sim/scene/generators.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "sim/base/error.h"
#include "sim/scene/fields.h"

namespace pabd {

std::span<const std::string_view> spec::generated_shape_words(bool mixed) {
  static const std::vector<std::string_view> kWords = [] {
    std::vector<std::string_view> out;
    for (const ShapeKind* kind : shape_kinds())
      if (kind->name == "box" || kind->name == "sphere" || kind->rod) out.push_back(kind->name);
    out.emplace_back("mixed");
    return out;
  }();
  return std::span(kWords).first(kWords.size() - (mixed ? 0 : 1));
}

const ShapeKind& generated_kind(std::string_view word) {
  const auto kinds = shape_kinds();
  return **std::find_if(kinds.begin(), kinds.end(),
                        [&](const ShapeKind* kind) { return kind->name == word; });
}

Shape generated_shape(const ShapeKind& kind, const Vec3& box, double diameter, const RodSize& rod) {
  if (kind.rod) return kind.rod(rod.length, rod.thickness);
  if (kind.name == "box") return Box{0.5 * box};
  return Sphere{diameter / 2};
}

void run_generators(const ObjectReader& scene, double d_hat, bool assumed, ModelBuilder& out) {
  const auto list = scene.find("generate");
  if (!list) return;
  std::vector<std::string_view> types;
  for_each_generator([&](const auto& entry) { types.push_back(entry.type); });
  std::map<std::string_view, int> used;  // how often each type was seen, so that default names differ
  const std::size_t count = list->array_size();
  for (std::size_t i = 0; i < count; ++i) {
    const Node node = list->element(i);
    const std::string_view type = types[type_of_entry(node, types)];
    const int n = ++used[type];
    for_each_generator([&](auto entry) {
      if (entry.type != type) return;
      const std::size_t first = out.model.name.size();
      const auto keys = keys_of_entry(entry);
      const ObjectReader in(node, keys);
      in.record("generate", type);
      try {
        entry.fields(FieldReader(in, d_hat));
        generate(entry, {in, d_hat, n == 1 ? std::string(type) : fmt::format("{}{}", type, n), out});
      } catch (const Error&) {
        if (assumed) throw GapsInDoubt();
        throw;
      }
      if constexpr (requires { entry.bricks; }) {
        out.set_touch(first, touch_of(entry.bricks), in);
      } else {
        out.set_touch(first, touch_of(entry), in);
      }
    });
  }
}

}  // namespace pabd
