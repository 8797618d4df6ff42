// SPDX-License-Identifier: MIT
// Finding a command by its words.
#include <catch2/catch.hpp>

#include <algorithm>
#include <set>

#include "app/gui/actions.h"

namespace pabd::test_palette {

namespace {

std::vector<UserAction> three() {
  return {{"open", "Files", "ctrl+o", "open a scene", {}},
          {"save", "Files", "", "save the scene", {}},
          {"front", "View", "1", "from the front", {}}};
}

std::vector<std::string> found(const std::string& text) {
  const auto entries = three();
  std::vector<std::string> out;
  for (const UserAction* each : find_actions(entries, text)) out.push_back(each->words);
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

TEST_CASE(
    "every action can be carried out, is found by its name and told from the others, and no key has two") {
  std::set<std::pair<std::string, std::string>> names;
  std::set<std::string> keys;
  for (const UserAction& action : user_actions()) {
    CAPTURE(action.group, action.words);
    CHECK(action.act);
    CHECK_FALSE(action.words.empty());
    CHECK(names.emplace(action.group, action.words).second);
    if (*action.keys || *action.button) CHECK(&user_action(action.name) == &action);
    for (const KeyChord& chord : action.chords()) {
      CHECK(keys.insert(chord_text(chord)).second);
      CHECK(action.key_text().find(chord_text(chord)) != std::string::npos);
    }
    const auto found = find_actions(user_actions(), action.words);
    CHECK(std::find(found.begin(), found.end(), &action) != found.end());
  }
  for (const Choice& from : kLookFrom) CHECK(user_action(from.name).group == std::string("View"));
  CHECK(keys.size() > 40);
  CHECK(names.size() > keys.size());  // and what has no key
}

TEST_CASE("keys are named as people know them") {
  CHECK(chord_text(parse_key_chord("ctrl+shift+p")) == "Ctrl+Shift+P");
  CHECK(chord_text(parse_key_chord("shift+/")) == "?");
  CHECK(chord_text(parse_key_chord("left")) == "←");
}

}  // namespace pabd::test_palette
