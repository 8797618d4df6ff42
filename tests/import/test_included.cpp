// SPDX-License-Identifier: MIT
// A robot as a part of a scene, and friction of its single bodies.
#include "tests/import/import_helpers.h"
#include "tests/support/temp_folder.h"

namespace pabd::test_included {

using namespace test;

TEST_CASE("a scene includes a robot, whose notes are told", "[import]") {
  const TempFolder folder;
  write_bytes(folder / "cart.urdf", R"(<robot name="cart">
  <link name="base"><inertial><mass value="2"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>
    <collision><geometry><box size="1 0.4 0.2"/></geometry></collision></link>
  <transmission name="t"/>
</robot>)");
  const std::string text = R"({ "format": "pabd-scene", "version": 1, "includes": [
    { "scene": "cart.urdf", "prefix": "a.", "position": [0, 5, 0] },
    { "scene": "cart.urdf", "prefix": "b.", "position": [3, 5, 0] } ] })";
  write_bytes(folder / "scene.json", text);
  std::vector<ImportNote> notes;
  const Scene scene = load_any_scene(folder / "scene.json", {}, &notes);
  REQUIRE(scene.model.name == std::vector<std::string>{"a.base", "b.base"});  // without a ground of their own
  CHECK(scene.model.mass[1] == 2);
  CHECK((scene.initial.c[1] - Vec3(3, 5, 0)).norm() < 1e-12);
  const auto told = [&](const char* part) {
    return std::count_if(notes.begin(), notes.end(),
                         [&](const ImportNote& note) { return note.text.find(part) != std::string::npos; });
  };
  CHECK(told("<transmission>") == 1);
  std::vector<std::string> files;
  for (const auto& file : scene.files) files.push_back(file.filename().string());
  CHECK(std::count(files.begin(), files.end(), "cart.urdf") == 1);
  CHECK(parse_any_scene(text, "scene.json", folder.path()).hash == scene.hash);

  write_bytes(folder / "cart.urdf", "<robot name='cart'>\n<link name='base'>\n</robot>");
  try {
    parse_any_scene(text, "scene.json", folder.path());
    FAIL_CHECK("accepted");
  } catch (const Error& error) {
    CHECK_THAT(error.what(), Catch::StartsWith("scene.json: /includes/0/scene: cart.urdf:"));
    CHECK_THAT(error.what(), !Catch::Contains(folder.path().string()));
  }
}

TEST_CASE("bodies of an MJCF file have friction of their own, and the larger one of two counts", "[import]") {
  const ImportedScene robot = import_robot_text(R"(<mujoco><worldbody>
      <geom name="floor" type="plane" size="1 1 1"/>
      <body name="a" pos="0 0 1"><freejoint/><geom type="box" size=".1 .1 .1" friction="0.4"/></body>
      <body name="b" pos="1 0 1"><freejoint/><geom type="box" size=".1 .1 .1"/></body>
      <body name="c" pos="2 0 1"><freejoint/><geom type="box" size=".1 .1 .1" friction="0.2"/>
        <geom type="box" pos="0 0 .2" size=".1 .1 .1" friction="0.3"/></body>
    </worldbody></mujoco>)",
                                                "r.xml", "/nowhere");
  const Scene scene = parse_scene(robot.text, "r", {});
  CHECK(scene.params.contact.friction_rule == FrictionRule::max);
  CHECK(scene.params.contact.mu_static == 1);
  const auto friction_of = [&](const std::string& name) {
    const auto& names = scene.model.name;
    return scene.model.friction.at(
        static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin()));
  };
  CHECK(friction_of("a") == SurfaceFriction{0.4, 0.4});
  CHECK_FALSE(friction_of("b"));
  CHECK(friction_of("c") == SurfaceFriction{0.3, 0.3});
  CHECK(note_with(robot, "geoms of one body with different friction").where.size() == 1);
}

}  // namespace pabd::test_included
