// SPDX-License-Identifier: MIT
// A folder with the plan of a sweep, and what its commands leave there.
#pragma once

#include <catch2/catch.hpp>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tests/cli/program.h"

namespace pabd::test {

inline std::string plan_text() {
  return R"({"format": "pabd-sweep", "version": 1, "scene": "two_boxes", "picture": false, "stop": {"steps": 20},
    "parameters": [{"key": "contact.N", "values": [2, 3]}, {"key": "contact.d_hat", "values": [0.01, 0.02, -1]}]})";
}

// Every file of the tasks but timing.json, by its path below DIR/tasks.
inline std::map<std::string, std::string> results_in(const std::filesystem::path& folder) {
  std::map<std::string, std::string> out;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder / "tasks")) {
    if (entry.is_regular_file() && entry.path().filename() != "timing.json")
      out[std::filesystem::relative(entry.path(), folder / "tasks").string()] = read_text(entry.path());
  }
  return out;
}

// Whole tasks only: nothing temporary.
inline void check_whole(const std::filesystem::path& folder) {
  for (const auto& entry : std::filesystem::directory_iterator(folder / "tasks")) {
    CAPTURE(entry.path());
    CHECK(entry.path().filename().string().size() == 16);
    CHECK(std::filesystem::exists(entry.path() / "result.json"));
  }
}

inline std::size_t done_in(const std::filesystem::path& folder) {
  std::size_t n = 0;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "tasks", ignored))
    n += std::filesystem::exists(entry.path() / "result.json") ? 1 : 0;
  return n;
}

// A folder with plan.json, in which one text is replaced by another.
class PlanFolder : public CommandFolder {
 public:
  explicit PlanFolder(const std::string& from = "", const std::string& to = "") {
    std::string text = plan_text();
    text.replace(text.find(from), from.size(), to);
    write_text(*this / "plan.json", text);
  }
};
inline PlanFolder steps_planned(int steps) { return PlanFolder("20}", std::to_string(steps) + "}"); }
inline PlanFolder with_pictures() { return PlanFolder("\"picture\": false", "\"picture\": true"); }

inline Outcome sweep(const CommandFolder& folder, const std::string& out,
                     const std::vector<std::string>& more = {}, const Setting& setting = {}) {
  std::vector<std::string> command = {"sweep", folder / "plan.json", "-o", folder / out, "--quiet"};
  command.insert(command.end(), more.begin(), more.end());
  return run_pabd(command, setting);
}

}  // namespace pabd::test
