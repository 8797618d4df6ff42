// SPDX-License-Identifier: MIT
// Picks the generator of each entry of "generate". See generators.h.
#include "sim/scene/generators.h"

#include <fmt/format.h>

#include <iterator>

#include "sim/base/error.h"
#include "sim/body/shape_kind.h"
#include "sim/scene/keys.h"
#include "sim/scene/read_touch.h"
#include "sim/scene/text.h"

namespace pabd {

namespace {

using Function = void (*)(const ObjectReader&, const GeneratorContext&, ModelBuilder&);

struct Generator {
  std::string_view type;
  std::span<const std::string_view> keys;
  Function function;
};

constexpr Generator kGenerators[] = {
    {"stack", keys::stack, generate_stack},       {"wall", keys::wall, generate_wall},
    {"pyramid", keys::pyramid, generate_pyramid}, {"pile", keys::pile, generate_pile},
    {"chain", keys::chain, generate_chain},       {"net", keys::net, generate_net}};

const Generator& find_generator(const Node& node) {
  if (!node.value().is_object()) node.fail_expected("an object with a \"type\"");
  Choice choices[std::size(kGenerators)];
  std::vector<std::string_view> words;
  for (std::size_t i = 0; i < std::size(kGenerators); ++i) {
    choices[i] = {kGenerators[i].type, static_cast<int>(i)};
    words.push_back(kGenerators[i].type);
  }
  const auto it = node.value().find("type");
  if (it == node.value().end()) {
    fail_at(node.context(), node.pointer() + "/type", "missing; expected " + one_of(words));
  }
  return kGenerators[Node(*it, node, "type").choice(choices)];
}

}  // namespace

bool is_rod(int kind) { return shape_kinds()[static_cast<std::size_t>(kind)]->rod != nullptr; }

std::vector<Choice> generated_shapes() {
  std::vector<Choice> out;
  for (std::size_t k = 0; k < shape_kinds().size(); ++k) {
    const ShapeKind& kind = *shape_kinds()[k];
    if (kind.name == "box" || kind.name == "sphere" || kind.rod)
      out.push_back({kind.name, static_cast<int>(k)});
  }
  return out;
}

Shape generated_shape(int kind, const Vec3& box, double diameter, const RodSize& rod) {
  const ShapeKind& row = *shape_kinds()[static_cast<std::size_t>(kind)];
  if (row.rod) return row.rod(rod.length, rod.thickness);
  if (row.name == "box") return Box{0.5 * box};
  return Sphere{diameter / 2};
}

void run_generators(const ObjectReader& scene, double d_hat, bool assumed, ModelBuilder& out) {
  const auto list = scene.find("generate");
  if (!list) return;
  const std::size_t count = list->array_size();
  int used[std::size(kGenerators)] = {};  // how often each type was seen, so that default names differ
  for (std::size_t i = 0; i < count; ++i) {
    const Node node = list->element(i);
    const Generator& generator = find_generator(node);
    const ObjectReader in(node, generator.keys);
    in.record("generate", generator.type);
    const int n = ++used[&generator - kGenerators];
    const std::string prefix = n == 1 ? std::string(generator.type) : fmt::format("{}{}", generator.type, n);
    const std::size_t first = out.model.name.size();
    try {
      generator.function(in, {d_hat, prefix}, out);
    } catch (const Error&) {
      if (assumed) throw GapsInDoubt();
      throw;
    }
    out.set_touch(first, read_touch(in), in);
  }
}

}  // namespace pabd
