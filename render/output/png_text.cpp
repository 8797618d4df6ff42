// SPDX-License-Identifier: MIT
// The text in a PNG file, without its picture: chunk by chunk, so that nothing is unpacked but text, and of
// text only so much. Every checksum is checked: a file that was cut off or damaged is refused.
#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <memory>
#include <new>
#include <string_view>

#include "render/output/png.h"
#include "sim/base/error.h"
#include "sim/base/input_file.h"
#include "sim/base/utf8.h"

namespace pabd {
namespace {

constexpr std::size_t kMostText = std::size_t{16} << 20;  // bytes in a file, unpacked
constexpr std::size_t kPart = 1 << 16;
constexpr std::size_t kLongestKey = 79;

class ChunkReader {
 public:
  explicit ChunkReader(const std::filesystem::path& path)
      : path_(path), file_(require_input(path, "a PNG file")) {}

  PngText read() {
    check_signature();
    bool first = true;
    while (true) {
      std::array<unsigned char, 8> head;
      take(head.data(), head.size());
      const std::uint32_t length = number(head.data());
      const std::string kind(reinterpret_cast<const char*>(head.data()) + 4, 4);
      if (length > 0x7fffffffu || first != (kind == "IHDR")) damaged("its chunks are out of order");
      first = false;
      crc_ = static_cast<std::uint32_t>(::crc32(0, head.data() + 4, 4));
      const bool is_text = kind == "tEXt" || kind == "zTXt" || kind == "iTXt";
      std::string data;
      if (is_text) {
        spend(length);
        data.resize(length);
        take_data(reinterpret_cast<unsigned char*>(data.data()), length);
      } else {
        skip(length);
      }
      std::array<unsigned char, 4> sum;
      take(sum.data(), sum.size());
      if (number(sum.data()) != crc_) damaged("a checksum is another one");
      if (is_text) add(kind, data);
      if (kind == "IEND") return std::move(texts_);
    }
  }

 private:
  [[noreturn]] void damaged(const std::string& how) const {
    throw Error(ErrorKind::bad_input, fmt::format("{}: this PNG file is damaged: {}", path_.string(), how));
  }

  void check_signature() {
    static constexpr std::array<unsigned char, 8> expected = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    std::array<unsigned char, 8> found{};
    if (try_take(found.data(), found.size()) != found.size() || found != expected)
      throw Error(ErrorKind::bad_input,
                  fmt::format("{}: this is not a PNG file; expected one", path_.string()));
  }

  static std::uint32_t number(const unsigned char* b) {
    return std::uint32_t{b[0]} << 24 | std::uint32_t{b[1]} << 16 | std::uint32_t{b[2]} << 8 | b[3];
  }

  std::size_t try_take(unsigned char* to, std::size_t n) {
    std::size_t done = 0;
    while (done < n) {
      if (at_ == held_) {
        const ssize_t got = read_some(file_.get(), buffer_.data(), buffer_.size());
        if (got < 0) {
          throw Error(ErrorKind::file,
                      fmt::format("{}: cannot be read: {}", path_.string(), system_reason(errno)));
        }
        if (got == 0) return done;
        at_ = 0;
        held_ = static_cast<std::size_t>(got);
      }
      const std::size_t part = std::min(n - done, held_ - at_);
      std::memcpy(to + done, buffer_.data() + at_, part);
      at_ += part;
      done += part;
    }
    return done;
  }
  void take(unsigned char* to, std::size_t n) {
    if (try_take(to, n) != n) damaged("the file ends too early");
  }
  void take_data(unsigned char* to, std::size_t n) {
    take(to, n);
    crc_ = static_cast<std::uint32_t>(::crc32(crc_, to, static_cast<uInt>(n)));
  }
  void skip(std::size_t n) {
    std::array<unsigned char, 4096> part;
    for (; n > 0; n -= std::min(n, part.size())) take_data(part.data(), std::min(n, part.size()));
  }

  void spend(std::size_t bytes) {
    if (bytes > budget_) {
      throw Error(ErrorKind::bad_input, fmt::format("{}: this PNG file holds more than {} bytes of text",
                                                    path_.string(), kMostText));
    }
    budget_ -= bytes;
  }

  // False when it cannot be unpacked.
  bool inflate_text(std::string_view packed, std::string& text) {
    z_stream stream = {};
    if (::inflateInit(&stream) != Z_OK) throw std::bad_alloc();
    const std::unique_ptr<z_stream, int (*)(z_stream*)> guard(&stream, &::inflateEnd);
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
    stream.avail_in = static_cast<uInt>(packed.size());
    std::array<char, kPart> part;
    for (int state = Z_OK; state != Z_STREAM_END;) {
      const std::size_t room = std::min(part.size(), budget_ + 1);
      stream.next_out = reinterpret_cast<Bytef*>(part.data());
      stream.avail_out = static_cast<uInt>(room);
      state = ::inflate(&stream, Z_NO_FLUSH);
      const std::size_t got = room - stream.avail_out;
      spend(got);
      text.append(part.data(), got);
      if (state != Z_OK && state != Z_STREAM_END) return false;
    }
    return true;
  }

  // What is not well-formed is no text, as for every reader of PNG files.
  void add(const std::string& kind, std::string_view data) {
    const auto cut = [&data] {  // up to the next zero byte
      const std::size_t end = std::min(data.find('\0'), data.size());
      const std::string_view part = data.substr(0, end);
      data.remove_prefix(std::min(end + 1, data.size()));
      return part;
    };
    const bool closed = data.find('\0') != std::string_view::npos;
    const std::string_view key = cut();
    if (!closed || key.empty() || key.size() > kLongestKey) return;
    bool packed = kind == "zTXt";
    if (packed) {
      if (data.empty() || data[0] != 0) return;
      data.remove_prefix(1);
    } else if (kind == "iTXt") {
      if (data.size() < 2 || data[0] > 1 || data[0] < 0 || data[1] != 0) return;
      packed = data[0] == 1;
      data.remove_prefix(2);
      cut();  // language
      cut();  // the keyword in it
    }
    std::string text(packed ? std::string_view() : data);
    if (packed && !inflate_text(data, text)) return;
    if (kind != "iTXt") {
      text = utf8_from_latin1(text);
    } else if (!is_utf8_text(text)) {
      return;
    }
    texts_.emplace(utf8_from_latin1(key), std::move(text));
  }

  std::filesystem::path path_;
  Descriptor file_;
  std::array<unsigned char, kPart> buffer_;
  std::size_t at_ = 0, held_ = 0;
  std::uint32_t crc_ = 0;
  std::size_t budget_ = kMostText;
  PngText texts_;
};

}  // namespace

PngText read_png_text(const std::filesystem::path& path) { return ChunkReader(path).read(); }

}  // namespace pabd
