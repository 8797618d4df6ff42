// SPDX-License-Identifier: MIT
// What a comparison found, for scripts and for people.
#include "render/output/compare_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "render/output/png.h"
#include "sim/base/atomic_file.h"
#include "sim/base/error.h"

namespace pabd {
namespace fs = std::filesystem;

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
