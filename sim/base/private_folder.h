// SPDX-License-Identifier: MIT
// Files in a folder that nobody else reads yet: they are written in place, wait for the disk together, and are there at
// once when the folder gets its name. Each by itself as AtomicFile would cost two waits for the disk a file.
#pragma once

#include <filesystem>
#include <string_view>

namespace pabd {

// Throws Error(file).
void write_private_file(const std::filesystem::path& path, std::string_view bytes);

// What is in the files of `folder` is on the disk, and then it has the name `place`; an empty folder there is replaced.
// Throws Error(file).
void publish_folder(const std::filesystem::path& folder, const std::filesystem::path& place);

}  // namespace pabd
