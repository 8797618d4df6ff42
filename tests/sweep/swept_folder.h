// SPDX-License-Identifier: MIT
// The folder of a sweep as its tasks leave it, written by hand.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "render/output/png.h"
#include "tests/support/files.h"
#include "tests/support/temp_folder.h"

namespace pabd::test {

struct FakeTask {
  int index = 0;
  std::map<std::string, std::string> parameters = {};  // key → JSON
  std::string status = "done";
  std::string why = {};
  std::string faults = {};
  std::map<std::string, std::string> metrics = {};   // name → JSON
  std::optional<double> step_time = {}, noise = {};  // ms
  std::optional<Image> picture = {};
};

inline std::string members(const std::map<std::string, std::string>& values) {
  std::string out = "{";
  for (const auto& [key, value] : values) out += (out.size() > 1 ? ",\"" : "\"") + key + "\":" + value;
  return out + "}";
}

// A gradient that differs from task to task.
inline Image fake_picture(int index, int width = 320, int height = 180) {
  Image image;
  image.resize(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const std::size_t at = 3 * static_cast<std::size_t>(y * width + x);
      image.rgb[at] = static_cast<std::uint8_t>(40 + 37 * index % 180);
      image.rgb[at + 1] = static_cast<std::uint8_t>(60 + x * 120 / width);
      image.rgb[at + 2] = static_cast<std::uint8_t>(60 + y * 160 / height);
    }
  }
  return image;
}

class SweptFolder {
 public:
  explicit SweptFolder(const std::string& plan = R"({"scene": "two_boxes"})") {
    write_bytes(path() / "plan.json", plan);
    std::filesystem::create_directory(path() / "tasks");
  }

  const std::filesystem::path& path() const { return folder_.path(); }

  static std::string hash_of(int index) {
    std::ostringstream out;
    out << std::hex << (0xabc0000000000000ull + static_cast<unsigned long long>(index) * 7919);
    return out.str();
  }
  std::filesystem::path task_folder(int index) const { return path() / "tasks" / hash_of(index); }

  void add(const FakeTask& task) const {
    const std::filesystem::path folder = task_folder(task.index);
    std::filesystem::create_directory(folder);
    const std::string head =
        "{\"index\":" + std::to_string(task.index) + ",\"hash\":\"" + hash_of(task.index) + "\",";
    write_bytes(folder / "task.json", head + "\"parameters\":" + members(task.parameters) + "}");
    const std::string why = task.why.empty() ? "" : "\"why\":\"" + task.why + "\",";
    const std::string faults = task.faults.empty() ? "" : "\"faults\":\"" + task.faults + "\",";
    write_bytes(folder / "result.json", head + "\"status\":\"" + task.status + "\"," + why + faults +
                                            "\"metrics\":" + members(task.metrics) +
                                            ",\"step\":60,\"time\":1}");
    if (task.step_time) {
      std::ostringstream timing;
      timing << "{\"seconds\":" << 0.06 * *task.step_time
             << ",\"threads\":1,\"step_time\":" << *task.step_time;
      if (task.noise) timing << ",\"step_time_noise\":" << *task.noise;
      timing << "}";
      write_bytes(folder / "timing.json", timing.str());
    }
    if (task.picture) write_png(folder / "end.png", *task.picture);
  }

 private:
  TempFolder folder_;
};

}  // namespace pabd::test
