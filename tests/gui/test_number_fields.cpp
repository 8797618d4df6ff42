// SPDX-License-Identifier: MIT
// Numbers that are typed into fields of the window: with a unit that fits, or refused.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/gui/script_runner.h"

namespace pabd::test_number_fields {

namespace {

// Types into the field at `at` of the inspector and makes a body. Returns the height of its centre, or what was
// refused.
std::string made_with(const std::string& typed, bool refused = false) {
  const std::string script = R"([
    {"do": "load", "scene": "two_boxes", "force": true},
    {"do": "panel", "panel": "inspector"},
    {"do": "wait", "frames": 3},
    {"do": "mouse", "at": [165, 545], "how": "click"},
    {"do": "key", "key": "ctrl+a"},
    {"do": "type", "text": ")" +
                             typed + R"("},
    {"do": "key", "key": "enter", "may_fail": )" +
                             (refused ? "true" : "false") + R"(},
    {"do": "wait", "frames": 2, "may_fail": true},
    {"do": "frame", "path": "free.png"},
    {"do": "print", "at": "/message"},
    {"do": "mouse", "at": [165, 595], "how": "click"},
    {"do": "wait", "frames": 3},
    {"do": "print", "at": "/a/bodies"}
  ])";
  const TempFolder folder;
  std::string renderer, printed;
  carry_out(Script(script, "s"), folder, renderer, nullptr, &printed);
  return printed;
}

}  // namespace

TEST_CASE("the size of a new body is taken in the unit that is typed") {
  const std::string plain = made_with("0.05");
  CHECK(made_with("5 cm") == plain);
  CHECK(made_with("50mm") == plain);
  CHECK(made_with("5 m") != plain);
  const std::string refused = made_with("5 s", true);
  CHECK_THAT(refused, Catch::Contains("expected a number (m), got \\\"5 s\\\""));
}

}  // namespace pabd::test_number_fields
