// SPDX-License-Identifier: MIT
// Folders that are there whole or not at all, as others see them.
#include <catch2/catch.hpp>
#include <filesystem>

#include "sim/base/atomic_file.h"
#include "tests/support/errors.h"
#include "tests/support/files.h"
#include "tests/support/temp_folder.h"

namespace pabd::test_private_folder {

namespace fs = std::filesystem;

TEST_CASE("a folder takes its place with all of its files") {
  const TempFolder folder;
  fs::create_directory(folder / ".partial");
  write_private_file(folder / ".partial/a", "one");
  write_private_file(folder / ".partial/a", "2");  // over what a process left that was ended
  write_private_file(folder / ".partial/b", std::string(100000, 'x'));
  publish_folder(folder / ".partial", folder / "place");
  CHECK(folder.names() == std::vector<std::string>{"place"});
  CHECK(read_bytes(folder / "place/a") == "2");
  CHECK(read_bytes(folder / "place/b") == std::string(100000, 'x'));

  fs::create_directory(folder / ".again");
  fs::create_directory(folder / "empty");
  publish_folder(folder / ".again", folder / "empty");
  CHECK(folder.names() == std::vector<std::string>{"empty", "place"});
}

TEST_CASE("what cannot be is an error with its path, and leaves what was there") {
  const TempFolder folder;
  fs::create_directory(folder / ".partial");
  write_private_file(folder / ".partial/a", "new");
  fs::create_directory(folder / "full");
  write_bytes(folder / "full/a", "old");
  const Caught taken = caught([&] { publish_folder(folder / ".partial", folder / "full"); });
  CHECK(taken.kind == file_error);
  CHECK(taken.says("full"));
  CHECK(read_bytes(folder / "full/a") == "old");
  CHECK(read_bytes(folder / ".partial/a") == "new");
  CHECK(caught([&] { write_private_file(folder / "nowhere/a", ""); }).says("mkdir -p"));
  CHECK(caught([&] { publish_folder(folder / "none", folder / "place"); }).kind == file_error);
  // Not through a link.
  fs::create_symlink(folder / "full/a", folder / ".partial/link");
  CHECK(caught([&] { write_private_file(folder / ".partial/link", "new"); }).kind == file_error);
  CHECK(read_bytes(folder / "full/a") == "old");
  CHECK(caught([] { write_private_file("/dev/full", "x"); }).says("free some space"));
}

}  // namespace pabd::test_private_folder
