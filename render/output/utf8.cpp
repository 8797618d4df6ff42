// What kind of text a string holds.
#include "render/output/utf8.h"

namespace pabd {

bool is_utf8_text(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const auto lead = static_cast<unsigned char>(text[i]);
    const int more = lead < 0x80   ? 0
                     : lead < 0xC2 ? -1
                     : lead < 0xE0 ? 1
                     : lead < 0xF0 ? 2
                     : lead < 0xF5 ? 3
                                   : -1;
    if (lead == 0 || more < 0 || i + static_cast<std::size_t>(more) >= text.size()) return false;
    for (int k = 1; k <= more; ++k) {
      const auto next = static_cast<unsigned char>(text[i + static_cast<std::size_t>(k)]);
      if ((next & 0xC0) != 0x80) return false;
      if (k > 1) continue;
      const bool overlong = (lead == 0xE0 && next < 0xA0) || (lead == 0xF0 && next < 0x90);
      const bool surrogate = lead == 0xED && next >= 0xA0;
      const bool too_large = lead == 0xF4 && next >= 0x90;
      if (overlong || surrogate || too_large) return false;
    }
    i += static_cast<std::size_t>(more) + 1;
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

}  // namespace pabd
