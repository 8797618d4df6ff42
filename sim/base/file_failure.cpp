// SPDX-License-Identifier: MIT
// See file_failure.h.
#include "sim/base/file_failure.h"

#include <fmt/format.h>

#include <cerrno>
#include <string>

#include "sim/base/descriptor.h"
#include "sim/base/error.h"

namespace pabd {
namespace {

// The remedy for the reasons that have one.
std::string remedy(int reason, const std::filesystem::path& folder) {
  switch (reason) {
    case ENOENT:
      return fmt::format("; create the folder: mkdir -p {}", folder.empty() ? "." : folder.string());
    case EACCES:
    case EPERM:
    case EROFS:
      return "; choose a folder that you may write to";
    case ENOSPC:
    case EDQUOT:
      return "; free some space or choose another disk";
    case EFBIG:
      return "; raise the limit on file sizes (ulimit -f)";
    case ENAMETOOLONG:
      return "; choose a shorter name";
    default:
      return "";
  }
}

}  // namespace

void fail_for(const std::filesystem::path& path, const std::string& what, int reason) {
  throw Error(ErrorKind::file, fmt::format("{}: {}: {}{}", path.string(), what, system_reason(reason),
                                           remedy(reason, path.parent_path())));
}

}  // namespace pabd
