// SPDX-License-Identifier: MIT
// The page of marks is what the program says, and the program says it of every mark that there is.
#include <fmt/format.h>
#include <catch2/catch.hpp>

#include "app/cli/marks_page.h"
#include "app/overlay/overlay_panel_table.h"
#include "app/overlay/overlay_panels.h"
#include "render/visual/body_marks.h"
#include "render/visual/palette.h"
#include "render/visual/picture_marks.h"
#include "sim/base/srgb.h"
#include "sim/body/joint.h"
#include "tests/cli/program.h"
#include "tests/support/places.h"

namespace pabd::test_cli_marks {

using namespace test;

namespace {

std::string page() { return cli::marks_page(); }

// "#rrggbb" of linear light.
std::string hex(const Vec4f& c) {
  return fmt::format("#{:02x}{:02x}{:02x}", srgb_byte(c.x()), srgb_byte(c.y()), srgb_byte(c.z()));
}

std::string row_that_begins(const std::string& text, const std::string& start) {
  for (const std::string& line : lines_of(text)) {
    if (line.starts_with(start)) return line;
  }
  return "";
}

}  // namespace

TEST_CASE("app/cli/marks.md is what 'pabd marks' prints") {
  const Outcome printed = run_pabd({"marks"});
  CHECK(printed.exit_code == 0);
  CHECK(printed.out == page());
  // Written with: pabd marks > app/cli/marks.md
  CHECK(read_text(places::project() + "/app/cli/marks.md") == printed.out);
}

TEST_CASE("every panel of the overlay has a row with what it shows") {
  for (const OverlayPanel* panel : overlay_panels()) {
    if (panel->name.empty()) continue;
    CAPTURE(panel->name);
    const std::string row = row_that_begins(page(), fmt::format("| `{}`", panel->name));
    CHECK(row.size() > 40);
  }
}

TEST_CASE("every mark of bodies and the first trails are on the page") {
  for (const PictureMark& mark : picture_marks()) {
    CAPTURE(mark.name);
    CHECK(row_that_begins(page(), fmt::format("| `{}` |", mark.name)).find(mark.help) != std::string::npos);
  }
  for (std::size_t k = 0; k < kTrailInks; ++k) CHECK(page().find(hex(trail_color(k))) != std::string::npos);
}

TEST_CASE("every type of joint has a row with the colour that it is drawn in") {
  for (const JointType type : kJointTypes) {
    CAPTURE(to_string(type));
    const std::string row = row_that_begins(page(), fmt::format("| `{}` |", to_string(type)));
    CHECK(row.find(hex(joint_color(type))) != std::string::npos);
  }
  for (const Vec4f& color : {bond_point_i_color(), bond_point_j_color(), bond_line_color()})
    CHECK(page().find(hex(color)) != std::string::npos);
}

TEST_CASE("the colours of contacts are those of the map, overlap told from touching") {
  const Color touching = contact_ink(0), onset = contact_ink(1);
  const auto shown = [](const Color& c) { return fmt::format("#{:02x}{:02x}{:02x}", c.r, c.g, c.b); };
  CHECK(row_that_begins(page(), "| 0 |").find(shown(touching)) != std::string::npos);
  CHECK(row_that_begins(page(), "| 1 |").find(shown(onset)) != std::string::npos);
  CHECK(row_that_begins(page(), "| below 0 |").find(shown(contact_ink(-1e-6))) != std::string::npos);
  CHECK(shown(contact_ink(-1e-6)) != shown(touching));
}

TEST_CASE("every way to colour bodies that the window takes is explained") {
  const std::string actions = run_pabd({"view", "--actions"}).out;
  const auto at = actions.find("color_by");
  REQUIRE(at != std::string::npos);
  const std::string fields = actions.substr(at, 300);
  int found = 0;
  for (const char* word : {"body", "projection", "speed", "energy", "component"}) {
    CAPTURE(word);
    CHECK(fields.find(word) != std::string::npos);
    CHECK(row_that_begins(page(), fmt::format("| `{}` |", word)).size() > 20);
    ++found;
  }
  CHECK(found == 5);
}

}  // namespace pabd::test_cli_marks
