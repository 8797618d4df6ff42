// SPDX-License-Identifier: MIT
// The content of folders, for file dialogs; needs no window.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pabd {

struct FileEntry {
  std::string name;  // of the file or folder alone
  bool folder = false;
};

// Folders and then files whose names end with one of `endings` (".mp4 .gif"), each in the order of their names with
// numbers by value, capitals like small letters. Without hidden and unreadable
// ones and at most `most` of either kind; empty for a folder that cannot be read.
std::vector<FileEntry> list_files(const std::filesystem::path& folder, const std::string& endings,
                                  std::size_t most = 2000);

// "frame2" before "frame10".
bool natural_less(const std::string& a, const std::string& b);

// The folder of a name that is being typed: "." for a name alone.
std::filesystem::path folder_of_typed(const std::string& text);
// The same name in another folder, or another name in the same one; "." leaves the name alone.
std::string in_folder(const std::filesystem::path& folder, const std::string& name);

// What a dropped file is, by its name and content. A JSON object without a format is a patch, a folder with a plan a
// sweep; anything else a scene, whose reader says what is wrong.
enum class DroppedKind { scene, recording, camera, patch, sweep };
DroppedKind kind_of_dropped(const std::string& path);

}  // namespace pabd
