// SPDX-License-Identifier: MIT
// What a comparison found, for scripts and for people.
#pragma once

#include <filesystem>
#include <string>

#include "render/output/compare_images.h"

namespace pabd {

// An object with equal, reason, tier, all numbers of the result and the file names (empty ones are left out).
// One line a key; ends with a newline.
std::string compare_json(const CompareResult& result, CompareTier tier,
                         const std::filesystem::path& actual = {}, const std::filesystem::path& expected = {},
                         const std::filesystem::path& difference = {});

// Makes `folder` and writes name.actual.png, name.expected.png, name.diff.png and name.json there. `expected`
// may be empty (there is none): its picture and the difference are left out then. Throws Error(file).
void save_failure(const std::filesystem::path& folder, const std::string& name, const Image& actual,
                  const Image& expected, const CompareResult& result, CompareTier tier);

}  // namespace pabd
