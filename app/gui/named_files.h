// SPDX-License-Identifier: MIT
// Names of files in commands, checked against the files that a session may use.
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

// Calls act(name, use, is_folder) for every name of a file or folder in a command. Scenes to open are the workbench's
// business.
template <class Commands, class Act>
void each_file_name(Commands& command, const Act& act) {
  std::visit(
      [&]<class C>(C& c) {
        if constexpr (requires { c.path; }) {
          // What may replace a file writes one; a recording that is loaded replaces what is in memory.
          constexpr bool replaces = requires { c.force; };
          constexpr bool loads = std::is_same_v<C, command::LoadRecording>;
          act(c.path, replaces && !loads ? FileUse::write : FileUse::read, false);
        }
        if constexpr (requires { c.folder; }) act(c.folder, FileUse::read, true);
        if constexpr (std::is_same_v<C, command::Load>) act(c.from, FileUse::read, false);
      },
      command);
}

}  // namespace pabd
