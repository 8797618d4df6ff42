// SPDX-License-Identifier: MIT
// Pictures against approved ones.
#include "tests/support/golden.h"

#include <fmt/format.h>

#include <cstdlib>
#include <iostream>
#include <set>
#include <string_view>

#include "render/output/compare_report.h"
#include "render/output/png.h"
#include "sim/base/error.h"
#include "tests/support/places.h"

namespace pabd {
namespace fs = std::filesystem;
namespace {

constexpr const char* reference_class = "llvmpipe-128";

// Dear ImGui places the edges of smooth lines by the processor's approximate reciprocal root, which is another one for
// each maker of processors. The few pictures where that shows have a second approved one.
constexpr const char* kOther = ".2.png";

// Which of the approved pictures is to be renewed.
const char* updated_ending() {
  const char* wish = std::getenv("PABD_UPDATE_GOLDEN");
  if (wish && std::string_view(wish) == "1") return ".png";
  if (wish && std::string_view(wish) == "2") return kOther;
  return nullptr;
}

void update(const fs::path& path, const Image& image, const std::string& renderer) {
  write_png(path, image, {{"GL_RENDERER", renderer}});
}

void say_lenient(const std::string& name, const std::string& own_class, const GoldenFolders& folders) {
  const std::string what = fs::exists(folders.baselines / own_class)
                               ? fmt::format("no approved picture {} of class {}", name, own_class)
                               : fmt::format("no approved pictures of class {}", own_class);
  static std::set<std::string> said;
  if (!said.insert(what).second) return;
  (folders.notes ? *folders.notes : std::cerr)
      << what << ": compared leniently with class " << reference_class << std::endl;
}

}  // namespace

GoldenFolders golden_folders() { return {places::tests() + "/golden", places::build() + "/golden_failures"}; }

CompareResult check_golden(const Image& image, const std::string& name, const std::string& renderer,
                           const GoldenFolders& folders) {
  const std::string own_class = renderer_class(renderer);
  const fs::path own = folders.baselines / own_class / (name + ".png");
  const fs::path reference = folders.baselines / reference_class / (name + ".png");
  if (const char* ending = updated_ending()) {
    update(folders.baselines / own_class / (name + ending), image, renderer);
    CompareResult result;
    result.equal = true;
    return result;
  }

  const bool has_own = fs::exists(own);
  const fs::path& baseline = has_own ? own : reference;
  const CompareTier tier = has_own ? CompareTier::same_class : CompareTier::cross_class;
  CompareResult result;
  Image expected;
  if (fs::exists(baseline)) {
    if (!has_own) say_lenient(name, own_class, folders);
    expected = read_png(baseline);
    result = compare_images(image, expected, tier);
  } else {
    result.reason =
        "there is no approved picture; look at the actual one and approve it with PABD_UPDATE_GOLDEN=1";
  }
  const fs::path other = folders.baselines / own_class / (name + kOther);
  if (!result.equal && has_own && fs::exists(other)) {
    const CompareResult second = compare_images(image, read_png(other), tier);
    if (second.equal) return second;
  }
  if (result.equal) return result;

  save_failure(folders.failures, name, image, expected, result, tier);
  result.reason =
      fmt::format("{}: {} (baseline {}, see {})", name, result.reason, baseline.lexically_normal().string(),
                  (folders.failures / (name + ".*")).string());
  return result;
}

}  // namespace pabd
