// Runs one engine on one scene and measures it.
//
// Two runs: the first is timed and nothing else, and gives the peak memory; the second reads contacts and
// poses after every step.
#pragma once

#include "tests/bench/peers/engine.h"
#include "tests/bench/peers/scenes.h"

namespace pabd::peers {

struct Depth {
  double max = 0;  // m
  double sum = 0;
  std::int64_t count = 0;
  void add(double depth);
  double mean() const { return count ? sum / static_cast<double>(count) : 0; }
};

struct Measurement {
  double median_ms = 0;       // wall clock, of all steps
  double median_cpu_ms = 0;   // processor time, all threads; less disturbed by other work on the machine
  double median_last_ms = 0;  // wall clock, of the last second
  Depth run;                  // contacts that the engine reports, all steps
  Depth last;                 // the same, last second
  Depth ruler_last;           // overlap found by this project's collision code, last second
  double top_shift = 0;       // horizontal way of the highest body from start to end; m
  double top_drop = 0;        // its way down; m
  double kinetic = 0;         // at the end; J
  double peak_mib = 0;        // VmHWM after the timed run
  bool repeatable = true;     // both runs ended at the same state
};

Measurement measure(const PeerScene& scene, int threads);

}  // namespace pabd::peers
