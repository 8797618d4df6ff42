// See step_at_time.h.
#include "app/session/step_at_time.h"

#include "app/session/timeline.h"

namespace pabd {

std::size_t moment_in_step(const Timeline& a, std::size_t i, const Timeline& b) {
  std::size_t j = b.at_time(a[i].report.time);
  // Edits that A has before it at this time are none of B yet.
  for (++i; i < a.size() && a[i].edit && j > 0 && b[j].edit; ++i) --j;
  return j;
}

}  // namespace pabd
