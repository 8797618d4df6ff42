// SPDX-License-Identifier: MIT
// The table of a sweep: one row per task, by index. The bytes do not depend on the order in which tasks were made;
// measured times are in a table of their own.
//
//   index, hash, parameters, status, metrics, step, time
#pragma once

#include <string>

#include "app/sweep/collect_sweep.h"

namespace pabd {

// Lines end with \n; fields as in RFC 4180; numbers in the shortest form that reads back exactly. Missing values are
// empty.
std::string table_csv(const CollectedSweep& sweep);

// {"index":0,"hash":"…","parameters":{…},"status":"done","metrics":{…},"step":60,"time":1.0} per line;
// missing values are omitted.
std::string table_jsonl(const CollectedSweep& sweep);

// A NumPy file (format 1.0) with a structured array: numbers as <f8 (missing: NaN), index and step as <i8
// (missing: −1), texts and parameters that are not numbers as <U. numpy.load() reads it, and
// pandas.DataFrame() takes the result.
std::string table_npy(const CollectedSweep& sweep);

// index, hash, seconds, threads, step_time (ms), of the tasks with measured times.
std::string timing_csv(const CollectedSweep& sweep);

}  // namespace pabd
