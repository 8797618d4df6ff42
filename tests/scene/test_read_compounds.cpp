// SPDX-License-Identifier: MIT
// Lists of meshes in scene files: one body of several parts.
#include "sim/body/compound.h"
#include "sim/scene/mesh_library.h"
#include "tests/scene/scene_helpers.h"
#include "tests/support/places.h"

namespace pabd::test_read_compounds {

using namespace test;

namespace {

const std::filesystem::path kMeshes = std::filesystem::path(places::assets()) / "meshes";

Scene load(const std::string& files) {
  return parse_scene(only_body(R"({ "position": [1, 2, 3], "density": 600, "shape": { "type": "mesh",
      "file": )" + files + R"(, "scale": 2 } }, { "shape": { "type": "mesh", "file": )" +
                               files + R"(, "scale": 2 } })"),
                     "test.json", kMeshes, {});
}

const char* const kChair = R"(["chair_seat.obj", "chair_left.obj", "chair_right.obj", "chair_back.obj"])";

}  // namespace

TEST_CASE("a list of meshes is one body with its origin in the common centre of mass", "[mesh]") {
  const Scene scene = load(kChair);
  REQUIRE(scene.model.size() == 2);
  CHECK(scene.initial.c[0] == Vec3(1, 2, 3));
  const CompoundData& chair = *std::get<Compound>(scene.model.shape[0]).data;
  CHECK(&chair == std::get<Compound>(scene.model.shape[1]).data.get());  // made once
  REQUIRE(chair.parts.size() == 4);
  // Boards of 0.5 × 0.05 × 0.5, twice 0.05 × 0.42 × 0.5, and 0.5 × 0.48 × 0.05, all times two.
  const double seat = 0.0125, side = 0.0105, back = 0.012;
  CHECK(scene.model.mass[0] == Approx(600 * 8 * (seat + 2 * side + back)).epsilon(1e-12));
  const double y = (seat * 0.445 + 2 * side * 0.21 + back * 0.71) / (seat + 2 * side + back);
  const double z = back * -0.225 / (seat + 2 * side + back);
  CHECK((chair.centroid - 2 * Vec3(0, y, z)).norm() < 1e-12);
}

TEST_CASE("the hash follows every part; a list of one is the mesh", "[mesh]") {
  CHECK(load(kChair).hash == load(kChair).hash);
  CHECK(load(R"(["chair_seat.obj", "chair_left.obj"])").hash !=
        load(R"(["chair_seat.obj", "chair_right.obj"])").hash);
  const Scene single = load(R"(["chair_seat.obj"])");
  CHECK(std::holds_alternative<Hull>(single.model.shape[0]));
  CHECK(single.hash == load(R"("chair_seat.obj")").hash);
}

TEST_CASE("shipped parts fit together: they touch and do not overlap", "[mesh]") {
  MeshLibrary meshes(kMeshes);
  const Compound bowl = meshes.load_parts(
      {"bowl_floor.obj", "bowl_east.obj", "bowl_north.obj", "bowl_west.obj", "bowl_south.obj"}, 1);
  CHECK(std::abs(bowl.data->centroid.x()) < 1e-12);
  CHECK(std::abs(bowl.data->centroid.z()) < 1e-12);
  // Floor 1 × 0.08 × 1; the walls are a frustum of squares 1.16 to 1.6 less one of 1 to 1.44, 0.55 high.
  const auto frustum = [](double a, double b) { return 0.55 / 3 * (a * a + a * b + b * b); };
  CHECK(bowl.data->volume == Approx(0.08 + frustum(1.16, 1.6) - frustum(1, 1.44)).epsilon(1e-9));
}

}  // namespace pabd::test_read_compounds
