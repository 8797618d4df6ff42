// SPDX-License-Identifier: MIT
// The sweep that is open in the window, as plain data.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/gui/view_command.h"
#include "app/sweep/collect_grid.h"
#include "app/sweep/collect_ranking.h"

namespace pabd {

struct Snapshot;

struct OpenedSweep {
  std::string folder;       // absolute; empty: none is open
  std::uint64_t asked = 0;  // rises whenever it is to be read
  bool reading = false;
  std::string problem;                         // why it could not be read; empty: it could
  std::shared_ptr<const CollectedSweep> read;  // null: not yet
  command::SweepView view;
  std::optional<std::size_t> loaded;  // place in read->tasks of the run that the window shows

  struct Wanted {  // by load_run
    std::size_t task = 0;
    std::vector<std::string> sets;
  };
  std::optional<Wanted> wanted;  // the last one
};

// What the cells of a sweep are made from.
struct ShownSweep {
  TaskGrid grid;
  std::vector<Criterion> criteria;
  std::size_t criterion = 0;  // place in criteria; beyond the last where there are none
  std::size_t slice = 0;
};

// Throws Error(bad_input) for parameters, a metric or a slice that the sweep does not have.
ShownSweep shown_of(const CollectedSweep& sweep, const command::SweepView& view);

// Takes what was read; the view of it stays as far as it still fits.
void take_read(OpenedSweep& sweep, std::shared_ptr<const CollectedSweep> read);

// The command that loads a task; notes it as wanted. Throws Error(bad_input) where there is none, or no end of it.
command::Load load_of(OpenedSweep& sweep, const command::LoadRun& run);

// Another scene was loaded: whether it is what load_of last asked for.
void note_loaded(OpenedSweep& sweep, const Snapshot& sim);

}  // namespace pabd
