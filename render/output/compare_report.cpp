// SPDX-License-Identifier: MIT
// What a comparison found, for scripts and for people.
#include "render/output/compare_report.h"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "render/output/png.h"
#include "sim/base/atomic_file.h"
#include "sim/base/error.h"
#include "sim/base/utf8.h"

namespace pabd {
namespace fs = std::filesystem;
namespace {

// "llvmpipe (LLVM 15.0.6, 256 bits)": code for other vectors may round elsewhere.
std::string llvmpipe_class(const std::string& name) {
  constexpr std::array<std::pair<std::string_view, const char*>, 3> widths = {
      {{"128 bits", "llvmpipe-128"}, {"256 bits", "llvmpipe-256"}, {"512 bits", "llvmpipe-512"}}};
  for (const auto& [bits, result] : widths) {
    if (name.find(bits) != std::string::npos) return result;
  }
  return "llvmpipe";
}

}  // namespace

std::string renderer_class(const std::string& gl_renderer) {
  const std::string name = lower_case(gl_renderer);
  if (name.starts_with("llvmpipe")) return llvmpipe_class(name);

  std::string word;  // also safe as a folder name
  for (char c : name) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-';
    if (letter) {
      word += c;
    } else if (!word.empty()) {
      break;
    }
  }
  // Layers over another driver are their own class: their pixels are not the driver's.
  for (const char* layer : {"softpipe", "zink", "virgl", "angle", "d3d12", "svga3d"}) {
    if (word == layer) return word;
  }
  constexpr std::array<std::pair<std::string_view, const char*>, 11> makers = {{{"nvidia", "nvidia"},
                                                                                {"geforce", "nvidia"},
                                                                                {"quadro", "nvidia"},
                                                                                {"tesla", "nvidia"},
                                                                                {"radeon", "amd"},
                                                                                {"amd", "amd"},
                                                                                {"intel", "intel"},
                                                                                {"apple", "apple"},
                                                                                {"mali", "mali"},
                                                                                {"adreno", "adreno"},
                                                                                {"videocore", "videocore"}}};
  for (const auto& [part, maker] : makers) {
    if (name.find(part) != std::string::npos) return maker;
  }
  return word.empty() ? "unknown" : word;
}

std::string compare_json(const CompareResult& result, CompareTier tier, const fs::path& actual,
                         const fs::path& expected, const fs::path& difference) {
  nlohmann::ordered_json json = {{"equal", result.equal},
                                 {"reason", result.reason},
                                 {"tier", tier == CompareTier::same_class ? "same_class" : "cross_class"},
                                 {"max_difference", result.max_difference},
                                 {"differing", result.differing},
                                 {"worst_tile",
                                  {{"x", result.worst_tile_x},
                                   {"y", result.worst_tile_y},
                                   {"pixels", result.worst_tile_pixels},
                                   {"mean", result.worst_tile_mean}}}};
  if (!actual.empty()) json["actual"] = actual.string();
  if (!expected.empty()) json["expected"] = expected.string();
  if (!difference.empty()) json["diff"] = difference.string();
  // File names need not be UTF-8.
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

void save_failure(const fs::path& folder, const std::string& name, const Image& actual, const Image& expected,
                  const CompareResult& result, CompareTier tier) {
  const fs::path base = folder / name;
  const auto part = [&base](const char* end) { return fs::path(base.string() + end); };
  const bool has_expected = !expected.rgb.empty();
  write_png(part(".actual.png"), actual);
  if (has_expected) {
    write_png(part(".expected.png"), expected);
    write_png(part(".diff.png"), difference_image(actual, expected));
  }
  write_file(part(".json"), compare_json(result, tier, part(".actual.png"),
                                         has_expected ? part(".expected.png") : fs::path(),
                                         has_expected ? part(".diff.png") : fs::path()));
}

}  // namespace pabd
