// SPDX-License-Identifier: MIT
// The page "Marks in pictures" has every mark that there is.
#include <fmt/format.h>
#include <catch2/catch.hpp>
#include <sstream>
#include <string>

#include "app/overlay/body_colors.h"
#include "app/overlay/overlay_panel_table.h"
#include "render/visual/build_visual.h"
#include "render/visual/picture_marks.h"
#include "sim/body/joint.h"
#include "tests/support/files.h"
#include "tests/support/places.h"

namespace pabd::test_marks_page {

namespace {

std::string page() {
  const std::string text = read_bytes(places::project() + "/app/overlay/README.md");
  return text.substr(text.find("## Marks in pictures"));
}

// The row of the table that is about this word, with what it shows.
bool has_row(std::string_view word) {
  std::istringstream lines(page());
  for (std::string line; std::getline(lines, line);) {
    const std::size_t first = line.find(fmt::format("`{}`", word));
    if (line.starts_with("| `") && first < line.find(" |", 1) && line.size() > 40) return true;
  }
  return false;
}

}  // namespace

TEST_CASE("every panel and every mark has a row that says what it shows") {
  for (const OverlayPanel* panel : overlay_panels()) {
    if (panel->name.empty()) continue;
    CAPTURE(panel->name);
    CHECK(has_row(panel->name));
  }
  for (const PictureMark& mark : picture_marks()) {
    CAPTURE(mark.name);
    CHECK(has_row(mark.name));
  }
  CHECK_FALSE(has_row("inertia"));
}

TEST_CASE("every quantity that bodies and contacts are coloured by is named") {
  const auto named = [](const char* name) {
    CAPTURE(name);
    CHECK(page().find(fmt::format("`{}`", name)) != std::string::npos);
  };
  for (const char* name : kColorNames) named(name);
  for (const char* name : kContactQuantities) named(name);
}

TEST_CASE("every type of joint has its colour named") {
  for (const JointType type : kJointTypes) {
    const std::string word = fmt::format("`{}`", to_string(type));
    CAPTURE(word);
    CHECK(page().find(word) != std::string::npos);
  }
}

}  // namespace pabd::test_marks_page
