// SPDX-License-Identifier: MIT
// See file_root.h.
#include "app/workbench/file_root.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>

#include "sim/base/error.h"
#include "sim/base/utf8.h"

namespace pabd {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestName = 128;

[[noreturn]] void refuse(const std::string& name, const std::string& why) {
  throw Error(ErrorKind::bad_input, name.substr(0, kLongestName), why);
}

bool below(const fs::path& file, const fs::path& folder) {
  const auto [end, _] = std::mismatch(folder.begin(), folder.end(), file.begin(), file.end());
  return end == folder.end();
}

std::int64_t changed_at(const struct stat& status) {
  return std::int64_t{status.st_mtim.tv_sec} * 1'000'000'000 + status.st_mtim.tv_nsec;
}

}  // namespace

std::string refusal_of_name(std::string_view name) {
  if (name.empty()) return "a file needs a name";
  if (name.size() > kLongestName) return fmt::format("longer than {} bytes", kLongestName);
  if (name.front() == '.') return "hidden files are not served; expected a name that begins with no dot";
  if (!is_utf8_text(name)) return "no UTF-8";
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '/' || c == '\\') return "another folder; expected a name alone, all files are in one folder";
    if (byte < 0x20 || byte == 0x7f) return "control characters; expected a plain name";
    if (c == '{' || c == '}') return "one file at a time; expected a name without { }";
  }
  return "";
}

FileRoot::FileRoot(const fs::path& folder) {
  std::error_code failure;
  folder_ = fs::canonical(folder, failure);
  if (failure) throw Error(ErrorKind::file, folder.string(), "cannot be used: " + failure.message());
  handle_ = Descriptor(::open(folder_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (handle_.get() < 0)
    throw Error(ErrorKind::file, folder.string(), "cannot be used: " + system_reason(errno));
  first_ = stored();
}

// The name alone.
std::string FileRoot::own_name(const std::string& name) const {
  const std::string inside = folder_.string() + "/";
  const std::string own = name.starts_with(inside) ? name.substr(inside.size()) : name;
  if (const std::string why = refusal_of_name(own); !why.empty()) refuse(own, why);
  return own;
}

std::string FileRoot::file_of(const std::string& name) const {
  const std::string own = own_name(name);
  struct stat status = {};
  if (::fstatat(handle_.get(), own.c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0 && !S_ISREG(status.st_mode))
    refuse(own, "no plain file; expected another name");
  return folder_.string() + "/" + own;
}

FileRoot::Stored FileRoot::stored(const std::string& but) const {
  Stored out;
  std::error_code failure;
  for (fs::directory_iterator at(folder_, failure), end; !failure && at != end; at.increment(failure)) {
    const std::string name = at->path().filename().string();
    struct stat status = {};
    if (name == but || ::fstatat(handle_.get(), name.c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0 ||
        !S_ISREG(status.st_mode))
      continue;
    ++out.files;
    out.bytes += static_cast<std::uintmax_t>(status.st_size);
  }
  return out;
}

void FileRoot::check_room(const std::string& name, std::uintmax_t bytes) const {
  const std::string own = own_name(name);
  const Stored others = stored(own);
  if (others.files >= first_.files + kMostFiles || others.bytes + bytes > first_.bytes + kMostBytes)
    refuse(own, "there is no room for it: a session may add 1 GiB and 1000 files");
}

std::string FileRoot::folder_of(const std::string& name) const {
  const std::string own = own_name(name.ends_with('/') ? name.substr(0, name.size() - 1) : name);
  struct stat status = {};
  if (::fstatat(handle_.get(), own.c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0 || !S_ISDIR(status.st_mode))
    refuse(own, "there is no such folder");
  return folder_.string() + "/" + own;
}

void FileRoot::check_mesh(const fs::path& file) const {
  std::error_code failure;
  const fs::path real = fs::weakly_canonical(file, failure);
  const std::scoped_lock lock(mutex_);
  const bool fits = !failure && (real.parent_path() == folder_ ||
                                 std::any_of(allowed_.begin(), allowed_.end(),
                                             [&](const fs::path& one) { return below(real, one); }));
  if (!fits) throw Error(ErrorKind::bad_input, "not among the files of this session; upload the mesh first");
}

void FileRoot::allow(const fs::path& file_or_folder) {
  std::error_code failure;
  const fs::path real = fs::weakly_canonical(file_or_folder, failure);
  if (failure) return;
  const std::scoped_lock lock(mutex_);
  allowed_.insert(real);
}

Descriptor FileRoot::open(const std::string& name) const {
  if (const std::string why = refusal_of_name(name); !why.empty()) refuse(name, why);
  Descriptor file(::openat(handle_.get(), name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  struct stat status = {};
  if (file.get() < 0 || ::fstat(file.get(), &status) != 0 || !S_ISREG(status.st_mode))
    throw Error(ErrorKind::file, name.substr(0, kLongestName), "there is no such file");
  return file;
}

std::vector<FileRoot::Entry> FileRoot::list(std::size_t most) const {
  std::vector<Entry> out;
  std::error_code failure;
  for (fs::directory_iterator at(folder_, failure), end; !failure && at != end && out.size() < most;
       at.increment(failure)) {
    const std::string name = at->path().filename().string();
    struct stat status = {};
    if (!refusal_of_name(name).empty()) continue;
    if (::fstatat(handle_.get(), name.c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0) continue;
    if (S_ISREG(status.st_mode))
      out.push_back({name, static_cast<std::uintmax_t>(status.st_size), changed_at(status)});
  }
  std::sort(out.begin(), out.end(), [](const Entry& a, const Entry& b) { return a.name < b.name; });
  return out;
}

}  // namespace pabd
