// SPDX-License-Identifier: MIT
// Which parameters are best, in what, and why: in sentences with numbers and units.
//
// Less is better: all metrics that sweeps know are errors or costs. Of a metric with a sign the size counts.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/sweep/collect_sweep.h"

namespace pabd {

// Something to be small.
struct Criterion {
  SweptQuantity quantity;
  bool cost = false;                         // time or iterations: not an error
  std::vector<std::optional<double>> sizes;  // one a task, ≥ 0; only of what is done
};

// Every metric of the table, and the time a step where tasks tell it.
std::vector<Criterion> criteria_of(const CollectedSweep& sweep);

// What time is measured in for "error against time": the time a step, else the iterations.
const Criterion* cost_of(std::span<const Criterion> criteria);

// Of points (rows of `dimensions` numbers each, finite): which are beaten by no other, that is none is at most
// as large in everything and smaller in something. Equal points are on the front together. By index.
std::vector<std::size_t> pareto_front(std::span<const double> points, std::size_t dimensions);

struct Ranked {
  std::size_t task;
  std::vector<std::size_t> ranks;  // one a criterion that counts, from 1; equal ones share the better rank
  std::size_t sum = 0;
};

struct Ranking {
  std::vector<Criterion> criteria;
  std::vector<std::size_t> counted;  // criteria of the front and the sum: all errors, and one cost
  std::vector<Ranked> front;         // by sum of ranks, then index
  std::size_t compared = 0;          // tasks that are done, acceptable, and have every criterion that counts
  std::size_t unacceptable = 0;      // tasks that are done, and nobody would take (acceptance.h)
  std::vector<std::string> sentences;  // rich text: one a criterion, of the acceptable tasks, then the whole
};

Ranking rank(const CollectedSweep& sweep);

// "task 7 (d̂ = 0.01 m, κ = 50 J)".
std::string task_words(const CollectedSweep& sweep, std::size_t task);

// 'pabd view SCENE --set KEY=VALUE …': the command that shows this run in the window. Empty without a scene.
std::string view_command(const CollectedSweep& sweep, const SweptTask& task);

}  // namespace pabd
