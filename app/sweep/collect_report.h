// SPDX-License-Identifier: MIT
// A sweep as one self-contained HTML file: pictures are embedded, there is no script, and text of the sweep's files is
// escaped.
#pragma once

#include <string>
#include <vector>

#include "app/sweep/collect_ranking.h"

namespace pabd {

struct ReportPicture {
  std::string title;  // plain text
  std::string type;   // "image/png", "image/svg+xml"
  std::string bytes;
  int width = 0;  // px, largest width on the page
};

struct Report {
  std::vector<std::string> notes;  // after those of the sweep
  std::vector<ReportPicture> sheets, maps, plots;
};

std::string report_html(const CollectedSweep& sweep, const Ranking& ranking, const Report& report);

}  // namespace pabd
