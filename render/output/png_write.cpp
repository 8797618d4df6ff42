// SPDX-License-Identifier: MIT
// PNG files with text chunks. stb_image_write makes the picture, libdeflate compresses it and counts its
// checksums; the chunks around the picture are added here.
//
// Each row is stored as its difference to the row above (filter "up") and compressed at level 1: on rendered
// frames better filters and levels cost several times the time for a tenth of the space.
#include <fmt/format.h>
#include <libdeflate.h>

#include <cstdint>
#include <cstdlib>
#include <memory>
#include <span>
#include <string_view>

#include "render/output/png.h"
#include "sim/base/atomic_file.h"
#include "sim/base/error.h"
#include "sim/base/utf8.h"

namespace {

constexpr int kCompressionLevel = 1;

// A zlib stream, in memory of malloc as stb wants it; null when there is no memory.
unsigned char* compress(unsigned char* data, int size, int* compressed_size, int /*quality*/) {
  const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor(
      libdeflate_alloc_compressor(kCompressionLevel), &libdeflate_free_compressor);
  if (!compressor) return nullptr;
  const std::size_t bound = libdeflate_zlib_compress_bound(compressor.get(), static_cast<std::size_t>(size));
  auto* out = static_cast<unsigned char*>(std::malloc(bound));
  if (out == nullptr) return nullptr;
  *compressed_size = static_cast<int>(
      libdeflate_zlib_compress(compressor.get(), data, static_cast<std::size_t>(size), out, bound));
  return out;
}

std::uint32_t checksum(const void* data, std::size_t size) { return libdeflate_crc32(0, data, size); }

}  // namespace

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#define STBIW_ZLIB_COMPRESS compress
#define STBIW_CRC32(data, size) checksum(data, static_cast<std::size_t>(size))
#include <stb_image_write.h>

namespace pabd {
namespace {

constexpr int kFilterUp = 2;
// Signature and header chunk: what comes before the chunks that may be added.
constexpr std::size_t kHeadSize = 8 + 12 + 13;

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
  const bool alpha_fits = image.alpha.empty() || image.alpha.size() == wanted / 3;
  if (!sides_fit || image.rgb.size() != wanted || !alpha_fits) {
    throw Error(ErrorKind::file,
                fmt::format("an image of {}x{} pixels with {} bytes cannot be a PNG; expected 1 to {} "
                            "pixels a side and 3 bytes a pixel",
                            image.width, image.height, image.rgb.size(), png_largest_side));
  }
  for (const auto& [key, value] : text) {
    if (!is_keyword(key)) {
      throw Error(ErrorKind::file,
                  fmt::format("PNG text keyword \"{}\": expected 1 to 79 printable ASCII characters", key));
    }
    if (!is_utf8_text(value)) {
      throw Error(ErrorKind::file, fmt::format("PNG text \"{}\": expected UTF-8 without zero bytes", key));
    }
  }
}

using Bytes = std::vector<std::uint8_t>;

void append_bytes(Bytes& out, std::string_view text) { out.insert(out.end(), text.begin(), text.end()); }

void append_big_endian(Bytes& out, std::uint32_t value) {
  for (const int shift : {24, 16, 8, 0}) out.push_back(static_cast<std::uint8_t>(value >> shift));
}

// Length, type, data, and the checksum of type and data.
void append_chunk(Bytes& out, std::string_view type, std::string_view data) {
  append_big_endian(out, static_cast<std::uint32_t>(data.size()));
  const std::size_t begin = out.size();
  append_bytes(out, type);
  append_bytes(out, data);
  append_big_endian(out, checksum(out.data() + begin, out.size() - begin));
}

void append_text(Bytes& out, const std::string& key, const std::string& value) {
  using namespace std::string_literals;
  if (is_ascii(value)) {
    append_chunk(out, "tEXt", key + "\0"s + value);
  } else {  // not compressed, no language, no translated keyword
    append_chunk(out, "iTXt", key + "\0\0\0\0\0"s + value);
  }
}

struct Free {
  void operator()(unsigned char* memory) const { std::free(memory); }
};

struct Picture {
  std::unique_ptr<unsigned char, Free> memory;
  std::size_t size = 0;
  std::span<const std::uint8_t> bytes() const { return {memory.get(), size}; }
};

// A PNG file without text.
Picture plain_png(const Image& image) {
  [[maybe_unused]] static const bool set = (stbi_write_force_png_filter = kFilterUp, true);
  int size = 0;
  Picture picture;
  if (image.alpha.empty()) {
    picture.memory.reset(stbi_write_png_to_mem(image.rgb.data(), 0, image.width, image.height, 3, &size));
  } else {
    Bytes rgba;
    rgba.reserve(4 * image.alpha.size());
    for (std::size_t i = 0; i < image.alpha.size(); ++i) {
      rgba.insert(rgba.end(), {image.rgb[3 * i], image.rgb[3 * i + 1], image.rgb[3 * i + 2], image.alpha[i]});
    }
    picture.memory.reset(stbi_write_png_to_mem(rgba.data(), 0, image.width, image.height, 4, &size));
  }
  picture.size = static_cast<std::size_t>(size);
  if (!picture.memory) {
    throw Error(ErrorKind::file,
                fmt::format("a frame of {}x{} pixels could not be encoded as PNG: out of memory", image.width,
                            image.height));
  }
  return picture;
}

}  // namespace

std::vector<std::uint8_t> encode_png(const Image& image, const PngText& text) {
  check(image, text);
  const Picture picture = plain_png(image);
  const auto head = picture.bytes().first(kHeadSize), rest = picture.bytes().subspan(kHeadSize);
  Bytes out;
  out.reserve(picture.size + 4096);
  out.assign(head.begin(), head.end());
  append_chunk(out, "sRGB", std::string_view("\0", 1));  // perceptual
  for (const auto& [key, value] : text) append_text(out, key, value);
  out.insert(out.end(), rest.begin(), rest.end());
  return out;
}

void check_png_name(const std::filesystem::path& path) {
  const std::string extension = lower_case(path.extension().string());
  std::error_code none;
  const bool device = std::filesystem::is_other(path, none) || std::filesystem::is_character_file(path, none);
  if (!extension.empty() && extension != ".png" && !device)
    throw Error(ErrorKind::bad_input, path.string(),
                "this picture is written as PNG; end the name with .png");
}

void write_png(const std::filesystem::path& path, const Image& image, const PngText& text) {
  check_png_name(path);
  const std::vector<std::uint8_t> bytes = encode_png(image, text);
  write_file(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

}  // namespace pabd
