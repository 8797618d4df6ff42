// Numbers and texts as bytes, little endian; reading checks everything. Internal to the recording.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "sim/error.h"
#include "sim/math/types.h"

namespace pabd {

class ByteWriter {
 public:
  void u8(std::uint8_t x) { out_.push_back(static_cast<char>(x)); }
  void u32(std::uint64_t x) { word(x, 4); }
  void u64(std::uint64_t x) { word(x, 8); }
  void number(double x) { u64(std::bit_cast<std::uint64_t>(x)); }
  template <class Matrix>
  void matrix(const Matrix& m) {
    for (Eigen::Index i = 0; i < m.size(); ++i) number(m.data()[i]);
  }
  void text(std::string_view t) {
    u32(t.size());
    out_.append(t);
  }
  void raw(std::string_view bytes) { out_.append(bytes); }
  std::string take() { return std::move(out_); }

 private:
  void word(std::uint64_t x, int bytes) {
    for (int i = 0; i < bytes; ++i) out_.push_back(static_cast<char>(x >> (8 * i) & 0xff));
  }
  std::string out_;
};

class ByteReader {
 public:
  ByteReader(std::string_view bytes, std::string source) : in_(bytes), source_(std::move(source)) {}

  [[noreturn]] void fail(const std::string& what) const {
    throw Error(ExitCode::bad_input, source_ + ": " + what);
  }
  // What a checksum cannot explain.
  void require(bool holds, const char* what) const {
    if (!holds) fail(std::string("damaged recording: ") + what + "; use another copy of the file");
  }

  std::size_t left() const { return in_.size() - at_; }
  std::string_view raw(std::size_t n) {
    require(n <= left(), "it ends too early");
    at_ += n;
    return in_.substr(at_ - n, n);
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
  std::string text() { return std::string(raw(u32())); }
  // How many things of at least so many bytes follow.
  std::size_t count(std::size_t least_bytes) {
    const std::size_t n = u32();
    require(n <= left() / least_bytes, "a list is longer than the file");
    return n;
  }
  bool flag() {
    const std::uint8_t x = u8();
    require(x <= 1, "a switch is neither on nor off");
    return x == 1;
  }

 private:
  std::uint64_t word(int bytes) {
    const std::string_view b = raw(static_cast<std::size_t>(bytes));
    std::uint64_t x = 0;
    for (int i = 0; i < bytes; ++i)
      x |= static_cast<std::uint64_t>(static_cast<unsigned char>(b[static_cast<std::size_t>(i)])) << (8 * i);
    return x;
  }

  std::string_view in_;
  std::string source_;
  std::size_t at_ = 0;
};

}  // namespace pabd
