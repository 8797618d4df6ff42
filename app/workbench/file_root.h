// SPDX-License-Identifier: MIT
// The one folder that a remote user may read and write, whatever name is given.
#pragma once

#include <cstdint>
#include <filesystem>
#include <mutex>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "sim/base/descriptor.h"

namespace pabd {

enum class FileUse { read, write };

class FileRoot {
 public:
  struct Entry {
    std::string name;
    std::uintmax_t bytes = 0;
    std::int64_t changed = 0;  // ns, of the file system
    bool operator==(const Entry&) const = default;
  };
  // Limits of what may be added.
  static constexpr std::size_t kMostFiles = 1000;
  static constexpr std::uintmax_t kMostBytes = std::uintmax_t{1} << 30;

  // `folder` exists. Throws Error(file) when it cannot be opened.
  explicit FileRoot(const std::filesystem::path& folder);

  const std::filesystem::path& folder() const { return folder_; }  // absolute, links followed

  // The file that a name means: a name alone, or that of a file in the folder. Throws Error(bad_input) for
  // everything else: another folder, hidden files, links, what is no plain file, {places} for numbers.
  std::string file_of(const std::string& name) const;

  // Throws Error(bad_input) as file_of, and when there is no room for another file of that size in its place.
  void check_room(const std::string& name, std::uintmax_t bytes = 0) const;

  // A folder in it, of whoever runs the server, by its name alone. Throws Error(bad_input) as file_of.
  std::string folder_of(const std::string& name) const;

  // Throws Error(bad_input) unless the mesh lies in the folder, or below one of those that were allowed, or
  // was allowed itself. Any thread.
  void check_mesh(const std::filesystem::path& file) const;
  void allow(const std::filesystem::path& file_or_folder);

  // Opens for reading, without following a link. Throws Error(bad_input) as file_of, Error(file).
  Descriptor open(const std::string& name) const;

  // Plain files by name, hidden ones left out, at most `most`.
  std::vector<Entry> list(std::size_t most = kMostFiles) const;

 private:
  struct Stored {
    std::size_t files = 0;
    std::uintmax_t bytes = 0;
  };
  Stored stored(const std::string& but = {}) const;  // all but that one
  std::string own_name(const std::string& name) const;

  std::filesystem::path folder_;
  Descriptor handle_;
  Stored first_;
  mutable std::mutex mutex_;
  std::set<std::filesystem::path> allowed_;
};

// Why this is no name of a file that a client may use; empty: it is one. Letters, digits and what is harmless
// on every system, at most 128 bytes, no dot in front.
std::string refusal_of_name(std::string_view name);

}  // namespace pabd
