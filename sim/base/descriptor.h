// SPDX-License-Identifier: MIT
// Checked reading and writing of POSIX descriptors.
#pragma once

#include <signal.h>
#include <sys/types.h>

#include <cstddef>
#include <string>
#include <utility>

namespace pabd {

// Owns a descriptor.
class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int fd) : fd_(fd) {}
  ~Descriptor() { close(); }
  Descriptor(Descriptor&& other) noexcept : fd_(other.fd_) { other.fd_ = -1; }
  Descriptor& operator=(Descriptor&& other) noexcept;
  int get() const { return fd_; }
  int release() { return std::exchange(fd_, -1); }  // it is another's now
  void close();

 private:
  int fd_ = -1;
};

// While it lives, writing to a pipe without reader gives EPIPE in this thread instead of ending the process,
// and other threads and the process's signal handlers stay as they are: a library must not set the handler of
// its program.
class BlockSigpipe {
 public:
  BlockSigpipe();
  ~BlockSigpipe();
  BlockSigpipe(const BlockSigpipe&) = delete;
  BlockSigpipe& operator=(const BlockSigpipe&) = delete;

 private:
  sigset_t previous_;
  bool was_pending_ = false;
};

// Reads once, through interruptions: the number of bytes, 0 at the end, −1 with errno.
ssize_t read_some(int fd, void* data, std::size_t size);

// Writes all bytes, through interruptions, short writes and non-blocking descriptors. Returns 0 or errno.
int write_all(int fd, const void* data, std::size_t size);

// The system's text for an errno value, in lower case: "no space left on device".
std::string system_reason(int number);

}  // namespace pabd
