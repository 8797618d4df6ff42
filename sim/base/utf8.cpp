// SPDX-License-Identifier: MIT
#include "sim/base/utf8.h"

#include <cassert>

namespace pabd {
namespace {

constexpr std::size_t kLongestLine = 1 << 14;  // bytes, about
constexpr char32_t kNoCharacter = 0xFFFD;

unsigned byte_at(std::string_view text, std::size_t i) { return static_cast<unsigned char>(text[i]); }

bool continues(unsigned byte) { return (byte & 0xC0) == 0x80; }

struct Character {
  char32_t code = kNoCharacter;
  std::size_t size = 1;  // bytes; of what is no character, those that could have begun one
  bool well_formed = false;
};

// Table 3-7 of the Unicode standard: which bytes may follow which.
bool may_be_second(unsigned lead, unsigned byte) {
  if (lead == 0xE0 && byte < 0xA0) return false;   // overlong
  if (lead == 0xED && byte >= 0xA0) return false;  // a surrogate
  if (lead == 0xF0 && byte < 0x90) return false;   // overlong
  if (lead == 0xF4 && byte >= 0x90) return false;  // beyond U+10FFFF
  return continues(byte);
}

Character character_at(std::string_view text, std::size_t i) {
  const unsigned lead = byte_at(text, i);
  if (lead < 0x80) return {lead, 1, true};
  if (lead < 0xC2 || lead > 0xF4) return {};
  const std::size_t size = lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
  char32_t code = lead & (0x7Fu >> size);
  for (std::size_t k = 1; k < size; ++k) {
    if (i + k == text.size()) return {kNoCharacter, k};
    const unsigned byte = byte_at(text, i + k);
    if (!(k == 1 ? may_be_second(lead, byte) : continues(byte))) return {kNoCharacter, k};
    code = code << 6 | (byte & 0x3F);
  }
  return {code, size, true};
}

// Steers the terminal, breaks the line, turns its direction or cannot be seen.
bool is_control(char32_t c) {
  return c < 0x20 || (c >= 0x7F && c < 0xA0) || c == 0x200E || c == 0x200F || (c >= 0x2028 && c <= 0x202E) ||
         (c >= 0x2066 && c <= 0x2069) || c == 0x200B || c == 0x2060 || c == 0xFEFF;
}

void append_escaped(std::string& out, unsigned byte) {
  static constexpr char digits[] = "0123456789abcdef";
  if (byte == '\n') {
    out += "\\n";
  } else if (byte == '\t') {
    out += "\\t";
  } else {
    out += {'\\', 'x', digits[byte >> 4], digits[byte & 15]};
  }
}

}  // namespace

bool is_utf8_text(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const Character c = character_at(text, i);
    if (!c.well_formed || c.code == 0) return false;
    i += c.size;
  }
  return true;
}

bool is_ascii(std::string_view text) {
  for (char c : text) {
    if ((c < ' ' || c > '~') && c != '\n' && c != '\t') return false;
  }
  return true;
}

char32_t next_character(std::string_view text, std::size_t& i) {
  assert(i < text.size());
  const Character c = character_at(text, i);
  i += c.size;
  return c.code;
}

void append_character(std::string& text, char32_t c) {
  if (c > 0x10FFFF || (c >= 0xD800 && c < 0xE000)) c = kNoCharacter;
  const auto add = [&](char32_t byte) { text += static_cast<char>(byte); };
  const auto add_rest = [&](int shift) { add(0x80 | (c >> shift & 0x3F)); };
  if (c < 0x80) return add(c);
  if (c < 0x800) {
    add(0xC0 | c >> 6);
  } else if (c < 0x10000) {
    add(0xE0 | c >> 12);
    add_rest(6);
  } else {
    add(0xF0 | c >> 18);
    add_rest(12);
    add_rest(6);
  }
  add_rest(0);
}

std::string utf8_from_latin1(std::string_view text) {
  std::string utf8;
  for (std::size_t i = 0; i < text.size(); ++i) append_character(utf8, byte_at(text, i));
  return utf8;
}

std::string lower_case(std::string_view text) {
  std::string out(text);
  for (char& c : out)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return out;
}

std::string_view first_bytes(std::string_view text, std::size_t size) {
  const std::size_t longest = size + 3;  // what only looks like the rest of a character ends, too
  while (size < text.size() && size < longest && continues(byte_at(text, size))) ++size;
  return text.substr(0, size);
}

std::string_view without_last(std::string_view text) {
  assert(!text.empty());
  std::size_t size = text.size() - 1;
  while (size > 0 && continues(byte_at(text, size))) --size;
  return text.substr(0, size);
}

std::string one_line(std::string_view text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == '\r' || text.back() == ' '))
    text.remove_suffix(1);
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    if (out.size() >= kLongestLine) return out + "...";
    const Character c = character_at(text, i);
    if (c.well_formed && !is_control(c.code)) {
      out.append(text.substr(i, c.size));
      i += c.size;
      continue;
    }
    for (const std::size_t end = i + c.size; i < end; ++i) append_escaped(out, byte_at(text, i));
  }
  return out;
}

}  // namespace pabd
