// SPDX-License-Identifier: MIT
// Files that are compiled as one (scripts/unity.cmake) mean what each means by itself.
//
// A name in an unnamed namespace is seen by the files after it, and hides one of a header: no compiler tells. So no file
// may use a name that a header of its own declares and that a file before it has for itself.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cctype>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "tests/structure/sources.h"
#include "tests/support/files.h"
#include "tests/support/places.h"

namespace pabd::test_compiled_together {

namespace fs = std::filesystem;

using pabd::Source;
using Names = std::set<std::string, std::less<>>;

namespace {

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool is_letter(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

// The identifier that ends before `end`; none where it belongs to a class or a namespace (A::name).
std::string name_before(std::string_view line, std::size_t end) {
  while (end > 0 && line[end - 1] == ' ') --end;
  std::size_t begin = end;
  while (begin > 0 && is_letter(line[begin - 1])) --begin;
  const bool of_another = begin >= 2 && line.substr(begin - 2, 2) == "::";
  return of_another ? std::string() : std::string(line.substr(begin, end - begin));
}

// What a line that begins at the margin declares: clang-format puts namespaces' members there, and nothing else.
void add_declared(std::string_view line, Names& names) {
  for (const char* word : {"return", "namespace", "using namespace", "#", "//", "}", " ", "extern \"C\""})
    if (line.starts_with(word)) return;
  if (line.starts_with("[[")) line.remove_prefix(line.find("]]") + 2);
  std::size_t stop = std::min(line.find_first_of("(={;["), line.find(" : "));
  if (stop == std::string_view::npos) return;
  names.insert(name_before(line, stop));
  if (line[stop] != '=') return;
  // constexpr double kA = 4, kB = 9;
  for (; stop != std::string_view::npos; stop = line.find(" = ", stop + 1))
    names.insert(name_before(line, stop));
}

// Names at namespace scope; `own`: only those in unnamed namespaces.
Names declared(const std::string& text, bool own) {
  Names names;
  bool unnamed = false;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line == "namespace {") unnamed = true;
    if (line == "}  // namespace") unnamed = false;
    if (unnamed || !own) add_declared(line, names);
  }
  names.erase("");
  return names;
}

// Where the text or the character that begins at i ends, R"glsl(…)glsl" too.
std::size_t after_literal(const std::string& text, std::size_t i) {
  if (text[i] == 'R') {
    const std::size_t open = text.find('(', i);
    const std::string close = ")" + text.substr(i + 2, open - i - 2) + "\"";
    return std::min(text.find(close, open), text.size() - close.size()) + close.size();
  }
  const char quote = text[i++];
  while (i < text.size() && text[i] != quote) i += text[i] == '\\' ? 2 : 1;
  return std::min(i + 1, text.size());
}

// Every identifier that stands alone: neither a member (a.b, a->b) nor A::b; no comments, no texts.
Names used(const std::string& text) {
  Names names;
  for (std::size_t i = 0; i < text.size();) {
    if (text.compare(i, 2, "//") == 0 || text[i] == '#') {
      i = std::min(text.find('\n', i), text.size());
    } else if (text[i] == '"' || text[i] == '\'' || text.compare(i, 2, "R\"") == 0) {
      i = after_literal(text, i);
    } else if (is_letter(text[i])) {
      const std::size_t begin = i;
      while (i < text.size() && (is_letter(text[i]) || (text[i] == '\'' && is_digit(text[begin])))) ++i;
      const char before = begin > 0 ? text[begin - 1] : ' ';
      if (before != '.' && before != ':' && before != '>') names.insert(text.substr(begin, i - begin));
    } else {
      ++i;
    }
  }
  return names;
}

const Source* source_of(const std::string& path) {
  const auto& all = pabd::sources();
  const auto at =
      std::lower_bound(all.begin(), all.end(), path,
                       [](const Source& source, const std::string& p) { return source.path < p; });
  return at != all.end() && at->path == path ? &*at : nullptr;
}

// The project's headers that a file reads, and what each of them declares.
std::map<std::string, Names> headers_of(const Source& source) {
  static std::map<std::string, Names> known;
  std::map<std::string, Names> found;
  std::vector<const Source*> left = {&source};
  while (!left.empty()) {
    const Source* next = left.back();
    left.pop_back();
    for (const std::string& include : next->includes) {
      const Source* header = source_of(include);
      if (header == nullptr || found.contains(include)) continue;
      if (!known.contains(include)) known[include] = declared(header->text, false);
      found[include] = known[include];
      left.push_back(header);
    }
  }
  return found;
}

// Files of tests are in a namespace of their own, which is named after them: no other file sees what is in it.
bool keeps_to_itself(const Source& source) {
  return source.text.find("namespace pabd::" + fs::path(source.path).stem().string() + " {") !=
         std::string::npos;
}

// "file: name is header's, and earlier's" for files that are compiled in this order.
std::vector<std::string> hidden(const std::vector<const Source*>& files) {
  std::vector<std::string> found;
  for (std::size_t j = 1; j < files.size(); ++j) {
    const Names mine = declared(files[j]->text, true), words = used(files[j]->text);
    const std::map<std::string, Names> headers = headers_of(*files[j]);
    for (std::size_t i = 0; i < j; ++i) {
      if (keeps_to_itself(*files[i])) continue;
      for (const std::string& name : declared(files[i]->text, true)) {
        if (mine.contains(name) || !words.contains(name)) continue;
        for (const auto& [header, names] : headers)
          if (names.contains(name))
            found.push_back(files[j]->path + ": " + name + " is " + header + "'s, and " + files[i]->path +
                            "'s");
      }
    }
  }
  return found;
}

}  // namespace

TEST_CASE("a name that hides a header's is found") {
  const Source before{
      "before.cpp", "namespace {\nconstexpr double kA = 1, kPlainLimit = 2;\n}  // namespace\n", {}, 3};
  Source after{
      "after.cpp", "double twice() {\n  return 2 * kPlainLimit;\n}\n", {"tests/structure/example.h"}, 3};
  const std::vector<std::string> one = {
      "after.cpp: kPlainLimit is tests/structure/example.h's, and before.cpp's"};
  CHECK(hidden({&before, &after}) == one);
  CHECK(hidden({&after, &before}).empty());
  after.text = "double twice() {\n  return 2 * example::kPlainLimit;  // kPlainLimit\n}\n";
  CHECK(hidden({&before, &after}).empty());
  after.text = "const char* const kText = R\"t(body's kPlainLimit)t\";\nconst int k = 1'000;\n";
  CHECK(hidden({&before, &after}).empty());
  after.text = "int f() {\n  return R\"t(body's)t\"[0] + 1'000 + '\\'' + kPlainLimit;\n}\n";
  CHECK(hidden({&before, &after}) == one);
  after.text = "namespace {\nint kPlainLimit();\n}  // namespace\nint f() {\n  return kPlainLimit();\n}\n";
  CHECK(hidden({&before, &after}).empty());
}

TEST_CASE("no file that is compiled with others takes their names for those of its headers") {
  std::vector<std::string> found;
  for (const auto& entry : fs::recursive_directory_iterator(places::build())) {
    if (entry.path().parent_path().filename() != "unity" || entry.path().extension() != ".cpp") continue;
    std::vector<const Source*> files;
    std::istringstream lines(pabd::read_bytes(entry.path()));
    for (std::string line; std::getline(lines, line);) {
      CAPTURE(entry.path(), line);
      REQUIRE(line.starts_with("#include \""));
      files.push_back(source_of(line.substr(10, line.size() - 11)));
      REQUIRE(files.back() != nullptr);
    }
    for (std::string& text : hidden(files)) found.push_back(std::move(text));
  }
  CHECK(found == std::vector<std::string>{});
}

}  // namespace pabd::test_compiled_together
