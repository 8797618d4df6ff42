// SPDX-License-Identifier: MIT
// Numbers and texts as bytes, little endian, in a stream of any length; reading checks everything. Internal
// to the recording.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>

#include "sim/base/error.h"
#include "sim/math/types.h"

namespace pabd {

inline constexpr std::size_t kStreamPart = 1 << 16;  // bytes that are held at a time

class ByteWriter {
 public:
  // `out` gets the bytes in parts; without it they are only counted.
  explicit ByteWriter(std::function<void(std::string_view)> out = {}) : out_(std::move(out)) {}

  bool counts_only() const { return !out_; }
  std::uint64_t size() const { return size_; }
  void flush() {
    if (out_ && !held_.empty()) out_(held_);
    held_.clear();
  }

  void u8(std::uint8_t x) { word(x, 1); }
  void u32(std::uint64_t x) { word(x, 4); }
  void u64(std::uint64_t x) { word(x, 8); }
  void number(double x) { u64(std::bit_cast<std::uint64_t>(x)); }
  template <class Matrix>
  void matrix(const Matrix& m) {
    for (Eigen::Index i = 0; i < m.size(); ++i) number(m.data()[i]);
  }
  void text(std::string_view t) {
    u32(t.size());
    raw(t);
  }
  void raw(std::string_view bytes) {
    size_ += bytes.size();
    if (!out_) return;
    held_.append(bytes);
    if (held_.size() >= kStreamPart) flush();
  }

 private:
  void word(std::uint64_t x, std::size_t bytes) {
    std::array<char, 8> b;
    for (std::size_t i = 0; i < bytes; ++i) b[i] = static_cast<char>(x >> (8 * i) & 0xff);
    raw({b.data(), bytes});
  }

  std::function<void(std::string_view)> out_;
  std::string held_;
  std::uint64_t size_ = 0;
};

// Bytes that can be read at any place: a file, or a text in memory.
struct ByteSource {
  std::uint64_t size = 0;
  // Precondition: at + n ≤ size. Throws Error(file).
  std::function<void(std::uint64_t at, char* to, std::size_t n)> read;
};

class ByteReader {
 public:
  // Bytes [begin, end) of `in`, which must outlive this.
  ByteReader(const ByteSource& in, std::uint64_t begin, std::uint64_t end, std::string source)
      : in_(in), next_(begin), end_(end), source_(std::move(source)) {}

  [[noreturn]] void fail(const std::string& what) const { throw Error(ErrorKind::bad_input, source_, what); }
  // What a checksum cannot explain.
  void require(bool holds, const char* what) const {
    if (!holds) fail(std::string("damaged recording: ") + what + "; use another copy of the file");
  }

  std::uint64_t left() const { return end_ - next_ + (held_.size() - at_); }
  // The next n bytes; valid until something else is read.
  std::string_view raw(std::size_t n) {
    require(n <= left(), "it ends too early");
    if (n > held_.size() - at_) fill(n);
    at_ += n;
    return std::string_view(held_).substr(at_ - n, n);
  }
  std::uint8_t u8() { return static_cast<std::uint8_t>(raw(1)[0]); }
  std::uint32_t u32() { return static_cast<std::uint32_t>(word(4)); }
  std::uint64_t u64() { return word(8); }
  double number() { return std::bit_cast<double>(u64()); }
  double finite() {
    const double x = number();
    require(std::isfinite(x), "a number is not finite");
    return x;
  }
  template <class Matrix>
  void matrix(Matrix& m) {
    for (Eigen::Index i = 0; i < m.size(); ++i) m.data()[i] = finite();
  }
  std::string text() {
    const std::size_t n = u32();
    require(n <= kLongestText, "a text is too long");
    return std::string(raw(n));
  }
  // How many things of at least so many bytes follow.
  std::size_t count(std::size_t least_bytes) {
    const std::size_t n = u32();
    require(n <= left() / least_bytes, "a list is longer than the file");
    return n;
  }

 private:
  static constexpr std::size_t kLongestText = std::size_t{1} << 24;

  void fill(std::size_t n) {
    held_.erase(0, at_);
    at_ = 0;
    const std::size_t had = held_.size();
    const auto more =
        static_cast<std::size_t>(std::min<std::uint64_t>(std::max(n, kStreamPart) - had, end_ - next_));
    held_.resize(had + more);
    in_.read(next_, held_.data() + had, more);
    next_ += more;
  }

  std::uint64_t word(int bytes) {
    const std::string_view b = raw(static_cast<std::size_t>(bytes));
    std::uint64_t x = 0;
    for (int i = 0; i < bytes; ++i)
      x |= static_cast<std::uint64_t>(static_cast<unsigned char>(b[static_cast<std::size_t>(i)])) << (8 * i);
    return x;
  }

  const ByteSource& in_;
  std::uint64_t next_, end_;  // of what is not held yet
  std::string source_;
  std::string held_;
  std::size_t at_ = 0;
};

}  // namespace pabd
