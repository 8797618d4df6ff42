// SPDX-License-Identifier: MIT
// What happened in the past that the timeline shows, in words, and where there is room for the words.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "app/gui/panel.h"

namespace pabd {

struct TrackEvent {
  double time = 0;    // s
  std::string name;   // on the track
  std::string brief;  // where there is less room
  std::string words;  // as the tooltip tells it
  bool warning = false;
  bool marked = false;  // something else marks its place on the track
};

// The more telling ones first.
std::vector<TrackEvent> track_events(const Snapshot& sim, const UiState& ui);

struct Span {
  float lo = 0, hi = 0;
  bool overlaps(const Span& other) const { return lo < other.hi && other.lo < hi; }
};

// A name at `x`, as wide as that, or `brief` if that has no room (0: there is no briefer one); pixels.
struct NameAt {
  float x = 0, width = 0, brief = 0;
};
struct PlacedName {
  std::size_t number = 0;  // among the names
  float left = 0;
  bool brief = false;
};
// Right or left of their places by `gap`, in `room`, clear of everything in `taken` and farther than `gap` from each
// other. What comes first has the choice; what finds no room is left out.
std::vector<PlacedName> place_names(std::span<const NameAt> names, std::vector<Span> taken, const Span& room,
                                    float gap);

}  // namespace pabd
