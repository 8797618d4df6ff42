// SPDX-License-Identifier: MIT
// The table of a sweep: one row a task, by index. The same tasks give the same bytes, whoever made them in what
// order; what clocks say is in a table of its own.
//
//   index, hash, one column a parameter, status, one a metric, step, time
#pragma once

#include <string>

#include "app/sweep/collect_sweep.h"

namespace pabd {

// Lines end with \n; fields as in RFC 4180; numbers as short as reading them back exactly allows. What is not
// there is empty.
std::string table_csv(const CollectedSweep& sweep);

// {"index":0,"hash":"…","parameters":{…},"status":"done","metrics":{…},"step":60,"time":1.0} a line; what is not
// there is left out, so is "why" of what is done.
std::string table_jsonl(const CollectedSweep& sweep);

// A NumPy file (format 1.0) with a structured array: numbers as <f8 with NaN for what is not there, index and
// step as <i8 with −1, texts and parameters that are no numbers as <U. numpy.load() reads it, and
// pandas.DataFrame() takes what that gives.
std::string table_npy(const CollectedSweep& sweep);

// index, hash, seconds, threads, step_time (ms): of tasks that have it.
std::string timing_csv(const CollectedSweep& sweep);

}  // namespace pabd
