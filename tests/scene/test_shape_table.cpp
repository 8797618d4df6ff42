// SPDX-License-Identifier: MIT
// Every shape of the table that is given by its sizes: read, refused, written and read again, generated, and
// offered by the schema.
#include <nlohmann/json.hpp>
#include <set>

#include "sim/body/mass_properties.h"
#include "sim/body/shape_kind.h"
#include "sim/scene/write_scene.h"
#include "tests/scene/scene_helpers.h"
#include "tests/support/files.h"
#include "tests/support/places.h"

namespace pabd::test_shape_table {

using namespace test;

namespace {

using Json = nlohmann::json;

std::vector<const ShapeKind*> sized_kinds() {
  std::vector<const ShapeKind*> out;
  for (const ShapeKind* kind : shape_kinds())
    if (kind->make) out.push_back(kind);
  return out;
}

// The shape with sizes 0.5, 0.75, 1 in the order of its keys.
Json sized(const ShapeKind& kind) {
  Json out{{"type", kind.name}};
  double next = 0.5;
  for (const ShapeSize& size : kind.sizes) {
    Json numbers = Json::array();
    for (int k = 0; k < size.count; ++k, next += 0.25) numbers.push_back(next);
    out[std::string(size.key)] = size.count == 1 ? numbers[0] : numbers;
  }
  return out;
}

Scene scene_of(const Json& shape) { return parse(only_body(Json{{"shape", shape}}.dump())); }

std::set<std::string> words(const Json& list) { return list.get<std::set<std::string>>(); }

}  // namespace

TEST_CASE("a shape is read by its keys, and says the same when it is written", "[scene]") {
  for (const ShapeKind* kind : sized_kinds()) {
    INFO(kind->name);
    const Scene first = scene_of(sized(*kind));
    CHECK(&kind_of(first.model.shape[0]) == kind);
    const Sizes sizes = kind->sizes_of(first.model.shape[0]);
    CHECK(sizes[0] == 0.5);
    CHECK(first.model.mass[0] == Approx(1000 * volume(first.model.shape[0])).epsilon(1e-15));
    const Scene again = parse(scene_to_json(first.model, first.initial, first.params, first.joint_law,
                                            first.name, std::nullopt, std::nullopt));
    CHECK(&kind_of(again.model.shape[0]) == kind);
    CHECK(kind->sizes_of(again.model.shape[0]) == sizes);
    CHECK(text_of(first.model.shape[0]).starts_with(kind->name));
  }
}

TEST_CASE("a shape without one of its sizes, with a wrong one or another key is refused", "[scene]") {
  for (const ShapeKind* kind : sized_kinds()) {
    for (const ShapeSize& size : kind->sizes) {
      const std::string key(size.key);
      Json shape = sized(*kind);
      shape.erase(key);
      check_refused(only_body(Json{{"shape", shape}}.dump()), {"/bodies/0/shape/" + key, "missing"});
      shape[key] = size.count == 1 ? Json(0) : Json({1, 0, 1});
      check_refused(only_body(Json{{"shape", shape}}.dump()), {"/bodies/0/shape/" + key, "1e-06", "(m)"});
    }
    Json shape = sized(*kind);
    shape["colour"] = 1;
    check_refused(only_body(Json{{"shape", shape}}.dump()), {"/bodies/0/shape", "colour"});
  }
  check_refused(only_body(R"({ "shape": { "size": [1, 1, 1] } })"), {"/shape/type", "\"box\"", "\"mesh\""});
}

TEST_CASE("piles and chains are made of every shape that may be a rod; links touch end to end", "[scene]") {
  for (const ShapeKind* kind : sized_kinds()) {
    if (!kind->rod) continue;
    const std::string name(kind->name);
    INFO(name);
    const Scene pile = parse(
        generated(R"({ "type": "pile", "count": 3, "size": [0.4, 1, 0.8], "shape": ")" + name + "\" }"));
    const Aabb box = bounds(pile.model.shape[0], Vec3::Zero(), Mat3::Identity());
    CHECK((box.hi - box.lo - Vec3(0.3, 1, 0.3)).norm() < 1e-12);

    const Scene chain = parse(generated(
        R"({ "type": "chain", "links": 3, "size": [0.5, 0.1, 0.1], "position": [1, 0, 0], "shape": ")" +
        name + "\" }"));
    REQUIRE(chain.model.size() == 3);
    for (std::size_t k = 0; k < 3; ++k) {
      const Aabb link = bounds(chain.model.shape[k], chain.initial.c[k], chain.initial.R[k]);
      CHECK(link.lo.x() == Approx(1 + 0.5 * static_cast<double>(k)).epsilon(1e-12));
      CHECK(link.hi.x() == Approx(1.5 + 0.5 * static_cast<double>(k)).epsilon(1e-12));
    }
  }
}

TEST_CASE("the schema offers the shapes of the program", "[scene]") {
  const Json defs =
      Json::parse(read_bytes(std::filesystem::path(places::assets()) / "pabd-scene.schema.json"))["$defs"];
  std::set<std::string> all, generated{"box", "sphere"}, offered;
  for (const ShapeKind* kind : shape_kinds()) {
    all.insert(std::string(kind->name));
    if (kind->rod) generated.insert(std::string(kind->name));
  }
  for (const Json& reference : defs["body"]["properties"]["shape"]["oneOf"])
    offered.insert(reference["$ref"].get<std::string>().substr(std::string("#/$defs/").size()));
  CHECK(offered == all);
  CHECK(words(defs["chain"]["properties"]["shape"]["enum"]) == generated);
  generated.insert("mixed");
  CHECK(words(defs["pile"]["properties"]["shape"]["enum"]) == generated);
  for (const ShapeKind* kind : sized_kinds()) {
    for (const ShapeSize& size : kind->sizes) {
      const Json key = defs[std::string(kind->name)]["properties"][std::string(size.key)];
      const Json& number = size.count == 1 ? key : key["items"];
      CHECK(number["minimum"] == 1e-6);
      CHECK(number["maximum"] == 1e6);
      if (size.count > 1) CHECK(key["maxItems"] == size.count);
    }
  }
}

}  // namespace pabd::test_shape_table
