// SPDX-License-Identifier: MIT
#include "sim/base/output_path.h"

#include <sys/stat.h>

#include <algorithm>

#include "sim/base/error.h"

namespace pabd {

void InputFiles::add(const std::filesystem::path& path) {
  struct stat info;
  if (!path.empty() && ::stat(path.c_str(), &info) == 0 && S_ISREG(info.st_mode))
    files_.emplace_back(info.st_dev, info.st_ino);
}

bool InputFiles::contains(const std::filesystem::path& path) const {
  struct stat info;
  if (::stat(path.c_str(), &info) != 0) return false;
  return std::find(files_.begin(), files_.end(), std::pair(info.st_dev, info.st_ino)) != files_.end();
}

void check_overwrite(const std::string& name, const std::filesystem::path& path, const OverwriteRule& rule) {
  struct stat info;
  if (::stat(path.c_str(), &info) != 0 || (!S_ISREG(info.st_mode) && !S_ISDIR(info.st_mode))) return;
  if (S_ISDIR(info.st_mode)) throw Error(ErrorKind::bad_input, name, "is a folder; name a file in it");
  if (rule.inputs && rule.inputs->contains(path)) {
    throw Error(ErrorKind::bad_input, name,
                "is read here, and what is read is never overwritten; choose another name");
  }
  if (!rule.force) refuse_existing(name, std::string(rule.remedy) + ", or choose another name");
}

void refuse_existing(const std::string& name, const std::string& remedy) {
  throw Error(ErrorKind::exists, name, "exists already; " + remedy);
}

}  // namespace pabd
