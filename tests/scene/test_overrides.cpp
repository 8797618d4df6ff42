// SPDX-License-Identifier: MIT
// --set: what it changes, what it makes, and how it refuses.
#include <algorithm>

#include "sim/scene/keys.h"
#include "tests/scene/scene_helpers.h"

namespace pabd::test_overrides {

using namespace test;

namespace {

const std::string kTwo = scene_text(R"("gravity": [0, -9.81, 0], "bodies": [
  { "name": "a", "shape": { "type": "sphere", "radius": 0.5 } },
  { "name": "b", "shape": { "type": "box", "size": [1, 1, 1] }, "position": [3, 0, 0] } ],
  "generate": [ { "type": "stack", "count": 2, "position": [9, 0, 0] } ])");

}  // namespace

TEST_CASE("overrides change values, list entries and absent settings", "[scene]") {
  const Scene s =
      parse(kTwo, {"contact.kappa=50", "contact.onset=0.1", "contact.friction.static=0.9",
                   "solver.tolerance=1e-4", "solver.method=sissm", "time_step=0.01", "gravity.1=-1.62",
                   "bodies.1.density=500", "/bodies/0/mass=2", "bodies.1.shape.size=[1, 1, 2]",
                   "generate.0.count=3", "name=new name", "joints_default.N=4"});
  CHECK(s.params.contact.kappa == 50.0);
  CHECK(s.params.contact.onset == 0.1);
  CHECK(s.params.contact.mu_static == 0.9);
  CHECK(s.params.solver.tolerance == 1e-4);
  CHECK(s.params.solver.method == SolverMethod::sissm);
  CHECK(s.params.h == 0.01);
  CHECK(s.params.gravity == Vec3(0, -1.62, 0));
  CHECK(s.model.mass[1] == Approx(1000).epsilon(1e-14));
  CHECK(s.model.mass[0] == 2);
  CHECK(s.model.size() == 5);
  CHECK(s.name == "new name");
}

TEST_CASE("later overrides win; whole sections may be set", "[scene]") {
  const Scene s = parse(kTwo, {"contact.N=4", "contact.N=5", R"(camera={"eye":[1,2,3],"target":[0,0,0]})"});
  CHECK(s.params.contact.N == 5);
  REQUIRE(s.camera.has_value());
  CHECK(s.camera->eye == Vec3(1, 2, 3));
}

TEST_CASE("every setting that the help lists can be set", "[scene]") {
  const std::vector<std::string> keys = scene_keys();
  for (const char* expected :
       {"time_step", "contact.kappa", "contact.friction.static", "solver.method", "camera.fov"}) {
    CHECK(std::find(keys.begin(), keys.end(), expected) != keys.end());
  }
  // An object is wrong everywhere; the refusal must come from the setting itself, so its path was understood.
  for (const std::string& key : keys) {
    std::string pointer = "/" + key;
    std::replace(pointer.begin(), pointer.end(), '.', '/');
    std::vector<std::string> overrides{key + "={}"};
    if (key.starts_with("camera."))
      overrides.insert(overrides.begin(), R"(camera={"eye":[1,2,3],"target":[0,0,0]})");
    check_refused(kTwo, {pointer + ": ", "expected"}, overrides);
  }
}

TEST_CASE("overrides pass the same checks, and the message says where the value came from", "[scene]") {
  check_refused(kTwo, {"/contact/d_hat", "expected", "--set contact.d_hat=-1"}, {"contact.d_hat=-1"});
  check_refused(kTwo, {"/contact/kapa", "did you mean \"kappa\"?", "--set contact.kapa=5"},
                {"contact.kapa=5"});
  check_refused(kTwo, {"/bodies/1/mass", "not both"}, {"bodies.1.mass=1", "bodies.1.density=1"});
  check_refused(kTwo,
                {"/time_step", "expected a step from 1e-6 to 1 (s)", "\"fast\"", "--set time_step=fast"},
                {"time_step=fast"});
  check_refused(kTwo, {"/time_step", "expected a step from 1e-6 to 1 (s)", "1e400"}, {"time_step=1e400"});
}

TEST_CASE("a bad path names the part that does not exist", "[scene]") {
  check_refused(kTwo, {"--set contcat.kappa=5", "the scene has no \"contcat\"", "did you mean \"contact\"?"},
                {"contcat.kappa=5"});
  check_refused(kTwo, {"\"bodies\" has 2 entries", "no 7"}, {"bodies.7.density=5"});
  check_refused(kTwo, {"\"bodies\" is a list", "in place of \"a\""}, {"bodies.a.density=5"});
  check_refused(kTwo, {"\"bodies.0\" has no \"shap\"", "did you mean \"shape\"?"},
                {"bodies.0.shap.radius=5"});
  check_refused(kTwo, {"\"gravity.1\" has no parts"}, {"gravity.1.x=5"});
  check_refused(kTwo, {"\"gravity\" has 3 entries"}, {"gravity.3=5"});
  check_refused(with_body(""), {"no \"gravity\"", "set it whole"}, {"gravity.1=5"});
  check_refused(kTwo, {"KEY=VALUE"}, {"contact.kappa"});
  check_refused(kTwo, {"KEY=VALUE"}, {"=5"});
  check_refused(kTwo, {"empty part"}, {"contact..kappa=5"});
  check_refused(kTwo, {"empty part"}, {"contact.=5"});
  check_refused(kTwo, {"empty part"}, {"/=5"});
  check_refused(kTwo, {"not UTF-8"}, {"name=\xff\xfe"});
}

TEST_CASE("a parameter without its section, or by its symbol, is told by its key", "[scene]") {
  const std::vector<std::pair<std::string, std::string>> short_keys = {
      {"kappa=5", "did you mean \"contact.kappa\"?"},
      {"N=3", "did you mean \"contact.N\"?"},
      {"h=0.01", "did you mean \"time_step\"?"},
      {"iterations=5", "did you mean \"solver.iterations\"?"},
      {"friction=0.5", "did you mean \"contact.friction\"?"}};
  for (const auto& [set, hint] : short_keys) check_refused(kTwo, {"--set " + set, hint}, {set});
  CHECK(parse(kTwo, {"name=h"}).name == "h");
}

}  // namespace pabd::test_overrides
