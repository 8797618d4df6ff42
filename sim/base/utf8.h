// SPDX-License-Identifier: MIT
// Text as UTF-8: what kind of text a string holds, its characters, and any text as one line that is safe to
// print.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace pabd {

// Well-formed UTF-8 (no overlong forms, no surrogates, at most U+10FFFF) without zero bytes.
bool is_utf8_text(std::string_view text);

// Printable ASCII, newline and tab only.
bool is_ascii(std::string_view text);

// The character that begins at byte `i` < text.size(), which moves behind it. U+FFFD for what is no character:
// one for all bytes that could have begun one together.
char32_t next_character(std::string_view text, std::size_t& i);

// Appends one character; U+FFFD for surrogates and what is beyond U+10FFFF.
void append_character(std::string& text, char32_t c);

// Text of one byte a character (ISO 8859-1).
std::string utf8_from_latin1(std::string_view text);

// With ASCII's capital letters as small ones.
std::string lower_case(std::string_view text);

// The first `size` bytes of `text` and the rest of the character that they cut; all of a shorter text.
std::string_view first_bytes(std::string_view text, std::size_t size);
// `text` without its last character. Precondition: it has one.
std::string_view without_last(std::string_view text);

// `text` for one line of a terminal or a message: blanks and line breaks at its end are dropped; control
// characters (those of U+0080 … U+009F too), bytes that are no UTF-8 and characters that turn the direction
// of writing or have no width are shown as \n, \t, \xNN. The result is well-formed UTF-8, cut to about 16 kB.
std::string one_line(std::string_view text);

}  // namespace pabd
