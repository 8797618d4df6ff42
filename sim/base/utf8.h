// What kind of text a string holds, and any text as one line that is safe to print.
#pragma once

#include <string>
#include <string_view>

namespace pabd {

// Well-formed UTF-8 (no overlong forms, no surrogates, at most U+10FFFF) without zero bytes.
bool is_utf8_text(std::string_view text);

// Printable ASCII, newline and tab only.
bool is_ascii(std::string_view text);

std::string utf8_from_latin1(std::string_view text);

// `text` for one line of a terminal or a message: blanks and line breaks at its end are dropped; control
// characters (those of U+0080 … U+009F too), bytes that are no UTF-8 and characters that turn the direction
// of writing are shown as \n, \t, \xNN. What is left is well-formed UTF-8, cut to about 16 kB.
std::string one_line(std::string_view text);

}  // namespace pabd
