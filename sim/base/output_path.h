// SPDX-License-Identifier: MIT
// May a file be written? Nothing that exists is replaced unasked, and nothing that is read ever.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace pabd {

// The files that a command reads, compared by device and inode, not by name: links and other ways to
// write a path lead to the same file.
class InputFiles {
 public:
  void add(const std::filesystem::path& path);  // one that does not exist is none
  bool contains(const std::filesystem::path& path) const;

 private:
  std::vector<std::pair<dev_t, ino_t>> files_;
};

struct OverwriteRule {
  bool force = false;                          // may replace what exists
  const InputFiles* inputs = nullptr;          // that are never replaced
  const char* remedy = "--force replaces it";  // when something exists and not `force`
};

// Throws Error(exists) if `path` is there and may not be replaced, Error(bad_input) if it may not be written
// for another reason. A device or a pipe is not replaced but written to. `name` is how messages call it: the
// path, perhaps with its option before.
void check_overwrite(const std::string& name, const std::filesystem::path& path, const OverwriteRule& rule);

// Throws Error(exists): "NAME: exists already; REMEDY".
[[noreturn]] void refuse_existing(const std::string& name, const std::string& remedy);

}  // namespace pabd
