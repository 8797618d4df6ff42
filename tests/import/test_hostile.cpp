// SPDX-License-Identifier: MIT
// Files of strangers: refused in one line with file and line, within limits, and nothing is read that may not be.
#include <fstream>

#include "tests/import/import_helpers.h"
#include "tests/support/places.h"
#include "tests/support/temp_folder.h"

namespace pabd::test_hostile {

using namespace test;

namespace {

void check_refused(const std::string& text, const std::vector<std::string>& parts) {
  INFO(text.substr(0, 300));
  try {
    import_robot_text(text, "robot.xml", "/nowhere");
  } catch (const Error& error) {
    const std::string message = error.what();
    CHECK(error.kind() == ErrorKind::bad_input);
    CHECK_THAT(message, Catch::StartsWith("robot.xml"));
    CHECK(message.find('\n') == std::string::npos);
    for (const std::string& part : parts) CHECK_THAT(message, Catch::Contains(part));
    return;
  }
  FAIL_CHECK("accepted; expected a refusal");
}

std::string repeated(const std::string& text, int count) {
  std::string out;
  for (int k = 0; k < count; ++k) out += text;
  return out;
}

std::string world(const std::string& inside) {
  return "<mujoco><worldbody>\n" + inside + "</worldbody></mujoco>";
}

}  // namespace

TEST_CASE("what is no robot is refused", "[import]") {
  check_refused("", {"no XML"});
  check_refused("<robot", {"well-formed"});
  check_refused("<sdf/>", {"robot.xml:1", "<robot> of URDF or <mujoco> of MJCF"});
  check_refused("<robot name='r'/>", {"<link>"});
  check_refused("<mujoco/>", {"no bodies"});
}

TEST_CASE("attributes and names have bounds, and nothing is compared with everything", "[import]") {
  const auto attributes = [](int count) {
    std::string out;
    for (int k = 0; k < count; ++k) out += " a" + std::to_string(k) + (k % 2 == 0 ? "='1'" : "=\">\"");
    return out;
  };
  // A million of them are refused as fast as they are read: compared in pairs, they would take an hour.
  for (const int count : {1001, 1'000'000})
    check_refused(world("<!-- a='1' -->\n<body" + attributes(count) + "/>"),
                  {"robot.xml:3", "more than 1000 attributes"});
  check_refused(world("<body" + attributes(1000) + "/>"), {"no bodies"});
  check_refused(world("<!--" + attributes(5000) + "--><![CDATA[<" + attributes(5000) + "]]>"), {"no bodies"});
  check_refused("<mujoco><include file='" + repeated("a", 5000) + "'/></mujoco>",
                {"<include> file", "5000 bytes long"});
  for (const char* open : {"<robot a='1", "<robot a=\"'", "<!-- ", "<![CDATA[ ", "<", "<robot a="})
    check_refused(open, {});
}

TEST_CASE("numbers are finite and in range", "[import]") {
  for (const char* bad : {"nan", "inf", "1e400", "0x1", "1,0", "1e13", ""}) {
    check_refused(world("<geom size='" + std::string(bad) + "'/>"), {"robot.xml:2", "<geom> size"});
  }
  check_refused(world("<geom size='-1'/>"), {"size"});
  check_refused(world("<body><geom size='1' mass='-1'/><freejoint/></body>"), {"negative"});
  check_refused(world("<body quat='0 0 0 0'><geom size='1'/></body>"), {"quat", "length is 0"});
  check_refused(world("<body><joint axis='0 0 0'/><geom size='1'/></body>"), {"axis"});
}

TEST_CASE("sizes, depths and counts have bounds", "[import]") {
  check_refused(repeated("<a>", 5000) + repeated("</a>", 5000), {"nested too deeply"});
  check_refused("<mujoco>" + repeated("<a/>", 200001) + "</mujoco>", {"elements"});
  check_refused(world(repeated("<body><geom size='1'/><freejoint/></body>", 5001)), {"bodies"});
  check_refused("<mujoco>" + std::string(std::size_t{17} << 20, ' ') + "</mujoco>", {"bytes"});
}

TEST_CASE("many that are called the same, or nested by files in files, cost no more than others",
          "[import]") {
  check_refused(world("<body><geom size='1'/>" + repeated("<joint/>", 7) + "</body>"),
                {"more than 6 joints"});
  check_refused("<mujoco><default>" + repeated("<geom/>", 101) + "</default></mujoco>",
                {"more than 100 defaults"});
  check_refused("<mujoco><default>" + repeated("<geom/>", 60) + "<default class='a'>" +
                    repeated("<geom/>", 60) +
                    "</default></default><worldbody><geom class='a' size='1'/></worldbody></mujoco>",
                {"more than 100 defaults"});
  // Names of which each is tried once: quadratic, these took minutes.
  const ImportedScene loops = import_robot_text(
      "<mujoco><worldbody><body name='a'><geom size='1'/><freejoint/></body></worldbody><equality>" +
          repeated("<connect body1='a' anchor='0 0 0'/>", 20000) + "</equality></mujoco>",
      "loops.xml", "/nowhere");
  CHECK(loops.text.find("\"loop 20000\"") != std::string::npos);

  const TempFolder folder;
  const std::string frames =
      repeated("<frame>", 90) + "<include file='self.xml'/>" + repeated("</frame>", 90);
  std::ofstream(folder / "self.xml") << "<mujoco>" << frames << "</mujoco>";
  const std::string includes = "<mujoco><worldbody>" + frames + "</worldbody></mujoco>";
  CHECK_THROWS_WITH(import_robot_text(includes, "robot.xml", folder.path()),
                    Catch::Contains("nested too deeply; expected at most 100 levels"));
  std::ofstream(folder / "self.xml") << "<mujoco><frame><include file='self.xml'/></frame></mujoco>";
  CHECK_THROWS_WITH(import_robot_text(includes, "robot.xml", folder.path()),
                    Catch::Contains("files include each other too deeply; expected at most 8 levels"));
}

TEST_CASE("a link may be called as the ground that is put under it", "[import]") {
  const ImportedScene imported = import_robot_text(
      "<robot name='r'><link name='ground under the robot'><inertial><mass value='1'/><inertia ixx='1' "
      "iyy='1' izz='1'/></inertial></link></robot>",
      "r.urdf", "/nowhere");
  CHECK(parse_scene(imported.text, "r", {}).model.name[1] == "ground under the robot 2");
}

TEST_CASE("a tree is a tree", "[import]") {
  const std::string a = "<link name='a'/><link name='b'/>";
  const auto joint = [](const std::string& name, const std::string& parent, const std::string& child) {
    return "<joint name='" + name + "' type='fixed'><parent link='" + parent + "'/><child link='" + child +
           "'/></joint>";
  };
  check_refused("<robot>" + a + joint("j", "a", "b") + joint("k", "b", "a") + "</robot>", {"circle"});
  check_refused("<robot>" + a + joint("j", "a", "b") + joint("k", "a", "b") + "</robot>", {"two parents"});
  check_refused("<robot>" + a + joint("j", "a", "c") + "</robot>", {"no link \"c\""});
  check_refused("<robot>" + a + a + "</robot>", {"another link is named \"a\""});
  check_refused(world("<geom class='x' size='1'/>"), {"no default class \"x\""});
}

TEST_CASE("entities bring no file in", "[import]") {
  const std::string text =
      "<!DOCTYPE r [<!ENTITY a SYSTEM 'file:///etc/hostname'>]><robot name='&a;'>"
      "<link name='base'><inertial><mass value='1'/><inertia ixx='1' iyy='1' izz='1'/></inertial>"
      "</link></robot>";
  const Scene scene = parse_scene(import_robot_text(text, "r.urdf", "/nowhere").text, "r", {});
  CHECK(scene.name == "&a;");
}

TEST_CASE("files beside a robot are asked for, and stay in their package", "[import]") {
  std::vector<std::string> asked;
  const MayRead refuse = [&](const std::filesystem::path& path) {
    asked.push_back(path.string());
    throw Error(ErrorKind::bad_input, "may not be read");
  };
  const auto robot = [](const std::string& file) {
    return "<robot name='r'><link name='b'><inertial><mass value='1'/><inertia ixx='1' iyy='1' "
           "izz='1'/></inertial>"
           "<collision><geometry><mesh filename='" +
           file + "'/></geometry></collision></link></robot>";
  };
  CHECK_THROWS_AS(import_robot_text(robot("../x.stl"), "r.urdf", "/a", {}, refuse), Error);
  CHECK(asked == std::vector<std::string>{"/a/../x.stl"});
  CHECK_THROWS_AS(import_robot_text("<mujoco><include file='b.xml'/></mujoco>", "m.xml", "/a", {}, refuse),
                  Error);
  CHECK(asked.back() == "/a/b.xml");
  const ImportedScene out = import_robot_text(robot("package://p/../../x.stl"), "r.urdf", "/a");
  CHECK_THAT(note_with(out, "leads out of its package").text, Catch::Contains("mesh left out"));
}

TEST_CASE("a package is looked for only where files may be read", "[import]") {
  const TempFolder around;
  const std::filesystem::path root = around / "root";
  std::filesystem::create_directories(root / "p");
  const auto robot = [&](const std::string& mesh, const std::string& package = "package://p/") {
    const std::string text =
        "<robot name='r'><link name='b'><inertial><mass value='1'/><inertia ixx='1' iyy='1' "
        "izz='1'/></inertial>"
        "<collision><geometry><mesh filename='" +
        package + mesh + "'/></geometry></collision></link></robot>";
    const MayRead below_root = [&](const std::filesystem::path& path) {
      if (!path.string().starts_with(root.string() + "/"))
        throw Error(ErrorKind::bad_input, "may not be read");
    };
    return import_robot_text(text, "r.urdf", root, {}, below_root);
  };
  const std::filesystem::path wedge = std::filesystem::path(places::assets()) / "meshes/wedge.obj";
  std::filesystem::copy_file(wedge, root / "p/inside.obj");
  CHECK(robot("inside.obj").files == std::vector<std::filesystem::path>{root / "p/inside.obj"});
  CHECK(robot("inside.obj", "package:///p/").files == robot("inside.obj").files);
  // A file outside is as one that does not exist.
  const std::string before = robot("outside.obj").text;
  std::filesystem::create_directories(around / "p");
  std::filesystem::copy_file(wedge, around / "p/outside.obj");
  const ImportedScene after = robot("outside.obj");
  CHECK(after.text == before);
  CHECK(after.files.empty());
  CHECK_THAT(note_with(after, "mesh left out").text, Catch::Contains("no such file"));
}

}  // namespace pabd::test_hostile
