// SPDX-License-Identifier: MIT
// See zip_file.h.
#include "app/export/zip_file.h"

#include <archive.h>
#include <archive_entry.h>
#include <fmt/format.h>

#include <new>

#include "sim/base/error.h"

namespace pabd {

// Never says no: of an archive that failed libarchive (3.6) does not free the buffer. check() tells of the failure instead.
long ZipFile::put(::archive*, void* self, const void* data, std::size_t size) {
  auto& zip = *static_cast<ZipFile*>(self);
  try {
    if (!zip.failed_ && !zip.given_up_) zip.file_.write(data, size);
  } catch (...) {
    zip.failed_ = std::current_exception();
  }
  return static_cast<long>(size);
}

ZipFile::ZipFile(const std::string& path) : file_(path), path_(path), archive_(archive_write_new()) {
  if (archive_ == nullptr) throw std::bad_alloc();
  try {
    check(archive_write_set_format_zip(archive_));
    check(archive_write_zip_set_compression_store(archive_));
    check(archive_write_set_bytes_in_last_block(archive_, 1));  // no zeros behind the end
    check(archive_write_open(archive_, this, nullptr, put, nullptr));
  } catch (...) {
    archive_write_free(archive_);
    throw;
  }
}

ZipFile::~ZipFile() {
  if (archive_ == nullptr) return;
  given_up_ = true;
  archive_write_free(archive_);
}

void ZipFile::check(long result) {
  if (failed_) std::rethrow_exception(failed_);
  if (result >= ARCHIVE_OK) return;
  const char* reason = archive_error_string(archive_);
  throw Error(ErrorKind::file, fmt::format("{}: the archive cannot be written: {}", path_,
                                           reason != nullptr ? reason : "unknown reason"));
}

void ZipFile::begin(const std::string& name, std::size_t size) {
  const std::unique_ptr<archive_entry, void (*)(archive_entry*)> entry(archive_entry_new(),
                                                                       archive_entry_free);
  if (!entry) throw std::bad_alloc();
  archive_entry_set_pathname(entry.get(), name.c_str());
  archive_entry_set_size(entry.get(), static_cast<la_int64_t>(size));
  archive_entry_set_filetype(entry.get(), AE_IFREG);
  archive_entry_set_perm(entry.get(), 0644);
  archive_entry_set_mtime(entry.get(), 0, 0);
  check(archive_write_header(archive_, entry.get()));
}

void ZipFile::write(std::string_view part) {
  while (!part.empty()) {
    const la_ssize_t taken = archive_write_data(archive_, part.data(), part.size());
    check(static_cast<long>(taken));
    if (taken == 0)
      throw Error(ErrorKind::file, fmt::format("{}: an entry is longer than it was said to be", path_));
    part.remove_prefix(static_cast<std::size_t>(taken));
  }
}

void ZipFile::commit() {
  const int closed = archive_write_close(archive_);
  check(closed);
  archive_write_free(archive_);
  archive_ = nullptr;
  file_.commit();
}

}  // namespace pabd
