// SPDX-License-Identifier: MIT
// A sweep as one HTML file that needs nothing else: pictures are in it, there is no script, and text of the
// sweep's files is only text.
#pragma once

#include <string>
#include <vector>

#include "app/sweep/collect_ranking.h"

namespace pabd {

struct ReportPicture {
  std::string title;  // plain text
  std::string type;   // "image/png", "image/svg+xml"
  std::string bytes;
  int width = 0;  // px, the widest that it is shown
};

struct Report {
  std::vector<std::string> notes;  // behind those of the sweep
  std::vector<ReportPicture> sheets, maps, plots;
  std::size_t most_rows = 2000;  // of the table; the files have all
};

std::string report_html(const CollectedSweep& sweep, const Ranking& ranking, const Report& report);

}  // namespace pabd
