// SPDX-License-Identifier: MIT
// Files that are read: never without end, never waiting for nobody. Files that are written: never over those.
#include <fcntl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <cstring>
#include <thread>

#include "sim/base/atomic_file.h"
#include "sim/base/input_file.h"
#include "sim/base/leftovers.h"
#include "sim/base/output_path.h"
#include "tests/support/errors.h"
#include "tests/support/temp_folder.h"

namespace pabd::test_files {

namespace fs = std::filesystem;

namespace {

Caught reading(const fs::path& path, std::size_t most = 100) {
  return caught([&] { static_cast<void>(read_file(path, most, "a list of things")); });
}

}  // namespace

TEST_CASE("a file is read up to its limit, not a byte further") {
  const TempFolder folder;
  const fs::path file = folder / "a";
  for (const std::size_t size : {0, 1, 99, 100}) {
    write_bytes(file, std::string(size, 'x'));
    CHECK(read_file(file, 100, "a list").size() == size);
  }
  write_bytes(file, std::string(101, 'x'));
  const Caught error = reading(file);
  CHECK(error.kind == bad_input);
  CHECK(error.says("longer than 100 bytes; expected a list of things"));
  // Sparse: nothing of it is on the disk, and nothing of it is read.
  REQUIRE(::truncate(file.c_str(), off_t{1} << 40) == 0);
  CHECK(reading(file).kind == bad_input);
  // A file whose size is only known when it is read.
  CHECK(read_file("/proc/self/status", 1 << 16, "a status").size() > 100);
  CHECK(reading("/proc/self/status", 50).kind == bad_input);
  // More than is read at a time, to the byte.
  std::string large;
  for (int i = 0; i < 60000; ++i) large += std::to_string(i);
  write_bytes(file, large);
  CHECK(read_file(file, large.size(), "numbers") == large);
}

TEST_CASE("what may block or never end is refused at once, by what it is") {
  const TempFolder folder;
  fs::create_symlink("/dev/zero", folder / "zero");
  fs::create_symlink("loop", folder / "loop");
  REQUIRE(::mkfifo((folder / "fifo").c_str(), 0600) == 0);
  fs::create_symlink("fifo", folder / "to fifo");
  const int listening = ::socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un address = {};
  address.sun_family = AF_UNIX;
  std::strncpy(address.sun_path, (folder / "socket").c_str(), sizeof address.sun_path - 1);
  REQUIRE(::bind(listening, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0);
  for (const auto& [name, words] : {std::pair{"zero", "it is a device"},
                                    {"loop", "too many levels of symbolic links"},
                                    {"fifo", "it is a pipe"},
                                    {"to fifo", "it is a pipe"},
                                    {"socket", "it is a socket"},
                                    {".", "it is a folder"},
                                    {"none", "no such file"}}) {
    const Caught error = reading(folder / name);
    INFO(error.text);
    CHECK(error.kind == file_error);
    CHECK(error.says(words));
    CHECK(error.says("expected a list of things"));
  }
  ::close(listening);
}

TEST_CASE("a pipe that the program was started with is read to its end, or to the limit") {
  int ends[2];
  REQUIRE(::pipe(ends) == 0);
  const std::string text(200000, 'k');  // more than a pipe holds
  std::thread writer([&] {
    CHECK(::write(ends[1], text.data(), text.size()) == static_cast<ssize_t>(text.size()));
    ::close(ends[1]);
  });
  const std::string path = "/dev/fd/" + std::to_string(ends[0]);
  CHECK(read_file(path, 1 << 20, "text") == text);
  writer.join();
  ::close(ends[0]);

  REQUIRE(::pipe(ends) == 0);
  REQUIRE(::write(ends[1], text.data(), 60000) == 60000);  // and it stays open: there is no end to wait for
  CHECK(reading("/dev/fd/" + std::to_string(ends[0]), 50000).says("longer than 50000"));
  ::close(ends[0]);
  ::close(ends[1]);
}

TEST_CASE("inputs are told by what they are: links and other names lead to the same file") {
  const TempFolder folder;
  write_bytes(folder / "in", "mine");
  write_bytes(folder / "other", "theirs");
  fs::create_symlink("in", folder / "link");
  fs::create_hard_link(folder / "in", folder / "hard");
  InputFiles inputs;
  inputs.add(folder / "link");
  inputs.add(folder / "none");
  const OverwriteRule forced{true, &inputs};
  for (const char* name : {"in", "link", "hard", "./../" /* replaced below */}) {
    const fs::path path =
        name[0] == '.' ? folder.path() / ".." / folder.path().filename() / "in" : folder / name;
    const Caught error = caught([&] { check_overwrite(path.string(), path, forced); });
    INFO(path);
    CHECK(error.kind == bad_input);
    CHECK(error.says("never overwritten"));
  }
  CHECK(caught([&] { check_overwrite("other", folder / "other", forced); }).kind == std::nullopt);
  CHECK(caught([&] { check_overwrite("new", folder / "new", forced); }).kind == std::nullopt);
  const Caught kept = caught([&] { check_overwrite("other", folder / "other", {false, &inputs}); });
  CHECK(kept.kind == exists);
  CHECK(kept.says("--force"));
  CHECK(caught([&] { check_overwrite("f", folder.path(), forced); }).says("is a folder"));
  CHECK(caught([&] { check_overwrite("null", "/dev/null", {}); }).kind == std::nullopt);
}

TEST_CASE("whoever leaves without destructors can remove what is temporary") {
  const TempFolder folder;
  AtomicFile kept(folder / "kept");
  kept.write("whole");
  kept.commit();
  AtomicFile begun(folder / "begun");
  begun.write("half");
  CHECK(folder.names().size() == 2);
  remove_leftovers();
  CHECK(folder.names() == std::vector<std::string>{"kept"});
  CHECK(caught([&] { begun.commit(); }).kind == file_error);

  write_bytes(folder / "past", "x");
  { const Leftover passing(folder / "past"); }
  write_bytes(folder / "moved", "x");
  Leftover one(folder / "moved");
  const Leftover other(std::move(one));
  // Many at a time, and their places used again.
  for (int round = 0; round < 3; ++round) {
    std::vector<Leftover> many;
    for (int i = 0; i < 300; ++i) many.emplace_back(folder / "none");
  }
  remove_leftovers();
  CHECK(folder.names() == std::vector<std::string>{"kept", "past"});
}

}  // namespace pabd::test_files
