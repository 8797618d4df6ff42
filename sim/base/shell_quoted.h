// SPDX-License-Identifier: MIT
// Text in a line of a shell.
#pragma once

#include <string>
#include <string_view>

namespace pabd {

// One word for sh and its kin, whatever is in it.
inline std::string sh_quoted(std::string_view text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

// The same, without quotes where none are needed.
inline std::string sh_word(std::string_view text) {
  constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./=:,+%@";
  const bool plain = !text.empty() && text.find_first_not_of(kPlain) == std::string_view::npos;
  return plain ? std::string(text) : sh_quoted(text);
}

}  // namespace pabd
