// SPDX-License-Identifier: MIT
// See notes.h.
#include "sim/import/notes.h"

#include <fmt/format.h>

#include <algorithm>

namespace pabd {
namespace {

constexpr std::size_t kMostNotes = 1000, kMostLines = 8;

}  // namespace

std::string ImportNote::line() const {
  if (where.empty()) return text;
  const std::size_t shown = std::min(where.size(), kMostLines);
  std::string out;
  for (std::size_t k = 0; k < shown; ++k) {
    const bool again = k > 0 && where[k].first == where[k - 1].first;
    out += again ? fmt::format(", {}", where[k].second)
                 : fmt::format("{}{}:{}", k > 0 ? ", " : "", where[k].first, where[k].second);
  }
  if (where.size() > shown) out += fmt::format(" and {} more", where.size() - shown);
  return out + ": " + text;
}

void ImportNotes::add(const std::string& text, const std::string& file, int line) {
  auto found = places_.find(text);
  if (found == places_.end()) {
    if (notes_.size() == kMostNotes) return;  // a hostile file: the thousand say enough
    found = places_.emplace(text, notes_.size()).first;
    notes_.push_back({text, {}});
  }
  auto& where = notes_[found->second].where;
  if (line > 0 && (where.empty() || where.back() != std::pair(file, line))) where.emplace_back(file, line);
}

}  // namespace pabd
