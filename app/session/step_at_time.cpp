// SPDX-License-Identifier: MIT
// See step_at_time.h.
#include "app/session/step_at_time.h"

#include "app/session/run.h"

namespace pabd {

std::size_t moment_in_step(const Timeline& a, std::size_t i, const Timeline& b) {
  std::size_t j = b.at_time(a[i].report.time);
  // Edits that A has before it at this time are none of B yet.
  for (++i; i < a.size() && a[i].edit && j > 0 && b[j].edit; ++i) --j;
  return j;
}

void rejoin(const Run& a, Run& b) {
  const std::size_t known = moment_in_step(a.timeline(), a.cursor(), b.timeline());
  if (b.cursor() < known) b.seek(known);
}

bool follow(const Run& a, Run& b, const std::function<void()>& made) {
  rejoin(a, b);
  const double time = a.state().time;
  while (b.at_end() && is_reached(b.state().time + b.params().h, time, b.params().h)) {
    if (!b.advance()) return false;
    if (made) made();
  }
  return true;
}

bool at_common_time(const Run& a, const Run& b) {
  const double h = b.timeline()[b.cursor()].params->h;
  return a.state().size() == b.state().size() && is_common_time(a.state().time, b.state().time, h);
}

}  // namespace pabd
