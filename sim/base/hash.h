// SPDX-License-Identifier: MIT
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

// The finaliser of splitmix64: one to one on 64 bits, and every bit of `x` changes half of those that come out.
constexpr std::uint64_t mixed(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
  return x ^ (x >> 31);
}

class Hash64 {
 public:
  void add_word(std::uint64_t word) {
    state_ = (state_ ^ word) * 0x100000001b3ull;
    state_ ^= state_ >> 32;
  }
  void add_number(double x) { add_word(std::bit_cast<std::uint64_t>(x)); }  // bit by bit: -0 differs from 0
  void add_text(std::string_view text);  // its length first: "ab","c" ≠ "a","bc"

  // 16 lower-case hex digits.
  std::string hex() const {
    std::uint64_t x = mixed(state_);
    std::string digits(16, '0');
    for (int i = 15; i >= 0; --i, x >>= 4) digits[static_cast<std::size_t>(i)] = "0123456789abcdef"[x & 15];
    return digits;
  }

 private:
  std::uint64_t state_ = 0xcbf29ce484222325ull;
};

// The hash of one text of known length that comes in parts: as add_text() of all of it.
class TextHash64 {
 public:
  explicit TextHash64(std::uint64_t length) { hash_.add_word(length); }
  void add(std::string_view part) {
    for (const unsigned char byte : part) {
      word_ |= static_cast<std::uint64_t>(byte) << (8 * used_);
      if (++used_ < 8) continue;
      hash_.add_word(word_);
      word_ = 0;
      used_ = 0;
    }
  }
  // Of everything that was added.
  Hash64 finished() const {
    Hash64 hash = hash_;
    if (used_ > 0) hash.add_word(word_);
    return hash;
  }

 private:
  friend class Hash64;
  explicit TextHash64(const Hash64& begun) : hash_(begun) {}

  Hash64 hash_;
  std::uint64_t word_ = 0;
  int used_ = 0;
};

inline void Hash64::add_text(std::string_view text) {
  add_word(text.size());
  TextHash64 parts(*this);
  parts.add(text);
  *this = parts.finished();
}

}  // namespace pabd
