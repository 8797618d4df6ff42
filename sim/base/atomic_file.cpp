// SPDX-License-Identifier: MIT
// A file that appears under its name only when it is whole.
#include "sim/base/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <ctime>
#include <utility>

#include "sim/base/descriptor.h"
#include "sim/base/error.h"

namespace pabd {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t buffer_size = 1 << 16;
constexpr std::size_t longest_name = 255;  // NAME_MAX of the usual file systems

// The remedy for the reasons that have one.
std::string remedy(int reason, const fs::path& folder) {
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

// Throws Error(file) "PATH: WHAT: REASON; REMEDY", the remedy where the reason, an errno, has one.
[[noreturn]] void fail_for(const fs::path& path, const std::string& what, int reason) {
  throw Error(ErrorKind::file, fmt::format("{}: {}: {}{}", path.string(), what, system_reason(reason),
                                           remedy(reason, path.parent_path())));
}

fs::path folder_of(const fs::path& path) {
  const fs::path folder = path.parent_path();
  return folder.empty() ? fs::path(".") : folder;
}

// The folders above `path` that are missing, innermost first.
std::vector<fs::path> missing_folders(const fs::path& path) {
  std::vector<fs::path> missing;
  for (fs::path folder = folder_of(path);; folder = folder_of(folder)) {
    struct stat info;
    if (::stat(folder.c_str(), &info) == 0) {
      if (S_ISDIR(info.st_mode)) return missing;
      throw Error(ErrorKind::file, fmt::format("{}: {} is a file, not a folder; choose another folder",
                                               path.string(), folder.string()));
    }
    const int reason = errno;
    if (reason != ENOENT || folder == folder_of(folder))
      fail_for(path, fmt::format("the folder {} cannot be used", folder.string()), reason);
    missing.push_back(folder);
  }
}

std::string random_letters() {
  static constexpr char alphabet[] = "abcdefghijklmnopqrstuvwxyz234567";
  unsigned char bytes[6] = {};
  if (::getrandom(bytes, sizeof bytes, 0) != static_cast<ssize_t>(sizeof bytes)) {
    timespec now = {};
    clock_gettime(CLOCK_MONOTONIC, &now);
    for (int i = 0; i < 6; ++i)
      bytes[i] = static_cast<unsigned char>((now.tv_nsec >> (4 * i)) ^ (::getpid() >> i));
  }
  std::string text;
  for (unsigned char byte : bytes) text += alphabet[byte % 32];
  return text;
}

// Some devices and network folders know no fsync: EINVAL, which says nothing about the data.
void sync(int fd, const fs::path& path) {
  if (::fsync(fd) != 0 && errno != EINVAL && errno != ENOTSUP) fail_for(path, "could not be written", errno);
}

// Removes a temporary file that nobody writes any more. False: it is in use, or may be.
bool remove_abandoned(const fs::path& temporary) {
  const Descriptor file(::open(temporary.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK));
  struct stat held, named;
  if (file.get() < 0 || ::fstat(file.get(), &held) != 0 || !S_ISREG(held.st_mode) ||
      held.st_uid != ::geteuid())
    return false;
  if (::flock(file.get(), LOCK_EX | LOCK_NB) != 0) return false;
  // Its writer may have given it its name just now, and another one begun.
  const bool same =
      ::lstat(temporary.c_str(), &named) == 0 && named.st_ino == held.st_ino && named.st_dev == held.st_dev;
  return same && ::unlink(temporary.c_str()) == 0;
}

}  // namespace

NewFolders::NewFolders(const fs::path& file) {
  const std::vector<fs::path> missing = missing_folders(file);
  for (auto folder = missing.rbegin(); folder != missing.rend(); ++folder) {
    if (::mkdir(folder->c_str(), 0777) == 0) {
      made_.push_back(*folder);
    } else if (errno != EEXIST) {  // else: another program made it meanwhile
      const int reason = errno;
      remove();
      fail_for(file, fmt::format("the folder {} cannot be made", folder->string()), reason);
    }
  }
}

NewFolders::~NewFolders() { remove(); }

void NewFolders::remove() {
  for (; !made_.empty(); made_.pop_back()) ::rmdir(made_.back().c_str());
}

AtomicFile::AtomicFile(fs::path path) : path_(std::move(path)), folders_(path_), target_(path_) {
  if (path_.empty()) throw Error(ErrorKind::file, "an output file needs a name; none was given");
  if (path_.filename().empty()) {
    throw Error(ErrorKind::file, fmt::format("{}: this names a folder; add a file name", path_.string()));
  }

  struct stat info;
  if (::stat(path_.c_str(), &info) == 0) {
    std::error_code ignored;
    const fs::path resolved = fs::canonical(path_, ignored);
    if (S_ISDIR(info.st_mode)) {
      throw Error(ErrorKind::file, fmt::format("{}: this is a folder; add a file name", path_.string()));
    }
    if (!S_ISREG(info.st_mode)) {
      direct_ = true;
      temporary_ = path_;
      fd_ = ::open(path_.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY);
      if (fd_ < 0) fail("cannot be opened", errno);
      return;
    }
    if (::access(path_.c_str(), W_OK) != 0) fail("exists and cannot be replaced", errno);
    if (!resolved.empty()) target_ = resolved;
    open_temporary();
    // Replacing a file keeps who may read it. Not being allowed to is no reason to lose the result.
    if (::fchmod(fd_, info.st_mode & 07777) != 0) return;
  } else {
    open_temporary();
  }
}

// One writer holds its lock until it ends, however it ends: a file that is not locked is that of a writer that was killed.
void AtomicFile::open_temporary() {
  std::string name = target_.filename().string();
  if (name.size() > longest_name) fail("cannot be created", ENAMETOOLONG);
  name.resize(std::min(name.size(), longest_name - 17));
  bool usual = true;  // the name that the next run looks at
  for (int attempt = 0; attempt < 100; ++attempt) {
    temporary_ = target_.parent_path() /
                 fmt::format(".{}{}{}.pabd.tmp", name, usual ? "" : ".", usual ? "" : random_letters());
    // Before the file is there: a signal may come at any time.
    leftover_ = Leftover(temporary_);
    // mkstemp would give 0600; 0666 leaves the choice to the user's umask, as for any other file.
    fd_ = ::open(temporary_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (fd_ >= 0) {
      struct stat info;
      static_cast<void>(::flock(fd_, LOCK_EX));
      if (::fstat(fd_, &info) != 0 || info.st_nlink > 0) return;
      ::close(std::exchange(fd_, -1));  // another program took it for an abandoned one
      continue;
    }
    leftover_.release();  // it is another's
    if (errno != EEXIST && errno != EINTR) fail("cannot be created", errno);
    usual = errno == EINTR || remove_abandoned(temporary_);
  }
  fail("cannot be created", EEXIST);
}

AtomicFile::~AtomicFile() {
  if (fd_ >= 0) ::close(fd_);
  if (!committed_ && !direct_ && !temporary_.empty()) ::unlink(temporary_.c_str());
}

void AtomicFile::fail(const std::string& what, int reason) const { fail_for(path_, what, reason); }

void AtomicFile::write(const void* data, std::size_t size) {
  if (fd_ < 0) throw Error(ErrorKind::defect, fmt::format("{}: written after commit", path_.string()));
  if (size == 0) return;
  if (buffer_.size() + size > buffer_size) flush();
  if (size < buffer_size) {
    buffer_.append(static_cast<const char*>(data), size);
    return;
  }
  const BlockSigpipe no_signal;  // a direct target may be a pipe
  if (const int reason = write_all(fd_, data, size)) fail("could not be written", reason);
}

void AtomicFile::flush() {
  if (buffer_.empty()) return;
  const BlockSigpipe no_signal;
  if (const int reason = write_all(fd_, buffer_.data(), buffer_.size())) fail("could not be written", reason);
  buffer_.clear();
}

void AtomicFile::commit() {
  if (fd_ < 0) throw Error(ErrorKind::defect, fmt::format("{}: committed twice", path_.string()));
  flush();
  sync(fd_, path_);
  const int closed = ::close(std::exchange(fd_, -1));
  if (closed != 0 && errno != EINTR) fail("could not be closed", errno);
  if (!direct_ && ::rename(temporary_.c_str(), target_.c_str()) != 0) fail("could not get its name", errno);
  committed_ = true;
  folders_.keep();
  leftover_.release();
  if (direct_) return;

  // The name itself lives in the folder: without this it can be lost in a power cut.
  const int folder = ::open(folder_of(target_).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder < 0) return;  // a folder that may be written but not read
  const int synced = ::fsync(folder);
  const int why = errno;
  ::close(folder);
  if (synced != 0 && why == EIO) fail("its folder could not be written", why);
}

void write_file(const fs::path& path, std::string_view bytes) {
  AtomicFile file(path);
  file.write(bytes);
  file.commit();
}

void check_creatable(const fs::path& path) { const AtomicFile probe(path); }

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
  for (; !failure && entries != fs::directory_iterator(); entries.increment(failure)) {
    const Descriptor file(::open(entries->path().c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW));
    if (file.get() < 0) fail_for(entries->path(), "cannot be opened", errno);
    sync(file.get(), entries->path());
  }
  if (failure) fail_for(folder, "cannot be read", failure.value());
  if (::rename(folder.c_str(), place.c_str()) != 0) fail_for(place, "could not get its name", errno);
}

}  // namespace pabd
