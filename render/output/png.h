// SPDX-License-Identifier: MIT
// PNG files with text chunks, written atomically; PNG files read back.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "render/output/image.h"

namespace pabd {

// keyword (printable ASCII, 1 to 79 characters, no space at an end or twice in a row) → UTF-8 text
using PngText = std::map<std::string, std::string>;

// Larger images are refused by both directions, in pixels.
inline constexpr int png_largest_side = 16384;

// The bytes of a PNG file: 8 bits a channel, sRGB, with alpha if the image has it. ASCII text becomes a tEXt chunk, other text an iTXt chunk.
// Deterministic: same image and text, same bytes. Throws Error(file) if the image is not 1 to 16384 pixels a
// side with 3 * width * height bytes, or a keyword or text is not as above.
std::vector<std::uint8_t> encode_png(const Image& image, const PngText& text = {});

// Encodes and writes to a temporary name in the same folder, checks every write, fsyncs, renames.
// Throws Error(file) naming the path and the system's reason; nothing is left under the final name then. Throws
// Error(bad_input) as check_png_name does.
void write_png(const std::filesystem::path& path, const Image& image, const PngText& text = {});

// A name that promises another format is refused: Error(bad_input). Devices and names without an ending are not.
void check_png_name(const std::filesystem::path& path);

// Any colour type and depth, converted to RGB with 8 bits; transparency is laid over black.
// Throws Error(file) if the file cannot be read, Error(bad_input) if it is not a PNG that can be decoded or
// is too large.
Image read_png(const std::filesystem::path& path);

// All text chunks before and after the picture, as UTF-8; the first of two with the same keyword. Throws like
// read_png.
PngText read_png_text(const std::filesystem::path& path);

}  // namespace pabd
