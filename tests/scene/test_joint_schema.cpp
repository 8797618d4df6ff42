// SPDX-License-Identifier: MIT
// The JSON Schema has of joints, word for word, what their traits give.
#include <catch2/catch.hpp>
#include <filesystem>

#include "sim/scene/joint_schema.h"
#include "tests/support/files.h"
#include "tests/support/places.h"

namespace pabd::test_joint_schema {

namespace {

// As it stands in the file, `indent` deep, without the indent of its first line.
std::string printed(const OrderedJson& value, int indent) {
  std::string out;
  for (const char c : value.dump(2)) {
    out += c;
    if (c == '\n') out.append(static_cast<std::size_t>(indent), ' ');
  }
  return out;
}

// Replaces what lies between two texts, the first of them behind `after`.
void replace_between(std::string& text, const std::string& after, const std::string& from,
                     const std::string& to, const std::string& by) {
  const std::size_t start = text.find(from, text.find(after)) + from.size();
  const std::size_t end = text.find(to, start);
  REQUIRE(end != std::string::npos);
  text.replace(start, end - start, by);
}

}  // namespace

TEST_CASE("the schema says of joints what their traits give", "[scene]") {
  const std::string written = read_bytes(std::filesystem::path(places::assets()) / "pabd-scene.schema.json");
  REQUIRE(written.find("\"$defs\"") != std::string::npos);
  std::string definitions;
  for (const JointType type : kJointTypes)
    definitions += std::string("    \"") + to_string(type) + "\": " + printed(joint_schema(type), 4) + ",\n";
  std::string expected = written;
  replace_between(expected, "\"joints\": {", "\"items\": ", ",\n      \"maxItems\"",
                  printed(joint_schema_list(), 6));
  definitions.insert(0, "\n");
  definitions.pop_back();
  const std::string first = std::string("\n    \"") + to_string(kJointTypes.front()) + "\": {";
  replace_between(expected, "\"$defs\"", first, "\n    \"drive\": {", definitions.substr(first.size()));
  if (written != expected) write_bytes("pabd-scene.schema.json", expected);
  INFO(
      "what it should be is in pabd-scene.schema.json of this folder: look at the change, copy it to assets");
  CHECK((written == expected));
}

}  // namespace pabd::test_joint_schema
