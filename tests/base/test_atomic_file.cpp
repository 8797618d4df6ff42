// SPDX-License-Identifier: MIT
// Files appear whole or not at all.
#include <catch2/catch.hpp>

#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <thread>

#include "sim/base/atomic_file.h"
#include "sim/base/descriptor.h"
#include "tests/support/errors.h"
#include "tests/support/file_size_limit.h"
#include "tests/support/files.h"
#include "tests/support/temp_folder.h"

namespace pabd::test_atomic_file {

namespace fs = std::filesystem;

namespace {

// The process's umask and folder, restored.
class Umask {
 public:
  explicit Umask(mode_t mask) : before_(::umask(mask)) {}
  ~Umask() { ::umask(before_); }

 private:
  mode_t before_;
};

class WorkingFolder {
 public:
  explicit WorkingFolder(const fs::path& path) : before_(fs::current_path()) { fs::current_path(path); }
  ~WorkingFolder() { fs::current_path(before_); }

 private:
  fs::path before_;
};

int mode_of(const fs::path& path) {
  struct stat info;
  return ::stat(path.c_str(), &info) == 0 ? static_cast<int>(info.st_mode & 0777) : -1;
}

}  // namespace

TEST_CASE("a committed file is whole, and nothing else is left") {
  const TempFolder folder;
  const std::string text(300000, 'x');
  {
    AtomicFile file(folder / "a.txt");
    CHECK_FALSE(fs::exists(folder / "a.txt"));
    CHECK(file.temporary().parent_path() == folder.path());
    file.write("begin ");
    file.write(text);
    file.write("");
    file.write(" end");
    CHECK_FALSE(fs::exists(folder / "a.txt"));
    file.commit();
    CHECK(read_bytes(folder / "a.txt") == "begin " + text + " end");
    CHECK(caught([&] { file.write("more"); }).kind == defect);
    CHECK(caught([&] { file.commit(); }).kind == defect);
  }
  CHECK(folder.names() == std::vector<std::string>{"a.txt"});
}

TEST_CASE("a file that is not committed leaves nothing, and what was there stays") {
  const TempFolder folder;
  write_bytes(folder / "a.txt", "before");
  { AtomicFile(folder / "a.txt").write("after"); }
  CHECK(read_bytes(folder / "a.txt") == "before");
  CHECK(folder.names() == std::vector<std::string>{"a.txt"});
}

TEST_CASE("names without folder, with spaces, and as long as can be") {
  const TempFolder folder;
  const WorkingFolder here(folder.path());
  for (const std::string& name :
       {std::string("plain"), std::string("with space %s {}.txt"), std::string(255, 'n')}) {
    AtomicFile file(name);
    file.write("x");
    file.commit();
    CHECK(read_bytes(folder / name) == "x");
  }
  CHECK(caught([] { AtomicFile file(std::string(256, 'n')); }).says("choose a shorter name"));
  CHECK(folder.names().size() == 3);
}

TEST_CASE("what a killed writer left goes with the next one; what another still writes stays") {
  const TempFolder folder;
  const fs::path path = folder / "a.txt";
  {
    AtomicFile first(path), second(path), third(path);  // side by side, each with a file of its own
    CHECK(first.temporary() != second.temporary());
    CHECK(second.temporary() != third.temporary());
    for (AtomicFile* file : {&third, &first, &second}) {
      file->write(file->temporary().string());
      file->commit();
    }
    CHECK(read_bytes(path) == second.temporary().string());
  }
  const fs::path left = AtomicFile(path).temporary();  // as every first writer calls it
  CHECK_FALSE(fs::exists(left));
  write_bytes(left, "of a writer that was killed");
  {
    AtomicFile next(path);
    CHECK(next.temporary() == left);
    next.write("whole");
    next.commit();
  }
  CHECK(read_bytes(path) == "whole");
  CHECK(std::distance(fs::directory_iterator(folder.path()), {}) == 1);
  // What looks so but is another's: neither followed nor removed.
  write_bytes(folder / "other", "kept");
  fs::create_symlink("other", left);
  CHECK(AtomicFile(path).temporary() != left);
  CHECK(read_bytes(folder / "other") == "kept");
  CHECK(fs::is_symlink(left));
}

TEST_CASE("permissions are those of any new file, and of the file that is replaced") {
  const TempFolder folder;
  const Umask mask(0027);
  AtomicFile file(folder / "new");
  file.commit();
  CHECK(mode_of(folder / "new") == 0640);
  ::chmod((folder / "new").c_str(), 0604);
  AtomicFile again(folder / "new");
  again.commit();
  CHECK(mode_of(folder / "new") == 0604);
}

TEST_CASE("a link stays and the file that it names is replaced") {
  const TempFolder folder;
  fs::create_directory(folder / "data");
  write_bytes(folder / "data/real", "old");
  fs::create_symlink("data/real", folder / "link");
  AtomicFile file(folder / "link");
  file.write("new");
  file.commit();
  CHECK(fs::is_symlink(folder / "link"));
  CHECK(read_bytes(folder / "data/real") == "new");
}

TEST_CASE("folders that are missing are made, and go again when nothing came into them") {
  const TempFolder folder;
  {
    AtomicFile file(folder / "a/b c/d/x.txt");
    CHECK(fs::is_directory(folder / "a/b c/d"));
  }
  CHECK(folder.names().empty());
  check_creatable(folder / "a/x.txt");
  CHECK(folder.names().empty());
  {
    AtomicFile file(folder / "a/b c/x.txt");
    file.write("x");
    file.commit();
  }
  CHECK(read_bytes(folder / "a/b c/x.txt") == "x");
  {
    AtomicFile other(folder / "e/f/x.txt");
    write_bytes(folder / "e/y.txt", "of another program");
  }
  CHECK_FALSE(fs::exists(folder / "e/f"));
  CHECK(read_bytes(folder / "e/y.txt") == "of another program");
  const WorkingFolder here(folder.path());
  AtomicFile relative("g/h/x.txt");
  relative.commit();
  CHECK(fs::exists(folder / "g/h/x.txt"));
}

TEST_CASE("folders that cannot be made or are none are named, with the remedy") {
  const TempFolder folder;
  const Caught long_name = caught([&] { AtomicFile file(folder / "b" / std::string(300, 'n') / "a.txt"); });
  CHECK(long_name.kind == file_error);
  CHECK(folder.names().empty());

  write_bytes(folder / "file", "");
  const Caught below = caught([&] { AtomicFile file(folder / "file/a.txt"); });
  CHECK(below.kind == file_error);
  CHECK(below.says("is a file, not a folder"));
  CHECK(caught([&] { AtomicFile file(folder / "file/deep/a.txt"); }).says("not a directory"));

  CHECK(caught([&] { AtomicFile file(folder.path()); }).says("this is a folder"));
  CHECK(caught([&] { AtomicFile file(folder / "file" / ""); }).kind == file_error);
  CHECK(caught([] { AtomicFile file(""); }).kind == file_error);
  CHECK(caught([&] { check_creatable(folder / "file/such/a.txt"); }).kind == file_error);
  CHECK_NOTHROW(check_creatable(folder / "fine"));
  CHECK(folder.names() == std::vector<std::string>{"file"});
}

TEST_CASE("a full disk is an error, and nothing is left under either name") {
  const TempFolder folder;
  {
    const FileSizeLimit full(100000);
    const Caught large = caught([&] {
      AtomicFile file(folder / "large");
      file.write(std::string(300000, 'x'));
      file.commit();
    });
    CHECK(large.kind == file_error);
    CHECK(large.says("file too large"));
    const Caught small = caught([&] {  // in pieces that are collected
      AtomicFile file(folder / "small");
      for (int i = 0; i < 30000; ++i) file.write("0123456789");
      file.commit();
    });
    CHECK(small.kind == file_error);
  }
  CHECK(folder.names().empty());

  const Caught device = caught([] {
    AtomicFile file("/dev/full");
    file.write("x");
    file.commit();
  });
  CHECK(device.kind == file_error);
  CHECK(device.says("no space left on device; free some space"));
  CHECK(fs::is_character_file("/dev/full"));
}

TEST_CASE("a device is written and not replaced") {
  AtomicFile file("/dev/null");
  file.write(std::string(200000, 'x'));
  file.commit();
  CHECK(fs::is_character_file("/dev/null"));
}

TEST_CASE("a pipe without reader gives an error and no signal") {
  int ends[2];
  REQUIRE(::pipe(ends) == 0);
  ::close(ends[0]);
  const Descriptor out(ends[1]);
  {
    const BlockSigpipe no_signal;  // the default action would end this program
    CHECK(write_all(out.get(), "x", 1) == EPIPE);
    const BlockSigpipe nested;
    CHECK(write_all(out.get(), "x", 1) == EPIPE);
  }
  sigset_t now;
  pthread_sigmask(SIG_SETMASK, nullptr, &now);
  CHECK(sigismember(&now, SIGPIPE) == 0);
  sigpending(&now);
  CHECK(sigismember(&now, SIGPIPE) == 0);
  struct sigaction action;
  ::sigaction(SIGPIPE, nullptr, &action);
  CHECK(action.sa_handler == SIG_DFL);
}

TEST_CASE("writing goes on after short writes on a pipe that does not block") {
  int ends[2];
  REQUIRE(::pipe2(ends, O_NONBLOCK) == 0);
  Descriptor in(ends[0]), out(ends[1]);
  const std::string text(1 << 20, 'y');  // 16 times what the pipe holds
  std::atomic<std::size_t> total{0};
  std::thread reader([&] {
    char part[5000];
    while (true) {
      const ssize_t n = ::read(in.get(), part, sizeof part);
      if (n == 0) return;
      if (n > 0) total += static_cast<std::size_t>(n);
      if (n < 0) ::usleep(200);
    }
  });
  CHECK(write_all(out.get(), text.data(), text.size()) == 0);
  out.close();
  reader.join();
  CHECK(total == text.size());
}

}  // namespace pabd::test_atomic_file
