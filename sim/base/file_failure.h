// SPDX-License-Identifier: MIT
// What is said when a file cannot be written.
#pragma once

#include <filesystem>
#include <string>

namespace pabd {

// Throws Error(file) "PATH: WHAT: REASON; REMEDY", the remedy where the reason, an errno, has one.
[[noreturn]] void fail_for(const std::filesystem::path& path, const std::string& what, int reason);

}  // namespace pabd
