// SPDX-License-Identifier: MIT
// Which parameters are best, in which metric, and why, in sentences with numbers and units.
//
// Less is better: all built-in metrics are errors or costs. Of a metric with a sign the absolute value counts.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/sweep/collect_sweep.h"

namespace pabd {

// A quantity to be minimized.
struct Criterion {
  SweptQuantity quantity;
  bool cost = false;                         // time or iterations, not an error
  std::vector<std::optional<double>> sizes;  // one per task, ≥ 0; only of tasks that are done
};

// Every metric of the table, and the time per step where it was measured.
std::vector<Criterion> criteria_of(const CollectedSweep& sweep);

// The cost in "error against cost": the time per step, else the iterations; null: neither.
const Criterion* cost_of(std::span<const Criterion> criteria);

// Indices of the points (rows of `dimensions` finite numbers) that no other point dominates, that is, is at most as large
// in everything and smaller in something. Equal points are on the front together.
std::vector<std::size_t> pareto_front(std::span<const double> points, std::size_t dimensions);

struct Ranked {
  std::size_t task;
  std::vector<std::size_t> ranks;  // one per counted criterion, from 1; equal tasks share the better rank
  std::size_t sum = 0;
};

struct Ranking {
  std::vector<Criterion> criteria;
  std::vector<std::size_t> counted;  // criteria that are compared: all errors, and one cost
  std::vector<Ranked> front;         // by sum of ranks, then index
  std::size_t compared = 0;          // tasks that are done, acceptable, and have every counted criterion
  std::size_t unacceptable = 0;      // tasks that are done with faults (acceptance.h)
  std::vector<std::string>
      sentences;  // rich text: one per criterion, of the acceptable tasks, then the best of all
};

Ranking rank(const CollectedSweep& sweep);

// "task 7 (d̂ = 0.01 m, κ = 50 J)".
std::string task_words(const CollectedSweep& sweep, std::size_t task);

// 'pabd view SCENE --set KEY=VALUE …': the command that shows this run in the window. Empty without a scene.
std::string view_command(const CollectedSweep& sweep, const SweptTask& task);

}  // namespace pabd
