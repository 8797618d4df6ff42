// SPDX-License-Identifier: MIT
// Names of files in commands: the one place where the window asks whether they may be named.
#pragma once

#include <string>
#include <type_traits>
#include <variant>

#include "app/workbench/command.h"
#include "app/workbench/file_root.h"

namespace pabd {

// The file that a name means. `files`: the only ones that may be named; null: any. Throws Error(bad_input), also
// when there is no room to write another one.
inline std::string named_file(const FileRoot* files, const std::string& name, FileUse use = FileUse::read) {
  if (!files || name.empty()) return name;
  if (use == FileUse::write) files->check_room(name);
  return files->file_of(name);
}

// The same of a folder.
inline std::string named_folder(const FileRoot* files, const std::string& name) {
  return files && !name.empty() ? files->folder_of(name) : name;
}

// `c` with the file or folder that it means, if it names one. Scenes to open are the workbench's business.
template <class Commands>
Commands with_named_file(Commands c, const FileRoot* files) {
  std::visit(
      [&](auto& x) {
        if constexpr (requires { x.path; }) {
          // What may replace a file writes one; a recording that is loaded replaces what is in memory.
          constexpr bool replaces = requires { x.force; };
          constexpr bool loads = std::is_same_v<std::decay_t<decltype(x)>, command::LoadRecording>;
          x.path = named_file(files, x.path, replaces && !loads ? FileUse::write : FileUse::read);
        }
        if constexpr (requires { x.folder; }) x.folder = named_folder(files, x.folder);
        if constexpr (std::is_same_v<std::decay_t<decltype(x)>, command::Load>)
          x.from = named_file(files, x.from);
      },
      c);
  return c;
}

}  // namespace pabd
