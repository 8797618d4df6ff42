// 64-bit hash over words, numbers and text, the same on every platform (no byte order, no std::hash).
//
// FNV-1a taken a word at a time, with a shift that carries the high bits down (plain FNV only moves bits up).
// Each step is a bijection of the word for a given state, so changing one value always changes the result.
#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

namespace pabd {

class Hash64 {
 public:
  void add_word(std::uint64_t word) {
    state_ = (state_ ^ word) * 0x100000001b3ull;
    state_ ^= state_ >> 32;
  }
  void add_number(double x) { add_word(std::bit_cast<std::uint64_t>(x)); }  // bit by bit: -0 differs from 0
  void add_text(std::string_view text) {  // its length first: "ab","c" ≠ "a","bc"
    add_word(text.size());
    std::uint64_t word = 0;
    int used = 0;
    for (const unsigned char byte : text) {
      word |= static_cast<std::uint64_t>(byte) << (8 * used);
      if (++used == 8) {
        add_word(word);
        word = 0;
        used = 0;
      }
    }
    if (used > 0) add_word(word);
  }

  // 16 lower-case hex digits.
  std::string hex() const {
    std::uint64_t x = state_;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
    x ^= x >> 31;
    std::string digits(16, '0');
    for (int i = 15; i >= 0; --i, x >>= 4) digits[static_cast<std::size_t>(i)] = "0123456789abcdef"[x & 15];
    return digits;
  }

 private:
  std::uint64_t state_ = 0xcbf29ce484222325ull;
};

}  // namespace pabd
