// SPDX-License-Identifier: MIT
// PNG files: what goes in comes out, and hostile files are refused.
#include <catch2/catch.hpp>

#include <zlib.h>

#include <cstdint>
#include <random>

#include "render/output/png.h"
#include "tests/support/errors.h"
#include "tests/support/file_size_limit.h"
#include "tests/support/picture.h"
#include "tests/support/temp_folder.h"

namespace pabd::test_png {

namespace {

std::string bytes_of(const std::vector<std::uint8_t>& bytes) { return {bytes.begin(), bytes.end()}; }

std::uint32_t crc(const std::string& bytes) {
  std::uint32_t value = 0xFFFFFFFFu;
  for (char c : bytes) {
    value ^= static_cast<unsigned char>(c);
    for (int i = 0; i < 8; ++i) value = (value >> 1) ^ (value & 1 ? 0xEDB88320u : 0);
  }
  return ~value;
}

std::string big_endian(std::uint32_t value) {
  std::string text;
  for (int shift = 24; shift >= 0; shift -= 8) text += static_cast<char>(value >> shift & 0xFF);
  return text;
}

std::string chunk(const std::string& kind, const std::string& data) {
  return big_endian(static_cast<std::uint32_t>(data.size())) + kind + data + big_endian(crc(kind + data));
}

// Deflate without compression: enough for small pictures.
std::string zlib_stored(const std::string& data) {
  std::uint32_t a = 1, b = 0;
  for (char c : data) {
    a = (a + static_cast<unsigned char>(c)) % 65521;
    b = (b + a) % 65521;
  }
  const auto size = static_cast<std::uint16_t>(data.size());
  std::string text = "\x78\x01\x01";
  for (unsigned value : {unsigned(size), unsigned(static_cast<std::uint16_t>(~size))}) {
    text += static_cast<char>(value & 0xFF);
    text += static_cast<char>(value >> 8);
  }
  return text + data + big_endian(b << 16 | a);
}

// Deflate as small as it gets.
std::string packed(const std::string& data) {
  uLongf size = ::compressBound(data.size());
  std::string out(size, '\0');
  REQUIRE(::compress2(reinterpret_cast<Bytef*>(out.data()), &size,
                      reinterpret_cast<const Bytef*>(data.data()), data.size(), 9) == Z_OK);
  out.resize(size);
  return out;
}

const std::string signature = "\x89PNG\r\n\x1a\n";

std::string header(std::uint32_t width, std::uint32_t height, int depth, int color, int interlace = 0) {
  const char rest[5] = {static_cast<char>(depth), static_cast<char>(color), 0, 0,
                        static_cast<char>(interlace)};
  return chunk("IHDR", big_endian(width) + big_endian(height) + std::string(rest, 5));
}

// A file of one row with filter 0.
std::string one_row(std::uint32_t width, int depth, int color, const std::string& row,
                    const std::string& before = "") {
  return signature + header(width, 1, depth, color) + before +
         chunk("IDAT", zlib_stored(std::string(1, '\0') + row)) + chunk("IEND", "");
}

std::vector<int> values(const Image& image) { return {image.rgb.begin(), image.rgb.end()}; }

}  // namespace

TEST_CASE("an image comes back bit for bit, whatever its size") {
  const TempFolder folder;
  for (const auto& [w, h] : {std::pair{1, 1}, {3, 7}, {64, 64}, {321, 123}}) {
    const Image image = test_frame(w, h, w);
    write_png(folder / "a.png", image);
    const Image back = read_png(folder / "a.png");
    CHECK(back.width == w);
    CHECK(back.height == h);
    CHECK(back.rgb == image.rgb);
  }
  CHECK(folder.names() == std::vector<std::string>{"a.png"});
}

TEST_CASE("the same image and text give the same bytes; the colours are marked as sRGB; there is no date") {
  const Image image = draw_picture();
  const PngText text = {{"scene", "boxes"}, {"kappa", "50 J"}};
  const std::string bytes = bytes_of(encode_png(image, text));
  CHECK(bytes == bytes_of(encode_png(image, text)));
  CHECK(bytes.find("sRGB") != std::string::npos);
  CHECK(bytes.find("tIME") == std::string::npos);
  CHECK(bytes.size() < image.rgb.size() / 3);
}

TEST_CASE("text comes back, in any script") {
  const TempFolder folder;
  const PngText text = {{"parameters", "d̂ = 0.01 m, κ = 50 J"},
                        {"GL_RENDERER", "llvmpipe (LLVM 15.0.6, 256 bits)"},
                        {"empty", ""},
                        {"lines", "one\ntwo\n"},
                        {"emoji", "\xF0\x9F\xA7\xB1"},
                        {"long", std::string(100000, 'k')}};
  const Image image = test_frame(40, 30, 1);
  write_png(folder / "a.png", image, text);
  CHECK(read_png_text(folder / "a.png") == text);
  CHECK(read_png(folder / "a.png").rgb == image.rgb);
  const std::string bytes = read_bytes(folder / "a.png");
  CHECK(bytes.find("iTXtparameters") != std::string::npos);
  CHECK(bytes.find("tEXtGL_RENDERER") != std::string::npos);
  write_png(folder / "none.png", image);
  CHECK(read_png_text(folder / "none.png").empty());
}

TEST_CASE("text written by others: Latin-1, after the picture, twice the same keyword") {
  const TempFolder folder;
  const std::string row(3, '\x40');
  const std::string file = signature + header(1, 1, 8, 2) + chunk("tEXt", std::string("a\0caf\xE9", 6)) +
                           chunk("IDAT", zlib_stored(std::string(1, '\0') + row)) +
                           chunk("tEXt", std::string("a\0second", 8)) +
                           chunk("tEXt", std::string("b\0late", 6)) + chunk("IEND", "");
  write_bytes(folder / "a.png", file);
  CHECK(read_png_text(folder / "a.png") == PngText{{"a", "café"}, {"b", "late"}});
}

TEST_CASE("what no PNG can hold is refused") {
  const Image image = test_frame(4, 4, 0);
  for (const std::string& key : {std::string(), std::string(80, 'k'), std::string(" a"), std::string("a "),
                                 std::string("a  b"), std::string("a\nb"), std::string("κ")}) {
    CHECK(caught([&] { encode_png(image, {{key, "x"}}); }).kind == file_error);
  }
  for (const std::string& value :
       {std::string("a\0b", 3), std::string("\xC0\xAF"), std::string("\xED\xA0\x80"), std::string("\xE2\x82"),
        std::string("\xF4\x90\x80\x80"), std::string("\x80")}) {
    CHECK(caught([&] { encode_png(image, {{"key", value}}); }).kind == file_error);
  }
  Image wrong = image;
  wrong.rgb.pop_back();
  CHECK(caught([&] { encode_png(wrong); }).kind == file_error);
  CHECK(caught([] { encode_png(Image{}); }).kind == file_error);
  wrong.width = -4;
  wrong.height = -4;
  CHECK(caught([&] { encode_png(wrong); }).kind == file_error);
  wrong.resize(20000, 1);
  CHECK(caught([&] { encode_png(wrong); }).says("16384"));
}

TEST_CASE("every kind of PNG becomes RGB with 8 bits") {
  const TempFolder folder;
  const auto read = [&folder](const std::string& bytes) {
    write_bytes(folder / "a.png", bytes);
    return values(read_png(folder / "a.png"));
  };
  const std::string palette = chunk("PLTE", std::string("\x0A\x14\x1E\xC8\xD2\xDC", 6));
  CHECK(read(one_row(2, 8, 0, "\x10\xF0")) == std::vector<int>{16, 16, 16, 240, 240, 240});
  CHECK(read(one_row(3, 1, 0, "\xA0")) == std::vector<int>{255, 255, 255, 0, 0, 0, 255, 255, 255});
  CHECK(read(one_row(2, 8, 3, std::string("\1\0", 2), palette)) ==
        std::vector<int>{200, 210, 220, 10, 20, 30});
  // 16 bits: 65535 levels onto 255, rounded: 0x8080 is 128 · 257, 0x00FF is 0.99 · 257
  CHECK(read(one_row(1, 16, 2, std::string("\x80\x80\xFF\xFF\x00\xFF", 6))) == std::vector<int>{128, 255, 1});
  // half transparent white over black; 128 / 255 · 255
  CHECK(read(one_row(1, 8, 6, "\xFF\xFF\xFF\x80")) == std::vector<int>{128, 128, 128});
  CHECK(read(one_row(1, 8, 4, "\xFF\xFF")) == std::vector<int>{255, 255, 255});
  CHECK(read(one_row(1, 8, 2, "\1\2\3")) == std::vector<int>{1, 2, 3});
}

TEST_CASE("files that are no PNG, or cannot be read") {
  const TempFolder folder;
  CHECK(caught([&] { read_png(folder / "none.png"); }).kind == file_error);
  CHECK(caught([&] { read_png(folder / "none.png"); }).says("no such file"));
  CHECK(caught([&] { read_png(folder.path()); }).kind == file_error);
  for (const std::string& bytes :
       {std::string(), std::string("\x89PNG"), std::string("GIF89a, not a PNG"), signature}) {
    write_bytes(folder / "a.png", bytes);
    CHECK(caught([&] { read_png(folder / "a.png"); }).kind == bad_input);
    CHECK(caught([&] { read_png_text(folder / "a.png"); }).kind == bad_input);
  }
}

TEST_CASE("huge pictures are refused before memory is asked for") {
  const TempFolder folder;
  const std::string little = chunk("IDAT", zlib_stored("x")) + chunk("IEND", "");
  for (const std::string& bytes :
       {signature + header(16385, 1, 8, 2) + little,
        signature + header(0x7FFFFFFF, 0x7FFFFFFF, 16, 6) + little,
        signature + header(16384, 16384, 16, 6) + little, signature + header(16384, 16384, 1, 0, 1) + little,
        signature + header(0, 5, 8, 2) + little, signature + header(5, 5, 7, 2) + little}) {
    write_bytes(folder / "a.png", bytes);
    CHECK(caught([&] { read_png(folder / "a.png"); }).kind == bad_input);
  }
  write_bytes(folder / "a.png", signature + header(16384, 16384, 8, 2) + little);  // 805 MB from 80 bytes
  CHECK(caught([&] { read_png(folder / "a.png"); }).says("do not fit into"));
}

TEST_CASE(
    "a chunk that claims more than the limit is refused before memory is asked for, whatever its kind") {
  const TempFolder folder;
  for (const char* kind : {"iTXt", "zTXt", "tEXt", "sPLT", "pCAL", "sCAL", "eXIf", "iCCP", "abCd"}) {
    INFO(kind);
    write_bytes(folder / "a.png", signature + header(2, 2, 8, 2) + big_endian(0x4C540019) + kind + "Title");
    CHECK(caught([&] { read_png(folder / "a.png"); }).kind == bad_input);
    CHECK(caught([&] { read_png(folder / "a.png"); }).says("too large"));
  }
}

TEST_CASE("damaged files are refused or read, and never crash") {
  const TempFolder folder;
  const Image image = test_frame(24, 18, 3);
  const std::string whole = bytes_of(encode_png(image, {{"a", "text"}, {"b", "κ"}}));
  int refused = 0;
  const auto attempt = [&](const std::string& bytes) {
    write_bytes(folder / "a.png", bytes);
    const Caught pixels = caught([&] { read_png(folder / "a.png"); });
    const Caught text = caught([&] { read_png_text(folder / "a.png"); });
    const bool known = (pixels.kind == std::nullopt || pixels.kind == bad_input) &&
                       (text.kind == std::nullopt || text.kind == bad_input);
    CHECK(known);
    refused += pixels.kind == bad_input;
  };
  int truncations = 0;
  for (std::size_t size = 0; size < whole.size(); size += 1 + whole.size() / 150, ++truncations) {
    attempt(whole.substr(0, size));
  }
  CHECK(refused == truncations);  // a picture that ends early is never taken for a whole one

  refused = 0;
  std::mt19937 random(7);
  for (int i = 0; i < 400; ++i) {
    std::string bytes = whole;
    for (int flips = 0; flips < 1 + i % 3; ++flips) {
      bytes[random() % bytes.size()] ^= static_cast<char>(1u << random() % 8);
    }
    attempt(bytes);
  }
  CHECK(refused > 300);  // a bit in a text chunk does no harm to the picture; one elsewhere is seen
}

TEST_CASE("packed text of others is read") {
  const TempFolder folder;
  const std::string row(3, '\x40');
  const auto file = [&](const std::string& chunks) {
    return signature + header(1, 1, 8, 2) + chunks + chunk("IDAT", zlib_stored(std::string(1, '\0') + row)) +
           chunk("IEND", "");
  };
  const std::string long_text(300000, 'k');
  write_bytes(
      folder / "a.png",
      file(chunk("zTXt", std::string("a\0\0", 3) + packed(long_text)) +
           chunk("iTXt", std::string("b\0\1\0de\0be\0", 10) + packed("κ = 50")) +
           chunk("iTXt", std::string("c\0\0\0\0\0", 6) + "plain") +
           chunk("zTXt", std::string("d\0\0", 3) + packed(long_text).substr(0, 50)) +  // cut off: none
           chunk("tEXt", "no end of the key") + chunk("iTXt", std::string("e\0\1", 3))));
  CHECK(read_png_text(folder / "a.png") == PngText{{"a", long_text}, {"b", "κ = 50"}, {"c", "plain"}});
  CHECK(read_png(folder / "a.png").rgb == std::vector<std::uint8_t>(3, 0x40));
}

TEST_CASE("text that was packed a thousandfold is not unpacked beyond a limit") {
  const TempFolder folder;
  const std::string row(3, '\x40');
  const std::string bomb = packed(std::string(std::size_t{7} << 20, 'k'));  // 7 kB
  std::string chunks;
  for (int i = 0; i < 700; ++i)
    chunks += i % 2 == 0 ? chunk("zTXt", "a" + std::to_string(i) + std::string("\0\0", 2) + bomb)
                         : chunk("iTXt", "b" + std::to_string(i) + std::string("\0\1\0\0\0", 5) + bomb);
  write_bytes(folder / "a.png", signature + header(1, 1, 8, 2) + chunks +
                                    chunk("IDAT", zlib_stored(std::string(1, '\0') + row)) +
                                    chunk("IEND", ""));
  const Caught error = caught([&] { static_cast<void>(read_png_text(folder / "a.png")); });
  CHECK(error.kind == bad_input);
  CHECK(error.says("bytes of text"));
  // The picture is there all the same, and its text is not looked at.
  CHECK(read_png(folder / "a.png").rgb == std::vector<std::uint8_t>(3, 0x40));
  // So is text that says it is long.
  write_bytes(folder / "b.png", signature + header(1, 1, 8, 2) + big_endian(0x7ffffff0u) + "tEXt" + "a");
  CHECK(caught([&] { static_cast<void>(read_png_text(folder / "b.png")); }).says("bytes of text"));
}

TEST_CASE("a name of another format is refused, and nothing is written") {
  const TempFolder folder;
  Image image;
  image.resize(4, 3);
  for (const char* name : {"a.jpg", "a.png.bmp", "a.PNGX"}) {
    CHECK_THROWS_WITH(write_png(folder / name, image), Catch::Contains("end the name with .png"));
    CHECK_FALSE(std::filesystem::exists(folder / name));
  }
  for (const char* name : {"a.png", "a.PNG", "a"}) CHECK_NOTHROW(write_png(folder / name, image));
  CHECK_NOTHROW(write_png("/dev/null", image));
}

TEST_CASE("a full disk leaves no picture behind") {
  const TempFolder folder;
  const FileSizeLimit full(2000);
  const Caught error = caught([&] { write_png(folder / "a.png", draw_picture()); });
  CHECK(error.kind == file_error);
  CHECK(error.says("a.png"));
  CHECK(folder.names().empty());
}

}  // namespace pabd::test_png
