// PNG files with text chunks, written atomically; PNG files read back.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "render/output/image.h"

namespace pabd {

using PngText = std::map<std::string, std::string>;  // keyword (Latin-1, 1 to 79 characters) → UTF-8 text

// The bytes of a PNG file. Deterministic: same image and text, same bytes. Throws Error(file) if encoding fails.
std::vector<std::uint8_t> encode_png(const Image& image, const PngText& text = {});

// Encodes and writes to a temporary name in the same folder, checks every write, fsyncs, renames.
// Throws Error(file) naming the path and the system's reason; nothing is left under the final name then.
void write_png(const std::filesystem::path& path, const Image& image, const PngText& text = {});

// Throws Error(file) if the file cannot be read, Error(bad_input) if it is not a PNG that can be decoded.
Image read_png(const std::filesystem::path& path);
PngText read_png_text(const std::filesystem::path& path);

}  // namespace pabd
