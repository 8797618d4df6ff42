// Text of inputs on one line that does nothing to a terminal.
#include <catch2/catch.hpp>
#include <random>

#include "sim/base/utf8.h"
#include "sim/error.h"

using namespace pabd;

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
  CHECK(one_line("\xE2\x80\xA8") == "\\xe2\\x80\\xa8");  // a line break
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
  CHECK(std::string(Error(ExitCode::file, "a\x1b]0;title\x07\n\xfe.json: gone\n").what()) ==
        "a\\x1b]0;title\\x07\\n\\xfe.json: gone");
}
