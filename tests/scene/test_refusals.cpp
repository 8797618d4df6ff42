// SPDX-License-Identifier: MIT
// Every kind of bad scene is refused with the place and the expectation.
#include <nlohmann/json.hpp>

#include "sim/scene/document.h"
#include "tests/scene/scene_helpers.h"

namespace pabd::test_refusals {

using namespace test;

TEST_CASE("text that is not JSON names line and column", "[scene]") {
  check_refused("", {"line 1, column 1", "not valid JSON"});
  check_refused("{\n  \"format\": ?\n}", {"line 2, column 13", "not valid JSON"});
  check_refused("{ \"format\": \"pabd-scene\" ", {"line 1", "not valid JSON"});
  check_refused("{ \"a\": NaN }", {"not valid JSON"});
  check_refused("{ \"a\": Infinity }", {"not valid JSON"});
  check_refused("{ \"a\": 1 } x", {"line 1", "not valid JSON"});
  check_refused("{ \"a\": \"\xff\" }", {"not valid JSON"});
}

TEST_CASE("a number that overflows is refused", "[scene]") {
  check_refused(with_body("\n\"time_step\": 1e400"), {"line 2", "1e400", "finite"});
  check_refused(with_body("\"gravity\": [0, -1e999, 0]"), {"1e999", "finite"});
}

TEST_CASE("deep nesting and duplicate keys are refused", "[scene]") {
  check_refused(std::string(100000, '['), {"nested deeper than 32"});
  check_refused(with_body("\"time_step\": 0.01, \"time_step\": 0.02"), {"/time_step", "twice"});
  check_refused(with_body(R"("contact": { "friction": { "static": 1, "static": 2 } })"),
                {"/contact/friction/static", "twice"});
  check_refused(only_body(R"({ "shape": { "type": "sphere", "radius": 1 } }, { "mass": 1, "mass": 1 })"),
                {"/bodies/1/mass", "twice"});
}

TEST_CASE("documents have a largest size", "[scene]") {
  const DocumentLimits limits{100, 5, 3};
  const auto message = [&](const std::string& text) {
    try {
      parse_document(text, "test.json", limits);
      return std::string("accepted");
    } catch (const Error& error) {
      CHECK(error.kind() == ErrorKind::bad_input);
      return std::string(error.what());
    }
  };
  CHECK(message("[1, 2, 3, 4]") == "accepted");  // the array counts as a value
  CHECK_THAT(message("[1, 2, 3, 4, 5]"), Catch::Contains("more than 5 values"));
  CHECK(message("[[[1]]]") == "accepted");
  CHECK_THAT(message("[[[[1]]]]"), Catch::Contains("nested deeper than 3"));
  CHECK(message(std::string(99, ' ') + "1") == "accepted");
  CHECK_THAT(message(std::string(100, ' ') + "1"), Catch::Contains("longer than 100 bytes"));
  check_refused(std::string((std::size_t{64} << 20) + 1, ' '), {"longer than 67108864 bytes"});
}

TEST_CASE("format and version come first", "[scene]") {
  check_refused("[]", {"expected an object"});
  check_refused("{}", {"/format", "pabd-scene"});
  check_refused(R"({ "format": "other" })", {"/format", "expected \"pabd-scene\"", "other"});
  check_refused(R"({ "format": "pabd-scene" })", {"/version", "expected 1"});
  check_refused(R"({ "format": "pabd-scene", "version": 2, "new_key": 0 })",
                {"/version", "version 2", "reads version 1", "newer pabd"});
  check_refused(R"({ "format": "pabd-scene", "version": 0 })", {"/version", "expected 1"});
  check_refused(R"({ "format": "pabd-scene", "version": "1" })", {"/version", "expected 1"});
}

TEST_CASE("unknown keys are refused, with a suggestion where one is near", "[scene]") {
  check_refused(with_body(R"("gravitiy": [0, 0, 0])"),
                {"/gravitiy", "unknown key", "did you mean \"gravity\"?"});
  check_refused(with_body(R"("contact": { "dhat": 0.01 })"), {"/contact/dhat", "did you mean \"d_hat\"?"});
  check_refused(with_body(R"("contact": { "n": 3 })"), {"/contact/n", "did you mean \"N\"?"});
  check_refused(with_body(R"("solver": { "steps": 3 })"), {"/solver/steps", "unknown key", "iterations"});
  check_refused(with_body(R"("camera": { "eye": [1,1,1], "target": [0,0,0], "zoom": 2 })"),
                {"/camera/zoom", "fov"});
  check_refused(with_body(R"("joints_default": { "stiffness": 2 })"), {"/joints_default/stiffness"});
  check_refused(only_body(R"({ "shape": { "type": "sphere", "radius": 1 }, "densty": 5 })"),
                {"/bodies/0/densty", "did you mean \"density\"?"});
  check_refused(only_body(R"({ "shape": { "type": "sphere", "radius": 1, "size": [1,1,1] } })"),
                {"/bodies/0/shape/size", "unknown key"});
  check_refused(only_body(R"({ "shape": { "type": "sphere", "radius": 1 }, "colour": [1, 0, 0] })"),
                {"/bodies/0/colour", "did you mean \"color\"?"});
  check_refused(generated(R"({ "type": "pyramid", "base": 3, "count": 3 })"),
                {"/generate/0/count", "unknown key"});
  check_refused(with_body("\"a\\nb\": 1"), {"a\\nb", "unknown key"});
}

TEST_CASE("parameters out of range are refused at their place", "[scene]") {
  const std::vector<std::pair<std::string, std::vector<std::string>>> cases{
      {R"("time_step": 0)", {"/time_step", "expected"}},
      {R"("time_step": -0.01)", {"/time_step", "expected"}},
      {R"("time_step": "fast")", {"/time_step", "expected a step from 1e-6 to 1 (s)", "fast"}},
      {R"("gravity": [0, -9.81])", {"/gravity", "an array of 3 numbers"}},
      {R"("gravity": [0, -9.81, null])", {"/gravity/2", "expected a number", "null"}},
      {R"("gravity": -9.81)", {"/gravity", "an array of 3 numbers"}},
      {R"("gravity": [0, 1e7, 0])", {"/gravity/1", "from -1000000"}},
      {R"("solver": [])", {"/solver", "expected an object"}},
      {R"("solver": { "method": "decsent" })", {"/solver/method", "did you mean \"descent\"?"}},
      {R"("solver": { "method": 3 })", {"/solver/method", "\"descent\""}},
      {R"("solver": { "projection": "nearest" })", {"/solver/projection", "\"polar\"", "\"weighted\""}},
      {R"("solver": { "iterations": 0 })", {"/solver/iterations", "expected"}},
      {R"("solver": { "iterations": 2.5 })", {"/solver/iterations", "whole number"}},
      {R"("solver": { "iterations": 4294967297 })", {"/solver/iterations", "whole number"}},
      {R"("solver": { "iterations": 18446744073709551615 })", {"/solver/iterations", "whole number"}},
      {R"("solver": { "iterations": 99999999999999999999 })", {"/solver/iterations", "whole number"}},
      {R"("solver": { "tolerance": -1 })", {"/solver/tolerance", "expected"}},
      {R"("solver": { "relaxation": 0 })", {"/solver/relaxation", "expected"}},
      {R"("solver": { "relaxation": 1.5 })", {"/solver/relaxation", "expected"}},
      {R"("contact": { "barrier": "cubic" })", {"/contact/barrier", "\"polynomial\"", "\"log\"", "\"even\""}},
      {R"("contact": { "d_hat": 0 })", {"/contact/d_hat", "expected"}},
      {R"("contact": { "d_hat": -0.01 })", {"/contact/d_hat", "expected"}},
      {R"("contact": { "N": 0 })", {"/contact/N", "expected"}},
      {R"("contact": { "N": 33 })", {"/contact/N", "32"}},
      {R"("contact": { "N": 3.5 })", {"/contact/N", "a whole number from 1 to 32"}},
      {R"("contact": { "N": "3" })", {"/contact/N", "whole number"}},
      {R"("contact": { "N": 1, "barrier": "even" })", {"/contact/N", "expected 2"}},
      {R"("contact": { "kappa": 0 })", {"/contact/kappa", "expected"}},
      {R"("contact": { "kappa": "stiff" })", {"/contact/kappa", "\"auto\"", "stiff"}},
      {R"("contact": { "onset": 1 })", {"/contact/onset", "expected"}},
      {R"("contact": { "onset": -0.1 })", {"/contact/onset", "expected"}},
      {R"("contact": { "friction": { "static": -1 } })", {"/contact/friction/static", "expected"}},
      {R"("contact": { "friction": { "static": 0.2, "dynamic": 0.3 } })",
       {"/contact/friction/dynamic", "not above the static"}},
      {R"("contact": { "friction": "high" })", {"/contact/friction", "expected"}},
      {R"("joints_default": { "potential": "firm" })", {"/joints_default/potential", "\"soft\"", "\"hard\""}},
      {R"("joints_default": { "kappa": -1 })", {"/joints_default/kappa", "1e-12", "(N/m)"}},
      {R"("joints_default": { "kappa": true })", {"/joints_default/kappa", "\"auto\""}},
      {R"("joints_default": { "N": 40 })", {"/joints_default/N", "32"}},
      {R"("joints_default": { "d_hat": 0 })", {"/joints_default/d_hat", "expected"}},
      {R"("name": "")", {"/name", "at least one character"}},
      {R"("name": "a\nb")", {"/name", "control characters"}},
      {R"("description": 5)", {"/description", "text"}},
      {R"("joints_default": { "N": 1 })", {"/joints_default/N", "from 2"}},
      {R"("joints": {})", {"/joints", "expected an array"}},
      {R"("generate": {})", {"/generate", "expected an array"}}};
  for (const auto& [members, parts] : cases) check_refused(with_body(members), parts);
}

TEST_CASE("a duration is a positive number", "[scene]") {
  CHECK(parse(with_body(R"("duration": 2.5)")).duration == 2.5);
  CHECK_FALSE(parse(with_body("")).duration.has_value());
  CHECK(parse(with_body(R"("duration": 2.5)"), {"duration=4"}).duration == 4);
  for (const char* bad : {"0", "-1", "2e6", "null", "\"5 s\""})
    check_refused(with_body(std::string(R"("duration": )") + bad), {"/duration", "expected a number"});
}

TEST_CASE("bad cameras are refused", "[scene]") {
  check_refused(with_body(R"("camera": {})"), {"/camera/eye", "missing"});
  check_refused(with_body(R"("camera": { "eye": [1, 2, 3] })"), {"/camera/target", "missing"});
  check_refused(with_body(R"("camera": { "eye": [1, 2, 3], "target": [1, 2, 3] })"),
                {"/camera/eye", "target"});
  for (const char* fov : {"0", "1", "170", "-45", "1000"}) {
    check_refused(
        with_body(std::string(R"("camera": { "eye": [1, 2, 3], "target": [0, 0, 0], "fov": )") + fov + "}"),
        {"/camera/fov", "between 1 and 170"});
  }
}

TEST_CASE("bad bodies are refused", "[scene]") {
  const std::string sphere = R"("shape": { "type": "sphere", "radius": 1 })";
  const std::vector<std::pair<std::string, std::vector<std::string>>> cases{
      {"5", {"/bodies/0", "expected an object"}},
      {"{}", {"/bodies/0/shape", "missing"}},
      {R"({ "shape": "box" })", {"/bodies/0/shape", "an object"}},
      {R"({ "shape": {} })", {"/bodies/0/shape/type", "missing"}},
      {R"({ "shape": { "type": "bxo" } })", {"/bodies/0/shape/type", "did you mean \"box\"?"}},
      {R"({ "shape": { "type": "mesh", "file": "a.obj" } })",
       {"/bodies/0/shape/file", "a.obj: the file does not exist"}},
      {R"({ "shape": { "type": "mesh" } })", {"/bodies/0/shape/file", "missing"}},
      {R"({ "shape": { "type": "mesh", "file": ["a.obj", "b.obj"] } })",
       {"/bodies/0/shape/file/0", "a.obj: the file does not exist"}},
      {R"({ "shape": { "type": "mesh", "file": [] } })", {"/bodies/0/shape/file", "1 to 64 files"}},
      {R"({ "shape": { "type": "mesh", "file": ["a.obj", 5] } })", {"/bodies/0/shape/file/"}},
      {R"({ "shape": { "type": "mesh", "file": "" } })", {"/bodies/0/shape/file", "OBJ, STL or PLY"}},
      {R"({ "shape": { "type": "mesh", "file": "/dev/zero" } })", {"/bodies/0/shape/file", "regular file"}},
      {R"({ "shape": { "type": "mesh", "file": "a.obj", "scale": 0 } })", {"/bodies/0/shape/scale"}},
      {R"({ "shape": { "type": "box" } })", {"/bodies/0/shape/size", "missing"}},
      {R"({ "shape": { "type": "box", "size": [1, 0, 1] } })", {"/bodies/0/shape/size/1", "1e-06"}},
      {R"({ "shape": { "type": "box", "size": [1, -1, 1] } })", {"/bodies/0/shape/size/1", "1e-06"}},
      {R"({ "shape": { "type": "box", "size": [1, 1e7, 1] } })", {"/bodies/0/shape/size/1", "1000000"}},
      {R"({ "shape": { "type": "sphere", "radius": 0 } })", {"/bodies/0/shape/radius", "1e-06"}},
      {R"({ "shape": { "type": "sphere", "radius": -2 } })", {"/bodies/0/shape/radius", "1e-06"}},
      {R"({ "shape": { "type": "capsule", "radius": 1, "length": 0 } })",
       {"/bodies/0/shape/length", "1e-06"}},
      {R"({ "shape": { "type": "plane", "normal": [0, 0, 0] } })", {"/bodies/0/shape/normal", "not zero"}},
      {R"({ "shape": { "type": "plane" }, "fixed": false })", {"/bodies/0/fixed", "always fixed"}},
      {R"({ "shape": { "type": "plane" }, "position": [0, 0, 0] })",
       {"/bodies/0/position", "remove this key"}},
      {R"({ "shape": { "type": "plane" }, "mass": 1 })", {"/bodies/0/mass", "remove this key"}},
      {"{" + sphere + R"(, "density": 0 })", {"/bodies/0/density", "kg/m³"}},
      {"{" + sphere + R"(, "density": -1 })", {"/bodies/0/density", "kg/m³"}},
      {"{" + sphere + R"(, "density": 1e10 })", {"/bodies/0/density", "kg/m³"}},
      {"{" + sphere + R"(, "mass": 0 })", {"/bodies/0/mass", "(kg)"}},
      {"{" + sphere + R"(, "mass": -1 })", {"/bodies/0/mass", "(kg)"}},
      {"{" + sphere + R"(, "mass": 1, "density": 1 })", {"/bodies/0/mass", "not both"}},
      {"{" + sphere + R"(, "fixed": "yes" })", {"/bodies/0/fixed", "true or false"}},
      {"{" + sphere + R"(, "position": [2e6, 0, 0] })", {"/bodies/0/position/0", "1000000"}},
      {"{" + sphere + R"(, "orientation": [0, 0, 0, 0] })", {"/bodies/0/orientation", "unit quaternion"}},
      {"{" + sphere + R"(, "orientation": [1, 0.1, 0, 0] })",
       {"/bodies/0/orientation", "unit quaternion", "1.00498"}},
      {"{" + sphere + R"(, "orientation": [1e300, 1e300, 0, 0] })",
       {"/bodies/0/orientation", "unit quaternion"}},
      {"{" + sphere + R"(, "orientation": [1, 0, 0] })", {"/bodies/0/orientation", "an array of 4 numbers"}},
      {"{" + sphere + R"(, "velocity": [0, 1e7, 0] })", {"/bodies/0/velocity/1", "m/s"}},
      {"{" + sphere + R"(, "angular_velocity": [0, "a", 0] })",
       {"/bodies/0/angular_velocity/1", "degrees/s"}},
      {"{" + sphere + R"(, "fixed": true, "velocity": [1, 0, 0] })", {"/bodies/0/velocity", "fixed body"}},
      {"{" + sphere + R"(, "fixed": true, "angular_velocity": [1, 0, 0] })",
       {"/bodies/0/angular_velocity", "fixed body"}},
      {"{" + sphere + R"(, "name": "a" }, {)" + sphere + R"(, "name": "a" })",
       {"/bodies/1/name", "\"a\"", "different names"}},
      {R"({ "shape": { "type": "box", "size": [1e6, 1e6, 1e6] } })", {"/bodies/0", "mass", "expected"}},
      {R"({ "shape": { "type": "sphere", "radius": 1e-6 } })", {"/bodies/0", "mass", "expected"}}};
  for (const auto& [body, parts] : cases) check_refused(only_body(body), parts);
  check_refused(scene_text(""), {"no bodies"});
  check_refused(scene_text(R"("bodies": 3)"), {"/bodies", "expected an array"});
}

TEST_CASE("bad generators are refused", "[scene]") {
  const std::vector<std::pair<std::string, std::vector<std::string>>> cases{
      {"[]", {"/generate/0", "expected an object"}},
      {"{}", {"/generate/0/type", "missing"}},
      {R"({ "type": "pyramids" })", {"/generate/0/type", "did you mean \"pyramid\"?"}},
      {R"({ "type": "chain" })", {"/generate/0/links", "missing"}},
      {R"({ "type": "chain", "links": 0 })", {"/generate/0/links", "from 1 to 4000000"}},
      {R"({ "type": "chain", "links": 2, "shape": "mixed" })", {"/generate/0/shape", "\"capsule\""}},
      {R"({ "type": "chain", "links": 2, "shape": "capsule", "size": [1, 1, 1] })",
       {"/generate/0/size", "no straight part"}},
      {R"({ "type": "chain", "links": 2, "direction": [0, 0, 0] })", {"/generate/0/direction", "not zero"}},
      {R"({ "type": "chain", "links": 2, "joint": "slider" })", {"/generate/0/joint", "\"hinge\""}},
      {R"({ "type": "chain", "links": 2, "axis": [0, 0, 1] })", {"/generate/0/axis", "only hinges"}},
      {R"({ "type": "chain", "links": 2, "joint": "hinge", "axis": [0, 0, 0] })",
       {"/generate/0/axis", "not zero"}},
      {R"({ "type": "chain", "links": 2, "fixed": "last" })", {"/generate/0/fixed", "\"first\""}},
      {R"({ "type": "chain", "links": 2, "gap": -1 })", {"/generate/0/gap", "(m)"}},
      {R"({ "type": "chain", "links": 2, "end_mass": 0 })", {"/generate/0/end_mass", "(kg)"}},
      {R"({ "type": "chain", "links": 2, "mass": 1, "density": 1 })", {"/generate/0/mass", "not both"}},
      {R"({ "type": "chain", "links": 2000000 })", {"/generate/0", "expected coordinates within 1000000"}},
      {R"({ "type": "net", "rows": 2 })", {"/generate/0/columns", "missing"}},
      {R"({ "type": "net", "rows": 0, "columns": 2 })", {"/generate/0/rows", "from 1"}},
      {R"({ "type": "net", "rows": 4000000, "columns": 4000000 })", {"/generate/0", "at most 4000000"}},
      {R"({ "type": "net", "rows": 2, "columns": 2, "shape": "capsule" })",
       {"/generate/0/shape", "\"sphere\""}},
      {R"({ "type": "net", "rows": 2, "columns": 2, "fixed": "left" })", {"/generate/0/fixed", "\"top\""}},
      {R"({ "type": "net", "rows": 2, "columns": 2, "joint": "hinge" })",
       {"/generate/0/joint", "\"distance\""}},
      {R"({ "type": "net", "rows": 2, "columns": 2, "upright": 1 })", {"/generate/0/upright", "true"}},
      {R"({ "type": "stack" })", {"/generate/0/count", "missing"}},
      {R"({ "type": "stack", "count": 0 })", {"/generate/0/count", "from 1 to 4000000"}},
      {R"({ "type": "stack", "count": 5000000 })", {"/generate/0/count", "4000000"}},
      {R"({ "type": "stack", "count": 2, "size": [0, 1, 1] })", {"/generate/0/size/0", "1e-06"}},
      {R"({ "type": "stack", "count": 2, "gap": -1 })", {"/generate/0/gap", "from 0"}},
      {R"({ "type": "stack", "count": 2, "masses": [] })", {"/generate/0/masses", "at least one"}},
      {R"({ "type": "stack", "count": 2, "masses": [1, 0] })", {"/generate/0/masses/1", "(kg)"}},
      {R"({ "type": "stack", "count": 2, "masses": [1], "mass": 1 })", {"/generate/0/masses", "one of"}},
      {R"({ "type": "stack", "count": 2, "mass": 1, "density": 1 })", {"/generate/0/mass", "not both"}},
      {R"({ "type": "stack", "count": 4000000 })", {"/generate/0", "expected coordinates within 1000000"}},
      {R"({ "type": "wall", "columns": 4000000, "rows": 4000000 })", {"/generate/0", "at most 4000000"}},
      {R"({ "type": "wall", "columns": 3, "rows": 2, "spacing": 1 })", {"/generate/0", "half blocks"}},
      {R"({ "type": "wall", "columns": 0, "rows": 2 })", {"/generate/0/columns", "whole number from 1"}},
      {R"({ "type": "pyramid", "base": 3000 })", {"/generate/0/base", "2827"}},
      {R"({ "type": "pyramid", "base": 2.5 })", {"/generate/0/base", "whole number"}},
      {R"({ "type": "pile", "count": 10, "shape": "ball" })", {"/generate/0/shape", "\"sphere\""}},
      {R"({ "type": "pile", "count": 10, "spacing": 0.5 })", {"/generate/0/spacing", "overlap"}},
      {R"({ "type": "pile", "count": 10, "seed": -1 })", {"/generate/0/seed", "whole number"}},
      {R"({ "type": "pile", "count": 10, "vary": 1 })", {"/generate/0/vary", "0.9"}},
      {R"({ "type": "pile", "count": 10 , "name": "a" }, { "type": "pile", "count": 10 , "name": "a" })",
       {"/generate", "\"a 0\"", "different names"}}};
  for (const auto& [generator, parts] : cases) check_refused(generated(generator), parts);
  check_refused(generated(R"({ "type": "pile", "count": 3000000 }, { "type": "pile", "count": 3000000 })"),
                {"/generate/1", "6000000 bodies", "at most 4000000"});
}

TEST_CASE("a file that cannot be read is an error of its own", "[scene]") {
  const auto folder = std::filesystem::temp_directory_path();
  for (const std::filesystem::path& file : {folder / "pabd-no-such-scene.json", folder}) {
    try {
      load_scene(file);
      FAIL_CHECK("read " << file);
    } catch (const Error& error) {
      CHECK(error.kind() == ErrorKind::file);
      CHECK_THAT(error.what(), Catch::StartsWith(file.string() + ": cannot be read: "));
    }
  }
}

}  // namespace pabd::test_refusals
