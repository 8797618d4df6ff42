// SPDX-License-Identifier: MIT
// Finding a command by its words.
#include <catch2/catch.hpp>

#include <algorithm>
#include <set>

#include "app/gui/key_table.h"
#include "app/gui/palette.h"

namespace pabd::test_palette {

namespace {

std::vector<PaletteEntry> three() {
  return {{"Files", "open a scene", "Ctrl+O", {}},
          {"Files", "save the scene", "", {}},
          {"View", "from the front", "1", {}}};
}

std::vector<std::string> found(const std::string& text) {
  const auto entries = three();
  std::vector<std::string> out;
  for (const PaletteEntry* each : find_entries(entries, text)) out.push_back(each->words);
  return out;
}

}  // namespace

TEST_CASE("entries are found by the beginnings of their words, then by parts of them") {
  using Words = std::vector<std::string>;
  CHECK(found("") == Words{"open a scene", "save the scene", "from the front"});
  CHECK(found("scene") == Words{"open a scene", "save the scene"});
  CHECK(found("SC sa") == Words{"save the scene"});
  CHECK(found("files") == Words{"open a scene", "save the scene"});
  CHECK(found("ctrl+o") == Words{"open a scene"});
  CHECK(found("pen") == Words{"open a scene"});
  CHECK(found("e") == Words{"open a scene", "save the scene", "from the front"});
  CHECK(found("fr") == Words{"from the front"});
  CHECK(found("front scene").empty());
  CHECK(found("   ").size() == 3);
}

TEST_CASE("the palette has every key, and every entry can be carried out and told from the others") {
  const auto& entries = palette_entries();
  std::set<std::pair<std::string, std::string>> names;
  for (const PaletteEntry& entry : entries) {
    CAPTURE(entry.group, entry.words);
    CHECK(entry.act);
    CHECK_FALSE(entry.words.empty());
    CHECK(names.emplace(entry.group, entry.words).second);
  }
  for (const KeyBinding& binding : key_table()) {
    const std::string keys = chord_text(binding.chord);
    CAPTURE(keys, binding.help);
    CHECK(std::count_if(entries.begin(), entries.end(), [&](const PaletteEntry& e) {
            return e.words == binding.help && e.keys.find(keys) != std::string::npos;
          }) == 1);
  }
  CHECK(entries.size() > key_table().size());  // and what has no key
}

TEST_CASE("keys are named as people know them") {
  CHECK(chord_text(parse_key_chord("ctrl+shift+p")) == "Ctrl+Shift+P");
  CHECK(chord_text(parse_key_chord("shift+/")) == "?");
  CHECK(chord_text(parse_key_chord("left")) == "←");
}

}  // namespace pabd::test_palette
