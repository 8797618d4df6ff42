// SPDX-License-Identifier: MIT
// Files that are read: opened so that nothing blocks or never ends, and read to a limit.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "sim/base/descriptor.h"

namespace pabd {

// Opens a regular file, or a pipe that this program was started with (standard input, <(…) of a shell). A
// pipe by name, a device, a folder or a socket is refused: it may block or never end. `problem` is empty, or
// says in a few words why there is no descriptor.
Descriptor open_input(const std::filesystem::path& path, std::string& problem);
// The same; throws Error(file) "PATH: cannot be read: …; expected …". `expected`: "a scene file".
Descriptor require_input(const std::filesystem::path& path, std::string_view expected);

enum class ReadOutcome { done, unreadable, too_long };

// The whole file into `bytes`, if it has at most `most`. Otherwise `problem` says why not.
ReadOutcome try_read_file(const std::filesystem::path& path, std::size_t most, std::string& bytes,
                          std::string& problem);
// The whole file. Throws Error(file) as require_input does, Error(bad_input) if it is longer than `most`
// bytes: then `shorter` is what was expected, if given.
std::string read_file(const std::filesystem::path& path, std::size_t most, std::string_view expected,
                      std::string_view shorter = {});
// The whole file, or nothing when it cannot be read or is longer: for the system's files about itself.
std::string read_if_possible(const std::filesystem::path& path, std::size_t most);

}  // namespace pabd
