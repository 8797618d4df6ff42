// SPDX-License-Identifier: MIT
// PNG files read back, through libpng. A file is hostile until it is read: sides and chunk sizes are limited
// before anything is allocated, and a picture that its file is too short for is refused.
#include <fmt/format.h>
#include <png.h>

#include <cerrno>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <memory>
#include <vector>

#include "render/output/png.h"
#include "sim/base/error.h"
#include "sim/base/input_file.h"

namespace pabd {
namespace fs = std::filesystem;
namespace {

constexpr png_uint_32 most_chunks = 1000;
constexpr png_alloc_size_t largest_chunk = 8 << 20;
constexpr png_byte not_needed[] = "tEXt\0zTXt\0iTXt\0sPLT";
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

  bool read_header() {
    if (setjmp(png_jmpbuf(png_))) return false;
    png_set_read_fn(png_, &decoder_, on_read);
    png_set_sig_bytes(png_, 8);
    png_set_user_limits(png_, png_largest_side, png_largest_side);
    png_set_chunk_cache_max(png_, most_chunks);
    png_set_chunk_malloc_max(png_, largest_chunk);
    // Text is no part of the picture, and may be packed a thousandfold.
    png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_NEVER, not_needed, 4);
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

}  // namespace pabd
