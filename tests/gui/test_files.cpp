// SPDX-License-Identifier: MIT
// What the browser of a dialog lists, and what a dropped file is taken for.
#include <catch2/catch.hpp>
#include <filesystem>

#include "app/gui/file_list.h"
#include "tests/support/temp_folder.h"

namespace pabd::test_files {

namespace fs = std::filesystem;

TEST_CASE("names are in the order in which people count") {
  CHECK(natural_less("frame2.png", "frame10.png"));
  CHECK_FALSE(natural_less("frame10.png", "frame2.png"));
  CHECK(natural_less("a.json", "B.json"));
  CHECK(natural_less("a", "ab"));
  CHECK_FALSE(natural_less("a", "a"));
  CHECK(natural_less("x007", "x8"));
  CHECK(natural_less("99999999999999999999998", "99999999999999999999999"));  // larger than any number
}

TEST_CASE("folders come first, then files of the kind, hidden ones never") {
  const TempFolder folder;
  for (const char* name : {"b.json", "a10.json", "a2.json", "note.txt", ".hidden.json"})
    write_bytes(folder / name, "{}");
  fs::create_directory(folder / "z");
  fs::create_directory(folder / "A");
  fs::create_directory(folder / ".git");
  std::vector<std::string> names;
  for (const FileEntry& entry : list_files(folder.path(), ".json"))
    names.push_back(entry.name + (entry.folder ? "/" : ""));
  CHECK(names == std::vector<std::string>{"A/", "z/", "a2.json", "a10.json", "b.json"});
  CHECK(list_files(folder.path(), ".json", 1).size() == 2);  // one of either kind
  CHECK(list_files(folder / "nothing", ".json").empty());
  CHECK(list_files(folder / "b.json", ".json").empty());
}

TEST_CASE("what is typed names a folder and a file in it") {
  const TempFolder folder;
  CHECK(folder_of_typed("scene.json") == ".");
  CHECK(folder_of_typed("") == ".");
  CHECK(folder_of_typed((folder / "new.json").string()) == folder.path());
  CHECK(folder_of_typed(folder.path().string()) == folder.path());
  CHECK(in_folder(".", "a.json") == "a.json");
  CHECK(in_folder("/x/y/..", "a.json") == "/x/a.json");
}

TEST_CASE("what is dropped is told by its name and by what is in it") {
  const TempFolder folder;
  const auto kind = [&](const char* name, const std::string& text) {
    write_bytes(folder / name, text);
    return kind_of_dropped((folder / name).string());
  };
  CHECK(kind("a.pabdrec", "") == DroppedKind::recording);
  CHECK(kind("keys.json", R"({"format": "pabd-camera", "version": 1})") == DroppedKind::camera);
  CHECK(kind("soft.json", R"(  {"contact": {"kappa": 50}})") == DroppedKind::patch);
  CHECK(kind("scene.json", R"({"format": "pabd-scene", "version": 1})") == DroppedKind::scene);
  CHECK(kind("list.json", "[1, 2]") == DroppedKind::scene);  // whose reader says what is wrong
  CHECK(kind("large.json", "{" + std::string(2000000, ' ') + "}") == DroppedKind::scene);
  CHECK(kind_of_dropped((folder / "nothing.json").string()) == DroppedKind::scene);
}

}  // namespace pabd::test_files
