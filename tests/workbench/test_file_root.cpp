// SPDX-License-Identifier: MIT
// The one folder of somebody far away: no name leads out of it.
#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <filesystem>

#include "app/workbench/file_root.h"
#include "sim/base/error.h"
#include "tests/support/files.h"
#include "tests/support/temp_folder.h"

namespace pabd::test_file_root {

namespace fs = std::filesystem;

namespace {

bool refused(const FileRoot& root, const std::string& name) {
  try {
    static_cast<void>(root.file_of(name));
    return false;
  } catch (const Error& error) {
    return error.kind() == ErrorKind::bad_input;
  }
}

}  // namespace

TEST_CASE("a name is a file of the folder") {
  const TempFolder folder;
  const FileRoot root(folder.path());
  const std::string inside = (fs::canonical(folder.path()) / "a.json").string();
  CHECK(root.file_of("a.json") == inside);
  CHECK(root.file_of(inside) == inside);
  CHECK(root.file_of("Würfel 2.json").ends_with("/Würfel 2.json"));
}

TEST_CASE("nothing else is") {
  const TempFolder folder;
  const FileRoot root(folder.path());
  const std::string inside = fs::canonical(folder.path()).string();
  for (const std::string& name :
       {std::string(""), std::string("."), std::string(".."), std::string("../a"), std::string("/etc/passwd"),
        std::string("a/b"), std::string("a\\b"), std::string(".hidden"), std::string("a\nb"),
        std::string("a\0b", 3), std::string("\xff"), std::string("{frame:04}.png"), std::string(200, 'x'),
        inside, inside + "/", inside + "/../a", inside + "/sub/a", inside + "/.hidden", inside + "x/a"}) {
    CAPTURE(name);
    CHECK(refused(root, name));
  }
}

TEST_CASE("links, folders and pipes are no files, even when they lie there") {
  const TempFolder folder, outside;
  write_bytes(outside / "secret", "secret");
  fs::create_symlink(outside / "secret", folder / "link");
  fs::create_symlink(outside.path(), folder / "folder_link");
  fs::create_symlink("/nowhere", folder / "dangling");
  fs::create_directory(folder / "sub");
  REQUIRE(::mkfifo((folder / "pipe").c_str(), 0600) == 0);
  write_bytes(folder / "file", "ours");
  const FileRoot root(folder.path());
  for (const char* name : {"link", "folder_link", "dangling", "sub", "pipe"}) {
    CAPTURE(name);
    CHECK(refused(root, name));
    CHECK_THROWS_AS(root.open(name), Error);
  }
  CHECK_FALSE(refused(root, "file"));
  char bytes[5] = {};
  CHECK(read_some(root.open("file").get(), bytes, 4) == 4);
  CHECK(std::string(bytes) == "ours");
  const auto listed = root.list();
  REQUIRE(listed.size() == 1);
  CHECK(listed[0].name == "file");
  CHECK(listed[0].bytes == 4);
}

TEST_CASE("there is room for 1 GiB and 1000 files beside what the folder had") {
  const TempFolder folder;
  const auto file_of = [&](const std::string& name, std::uintmax_t bytes) {
    write_bytes(folder / name, "");
    fs::resize_file(folder / name, bytes);
  };
  file_of("before", 3 * FileRoot::kMostBytes);  // they have holes
  const FileRoot root(folder.path());
  CHECK_NOTHROW(root.check_room("new", FileRoot::kMostBytes));
  CHECK_THROWS_AS(root.check_room("new", FileRoot::kMostBytes + 1), Error);
  CHECK_THROWS_AS(root.check_room("../new"), Error);
  file_of("large", FileRoot::kMostBytes - 10);
  CHECK_NOTHROW(root.check_room("new", 10));
  CHECK_THROWS_AS(root.check_room("new", 11), Error);
  CHECK_NOTHROW(root.check_room("large", FileRoot::kMostBytes));  // in its place
  // More than a list has.
  for (std::size_t i = 2; i < FileRoot::kMostFiles; ++i) write_bytes(folder / ("a" + std::to_string(i)), "");
  CHECK_NOTHROW(root.check_room("new"));
  write_bytes(folder / ".hidden", "");
  CHECK_THROWS_AS(root.check_room("new"), Error);
  CHECK_NOTHROW(root.check_room("a2", 10));
  CHECK_THROWS_AS(root.check_room("a2", 11), Error);
}

TEST_CASE("meshes come from the folder, or from where it was allowed") {
  const TempFolder folder, outside;
  fs::create_directory(outside / "meshes");
  write_bytes(outside / "meshes" / "a.obj", "");
  write_bytes(outside / "b.obj", "");
  write_bytes(folder / "own.obj", "");
  fs::create_symlink(outside / "b.obj", folder / "link.obj");
  FileRoot root(folder.path());
  CHECK_NOTHROW(root.check_mesh(folder / "own.obj"));
  CHECK_THROWS_AS(root.check_mesh(folder / "link.obj"), Error);
  CHECK_THROWS_AS(root.check_mesh(folder / ".." / "b.obj"), Error);
  CHECK_THROWS_AS(root.check_mesh(outside / "meshes" / "a.obj"), Error);
  root.allow(outside / "meshes");
  CHECK_NOTHROW(root.check_mesh(outside / "meshes" / "a.obj"));
  CHECK_THROWS_AS(root.check_mesh(outside / "meshes" / ".." / "b.obj"), Error);
  root.allow(outside / "b.obj");
  CHECK_NOTHROW(root.check_mesh(folder / "link.obj"));
}

TEST_CASE("a folder is one that lies there, by its name alone") {
  const TempFolder folder, outside;
  fs::create_directory(folder / "sweep");
  fs::create_directory(folder / "sweep/tasks");
  fs::create_directory(folder / ".hidden");
  fs::create_symlink(outside.path(), folder / "link");
  write_bytes(folder / "file", "ours");
  const FileRoot root(folder.path());
  const std::string inside = (fs::canonical(folder.path()) / "sweep").string();
  for (const std::string& name : {std::string("sweep"), std::string("sweep/"), inside})
    CHECK(root.folder_of(name) == inside);
  for (const char* name : {"", ".", "..", "/", "link", "file", "none", ".hidden", "sweep/tasks", "/tmp"}) {
    CAPTURE(name);
    CHECK_THROWS_AS(root.folder_of(name), Error);
  }
}

}  // namespace pabd::test_file_root
