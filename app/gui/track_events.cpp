// SPDX-License-Identifier: MIT
// See track_events.h.
#include "app/gui/track_events.h"

#include <fmt/format.h>

#include <algorithm>

namespace pabd {

std::vector<TrackEvent> track_events(const Snapshot& sim, const UiState& ui) {
  std::vector<TrackEvent> out;
  if (const auto& p = sim.a.parting) {
    if (p->parted)
      out.push_back(
          {*p->parted, "parts", "", "parts from the run before: a body is more than d̂ away", true, true});
    out.push_back({p->time, "branch", "", "here this run leaves the one before", false, true});
  }
  // Of what goes on for long, where it begins. What is so from the first step on, or was so before what the timeline
  // still holds, begins nowhere.
  const Reports& history = sim.a.history;
  const auto begins = [&](const char* name, const char* brief, const char* words, bool warning, auto&& is) {
    if (sim.forgotten > 0) return;
    bool before = true;  // no step led to the first moment
    for (std::size_t i = 1; i < history.size(); ++i) {
      const bool now = is(history[i]);
      if (now && !before) return out.push_back({history[i].time, name, brief, words, warning, false});
      if (now) return;
      before = false;
    }
  };
  begins("first contact", "contact", "the first contact", false,
         [](const StepSummary& r) { return r.contacts > 0; });
  begins("first overlap", "overlap", "for the first time bodies overlap", true,
         [](const StepSummary& r) { return r.max_penetration > 0; });
  begins("iteration limit", "limit", "for the first time a step ended at the iteration limit", true,
         [](const StepSummary& r) { return r.status == StepStatus::iteration_limit; });
  begins("first halves", "halves", "for the first time a step was made again in halves", false,
         [](const StepSummary& r) { return r.halved_bodies > 0; });
  for (std::size_t k = 0; k < ui.camera_keys.size(); ++k) {
    const double time = ui.camera_keys[k].time;
    out.push_back(
        {time, fmt::format("key {}", k + 1), "", fmt::format("camera key at {:.3f} s", time), false, true});
  }
  return out;
}

std::vector<PlacedName> place_names(std::span<const NameAt> names, std::vector<Span> taken, const Span& room,
                                    float gap) {
  std::vector<PlacedName> out;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const NameAt& name = names[i];
    const float margin = gap / 4;
    const auto place = [&](float width, float left, bool brief) {
      const Span wanted{left - margin, left + width + margin};
      const bool inside = left >= room.lo && left + width <= room.hi;
      const auto is_taken = [&](const Span& other) { return wanted.overlaps(other); };
      if (width <= 0 || !inside || std::any_of(taken.begin(), taken.end(), is_taken)) return false;
      taken.push_back({left - gap, left + width + gap});
      out.push_back({i, left, brief});
      return true;
    };
    static_cast<void>(
        place(name.width, name.x + gap, false) || place(name.width, name.x - gap - name.width, false) ||
        place(name.brief, name.x + gap, true) || place(name.brief, name.x - gap - name.brief, true));
  }
  return out;
}

}  // namespace pabd
