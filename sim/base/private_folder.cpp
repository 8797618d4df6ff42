// SPDX-License-Identifier: MIT
// See private_folder.h.
#include "sim/base/private_folder.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>

#include "sim/base/descriptor.h"
#include "sim/base/file_failure.h"

namespace pabd {
namespace {

namespace fs = std::filesystem;

void sync_file(const fs::path& path) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW));
  if (file.get() < 0) fail_for(path, "cannot be opened", errno);
  // Some network folders know no fsync, which says nothing about the data.
  if (::fsync(file.get()) != 0 && errno != EINVAL && errno != ENOTSUP)
    fail_for(path, "could not be written", errno);
}

}  // namespace

void write_private_file(const fs::path& path, std::string_view bytes) {
  const Descriptor file(::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NOFOLLOW, 0666));
  if (file.get() < 0) fail_for(path, "cannot be created", errno);
  if (const int reason = write_all(file.get(), bytes.data(), bytes.size()))
    fail_for(path, "could not be written", reason);
}

// The name itself may be lost in a power cut, and the folder then has its old one: nobody took it for whole.
void publish_folder(const fs::path& folder, const fs::path& place) {
  std::error_code failure;
  fs::directory_iterator entries(folder, failure);
  for (; !failure && entries != fs::directory_iterator(); entries.increment(failure))
    sync_file(entries->path());
  if (failure) fail_for(folder, "cannot be read", failure.value());
  if (::rename(folder.c_str(), place.c_str()) != 0) fail_for(place, "could not get its name", errno);
}

}  // namespace pabd
