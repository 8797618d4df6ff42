// SPDX-License-Identifier: MIT
// Text of inputs on one line that does nothing to a terminal.
#include <catch2/catch.hpp>
#include <random>

#include "sim/base/error.h"
#include "sim/base/utf8.h"

namespace pabd::test_text {

TEST_CASE("what is printed as it is, and what is shown by number") {
  CHECK(one_line("d̂ = 0.01 m → κ · 50 %, \"é\" 漢字 \xF0\x9F\xA7\xB1") ==
        "d̂ = 0.01 m → κ · 50 %, \"é\" 漢字 \xF0\x9F\xA7\xB1");
  CHECK(one_line("a\x1b[31mred\x1b[0m") == "a\\x1b[31mred\\x1b[0m");
  CHECK(one_line("one\ntwo\tthree\r\n \n") == "one\\ntwo\\tthree");
  CHECK(one_line(std::string("a\0b", 3)) == "a\\x00b");
  CHECK(one_line("\x7f\x80\xff") == "\\x7f\\x80\\xff");
  CHECK(one_line("\xC2\x9B"
                 "31m") == "\\xc2\\x9b31m");             // CSI as a character
  CHECK(one_line("\xE2\x80\xAE") == "\\xe2\\x80\\xae");  // right to left from here on
  CHECK(one_line("\xE2\x81\xA6") == "\\xe2\\x81\\xa6");
  CHECK(one_line("\xE2\x80\xA8") == "\\xe2\\x80\\xa8");                                   // a line break
  CHECK(one_line("\xEF\xBB\xBFkey\xE2\x80\x8B") == "\\xef\\xbb\\xbfkey\\xe2\\x80\\x8b");  // without width
  CHECK(one_line("\xC0\xAF\xED\xA0\x80\xF4\x90\x80\x80") ==
        "\\xc0\\xaf\\xed\\xa0\\x80\\xf4\\x90\\x80\\x80");  // too long, half a pair, beyond the last
  CHECK(one_line("caf\xC3") == "caf\\xc3");                // cut off
  CHECK(one_line("") == "");
}

TEST_CASE("what is far too long for a line is cut") {
  const std::string line = one_line(std::string(10'000'000, '\x1b'));
  CHECK(line.size() < 20000);
  CHECK(line.ends_with("\\x1b..."));
  CHECK(one_line(std::string(15000, 'k')).size() == 15000);
}

TEST_CASE("any bytes become UTF-8 without control characters, and stay as they are then") {
  std::mt19937 random(11);
  for (int i = 0; i < 3000; ++i) {
    std::string text(random() % 20, ' ');
    for (char& c : text) c = static_cast<char>(random() % 4 == 0 ? 0xC2 + random() % 3 : random() % 256);
    const std::string line = one_line(text);
    CHECK(is_utf8_text(line));
    for (const char c : line) CHECK(static_cast<unsigned char>(c) >= 0x20);
    CHECK(one_line(line) == line);
  }
}

TEST_CASE("every error is such a line, whoever threw it") {
  CHECK(std::string(Error(ErrorKind::file, "a\x1b]0;title\x07\n\xfe.json: gone\n").what()) ==
        "a\\x1b]0;title\\x07\\n\\xfe.json: gone");
}

TEST_CASE("an error knows what it is about apart from what it says") {
  const Error plain(ErrorKind::file, "a.json: gone");
  CHECK(plain.source().empty());
  CHECK(plain.message() == "a.json: gone");
  for (const char* source : {"a.json", "a b \n", "\x1b\xC3", ""}) {
    const Error error(ErrorKind::bad_input, source, "/x: expected a number\n");
    CHECK(error.kind() == ErrorKind::bad_input);
    CHECK(error.source() == source);
    CHECK(error.message() == "/x: expected a number");
    CHECK(error.what() == one_line(std::string(source) + ":") + " /x: expected a number");
  }
  // What is cut for its length has no message left, and nothing beyond it is read.
  CHECK(Error(ErrorKind::file, std::string(100'000, 'a'), "gone").message().empty());
}

TEST_CASE("characters: every one there and back, with the bytes of RFC 3629") {
  const std::pair<char32_t, const char*> known[] = {{U'$', "$"},
                                                    {0x7F, "\x7F"},
                                                    {0x80, "\xC2\x80"},
                                                    {0x7FF, "\xDF\xBF"},
                                                    {0x800, "\xE0\xA0\x80"},
                                                    {0x20AC, "\xE2\x82\xAC"},
                                                    {0xFFFF, "\xEF\xBF\xBF"},
                                                    {0x10000, "\xF0\x90\x80\x80"},
                                                    {0x1F9F1, "\xF0\x9F\xA7\xB1"},
                                                    {0x10FFFF, "\xF4\x8F\xBF\xBF"}};
  for (const auto& [c, bytes] : known) {
    std::string text;
    append_character(text, c);
    CHECK(text == bytes);
  }
  int wrong = 0;
  for (char32_t c = 0; c <= 0x10FFFF; ++c) {
    if (c >= 0xD800 && c < 0xE000) continue;
    std::string text;
    append_character(text, c);
    std::size_t i = 0;
    wrong += next_character(text, i) != c || i != text.size();
  }
  CHECK(wrong == 0);
  for (const char32_t c : {0xD800, 0xDFFF, 0x110000}) {
    std::string text;
    append_character(text, c);
    CHECK(text == "\xEF\xBF\xBD");
  }
}

TEST_CASE("what is no character is U+FFFD, one for each beginning of one") {
  const auto decoded = [](std::string_view text) {
    std::u32string out;
    for (std::size_t i = 0; i < text.size();) out += next_character(text, i);
    return out;
  };
  // The example of the Unicode standard, table 3-8.
  CHECK(decoded("\x61\xF1\x80\x80\xE1\x80\xC2\x62\x80\x63\x80\xBF\x64") ==
        U"a\uFFFD\uFFFD\uFFFDb\uFFFDc\uFFFD\uFFFDd");
  CHECK(decoded("\xC0\xAF\xED\xA0\x80") == U"\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD");
  // The last overlong ones of each length, half of a pair, beyond the last; and their neighbours that are fine.
  for (const char* text :
       {"\xC1\xBF", "\xE0\x9F\xBF", "\xF0\x8F\xBF\xBF", "\xED\xA0\x80", "\xF4\x90\x80\x80"}) {
    CHECK(decoded(text) == std::u32string(std::string_view(text).size(), U'\uFFFD'));
    CHECK_FALSE(is_utf8_text(text));
  }
  CHECK(decoded("\xC2\x80\xE0\xA0\x80\xF0\x90\x80\x80\xED\x9F\xBF\xF4\x8F\xBF\xBF") ==
        std::u32string({0x80, 0x800, 0x10000, 0xD7FF, 0x10FFFF}));
  CHECK(utf8_from_latin1("\xE9t\xE9") == "\xC3\xA9t\xC3\xA9");
}

TEST_CASE("text is cut between characters") {
  const std::string text = "aé漢\xF0\x9F\xA7\xB1z";  // 1, 2, 3, 4 and 1 bytes
  const std::size_t ends[] = {0, 1, 3, 3, 6, 6, 6, 10, 10, 10, 10, 11, 11};
  for (std::size_t n = 0; n < std::size(ends); ++n) CHECK(first_bytes(text, n) == text.substr(0, ends[n]));
  std::string_view left = text;
  for (const std::size_t size : {10, 6, 3, 1, 0}) {
    left = without_last(left);
    CHECK(left == text.substr(0, size));
  }
  CHECK(first_bytes(std::string(100, '\x80'), 10).size() == 13);  // no text, and still an end
}

}  // namespace pabd::test_text
