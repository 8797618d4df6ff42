// SPDX-License-Identifier: MIT
// A file that appears under its name only when it is whole.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "sim/base/leftovers.h"

namespace pabd {

// Folders that are made for a file, and go again with the object unless it is kept or they are in use.
class NewFolders {
 public:
  explicit NewFolders(const std::filesystem::path& file);  // throws Error(file)
  ~NewFolders();
  NewFolders(const NewFolders&) = delete;
  NewFolders& operator=(const NewFolders&) = delete;

  void keep() { made_.clear(); }

 private:
  void remove();

  std::vector<std::filesystem::path> made_;  // outermost first
};

class AtomicFile {
 public:
  // Opens a temporary file beside `path`, whose folder is made if need be. Throws Error(file) with path,
  // reason and remedy. A link is followed, so that the file it names is replaced and not the link. A device
  // or a pipe (/dev/stdout) cannot be replaced and is written directly.
  explicit AtomicFile(std::filesystem::path path);
  ~AtomicFile();  // removes the temporary file unless committed
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  // Small writes are collected, so an error may show at a later write or at commit. Throws Error(file).
  void write(const void* data, std::size_t size);
  void write(std::string_view text) { write(text.data(), text.size()); }
  void commit();  // flush, fsync, rename; throws Error(file). Once only.

  // For a program that writes the file by name, such as an encoder.
  const std::filesystem::path& temporary() const { return temporary_; }

 private:
  void open_temporary();
  void flush();
  [[noreturn]] void fail(const std::string& what, int reason) const;

  std::filesystem::path path_;  // as the caller named it: for messages
  NewFolders folders_;
  std::filesystem::path target_;  // links followed
  std::filesystem::path temporary_;
  std::string buffer_;
  Leftover leftover_;
  int fd_ = -1;
  bool direct_ = false;  // a device or a pipe
  bool committed_ = false;
};

// The whole file at once. Throws Error(file).
void write_file(const std::filesystem::path& path, std::string_view bytes);

// Throws the Error(file) that AtomicFile(path) would throw: to learn before hours of simulating. Leaves
// nothing.
void check_creatable(const std::filesystem::path& path);

// Files in a folder that nobody else reads yet are written in place, wait for the disk together, and are there at once when
// the folder gets its name. Each by itself as AtomicFile would cost two waits for the disk a file.
// Throws Error(file).
void write_private_file(const std::filesystem::path& path, std::string_view bytes);

// What is in the files of `folder` is on the disk, and then it has the name `place`; an empty folder there is replaced.
// Throws Error(file).
void publish_folder(const std::filesystem::path& folder, const std::filesystem::path& place);

}  // namespace pabd
