// What kind of text a string holds, and any text as one line that is safe to print.
#include "sim/base/utf8.h"

namespace pabd {
namespace {

constexpr std::size_t kLongestLine = 1 << 14;  // bytes, about

unsigned byte_at(std::string_view text, std::size_t i) { return static_cast<unsigned char>(text[i]); }

// Bytes of the well-formed character at `i`; 0 when there is none.
std::size_t character_length(std::string_view text, std::size_t i) {
  const unsigned lead = byte_at(text, i);
  const std::size_t length = lead < 0x80 ? 1 : lead < 0xC2 ? 0 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
  if (lead >= 0xF5 || length == 0 || length > text.size() - i) return 0;
  for (std::size_t k = 1; k < length; ++k) {
    const unsigned next = byte_at(text, i + k);
    if ((next & 0xC0) != 0x80) return 0;
    if (k > 1) continue;
    const bool overlong = (lead == 0xE0 && next < 0xA0) || (lead == 0xF0 && next < 0x90);
    const bool surrogate = lead == 0xED && next >= 0xA0;
    const bool too_large = lead == 0xF4 && next >= 0x90;
    if (overlong || surrogate || too_large) return 0;
  }
  return length;
}

// Steers the terminal, breaks the line or turns its direction. `length` as above, not 0.
bool is_control(std::string_view text, std::size_t i, std::size_t length) {
  const unsigned a = byte_at(text, i);
  if (length == 1) return a < 0x20 || a == 0x7F;
  const unsigned b = byte_at(text, i + 1);
  if (length == 2) return a == 0xC2 && b < 0xA0;
  if (length == 4 || a != 0xE2) return false;
  const unsigned c = byte_at(text, i + 2);
  if (b == 0x80) return c == 0x8E || c == 0x8F || (c >= 0xA8 && c <= 0xAE);
  return b == 0x81 && c >= 0xA6 && c <= 0xA9;
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
    const std::size_t length = character_length(text, i);
    if (length == 0 || text[i] == '\0') return false;
    i += length;
  }
  return true;
}

bool is_ascii(std::string_view text) {
  for (char c : text) {
    if ((c < ' ' || c > '~') && c != '\n' && c != '\t') return false;
  }
  return true;
}

std::string utf8_from_latin1(std::string_view text) {
  std::string utf8;
  for (char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80) {
      utf8 += c;
    } else {
      utf8 += static_cast<char>(0xC0 | (byte >> 6));
      utf8 += static_cast<char>(0x80 | (byte & 0x3F));
    }
  }
  return utf8;
}

std::string one_line(std::string_view text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == '\r' || text.back() == ' '))
    text.remove_suffix(1);
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    if (out.size() >= kLongestLine) return out + "...";
    const std::size_t length = character_length(text, i);
    if (length > 0 && !is_control(text, i, length)) {
      out.append(text.substr(i, length));
      i += length;
      continue;
    }
    for (const std::size_t end = i + (length > 0 ? length : 1); i < end; ++i)
      append_escaped(out, byte_at(text, i));
  }
  return out;
}

}  // namespace pabd
