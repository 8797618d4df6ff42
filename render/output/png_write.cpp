// PNG files with text chunks, through libpng.
//
// Each row is stored as its difference to the row above (filter "up") and compressed at level 1: on rendered
// frames this is about five times faster than the best compression and costs a third more space.
#include <fmt/format.h>
#include <png.h>

#include <csetjmp>
#include <string_view>

#include "render/output/atomic_file.h"
#include "render/output/png.h"
#include "render/output/utf8.h"
#include "sim/error.h"

namespace pabd {
namespace {

struct Encoder {
  std::vector<std::uint8_t> bytes;
  std::string message;
  bool out_of_memory = false;
};

void on_write(png_structp png, png_bytep data, std::size_t size) {
  Encoder& encoder = *static_cast<Encoder*>(png_get_io_ptr(png));
  try {  // no exception may pass through C code
    encoder.bytes.insert(encoder.bytes.end(), data, data + size);
    return;
  } catch (...) {
    encoder.out_of_memory = true;
  }
  png_error(png, "out of memory");
}

void on_flush(png_structp) {}

[[noreturn]] void on_error(png_structp png, png_const_charp message) {
  Encoder& encoder = *static_cast<Encoder*>(png_get_error_ptr(png));
  if (!encoder.out_of_memory) encoder.message = message;
  png_longjmp(png, 1);
}

void on_warning(png_structp, png_const_charp) {}

bool is_keyword(std::string_view key) {
  if (key.empty() || key.size() > 79 || key.front() == ' ' || key.back() == ' ') return false;
  if (key.find("  ") != std::string_view::npos) return false;
  for (char c : key) {
    if (c < ' ' || c > '~') return false;
  }
  return true;
}

void check(const Image& image, const PngText& text) {
  const bool sides_fit = image.width >= 1 && image.height >= 1 && image.width <= png_largest_side &&
                         image.height <= png_largest_side;
  const std::size_t wanted =
      static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * 3;
  if (!sides_fit || image.rgb.size() != wanted) {
    throw Error(ExitCode::file,
                fmt::format("an image of {}x{} pixels with {} bytes cannot be a PNG; expected 1 to {} "
                            "pixels a side and 3 bytes a pixel",
                            image.width, image.height, image.rgb.size(), png_largest_side));
  }
  for (const auto& [key, value] : text) {
    if (!is_keyword(key)) {
      throw Error(ExitCode::file,
                  fmt::format("PNG text keyword \"{}\": expected 1 to 79 printable ASCII characters", key));
    }
    if (!is_utf8_text(value)) {
      throw Error(ExitCode::file, fmt::format("PNG text \"{}\": expected UTF-8 without zero bytes", key));
    }
  }
}

std::vector<png_text> chunks(const PngText& text) {
  std::vector<png_text> list;
  for (const auto& [key, value] : text) {
    png_text chunk = {};
    const bool ascii = is_ascii(value);
    chunk.compression = ascii ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
    chunk.key = const_cast<char*>(key.c_str());  // libpng copies both and changes neither
    chunk.text = const_cast<char*>(value.c_str());
    (ascii ? chunk.text_length : chunk.itxt_length) = value.size();
    list.push_back(chunk);
  }
  return list;
}

// Apart from its caller because of setjmp: no object with a destructor may live in this frame.
bool encode(png_structp png, png_infop info, Encoder& encoder, const Image& image, const png_text* text,
            int texts) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_set_write_fn(png, &encoder, on_write, on_flush);
  png_set_IHDR(png, info, static_cast<png_uint_32>(image.width), static_cast<png_uint_32>(image.height), 8,
               PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
  png_set_compression_level(png, 1);
  png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_UP);
  png_set_compression_buffer_size(png, 1 << 16);
  if (texts > 0) png_set_text(png, info, text, texts);
  png_write_info(png, info);
  const std::size_t stride = static_cast<std::size_t>(image.width) * 3;
  for (int y = 0; y < image.height; ++y)
    png_write_row(png, image.rgb.data() + static_cast<std::size_t>(y) * stride);
  png_write_end(png, info);
  return true;
}

}  // namespace

std::vector<std::uint8_t> encode_png(const Image& image, const PngText& text) {
  check(image, text);
  Encoder encoder;
  encoder.bytes.reserve(image.rgb.size() / 4 + 4096);
  const std::vector<png_text> list = chunks(text);
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &encoder, on_error, on_warning);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  const bool done = info && encode(png, info, encoder, image, list.data(), static_cast<int>(list.size()));
  png_destroy_write_struct(&png, &info);
  if (!done) {
    throw Error(ExitCode::file,
                fmt::format("a frame of {}x{} pixels could not be encoded as PNG: {}", image.width,
                            image.height, encoder.message.empty() ? "out of memory" : encoder.message));
  }
  return std::move(encoder.bytes);
}

void write_png(const std::filesystem::path& path, const Image& image, const PngText& text) {
  const std::vector<std::uint8_t> bytes = encode_png(image, text);
  AtomicFile file(path);
  file.write(bytes.data(), bytes.size());
  file.commit();
}

}  // namespace pabd
