// SPDX-License-Identifier: MIT
// A PNG file: its picture and its texts. Checksums of chunks are set right as well, so that what is behind
// them is reached.
#include <sys/mman.h>
#include <unistd.h>
#include <zlib.h>

#include <cstdint>

#include "render/output/png.h"
#include "tests/fuzz/fuzz.h"

using namespace pabd;

namespace {

std::uint32_t word(const std::string& bytes, std::size_t at) {
  std::uint32_t out = 0;
  for (std::size_t k = 0; k < 4; ++k) out = out << 8 | static_cast<unsigned char>(bytes[at + k]);
  return out;
}

// Length (4 bytes), name (4), data, checksum of name and data (4); the signature has 8 bytes.
std::string with_checksums(std::string bytes) {
  for (std::size_t at = 8; at + 12 <= bytes.size();) {
    const std::size_t length = word(bytes, at);
    if (length > bytes.size() - at - 12) break;
    const auto* name = reinterpret_cast<const Bytef*>(bytes.data() + at + 4);
    const auto sum = static_cast<std::uint32_t>(crc32(0, name, static_cast<uInt>(length + 4)));
    for (std::size_t k = 0; k < 4; ++k)
      bytes[at + 8 + length + k] = static_cast<char>(sum >> (8 * (3 - k)) & 0xff);
    at += 12 + length;
  }
  return bytes;
}

void read(const std::string& bytes) {
  static const int file = memfd_create("fuzz.png", MFD_CLOEXEC);
  static const std::string path = "/proc/self/fd/" + std::to_string(file);
  const bool written = ftruncate(file, 0) == 0 &&
                       pwrite(file, bytes.data(), bytes.size(), 0) == static_cast<ssize_t>(bytes.size());
  fuzz::require(written, "the input is written");
  fuzz::accepts([&] {
    const Image image = read_png(path);
    fuzz::require(image.rgb.size() == std::size_t{3} * static_cast<std::size_t>(image.width) *
                                          static_cast<std::size_t>(image.height),
                  "a picture has three bytes a pixel");
  });
  fuzz::accepts([&] { read_png_text(path); });
}

}  // namespace

PABD_FUZZ_TARGET(png, bytes) {
  const std::string given(bytes), mended = with_checksums(given);
  read(given);
  if (mended != given) read(mended);
}
