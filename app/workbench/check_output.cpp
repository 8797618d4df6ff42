// SPDX-License-Identifier: MIT
// See check_output.h.
#include "app/workbench/check_output.h"

#include <filesystem>

#include "sim/base/error.h"
#include "sim/base/output_path.h"

namespace pabd {

bool same_file(const std::string& a, const std::string& b) {
  std::error_code none;
  return std::filesystem::equivalent(a, b, none);
}

void check_output(const std::string& path, bool force, const std::string& open_scene) {
  if (path.empty()) throw Error(ErrorKind::bad_input, "a file needs a name");
  check_overwrite(path, path, {force, nullptr, "replace it"});
  if (same_file(path, open_scene))
    throw Error(ErrorKind::bad_input, path, "that is the scene which is open; choose another name");
}

}  // namespace pabd
