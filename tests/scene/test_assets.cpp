// SPDX-License-Identifier: MIT
// The shipped scenes load, and the JSON Schema says what the reader does.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <set>

#include "sim/scene/parameter_docs.h"
#include "sim/scene/scene_schema.h"
#include "sim/solver/step_numbers.h"
#include "sim/solver/time_step.h"
#include "tests/scene/scene_helpers.h"
#include "tests/support/files.h"
#include "tests/support/places.h"
#include "tests/support/sanitized.h"

namespace pabd::test_assets {

using namespace test;
using Json = nlohmann::json;

namespace {

const std::filesystem::path kAssets = places::assets();

Json schema() { return Json::parse(read_bytes(kAssets / "pabd-scene.schema.json")); }

// A key is documented when it, or what it refers to, has a description (a "type" word says itself what it
// is).
bool documented(const Json& root, const Json& property) {
  if (property.contains("description")) return true;
  if (!property.contains("$ref")) return false;
  const std::string ref = property["$ref"];
  return root.at(Json::json_pointer(ref.substr(1))).contains("description");
}

}  // namespace

TEST_CASE("every shipped scene loads and is fit to show", "[scene]") {
  std::set<std::string> stems, names;
  for (const auto& entry : std::filesystem::directory_iterator(kAssets / "scenes")) {
    if (entry.path().extension() != ".json") continue;
    INFO(entry.path());
    const Scene s = load_scene(entry.path());
    stems.insert(entry.path().stem().string());
    CHECK(names.insert(s.name).second);
    CHECK_FALSE(s.description.empty());
    CHECK(s.camera.has_value());
    CHECK(movable_mass(s.model).heaviest > 0);
  }
  for (const char* expected : {"two_boxes",
                               "pyramid",
                               "stack",
                               "pile",
                               "incline",
                               "wall",
                               "spin",
                               "shapes",
                               "meshes",
                               "chairs",
                               "pendulum",
                               "double_pendulum",
                               "chain_heavy_end",
                               "bridge",
                               "slider_crank",
                               "four_bar",
                               "ferris_wheel",
                               "gears",
                               "ragdoll",
                               "newtons_cradle",
                               "dominoes",
                               "card_house",
                               "wrecking_ball",
                               "trampoline",
                               "arch",
                               "drop",
                               "geneva",
                               "marble_mixer"}) {
    INFO(expected);
    CHECK(stems.contains(expected));
  }
}

TEST_CASE("every shipped scene runs: finite, joints closed, no body inside another at the start", "[scene]") {
  for (const auto& entry : std::filesystem::directory_iterator(kAssets / "scenes")) {
    if (entry.path().extension() != ".json") continue;
    INFO(entry.path());
    Scene s = load_scene(entry.path());
    StepWorkspace workspace;
    StepReport report;
    for (int k = 0; k < 10; ++k) {
      step(s.model, s.params, {}, s.initial, workspace, report);
      REQUIRE(report.status != StepStatus::non_finite);
      if (entry.path().stem() != "trampoline")
        CHECK(report.max_joint_error < 1e-6);                                        // its joints are springs
      if (entry.path().stem() != "two_boxes") CHECK(report.max_penetration < 1e-4);  // they start inside
    }
  }
}

#ifdef PABD_SANITIZED
constexpr int kSissmSteps = 20;  // it is the memory that is looked at then
#else
constexpr int kSissmSteps = 180;
#endif

TEST_CASE("every shipped scene runs with sissm: finite, energy below the start's and the work of drives",
          "[scene]") {
  for (const auto& entry : std::filesystem::directory_iterator(kAssets / "scenes")) {
    if (entry.path().extension() != ".json") continue;
    INFO(entry.path());
    Scene s = load_scene(entry.path(), {"solver.method=sissm"});
    StepWorkspace workspace;
    StepReport report;
    double allowed = 0, scale = 0, highest = 0;
    for (int k = 0; k < kSissmSteps; ++k) {
      step(s.model, s.params, {}, s.initial, workspace, report);
      REQUIRE(report.status != StepStatus::non_finite);
      const double energy = report.kinetic + report.potential + report.elastic;
      if (k == 0) {
        allowed = energy;
      } else {
        allowed += report.drive_work;
      }
      highest = std::max(highest, energy - allowed);
      scale = std::max(scale, report.kinetic + std::abs(report.potential));
    }
    CHECK(highest <= 1e-3 * scale);  // a tumbling body in free flight varies by so much
  }
}

TEST_CASE("the README of the assets lists every scene, and its example of joints is a scene", "[scene]") {
  const std::string text = read_bytes(kAssets / "README.md");
  std::size_t scenes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kAssets / "scenes")) {
    if (entry.path().extension() != ".json") continue;
    INFO(entry.path());
    CHECK(text.find("\n| `" + entry.path().stem().string() + "` |") != std::string::npos);
    ++scenes;
  }
  CHECK(scenes > 20);
  const std::string fence = "```json\n";
  const auto begin = text.find(fence);
  REQUIRE(begin != std::string::npos);
  const std::string example =
      text.substr(begin + fence.size(), text.find("```", begin + 3) - begin - fence.size());
  std::string bodies;
  for (const char* name : {"post", "arm", "crank", "rail", "cart", "hand", "tool", "shaft", "wheel", "sleeve",
                           "rod", "ram", "lid", "gear", "nut"}) {
    bodies += std::string(bodies.empty() ? "" : ",") + R"({"name": ")" + name +
              R"(", "shape": {"type": "sphere", "radius": 0.1}})";
  }
  const Scene s =
      parse_scene(R"({"format": "pabd-scene", "version": 1, "bodies": [)" + bodies + "], " + example + "}",
                  "README.md", kAssets);
  CHECK(s.model.joints.size() == 13 + 21 + 180);  // listed, chain with both ends, net of 10 by 10
  CHECK(s.model.joints[12].law.kappa == 500);
  CHECK(s.model.joints[3].arm == 0.2);
}

TEST_CASE("the gallery has every scene, with its picture and its command", "[scene]") {
  const std::string text = read_bytes(kAssets / "gallery.md");
  for (const auto& entry : std::filesystem::directory_iterator(kAssets / "scenes")) {
    if (entry.path().extension() != ".json") continue;
    const std::string stem = entry.path().stem();
    INFO(stem);
    const std::string picture = "gallery/" + stem + (stem == "drop" ? "_N" : "") + ".png";
    CHECK(text.find("(" + picture + ")") != std::string::npos);
    CHECK(std::filesystem::exists(kAssets / picture));
    CHECK(text.find("pabd render " + stem + " -o ") != std::string::npos);
    CHECK(text.find(load_scene(entry.path()).description) != std::string::npos);
  }
}

TEST_CASE("newton's cradle: the last ball takes the first one's momentum, the others stay", "[scene]") {
  Scene s = load_scene(kAssets / "scenes" / "newtons_cradle.json");
  const auto ball = [&](int k) {
    const auto& names = s.model.name;
    return static_cast<std::size_t>(std::find(names.begin(), names.end(), "ball " + std::to_string(k)) -
                                    names.begin());
  };
  StepWorkspace workspace;
  StepReport report;
  double fastest = 0;
  while (s.initial.time < 0.75) {
    step(s.model, s.params, {}, s.initial, workspace, report);
    fastest = std::max(fastest, s.initial.v[ball(1)].x());
  }
  CHECK(fastest > 2.8);  // it struck at √(2 g L (1 − cos 42°)) = 2.9 m/s
  for (int k = 1; k < 5; ++k) CHECK(std::abs(s.initial.v[ball(k)].x()) < 0.02 * fastest);
  CHECK(s.initial.v[ball(5)].x() > 0.9 * fastest);  // a little is left on the way, a little by gravity
}

TEST_CASE("slider-crank: the piston is where the crank's angle puts it", "[scene]") {
  Scene s = load_scene(kAssets / "scenes" / "slider_crank.json");
  const auto& names = s.model.name;
  const auto piston =
      static_cast<std::size_t>(std::find(names.begin(), names.end(), "piston") - names.begin());
  StepWorkspace workspace;
  StepReport report;
  const double r = 0.6, l = 1.8;
  double highest = 0, lowest = 9;
  for (int k = 0; k < 720; ++k) {
    step(s.model, s.params, {}, s.initial, workspace, report);
    const double theta = s.model.joints[0].drive->at(report.time);
    const double x = r * std::cos(theta) + std::sqrt(l * l - r * r * std::sin(theta) * std::sin(theta));
    CHECK(s.initial.c[piston].x() == Approx(x).margin(1e-6));
    highest = std::max(highest, s.initial.c[piston].x());
    lowest = std::min(lowest, s.initial.c[piston].x());
  }
  CHECK(highest - lowest == Approx(2 * r).epsilon(1e-3));  // one whole turn
}

TEST_CASE("four-bar linkage: the pen follows a closed curve", "[scene]") {
  Scene s = load_scene(kAssets / "scenes" / "four_bar.json");
  const auto& names = s.model.name;
  const auto pen = static_cast<std::size_t>(std::find(names.begin(), names.end(), "pen") - names.begin());
  StepWorkspace workspace;
  StepReport report;
  std::vector<Vec3> path;
  // The crank turns by 180° a second after the first one: two seconds for each time round.
  const int second = 240;
  for (int k = 0; k < 5 * second; ++k) {
    step(s.model, s.params, {}, s.initial, workspace, report);
    if (k >= second) path.push_back(s.initial.c[pen]);
  }
  double width = 0, apart = 0;
  for (int k = 0; k < 2 * second; ++k) {
    const auto i = static_cast<std::size_t>(k), again = static_cast<std::size_t>(k + 2 * second);
    width = std::max(width, (path[i] - path[0]).norm());
    apart = std::max(apart, (path[i] - path[again]).norm());
  }
  CHECK(width > 0.5);
  CHECK(apart < 1e-4);  // the step of 0.004166667 s is 3e-10 s off a part of a second
}

TEST_CASE("so many as a scene's description says are in it", "[scene]") {
  struct Promise {
    const char *scene, *words, *name;  // name: how those bodies' names begin; empty: all that move
    int count;
  };
  const Promise promises[] = {{"arch", "Two half rings of 24 stones", "thick", 24},
                              {"arch", "Two half rings of 24 stones", "thin", 24},
                              {"double_pendulum", "Three double pendulums", "upper", 3},
                              {"drop", "Three balls", "", 3},
                              {"marble_mixer", "20 staves", "stave", 20},
                              {"marble_mixer", "220 marbles", "marble", 220},
                              {"marble_mixer", "four lifters", "lifter", 4},
                              {"bridge", "22 hinged planks", "plank", 22},
                              {"chain_heavy_end", "18 light links", "chain", 18},
                              {"dominoes", "80 dominoes", "domino", 80},
                              {"ferris_wheel", "ten gondolas", "gondola", 10},
                              {"gears", "a tray of balls", "ball", 3},
                              {"meshes", "nine wedge blocks", "stone", 9},
                              {"newtons_cradle", "three resting ones", "ball", 5},
                              {"pile", "1000 boxes, spheres and capsules", "", 1000},
                              {"pyramid", "210 bricks", "", 210},
                              {"stack", "Ten cubes", "", 10},
                              {"trampoline", "225 tiles", "tile", 225},
                              {"two_boxes", "Two boxes", "", 2},
                              {"wrecking_ball", "twelve links", "chain", 12}};
  for (const Promise& promise : promises) {
    INFO(promise.scene);
    const Scene s = load_scene(kAssets / "scenes" / (std::string(promise.scene) + ".json"));
    CHECK(s.description.find(promise.words) != std::string::npos);
    int count = 0;
    for (std::size_t i = 0; i < s.model.name.size(); ++i)
      count += *promise.name ? s.model.name[i].starts_with(promise.name) : !s.model.fixed[i];
    CHECK(count == promise.count);
  }
  const Scene heavy = load_scene(kAssets / "scenes" / "chain_heavy_end.json");
  double link = 0, ball = 0;
  for (std::size_t i = 0; i < heavy.model.name.size(); ++i) {
    if (heavy.model.name[i] == "ball") ball = heavy.model.mass[i];
    if (heavy.model.name[i] == "chain 0") link = heavy.model.mass[i];
  }
  CHECK(ball / link == Approx(500).epsilon(0.01));
}

TEST_CASE("figures of the shipped scenes", "[scene]") {
  const auto load = [](const char* name) {
    return load_scene(kAssets / "scenes" / (std::string(name) + ".json"));
  };
  CHECK(load("pyramid").model.size() == 211);
  CHECK(load("pile").model.size() == 1001);
  CHECK(load("stack").model.size() == 11);

  // The boxes overlap by 0.1 m, the supplement's Figure 6.
  const Scene two = load("two_boxes");
  REQUIRE(two.model.size() == 3);
  CHECK(two.params.contact.d_hat == 0.05);
  CHECK(two.initial.c[1].y() + 0.5 - (two.initial.c[2].y() - 0.5) == Approx(0.1).epsilon(1e-12));

  // The crates lie flat on slopes of 26° and 27°: their bottom faces are parallel to them, at
  // the gap that carries them.
  const Scene incline = load("incline");
  for (const double angle : {26.0, 27.0}) {
    const std::size_t slope = angle == 26 ? 1 : 4, crate = slope + 2;
    const Vec3 normal = incline.initial.R[slope] * Vec3::UnitY();
    CHECK(std::acos(normal.y()) * 180 / kPi == Approx(angle).epsilon(1e-9));
    CHECK((incline.initial.R[crate] * Vec3::UnitY() - normal).norm() < 1e-9);
    const double apart = normal.dot(incline.initial.c[crate] - incline.initial.c[slope]);
    CHECK(apart - 0.5 - 0.1 == Approx(0.990879 * 0.01).epsilon(1e-3));
  }
}

TEST_CASE("the schema and the reference are what the lists of keys give", "[scene]") {
  const std::pair<const char*, std::string> made[] = {{"pabd-scene.schema.json", scene_schema()},
                                                      {"keys.md", key_reference()},
                                                      {"step_numbers.md", step_number_reference()}};
  for (const auto& [file, text] : made) {
    if (std::getenv("PABD_UPDATE_GOLDEN")) write_bytes(kAssets / file, text);
    INFO("PABD_UPDATE_GOLDEN=1 writes " << file << " anew");
    CHECK((read_bytes(kAssets / file) == text));
  }
}

TEST_CASE("the schema refuses unknown keys and describes the others", "[scene]") {
  const Json root = schema();
  Json objects = root["$defs"];
  objects["scene"] = root;
  CHECK(objects.size() > 30);
  for (const auto& [name, object] : objects.items()) {
    INFO(name);
    if (!object.contains("properties")) continue;
    CHECK(object["additionalProperties"] == false);
    for (const auto& [key, property] : object["properties"].items()) {
      INFO(key);
      CHECK((documented(root, property) || (key == "type" && property.contains("const"))));
    }
  }
}

TEST_CASE("the schema says of parameters what their table says", "[scene]") {
  const Json root = schema(), made = Json::parse(parameter_schema());
  INFO("assets/pabd-scene.schema.json should hold\n" << parameter_schema());
  for (const char* part : {"properties", "$defs"}) {
    CHECK(made[part].size() >= 3);
    for (const auto& [name, object] : made[part].items()) {
      INFO(name);
      CHECK(root[part][name] == object);
    }
  }
}

TEST_CASE("the reference of parameters is their table", "[scene]") {
  const std::string text = read_bytes(kAssets / "README.md");
  INFO("assets/README.md should hold\n" << parameter_reference());
  CHECK(text.find("\n" + parameter_reference() + "\n") != std::string::npos);
}

TEST_CASE("the schema gives the defaults of the program", "[scene]") {
  const Json root = schema();
  const Json& defs = root["$defs"];
  const auto default_of = [](const Json& object, const char* key) {
    return object["properties"][key]["default"];
  };
  CHECK(default_of(defs["camera"], "fov") == CameraDesc{}.fov);
  CHECK(default_of(defs["joints_default"], "potential") == "soft");
  CHECK(default_of(defs["joints_default"], "N") == BondLaw{}.N);
  CHECK(default_of(defs["joints_default"], "d_hat") == BondLaw{}.d_hat);
}

}  // namespace pabd::test_assets
