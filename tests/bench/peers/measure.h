// SPDX-License-Identifier: MIT
// Runs one engine on one scene and measures it.
//
// Two runs: the first is timed and nothing else, and gives the peak memory; the second reads contacts and
// poses after every step. A run that takes longer than its budget ends early.
#pragma once

#include "tests/bench/peers/engine.h"
#include "tests/bench/peers/peer_scenes.h"
#include "tests/bench/peers/rulers.h"

namespace pabd::peers {

inline constexpr double kBudget = 60;  // processor time of the timed run; s

struct Measurement {
  int steps = 0;              // of each run
  double median_ms = 0;       // wall clock, of all steps
  double median_cpu_ms = 0;   // processor time, all threads; less disturbed by other work on the machine
  double median_last_ms = 0;  // wall clock, of the last second
  Depth run;                  // contacts that the engine reports, all steps
  Depth last;                 // the same, last second
  Depth ruler_last;           // overlap found by this project's collision code, last second
  double drift = 0;           // largest distance of a joint's two anchors, all joints and steps; m
  double top_shift = 0;       // horizontal way of the highest body from start to end; m
  double top_drop = 0;        // its way down; m
  double kinetic = 0;         // at the end; J
  double energy_change = 0;  // kinetic and potential, from start to end, as part of the potential energy that
                             // was lost: 0 is right, −1 means that all of it is gone
  double peak_mib = 0;       // VmHWM after the timed run
  bool repeatable = true;    // both runs ended at the same state
};

Measurement measure(const PeerScene& scene, int threads);

}  // namespace pabd::peers
