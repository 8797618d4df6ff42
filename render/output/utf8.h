// What kind of text a string holds.
#pragma once

#include <string>
#include <string_view>

namespace pabd {

// Well-formed UTF-8 (no overlong forms, no surrogates, at most U+10FFFF) without zero bytes.
bool is_utf8_text(std::string_view text);

// Printable ASCII, newline and tab only.
bool is_ascii(std::string_view text);

std::string utf8_from_latin1(std::string_view text);

}  // namespace pabd
