// SPDX-License-Identifier: MIT
// Parameters as text: what is written reads back to the same bits, and what does not fit is refused.
#include <catch2/catch.hpp>

#include "sim/base/error.h"
#include "sim/scene/scene.h"
#include "sim/scene/tuning.h"

namespace pabd::test_tuning {

namespace {

const char* const kScene = R"({ "format": "pabd-scene", "version": 1,
  "contact": { "N": 4, "friction": 0.25 },
  "bodies": [ { "shape": { "type": "sphere", "radius": 1 } } ] })";

std::string message(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::bad_input);
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a tuned parameter reads back exactly") {
  Params start;
  const double kappa = 1.0 / 3;
  Params p = tuned(start, {"contact.kappa=0.33333333333333331", "solver.method=newton", "gravity=[0,-3,1]",
                           "contact.friction.static=0.75"});
  CHECK(p.contact.kappa == kappa);
  CHECK(p.solver.method == SolverMethod::newton);
  CHECK(p.gravity == Vec3(0, -3, 1));
  CHECK(p.contact.mu_static == 0.75);
  CHECK(p.contact.mu_dynamic == start.contact.mu_dynamic);
  CHECK(p.h == start.h);

  std::vector<std::string> sets;
  for (const auto& [key, value] : differences(start, p)) sets.push_back(key + "=" + value);
  CHECK(sets.size() == 4);
  CHECK(params_json(tuned(start, sets)) == params_json(p));
  CHECK(differences(p, tuned(start, sets)).empty());
  CHECK(params_json(patched(start, patch_json(start, p), "patch")) == params_json(p));
  CHECK(patch_json(p, p) == "{}\n");
  CHECK(tuned_value(tuned(p, {"contact.kappa=auto"}), "contact.kappa") == "auto");
  CHECK(tuned(p, {"contact.friction=0.5"}).contact.mu_static == 0.5);
  CHECK(tuned(p, {"gravity.1=-2"}).gravity == Vec3(0, -2, 1));
}

TEST_CASE("every tunable key can be read and set to what it is") {
  const Params p;
  for (const ParameterRow& row : parameter_table()) {
    const std::string key = row.key;
    const std::string value = tuned_value(p, key);
    INFO(key << " = " << value);
    CHECK(differences(p, tuned(p, {key + "=" + value})).empty());
  }
}

TEST_CASE("a tuned scene is the scene with other parameters") {
  const Scene scene = parse_scene(kScene, "scene.json", ".");
  const Params wanted =
      tuned(scene.params, {"contact.kappa=12.5", "contact.friction.dynamic=0.125", "time_step=0.01"});
  const Scene again = parse_scene(tuned_scene_text(kScene, "scene.json", {}, wanted), "again", ".");
  CHECK(params_json(again.params) == params_json(wanted));
  CHECK(again.model.size() == 1);
  const std::string light =
      tuned_scene_text(kScene, "scene.json", {"bodies.0.density=1", "contact.N=7"}, wanted);
  CHECK(parse_scene(light, "light", ".").model.mass[0] == Approx(4 * 3.14159265358979 / 3).epsilon(1e-12));
  CHECK(parse_scene(light, "light", ".").params.contact.N == 4);
  CHECK(again.hash == parse_scene(kScene, "scene.json", ".",
                                  {"contact.kappa=12.5",
                                   "contact.friction={\"static\":0.25,\"dynamic\":0.125}", "time_step=0.01"})
                          .hash);
}

TEST_CASE("what cannot be tuned is refused with its place") {
  const Params p;
  CHECK_THAT(message([&] { tuned(p, {"contact.kapa=5"}); }),
             Catch::Contains("contact.kapa") && Catch::Contains("contact.kappa\"?"));
  CHECK_THAT(message([&] { tuned(p, {"bodies.0.density=5"}); }),
             Catch::Contains("no parameter that can be tuned"));
  CHECK_THAT(message([&] { tuned_value(p, "contact"); }), Catch::Contains("no parameter that can be tuned"));
  CHECK_THAT(message([&] { tuned(p, {"contact.d_hat=-1"}); }),
             Catch::Contains("/contact/d_hat") && Catch::Contains("1e-9"));
  CHECK_THAT(message([&] { tuned(p, {"contact.N=2.5"}); }), Catch::Contains("/contact/N"));
  CHECK_THAT(message([&] { tuned(p, {"contact.N"}); }), Catch::Contains("KEY=VALUE"));
  CHECK_THAT(message([&] { tuned(p, {"solver.method=simplex"}); }), Catch::Contains("descent"));
  CHECK_THAT(message([&] { patched(p, "{\"contact\": {\"kapa\": 5}}", "p.json"); }),
             Catch::Contains("p.json") && Catch::Contains("kapa"));
  CHECK_THAT(message([&] { patched(p, "{\"bodies\": []}", "p.json"); }), Catch::Contains("bodies"));
  CHECK_THAT(message([&] { patched(p, "[1]", "p.json"); }), Catch::Contains("object"));
  CHECK_THAT(message([&] { patched(p, "{\"contact\": {\"N\": 40}}", "p.json"); }),
             Catch::Contains("p.json") && Catch::Contains("32"));
}

}  // namespace pabd::test_tuning
