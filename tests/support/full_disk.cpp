// SPDX-License-Identifier: MIT
// Preloaded into a program: a disk with room for PABD_DISK_BYTES bytes. What is written to regular files
// beyond that fails as on a full disk. With PABD_DISK_BROKEN set, fsync fails.
#include <dlfcn.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdlib>

namespace {

std::atomic<long long> used{0};

bool has_room(int fd, std::size_t size) {
  const char* room = std::getenv("PABD_DISK_BYTES");
  struct stat info;
  if (room == nullptr || ::fstat(fd, &info) != 0 || !S_ISREG(info.st_mode)) return true;
  return (used += static_cast<long long>(size)) <= std::atoll(room);
}

}  // namespace

extern "C" ssize_t write(int fd, const void* data, size_t size) {
  static const auto real =
      reinterpret_cast<ssize_t (*)(int, const void*, size_t)>(::dlsym(RTLD_NEXT, "write"));
  if (has_room(fd, size)) return real(fd, data, size);
  errno = ENOSPC;
  return -1;
}

extern "C" int fsync(int fd) {
  static const auto real = reinterpret_cast<int (*)(int)>(::dlsym(RTLD_NEXT, "fsync"));
  struct stat info;
  const bool broken = std::getenv("PABD_DISK_BROKEN") != nullptr;
  if (!broken || ::fstat(fd, &info) != 0 || !S_ISREG(info.st_mode)) return real(fd);
  errno = EIO;
  return -1;
}
