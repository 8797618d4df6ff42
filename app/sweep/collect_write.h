// SPDX-License-Identifier: MIT
// Writes all results of a sweep into a folder.
//
//   table.csv table.jsonl table.npy  timing.csv  ranking.txt
//   sheet.png (sheet_2.png …)  heat_METRIC.png .svg  pareto.png .svg  report.html
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "app/sweep/collect_sweep.h"

namespace pabd {

struct CollectOptions {
  std::string x = {}, y = {};  // parameters along the axes; empty: chosen
  bool force = false;          // replace what is there
};

// Called before each file is made.
using CollectProgress = std::function<void(const std::string& name, std::size_t number, std::size_t of)>;

// Plain text for people.
struct CollectionWords {
  std::vector<std::string> ranking;  // its sentences
  std::vector<std::string> notes;    // a line each: omissions of pictures
};

// Files appear whole. Throws Error(exists) before the first one is made if any exists and not `force`, Error(bad_input)
// for unknown axes, Error(file).
CollectionWords write_collection(const CollectedSweep& sweep, const std::filesystem::path& folder,
                                 const CollectOptions& options, const CollectProgress& progress = {});

}  // namespace pabd
