// SPDX-License-Identifier: MIT
#include "tests/structure/sources.h"

#include <algorithm>
#include <filesystem>
#include <regex>
#include <sstream>

#include "tests/support/files.h"
#include "tests/support/places.h"

namespace fs = std::filesystem;

namespace pabd {

const std::vector<Source>& sources() {
  static const std::vector<Source> all = [] {
    std::vector<Source> found;
    const fs::path root = places::project();
    const std::regex include("^\\s*#\\s*include\\s*[<\"]([^>\"]+)[>\"]");
    for (const char* folder : {"app", "render", "sim", "tests"}) {
      for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
        const std::string extension = entry.path().extension();
        if (extension != ".cpp" && extension != ".h") continue;
        Source source;
        source.path = fs::relative(entry.path(), root).string();
        source.text = read_bytes(entry.path());
        std::istringstream text(source.text);
        for (std::string line; std::getline(text, line); ++source.lines) {
          std::smatch match;
          if (std::regex_search(line, match, include)) source.includes.push_back(match[1]);
        }
        found.push_back(std::move(source));
      }
    }
    std::sort(found.begin(), found.end(), [](const Source& a, const Source& b) { return a.path < b.path; });
    return found;
  }();
  return all;
}

}  // namespace pabd
