// SPDX-License-Identifier: MIT
// Shapes as shaders see them, and those that they cannot take.
#include <bit>
#include <catch2/catch.hpp>

#include "render/device/narrow_parts.h"
#include "sim/body/compound.h"
#include "sim/body/convex_hull.h"
#include "sim/body/shape_kind.h"
#include "tests/collision/reference.h"

namespace pabd::test_shape_table {

using namespace reference;

namespace {

Model model_of(const std::vector<Shape>& shapes) {
  Setup setup;
  for (const Shape& shape : shapes) setup.add(shape, Vec3::Zero());
  return setup.model;
}

}  // namespace

TEST_CASE("equal shapes share a record, hulls made twice too") {
  const Shape shapes[] = {
      Box{{0.3, 0.5, 0.4}}, Sphere{0.3},          Capsule{0.3, 0.5}, Plane{Vec3::UnitY(), 0.3},
      rock(12, 0.5, 1),     Box{{0.5, 0.3, 0.4}}, Sphere{0.5},       rock(12, 0.5, 2)};
  std::vector<Shape> all;
  for (int k = 0; k < 1000; ++k) all.push_back(shapes[k % 8]);
  all.push_back(rock(12, 0.5, 1));
  const ShapeTable table = make_shape_table(model_of(all));
  REQUIRE(table.shapes.size() == 8);
  REQUIRE(table.of_body.size() == all.size());
  for (std::uint32_t k = 0; k < 1000; ++k) REQUIRE(table.of_body[k] == k % 8);
  CHECK(table.of_body[1000] == 4);
  CHECK(table.shapes[0].size[3] == 0.3);
  CHECK(table.shapes[2].size[1] == 0.5);
  for (std::uint32_t k = 0; k < 8; ++k) CHECK(table.shapes[k].kind == all[k].index());
}

TEST_CASE("the words of a hull are its vertices, faces, corners and edges") {
  const Shape shape = rock(12, 0.5, 1);
  const HullData& hull = *std::get_if<Hull>(&shape)->data;
  const ShapeTable table = make_shape_table(model_of({Sphere{1}, shape}));
  const ShapeRecord& record = table.shapes[1];
  REQUIRE(record.vertices == hull.vertices.size());
  REQUIRE(record.faces == hull.faces.size());
  REQUIRE(record.corners == hull.loop.size());
  REQUIRE(record.edges == hull.edges.size());
  CHECK(record.size[0] == hull.bounding_radius);
  CHECK(record.size[3] == hull.inner_radius);
  CHECK(table.hulls.size() ==
        record.first + 3 * record.vertices + 5 * record.faces + record.corners + 2 * record.edges);
  const std::uint64_t* words = &table.hulls[record.first];
  CHECK(std::bit_cast<double>(words[3 * 5 + 1]) == hull.vertices[5].y());
  const std::uint64_t* face = words + 3 * record.vertices + 5 * 2;
  CHECK(std::bit_cast<double>(face[3]) == hull.faces[2].offset);
  CHECK(face[4] == (hull.faces[2].first | std::uint64_t{hull.faces[2].count} << 32));
  const std::uint64_t* edge = words + 3 * record.vertices + 5 * record.faces + record.corners + 2 * 3;
  CHECK(edge[0] == (hull.edges[3].from | std::uint64_t{hull.edges[3].to} << 32));
  CHECK(edge[1] == (hull.edges[3].left | std::uint64_t{hull.edges[3].right} << 32));
}

TEST_CASE("the record of a round solid is the hull that stands for it, with the ends of the solid") {
  const ShapeTable table = make_shape_table(model_of(
      {make_shape("cylinder", {0.4, 1}), make_shape("cone", {0.3, 0.8}), make_shape("cone", {0.3, 0.8})}));
  CHECK(table.has_solids);
  REQUIRE(table.shapes.size() == 2);
  CHECK(table.of_body[2] == 1);
  const double ends[2][4] = {{-0.5, 0.4, 0.5, 0.4}, {-0.2, 0.3, 0.6, 0}};
  const std::uint32_t vertices[2] = {64, 33};
  for (std::size_t k = 0; k < 2; ++k) {
    CHECK(table.shapes[k].kind == kDeviceHull);
    CHECK(table.shapes[k].vertices == vertices[k]);
    for (std::size_t i = 0; i < 4; ++i)
      CHECK(std::bit_cast<double>(table.hulls[table.shapes[k].ends + i]) == Approx(ends[k][i]));
  }
  const ShapeTable flat = make_shape_table(model_of({rock(12, 0.5, 1)}));
  CHECK(!flat.has_solids);
  CHECK(flat.shapes[0].ends == 0);
}

TEST_CASE("the record of a compound lists its parts, which have records of their own") {
  const auto stone = [](unsigned seed) { return std::get<Hull>(rock(8, 0.5, seed)); };
  const Shape shape = make_compound({stone(1), stone(2), stone(1)});
  const auto& parts = std::get<Compound>(shape).data->parts;
  const ShapeTable table = make_shape_table(model_of({shape, Sphere{1}, shape, stone(2)}));
  REQUIRE(table.shapes.size() == 4);  // two stones, the compound, the ball
  const ShapeRecord& record = table.shapes[table.of_body[0]];
  CHECK(table.of_body[2] == table.of_body[0]);
  CHECK(record.kind == kDeviceCompound);
  REQUIRE(record.parts == 3);
  const std::uint64_t* words = &table.hulls[record.first];
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t i = 0; i < 3; ++i)
      CHECK(std::bit_cast<double>(words[4 * k + i]) == parts[k].offset[static_cast<Index>(i)]);
    CHECK(table.shapes[words[4 * k + 3]].kind == kDeviceHull);
  }
  CHECK(words[3] == words[11]);
  CHECK(words[7] == table.of_body[3]);
}

TEST_CASE("bodies that the GPU cannot take are named") {
  const Shape many = [] {
    std::vector<Vec3> points;
    for (int k = 0; k < 31; ++k)
      for (const double y : {-0.5, 0.5}) points.emplace_back(std::cos(0.2 * k), y, std::sin(0.2 * k));
    return Shape(Hull{make_hull(points).hull});
  }();
  CHECK(why_not_on_device(model_of({Box{{1, 1, 1}}, Sphere{1}, Capsule{1, 1}, rock(12, 0.5, 1)})).empty());
  CHECK(why_not_on_device(Model{}).empty());
  CHECK(why_not_on_device(model_of({Sphere{1}, many, make_shape("cone", {1, 1})})) ==
        "body 'body 1' has 33 faces, the GPU takes at most 32");
  const Shape rocks = make_compound({std::get<Hull>(rock(8, 0.5, 1)), std::get<Hull>(rock(8, 0.5, 2))});
  CHECK(why_not_on_device(model_of({rocks})).empty());
  const Shape rough = make_compound({std::get<Hull>(rock(8, 0.5, 1)), std::get<Hull>(many)});
  CHECK(why_not_on_device(model_of({rocks, rough})) ==
        "body 'body 1' has 33 faces in one part, the GPU takes at most 32");
  CHECK(why_not_on_device(model_of({make_shape("cylinder", {1, 1}), make_shape("cone", {1, 1})})).empty());
}

TEST_CASE("every pair of kinds has its shader, but two planes") {
  for (int i = 0; i < kDeviceShapes; ++i) {
    for (int j = 0; j < kDeviceShapes; ++j) {
      CAPTURE(i, j);
      const auto parts = narrow_parts(i, j, true), swapped = narrow_parts(j, i, true);
      REQUIRE(parts.size() == swapped.size());
      CHECK((parts.size() >= 3) == !(i == kDevicePlane && j == kDevicePlane));
      for (std::size_t k = 0; k < parts.size(); ++k) CHECK(std::string(parts[k].file) == swapped[k].file);
    }
  }
}

}  // namespace pabd::test_shape_table
