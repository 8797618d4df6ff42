// SPDX-License-Identifier: MIT
// PNG files read back, through libpng. A file is hostile until it is read: sides and chunk sizes are limited
// before anything is allocated, and a picture that its file is too short for is refused. Text is unpacked here, so that
// only so much of it is.
#include <fmt/format.h>
#include <png.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <memory>
#include <new>
#include <span>
#include <string_view>
#include <vector>

#include "render/output/png.h"
#include "sim/base/error.h"
#include "sim/base/input_file.h"
#include "sim/base/utf8.h"

namespace pabd {
namespace fs = std::filesystem;
namespace {

constexpr png_uint_32 most_chunks = 1000;
constexpr png_alloc_size_t largest_chunk = 8 << 20;
constexpr png_byte text_chunks[] = "tEXt\0zTXt\0iTXt", not_needed[] = "tEXt\0zTXt\0iTXt\0sPLT",
                   picture_chunk[] = "IDAT";
constexpr std::size_t most_text = std::size_t{16} << 20;  // bytes in a file, unpacked
// Deflate cannot make anything smaller than this times.
constexpr double best_compression = 1032;

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

struct Decoder {
  std::FILE* file = nullptr;
  int reason = 0;  // errno of a failed read
  char message[200] = "";
};

void on_read(png_structp png, png_bytep data, std::size_t size) {
  Decoder& decoder = *static_cast<Decoder*>(png_get_io_ptr(png));
  if (std::fread(data, 1, size, decoder.file) == size) return;
  if (std::ferror(decoder.file)) decoder.reason = errno;
  png_error(png, "the file ends too early");
}

[[noreturn]] void on_error(png_structp png, png_const_charp message) {
  Decoder& decoder = *static_cast<Decoder*>(png_get_error_ptr(png));
  std::snprintf(decoder.message, sizeof decoder.message, "%s", message);
  png_longjmp(png, 1);
}

// libpng only warns of a chunk above the limit, and then takes as much memory as it claims.
void on_warning(png_structp png, png_const_charp message) {
  if (std::strstr(message, "too large")) png_error(png, message);
}

[[noreturn]] void refuse_text(const fs::path& path) {
  throw Error(ErrorKind::bad_input,
              fmt::format("{}: this PNG file holds more than {} bytes of text", path.string(), most_text));
}

// Chunks of text, unpacked.
class TextOfChunks {
 public:
  explicit TextOfChunks(const fs::path& path) : path_(path) {}

  // What is not well-formed is no text, as for every reader of PNG files.
  void add(std::string_view kind, std::string_view data) {
    spend(data.size());
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

  PngText take() { return std::move(texts_); }

 private:
  static constexpr std::size_t kPart = 1 << 16, kLongestKey = 79;

  void spend(std::size_t bytes) {
    if (bytes > budget_) refuse_text(path_);
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

  fs::path path_;
  std::size_t budget_ = most_text;
  PngText texts_;
};

// A PNG file open for reading, closed and freed at the end of the scope.
class PngReader {
 public:
  explicit PngReader(const fs::path& path) : path_(path) {
    Descriptor file = require_input(path, "a PNG file");
    file_.reset(::fdopen(file.get(), "rb"));
    if (!file_) fail_file(errno);
    file.release();
    decoder_.file = file_.get();
    unsigned char signature[8];
    const std::size_t got = std::fread(signature, 1, sizeof signature, file_.get());
    if (std::ferror(file_.get())) fail_file(errno);
    if (got < sizeof signature || png_sig_cmp(signature, 0, sizeof signature) != 0) {
      throw Error(ErrorKind::bad_input,
                  fmt::format("{}: this is not a PNG file; expected one", path.string()));
    }
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, &decoder_, on_error, on_warning);
    if (png_) info_ = png_create_info_struct(png_);
    if (!info_) {
      png_destroy_read_struct(&png_, &info_, nullptr);
      throw Error(ErrorKind::file, fmt::format("{}: out of memory while opening", path.string()));
    }
  }
  ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;

  // `with_text`: the picture is skipped.
  bool read_header(bool with_text = false) {
    if (setjmp(png_jmpbuf(png_))) return false;
    png_set_read_fn(png_, &decoder_, on_read);
    png_set_sig_bytes(png_, 8);
    png_set_user_limits(png_, png_largest_side, png_largest_side);
    png_set_chunk_cache_max(png_, most_chunks);
    png_set_chunk_malloc_max(png_, largest_chunk);
    if (with_text) {
      png_set_crc_action(png_, PNG_CRC_DEFAULT, PNG_CRC_ERROR_QUIT);
      png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_NEVER, picture_chunk, 1);
      png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_ALWAYS, text_chunks, 3);
    } else {  // text is no part of the picture, and may be packed a thousandfold
      png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_NEVER, not_needed, 4);
    }
    png_read_info(png_, info_);
    return true;
  }

  // Bytes of the unpacked picture as stored.
  double stored_bytes() const {
    return static_cast<double>(png_get_rowbytes(png_, info_)) * png_get_image_height(png_, info_);
  }
  int width() const { return static_cast<int>(png_get_image_width(png_, info_)); }
  int height() const { return static_cast<int>(png_get_image_height(png_, info_)); }

  // rgb: 3 * width * height bytes.
  bool read_pixels(std::uint8_t* rgb) {
    if (setjmp(png_jmpbuf(png_))) return false;
    png_set_expand(png_);
    png_set_scale_16(png_);
    png_set_gray_to_rgb(png_);
    png_color_16 black = {};
    png_set_background(png_, &black, PNG_BACKGROUND_GAMMA_SCREEN, 0, 1.0);
    const int passes = png_set_interlace_handling(png_);
    png_read_update_info(png_, info_);
    const std::size_t stride = static_cast<std::size_t>(width()) * 3;
    if (png_get_rowbytes(png_, info_) != stride) png_error(png_, "unexpected pixel format");
    for (int pass = 0; pass < passes; ++pass) {
      for (int y = 0; y < height(); ++y)
        png_read_row(png_, rgb + static_cast<std::size_t>(y) * stride, nullptr);
    }
    png_read_end(png_, nullptr);
    return true;
  }

  // Of read_header(true): to the end of the file.
  bool read_rest() {
    if (setjmp(png_jmpbuf(png_))) return false;
    png_read_end(png_, info_);
    return true;
  }
  std::span<const png_unknown_chunk> chunks() const {
    png_unknown_chunkp chunks = nullptr;
    const int count = png_get_unknown_chunks(png_, info_, &chunks);
    return {chunks, static_cast<std::size_t>(count)};
  }
  // Why the text could not be read.
  [[noreturn]] void fail_text() const {
    if (std::strstr(decoder_.message, "too large")) refuse_text(path_);
    fail();
  }

  [[noreturn]] void fail() const {
    if (decoder_.reason != 0) fail_file(decoder_.reason);
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: this PNG file is damaged or larger than {} pixels a side: {}",
                            path_.string(), png_largest_side, decoder_.message));
  }

 private:
  [[noreturn]] void fail_file(int reason) const {
    throw Error(ErrorKind::file,
                fmt::format("{}: cannot be read: {}", path_.string(), system_reason(reason)));
  }

  fs::path path_;
  std::unique_ptr<std::FILE, CloseFile> file_;
  Decoder decoder_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
};

}  // namespace

Image read_png(const fs::path& path) {
  PngReader reader(path);
  if (!reader.read_header()) reader.fail();
  std::error_code unknown;
  const auto file_bytes = fs::file_size(path, unknown);
  if (!unknown && reader.stored_bytes() > best_compression * static_cast<double>(file_bytes)) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: this PNG file is damaged: {}x{} pixels do not fit into {} bytes",
                            path.string(), reader.width(), reader.height(), file_bytes));
  }
  Image image;
  image.resize(reader.width(), reader.height());
  if (!reader.read_pixels(image.rgb.data())) reader.fail();
  return image;
}

PngText read_png_text(const fs::path& path) {
  PngReader reader(path);
  if (!reader.read_header(true) || !reader.read_rest()) reader.fail_text();
  TextOfChunks text(path);
  for (const png_unknown_chunk& chunk : reader.chunks())
    text.add(reinterpret_cast<const char*>(chunk.name),
             {reinterpret_cast<const char*>(chunk.data), chunk.size});
  return text.take();
}

}  // namespace pabd
