// SPDX-License-Identifier: MIT
// Scenes that include others: moved, turned and renamed, and refused where they lie.
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "sim/scene/builder.h"
#include "sim/scene/guarded_scene.h"
#include "sim/solver/time_step.h"
#include "tests/scene/scene_helpers.h"
#include "tests/support/places.h"
#include "tests/support/temp_folder.h"

namespace pabd::test_includes {

using namespace test;

namespace {

// Joints of every kind that knows the world, generators, friction, groups, colours, and a plane.
const std::string kPart = scene_text(R"("gravity": [0, 0, 0], "time_step": 0.002,
  "contact": { "friction": 0.9 }, "camera": { "eye": [9, 9, 9], "target": [0, 0, 0] }, "duration": 3,
  "joints_default": { "potential": "soft", "kappa": 4000 },
  "bodies": [
    { "name": "floor", "shape": { "type": "plane", "offset": -50 }, "group": "ground" },
    { "name": "rod", "shape": { "type": "box", "size": [1, 0.2, 0.1] }, "position": [0.5, 0, 0], "mass": 2,
      "velocity": [0, 1, 0], "angular_velocity": [0, 0, 100], "friction": 0.3, "restitution": 0.4, "group": ["left", "arm"],
      "color": "#112233" },
    { "name": "bob", "shape": { "type": "capsule", "radius": 0.2, "length": 0.6 }, "position": [1.5, 0.3, 0],
      "orientation": { "euler": [10, 20, 30] }, "velocity": [1, 2, 3], "group": "arm",
      "force": { "keys": [[0, [0, 0, 0]], [0.3, [20, 5, 0]]] }, "torque": [0, 0.5, 0] } ],
  "generate": [ { "type": "chain", "links": 3, "position": [0, 3, 0], "direction": [1, 0, 1], "joint": "hinge" } ],
  "joints": [
    { "name": "pin", "type": "hinge", "bodies": [null, "rod"], "anchor": [0, 0, 0], "axis": [0, 0, 1],
      "limits": [-30, 30] },
    { "type": "spherical", "bodies": ["rod", "bob"], "anchor": [1, 0, 0], "drive": { "keys": [[0, [0, 0, 0]], [1, [20, 0, 40]]] } },
    { "name": "spring", "type": "distance", "bodies": ["floor", "bob"], "points": [[1.5, 4, 0], [1.5, 0.5, 0]],
      "length": 3, "kappa": 50 },
    { "name": "rail", "type": "slider", "bodies": [null, "chain 2"], "anchor": [3, 3, 2], "axis": [0, 1, 0], "twist": "free",
      "kappa": 90 } ],
  "no_collide": [["rod", "chain 0"], ["rod", "floor"], [{ "group": "arm" }, { "group": "arm" }]])");

struct Files {
  TempFolder folder;
  Files() { write("part.json", kPart); }
  void write(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories((folder / name).parent_path());
    write_bytes(folder / name, text);
  }
  Scene parse(const std::string& text) const { return parse_scene(text, "test.json", folder.path()); }
  std::string refusal(const std::string& text) const {
    try {
      parse(text);
    } catch (const Error& error) {
      CHECK(error.kind() == ErrorKind::bad_input);
      const std::string what = error.what();
      CHECK(what.find('\n') == std::string::npos);
      CHECK(what.find(folder.path().string()) == std::string::npos);
      return what;
    }
    return "accepted";
  }
};

std::string including(const std::string& entries, const std::string& more = "") {
  return scene_text(R"("includes": [ )" + entries + " ]" + (more.empty() ? "" : ", " + more));
}

std::size_t number_of(const Scene& scene, const std::string& name) {
  const auto& names = scene.model.name;
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

State after(const Scene& scene, int steps) {
  State state = scene.initial;
  StepWorkspace workspace;
  StepReport report;
  for (int k = 0; k < steps; ++k) step(scene.model, scene.params, {}, state, workspace, report);
  return state;
}

const std::string kSettings = R"("gravity": [0, 0, 0], "time_step": 0.002)";
const std::string kPlaced = R"({ "scene": "part.json", "prefix": "l.", "position": [10, -20, 5],
                                 "orientation": { "axis": [1, 2, 3], "angle": 130 } })";

}  // namespace

TEST_CASE("an included scene moves as it does alone, moved and turned", "[scene]") {
  const Files files;
  const Scene alone = files.parse(kPart), placed = files.parse(including(kPlaced, kSettings));
  const Mat3 R = Eigen::AngleAxisd(130 * kPi / 180, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  const Vec3 p(10, -20, 5);
  REQUIRE(placed.model.size() == alone.model.size() - 1);  // without the plane
  for (const int steps : {0, 1, 200}) {
    INFO(steps);
    const State a = after(alone, steps), b = after(placed, steps);
    double moved = 0;
    for (std::size_t i = 1; i < a.c.size(); ++i) {
      const std::size_t k = number_of(placed, "l." + alone.model.name[i]);
      REQUIRE(k < b.c.size());
      CHECK((b.c[k] - (p + R * a.c[i])).norm() < 1e-6);
      CHECK((b.R[k] - R * a.R[i]).norm() < 1e-6);
      CHECK((b.v[k] - R * a.v[i]).norm() < 1e-4);
      CHECK((b.omega[k] - R * a.omega[i]).norm() < 1e-4);
      moved = std::max(moved, (a.c[i] - alone.initial.c[i]).norm());
    }
    CHECK((moved > 0.1) == (steps == 200));
  }
}

TEST_CASE("what is taken of an included scene, and under which names", "[scene]") {
  const Files files;
  const Scene s = files.parse(including(kPlaced, R"("name": "whole", "bodies": [
    { "name": "own", "shape": { "type": "box", "size": [1, 1, 1] } } ],
    "joints": [{ "name": "pin", "type": "fixed", "bodies": ["own", "l.bob"], "anchor": [0, 0, 0] }],
    "no_collide": [["own", { "group": "l.arm" }]])"));
  CHECK(s.model.name ==
        std::vector<std::string>{"own", "l.rod", "l.bob", "l.chain 0", "l.chain 1", "l.chain 2"});
  std::vector<std::string> joints;
  for (const Joint& joint : s.model.joints) joints.push_back(joint.name);
  CHECK(joints == std::vector<std::string>{"pin", "l.pin", "l.joint 1", "l.spring", "l.rail", "", "", ""});
  // The spring held on to the plane.
  CHECK(s.model.joints[3].i == kWorld);
  CHECK(s.model.joints[3].law.kappa == 50);
  CHECK(s.model.joints[1].law.kappa == 4000);  // of the included scene's joints_default
  CHECK(s.model.joints[0].law.kappa != 4000);
  CHECK(s.looks.at("l.rod").color == Vec3(0x11, 0x22, 0x33) / 255);
  REQUIRE(s.model.friction.size() == 6);
  CHECK(s.model.friction[1] == SurfaceFriction{0.3, 0.3});
  CHECK_FALSE(s.model.friction[2]);
  REQUIRE(s.model.restitution.size() == 6);
  CHECK(s.model.restitution[1] == 0.4);
  CHECK_FALSE(s.model.restitution[2]);
  CHECK(s.model.groups.name == std::vector<std::string>{"l.ground", "l.left", "l.arm"});
  CHECK(keeps_apart(s.model.groups, 1, 2));
  CHECK_FALSE(keeps_apart(s.model.groups, 0, 2));
  const auto& pairs = s.model.no_collide;
  for (const std::pair<Index, Index>& pair : {std::pair<Index, Index>{1, 3}, {0, 1}, {0, 2}})
    CHECK(std::binary_search(pairs.begin(), pairs.end(), pair));
  // Those that scenes state themselves; joints bring others.
  CHECK(s.model.stated_apart == std::vector<std::pair<Index, Index>>{{0, 1}, {0, 2}, {1, 3}});
  CHECK(pairs.size() > 3);
  // What is not taken.
  CHECK(s.params == Params{});
  CHECK_FALSE(s.camera);
  CHECK_FALSE(s.duration);
  CHECK(s.name == "whole");
}

TEST_CASE("a scene may be included many times, and inside others", "[scene]") {
  const Files files;
  files.write("deep/hand.json",
              including(R"({ "scene": "finger.json", "prefix": "a.", "position": [1, 0, 0] },
    { "scene": "../deep/finger.json", "prefix": "b.", "orientation": { "euler": [0, 90, 0] } })"));
  files.write("deep/finger.json", scene_text(R"("bodies": [{ "name": "tip", "position": [1, 0, 0],
    "shape": { "type": "mesh", "file": "tip.obj" } }])"));
  files.write("deep/tip.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  const Scene s = files.parse(including(R"({ "scene": "deep/hand.json", "prefix": "l.", "position": [0, 5, 0],
    "orientation": { "euler": [0, -90, 0] } }, { "scene": "deep/hand.json" })"));
  CHECK(s.model.name == std::vector<std::string>{"l.a.tip", "l.b.tip", "a.tip", "b.tip"});
  CHECK((s.initial.c[0] - Vec3(0, 5, 2)).norm() < 1e-15);
  CHECK((s.initial.c[1] - Vec3(1, 5, 0)).norm() < 1e-15);  // turned by 90° and back
  CHECK((s.initial.R[1] - Mat3::Identity()).norm() < 1e-15);
  CHECK((s.initial.c[3] - Vec3(0, 0, -1)).norm() < 1e-15);
  std::vector<std::string> names;
  for (const auto& file : s.files) names.push_back(file.filename().string());
  for (const char* name : {"hand.json", "finger.json", "tip.obj"})
    CHECK(std::count(names.begin(), names.end(), name) >= 1);
}

TEST_CASE("an error in an included scene names the files on the way to it", "[scene]") {
  const Files files;
  const auto wrong = [&](const std::string& text) {
    files.write("b/inner.json", text);
    files.write("outer.json", including(R"({ "scene": "b/inner.json" })"));
    return files.refusal(including(R"({ "scene": "outer.json" })"));
  };
  const std::string way = "test.json: /includes/0/scene: outer.json: /includes/0/scene: b/inner.json: ";
  CHECK(wrong(only_body(R"({ "shape": { "type": "sphere", "radius": -1 } })"))
            .starts_with(way + "/bodies/0/shape/radius: "));
  CHECK(wrong("{\n  \"format\": \"pabd-scene\",,\n}").starts_with(way + "line 2"));
  CHECK(wrong(R"({ "format": "pabd-scene", "version": 2 })").starts_with(way + "/version: "));
  // All of it is looked at, taken or not.
  CHECK(wrong(with_body(R"("contact": { "kappa": -1 })")).starts_with(way + "/contact/kappa: "));
  CHECK(wrong(with_body(R"("camera": { "fov": 45 })")).starts_with(way + "/camera/eye: "));
  CHECK(wrong(scene_text(R"("bodies": [{ "shape": { "type": "plane" } }])"))
            .starts_with(
                "test.json: /includes/0/scene: outer.json: /includes/0/scene: it has no bodies but planes"));
  CHECK(wrong(only_body(R"({ "shape": { "type": "mesh", "file": "no.obj" } })"))
            .starts_with(way + "/bodies/0/shape/file: no.obj: the file does not exist"));
}

TEST_CASE("includes that cannot be are refused", "[scene]") {
  const Files files;
  const auto refused = [&](const std::string& text, const std::vector<std::string>& parts) {
    const std::string message = files.refusal(text);
    INFO(message);
    for (const std::string& part : parts) CHECK(message.find(part) != std::string::npos);
  };
  refused(including(R"({ })"), {"/includes/0/scene", "missing"});
  refused(including(R"({ "scene": "" })"), {"/includes/0/scene", "the name of a scene file"});
  refused(including(R"({ "scene": "no.json" })"),
          {"/includes/0/scene", "no.json: cannot be read: no such file"});
  refused(including(R"({ "scene": "." })"), {"/includes/0/scene", "cannot be read", "folder"});
  refused(including(R"({ "scene": "part.json", "scale": 2 })"), {"/includes/0/scale", "unknown key"});
  refused(including(R"({ "scene": "part.json", "position": [2e6, 0, 0] })"), {"/includes/0/position/0"});
  refused(including(R"({ "scene": "part.json", "position": [1e6, 0, 0] })"),
          {"/includes/0/scene", "\"rod\"", "1000000"});
  refused(including(R"({ "scene": "part.json" }, { "scene": "part.json" })"),
          {"/includes/1/scene", "a joint \"pin\"", "prefix"});
  refused(including(R"({ "scene": "part.json" })",
                    R"("bodies": [{ "name": "rod", "shape": { "type": "sphere", "radius": 1 } }])"),
          {"/includes", "\"rod\"", "prefix"});
  refused(
      including(
          R"({ "scene": "part.json", "prefix": "l." })",
          R"("joints": [{ "name": "l.pin", "type": "fixed", "bodies": ["l.rod", "l.bob"], "anchor": [0, 0, 0] }])"),
      {"/joints/0/name", "l.pin"});
  refused(including(R"({ "scene": "part.json", "prefix": ")" + std::string(98, 'x') + "\" }"),
          {"/includes/0/scene", "101 bytes", "shorten \"prefix\""});
}

TEST_CASE("what an included scene remembers of a run is checked as well, and not taken", "[scene]") {
  const Files files;
  const auto with = [&](const std::string& memory) {
    files.write("saved.json", kPart.substr(0, kPart.rfind('}')) + ", " + memory + "}");
    return including(R"({ "scene": "saved.json" })");
  };
  CHECK_THAT(files.refusal(with(R"("joint_forces": "x")")), Catch::Contains("/joint_forces"));
  CHECK_THAT(files.refusal(with(R"("friction_anchors": [3])")), Catch::Contains("/friction_anchors/0"));
  const Scene plain = files.parse(including(R"({ "scene": "part.json" })"));
  const Scene saved =
      files.parse(with(R"("friction_anchors": [{ "bodies": [1, 2], "feature": 1, "stretch": [0, 0, 0] }])"));
  CHECK(saved.hash == plain.hash);
  CHECK(saved.initial.contacts.empty());
}

TEST_CASE("joints without a name may be beside included ones without", "[scene]") {
  const Files files;
  const std::string joints =
      R"("joints": [{ "type": "fixed", "bodies": [null, "BALL"], "anchor": [0, 0, 0] }])";
  const auto with_ball = [&](const std::string& name) {
    return R"("bodies": [{ "name": ")" + name + R"(", "shape": { "type": "sphere", "radius": 0.1 } }], )" +
           std::string(joints).replace(joints.find("BALL"), 4, name);
  };
  files.write("ball.json", scene_text(with_ball("a")));
  const Scene s = files.parse(including(R"({ "scene": "ball.json" })", with_ball("b")));
  REQUIRE(s.model.joints.size() == 2);
  CHECK(s.model.joints[0].name != s.model.joints[1].name);
}

TEST_CASE("scenes that include each other are refused with their chain", "[scene]") {
  const Files files;
  files.write("a.json", including(R"({ "scene": "sub/b.json" })"));
  files.write("sub/b.json", including(R"({ "scene": "c.json" })"));
  files.write("sub/c.json", including(R"({ "scene": "../sub/../a.json" })"));
  CHECK_THAT(
      files.refusal(including(R"({ "scene": "a.json" })")),
      Catch::EndsWith("../sub/../a.json: includes itself: a.json → sub/b.json → c.json → ../sub/../a.json; "
                      "remove one of them"));
  files.write("self.json", including(R"({ "scene": "self.json" })"));
  try {
    load_scene(files.folder / "self.json");
    FAIL_CHECK("accepted");
  } catch (const Error& error) {
    CHECK_THAT(error.what(), Catch::Contains("self.json; remove one of them"));
  }
}

TEST_CASE("there is an end to scenes inside each other and beside each other", "[scene]") {
  const Files files;
  files.write("0.json", with_body(""));
  for (int k = 1; k <= 9; ++k)
    files.write(fmt::format("{}.json", k),
                including(fmt::format(R"({{ "scene": "{}.json", "prefix": "p" }})", k - 1)));
  CHECK(files.parse(including(R"({ "scene": "7.json" })")).model.name[0] == "pppppppball");
  CHECK_THAT(files.refusal(including(R"({ "scene": "8.json" })")), Catch::Contains("more than 8 scenes"));
  std::string many;
  for (int k = 0; k < 1001; ++k)
    many += fmt::format(R"({}{{ "scene": "0.json", "prefix": "{}." }})", k == 0 ? "" : ", ", k);
  CHECK_THAT(files.refusal(including(many)),
             Catch::Contains("/includes/1000/scene") && Catch::Contains("1000"));
}

TEST_CASE("who may not read all files is asked before each", "[scene]") {
  const Files files;
  files.write("mesh.json", only_body(R"({ "shape": { "type": "mesh", "file": "/secret/rock.obj" } })"));
  std::vector<std::string> asked;
  const MayRead guard = [&](const std::filesystem::path& file) {
    asked.push_back(file.filename().string());
    if (file.string().starts_with("/secret")) throw Error(ErrorKind::bad_input, "is outside");
  };
  const auto refusal = [&](const std::string& scene) {
    try {
      parse_guarded_scene(including(R"({ "scene": ")" + scene + "\" }"), "test.json", files.folder.path(), {},
                          guard);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  CHECK(refusal("/secret/no.json") == "test.json: /includes/0/scene: /secret/no.json: is outside");
  CHECK_THAT(refusal("mesh.json"), Catch::Contains("rock.obj: is outside"));
  CHECK(refusal("part.json") == "accepted");
  CHECK(asked == std::vector<std::string>{"no.json", "mesh.json", "rock.obj", "part.json"});
}

TEST_CASE("the hash of an including scene is that of what is taken, not of file names", "[scene]") {
  const Files files;
  files.write("other.json", kPart);
  const auto hash = [&](const std::string& entry) { return files.parse(including(entry)).hash; };
  const std::string plain = hash(R"({ "scene": "part.json" })");
  CHECK(hash(R"({ "scene": "other.json" })") == plain);
  CHECK(hash(R"({ "scene": "other.json", "position": [0, 0, 0] })") == plain);
  for (const char* entry :
       {R"({ "scene": "part.json", "prefix": "l" })", R"({ "scene": "part.json", "position": [0, 0, 1] })",
        R"({ "scene": "part.json", "orientation": { "euler": [0, 0, 1] } })"})
    CHECK(hash(entry) != plain);
  std::string changed = kPart;
  changed.replace(changed.find("\"mass\": 2"), 9, "\"mass\": 3");
  files.write("other.json", changed);
  CHECK(hash(R"({ "scene": "other.json" })") != plain);
  changed = kPart;
  changed.replace(changed.find("0.002"), 5, "0.003");  // of its parameters
  files.write("other.json", changed);
  CHECK(hash(R"({ "scene": "other.json" })") == plain);
}

TEST_CASE("a builder includes scenes beside its folder, as often as it builds", "[scene]") {
  const Files files;
  SceneBuilder builder("test", files.folder.path());
  builder.add(spec::Include{.scene = "part.json",
                            .prefix = "l.",
                            .position = Vec3(10, -20, 5),
                            .orientation = spec::AxisAngle{Vec3(1, 2, 3), 130}});
  const Scene read = files.parse(including(kPlaced, R"("name": "test")"));
  for (int k = 0; k < 2; ++k) {
    const Scene built = builder.build();
    CHECK(built.hash == read.hash);
    CHECK(same_bits(built.initial, read.initial));
  }
}

TEST_CASE("the README's example of includes is a scene", "[scene]") {
  const std::string text = read_bytes(std::filesystem::path(places::assets()) / "README.md");
  const auto begin = text.find("{ \"format\"", text.find("## How bodies stand"));
  REQUIRE(begin != std::string::npos);
  const Files files;
  files.write("arm.json",
              scene_text(R"("bodies": [{ "name": "hand", "shape": { "type": "sphere", "radius": 0.1 } }])"));
  const Scene s = files.parse(text.substr(begin, text.find("```", begin) - begin));
  CHECK(s.model.name == std::vector<std::string>{"ground", "left.hand", "right.hand"});
  CHECK(s.model.joints.size() == 1);
}

}  // namespace pabd::test_includes
