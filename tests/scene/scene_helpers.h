// SPDX-License-Identifier: MIT
// Small scenes as text, and a check that one is refused in the right words.
#pragma once

#include <catch2/catch.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "sim/base/error.h"
#include "sim/scene/scene.h"

namespace pabd::test {

// A scene with `members` (JSON members, may be empty) beside format and version.
inline std::string scene_text(const std::string& members) {
  return R"({ "format": "pabd-scene", "version": 1)" + (members.empty() ? "" : ", " + members) + " }";
}

// The same with one body, so that only `members` can be wrong.
inline std::string with_body(const std::string& members) {
  return scene_text(R"("bodies": [ { "name": "ball", "shape": { "type": "sphere", "radius": 0.5 } } ])" +
                    (members.empty() ? "" : ", " + members));
}

// A scene whose only body is `body`.
inline std::string only_body(const std::string& body) { return scene_text("\"bodies\": [ " + body + " ]"); }

inline std::string generated(const std::string& generator) {
  return scene_text("\"generate\": [ " + generator + " ]");
}

inline Scene parse(const std::string& text, const std::vector<std::string>& overrides = {}) {
  return parse_scene(text, "test.json", {}, overrides);
}

// Refused as bad input, in one line that begins with the source and holds every one of `parts`.
inline void check_refused(const std::string& text, const std::vector<std::string>& parts,
                          const std::vector<std::string>& overrides = {}) {
  INFO(text.substr(0, 400));
  try {
    parse(text, overrides);
  } catch (const Error& error) {
    const std::string message = error.what();
    CHECK(error.kind() == ErrorKind::bad_input);
    CHECK_THAT(message, Catch::StartsWith("test.json: "));
    CHECK(message.find('\n') == std::string::npos);
    for (const std::string& part : parts) CHECK_THAT(message, Catch::Contains(part));
    return;
  }
  FAIL_CHECK("accepted; expected a refusal");
}

}  // namespace pabd::test
