// SPDX-License-Identifier: MIT
// What the window remembers comes back as it was; a file that somebody spoiled is refused whole.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>

#include "app/gui/settings.h"
#include "sim/base/error.h"
#include "tests/support/temp_folder.h"

namespace pabd::test_settings {

namespace fs = std::filesystem;

namespace {

Settings unusual() {
  Settings s;
  s.ui.dark = false;
  s.ui.scale = 1.75;
  s.ui.shown = {&scenes_tab, &barrier_tab, &series_tab};
  s.ui.open = {true, false, true};
  s.ui.sizes.of = {420, 0, 0.4, 0};
  s.ui.contacts = false;
  s.ui.color = ColorQuantity::speed;
  s.ui.recent = {"/a/b.json", "/c \"d\".json"};
  s.width = 1600;
  s.height = 900;
  return s;
}

std::string settings_refusal(const std::string& json) {
  try {
    static_cast<void>(parse_settings(json, "view.json"));
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("settings come back as they were") {
  const Settings s = unusual();
  const Settings back = parse_settings(settings_json(s), "view.json");
  CHECK(back.ui.dark == s.ui.dark);
  CHECK(back.ui.scale == s.ui.scale);
  CHECK(back.ui.shown == s.ui.shown);
  CHECK(back.ui.open == s.ui.open);
  CHECK(back.ui.sizes == s.ui.sizes);
  CHECK(back.ui.contacts == s.ui.contacts);
  CHECK(back.ui.bonds == s.ui.bonds);
  CHECK(back.ui.color == s.ui.color);
  CHECK(back.ui.recent == s.ui.recent);
  CHECK(back.width == 1600);
  CHECK(back.height == 900);
}

TEST_CASE("settings that make no sense are refused with their place") {
  const std::string head = R"({"format":"pabd-view-settings","version":1,)";
  CHECK(settings_refusal(head + R"("dark":true})").empty());
  CHECK_THAT(settings_refusal("{"), Catch::Contains("view.json"));
  CHECK_THAT(settings_refusal("[]"), Catch::Contains("/format"));
  CHECK_THAT(settings_refusal(head + R"("dark":1})"), Catch::Contains("/dark"));
  CHECK_THAT(settings_refusal(head + R"("scale":1e9})"), Catch::Contains("/scale"));
  CHECK_THAT(settings_refusal(head + R"("scale":null})"), Catch::Contains("/scale"));
  CHECK_THAT(settings_refusal(head + R"("color":"mauve"})"), Catch::Contains("/color"));
  CHECK_THAT(settings_refusal(head + R"("open":[true]})"), Catch::Contains("/open"));
  CHECK_THAT(settings_refusal(head + R"("shown":["x","y","z"]})"), Catch::Contains("panel"));
  CHECK_THAT(settings_refusal(head + R"("sizes":[0,0,0]})"), Catch::Contains("/sizes"));
  CHECK_THAT(settings_refusal(head + R"("sizes":[0,0,2,0]})"),
             Catch::Contains("/sizes/2: expected 0.1 to 0.9"));
  CHECK_THAT(settings_refusal(head + R"("recent":[1]})"), Catch::Contains("/recent"));
  CHECK_THAT(settings_refusal(head + R"("width":-3})"), Catch::Contains("/width"));
  // Any beginning of the file, and any byte of it another one: an error or settings, never anything else.
  const std::string whole = settings_json(unusual());
  for (std::size_t n = 0; n + 2 < whole.size(); ++n)
    CHECK_FALSE(settings_refusal(whole.substr(0, n)).empty());
  for (std::size_t n = 0; n < whole.size(); ++n) {
    std::string spoiled = whole;
    spoiled[n] = static_cast<char>(spoiled[n] ^ 0x11);
    CHECK_NOTHROW(settings_refusal(spoiled));
  }
}

TEST_CASE("settings on disk: none, written, in a place where nothing can be written") {
  const TempFolder folder;
  CHECK(read_settings(folder / "none.json").ui.dark);
  write_settings(folder / "new" / "view.json", unusual());
  CHECK(read_settings(folder / "new" / "view.json").width == 1600);
  write_bytes(folder / "file", "x");
  CHECK_THROWS_AS(write_settings(folder / "file" / "view.json", unusual()), Error);
  REQUIRE(::setenv("XDG_CONFIG_HOME", "/somewhere", 1) == 0);
  CHECK(settings_path() == fs::path("/somewhere/pabd/view.json"));
  REQUIRE(::unsetenv("XDG_CONFIG_HOME") == 0);
  REQUIRE(::setenv("HOME", "relative", 1) == 0);
  CHECK_FALSE(settings_path());
}

}  // namespace pabd::test_settings
