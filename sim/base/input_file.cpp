// SPDX-License-Identifier: MIT
#include "sim/base/input_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <linux/magic.h>
#include <sys/stat.h>
#include <sys/vfs.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

#include "sim/base/error.h"

namespace pabd {
namespace {

constexpr std::size_t kPart = 1 << 16;

#ifndef PIPEFS_MAGIC
#define PIPEFS_MAGIC 0x50495045
#endif

// A pipe without a name: whoever writes to it has it open already, or has ended.
bool is_inherited_pipe(int fd) {
  struct statfs system;
  return ::fstatfs(fd, &system) == 0 && system.f_type == PIPEFS_MAGIC;
}

std::string problem_of(int fd, const struct stat& info) {
  if (S_ISREG(info.st_mode)) return "";
  if (S_ISDIR(info.st_mode)) return "it is a folder";
  if (!S_ISFIFO(info.st_mode)) return "it is a device, not a regular file";
  return is_inherited_pipe(fd)
             ? ""
             : "it is a pipe, not a regular file, and may never end; save what it gives to a file";
}

[[noreturn]] void refuse(const std::filesystem::path& path, std::string_view problem,
                         std::string_view expected) {
  throw Error(ErrorKind::file, path.string(),
              fmt::format("cannot be read: {}; expected {}", problem, expected));
}

}  // namespace

Descriptor open_input(const std::filesystem::path& path, std::string& problem) {
  problem.clear();
  // Without O_NONBLOCK opening a pipe by name would wait for somebody to write to it.
  Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK));
  struct stat info;
  if (file.get() < 0 || ::fstat(file.get(), &info) != 0) {
    problem = errno == ENXIO ? "it is a socket or a device, not a regular file" : system_reason(errno);
  } else {
    problem = problem_of(file.get(), info);
  }
  if (!problem.empty()) return Descriptor();
  // What blocks though it calls itself a regular file (/proc/kmsg) says that it has nothing.
  if (!S_ISREG(info.st_mode)) ::fcntl(file.get(), F_SETFL, ::fcntl(file.get(), F_GETFL) & ~O_NONBLOCK);
  return file;
}

Descriptor require_input(const std::filesystem::path& path, std::string_view expected) {
  std::string problem;
  Descriptor file = open_input(path, problem);
  if (!problem.empty()) refuse(path, problem, expected);
  return file;
}

ReadOutcome try_read_file(const std::filesystem::path& path, std::size_t most, std::string& bytes,
                          std::string& problem) {
  bytes.clear();
  const Descriptor file = open_input(path, problem);
  if (!problem.empty()) return ReadOutcome::unreadable;
  const auto too_long = [&] {
    problem = fmt::format("longer than {} bytes", most);
    return ReadOutcome::too_long;
  };
  struct stat info;
  if (::fstat(file.get(), &info) == 0 && S_ISREG(info.st_mode)) {
    const auto size = static_cast<std::size_t>(info.st_size);
    if (size > most) return too_long();
    bytes.reserve(size);
  }
  while (true) {  // a file of /proc says 0, and any file may grow meanwhile
    const std::size_t had = bytes.size();
    bytes.resize(had + std::min(kPart, most + 1 - had));
    const ssize_t n = read_some(file.get(), bytes.data() + had, bytes.size() - had);
    bytes.resize(had + static_cast<std::size_t>(std::max<ssize_t>(n, 0)));
    if (n < 0) {
      problem = system_reason(errno);
      return ReadOutcome::unreadable;
    }
    if (n == 0) return ReadOutcome::done;
    if (bytes.size() > most) return too_long();
  }
}

std::string read_file(const std::filesystem::path& path, std::size_t most, std::string_view expected,
                      std::string_view shorter) {
  std::string bytes, problem;
  const ReadOutcome outcome = try_read_file(path, most, bytes, problem);
  if (outcome == ReadOutcome::unreadable) refuse(path, problem, expected);
  if (outcome == ReadOutcome::too_long) {
    throw Error(ErrorKind::bad_input, path.string(),
                fmt::format("{}; expected {}", problem, shorter.empty() ? expected : shorter));
  }
  return bytes;
}

std::string read_if_possible(const std::filesystem::path& path, std::size_t most) {
  std::string bytes, problem;
  return try_read_file(path, most, bytes, problem) == ReadOutcome::done ? bytes : "";
}

}  // namespace pabd
