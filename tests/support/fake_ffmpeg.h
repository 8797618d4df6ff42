// SPDX-License-Identifier: MIT
// A shell script that is called ffmpeg and found first.
#pragma once

#include <stdlib.h>
#include <sys/stat.h>

#include <cstdlib>
#include <string>

#include "tests/support/temp_folder.h"

namespace pabd {

// A variable of the environment for the life of this.
class Environment {
 public:
  Environment(const char* name, const std::string& value) : name_(name) {
    const char* before = std::getenv(name);
    had_ = before != nullptr;
    if (had_) before_ = before;
    ::setenv(name, value.c_str(), 1);
  }
  ~Environment() { had_ ? ::setenv(name_, before_.c_str(), 1) : ::unsetenv(name_); }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

 private:
  const char* name_;
  std::string before_;
  bool had_ = false;
};

class FakeFfmpeg {
 public:
  // "$HERE" in the script is a folder of its own.
  explicit FakeFfmpeg(const std::string& script)
      : path_("PATH", folder_.path().string() + ":" + std::getenv("PATH")) {
    write_bytes(folder_ / "ffmpeg", "#!/bin/sh\nHERE='" + folder_.path().string() + "'\n" + script);
    ::chmod((folder_ / "ffmpeg").c_str(), 0755);
  }
  std::filesystem::path operator/(const std::string& name) const { return folder_ / name; }
  std::string folder() const { return folder_.path().string(); }

 private:
  TempFolder folder_;
  Environment path_;
};

}  // namespace pabd
