// SPDX-License-Identifier: MIT
// A steps CSV: times rise and are finite, and what is taken is written and read again to the same bits.
#include <cmath>
#include <sstream>

#include "sim/trace/trace.h"
#include "tests/fuzz/fuzz.h"

using namespace pabd;

PABD_FUZZ_TARGET(steps, bytes) {
  const auto written = [](const StepsFile& file) {
    std::ostringstream out;
    write_steps_header(out);
    for (const StepSummary& step : file.steps) write_steps_row(out, step);
    return out.str();
  };
  constexpr std::size_t kMost = 1000;
  fuzz::accepts([&] {
    const StepsFile file = steps_from_csv(bytes, "steps.csv", kMost);
    fuzz::require(!file.steps.empty() && file.steps.size() <= kMost,
                  "a steps CSV has steps, and no more than asked");
    for (std::size_t k = 0; k < file.steps.size(); ++k)
      fuzz::require(
          std::isfinite(file.steps[k].time) && (k == 0 || file.steps[k].time >= file.steps[k - 1].time),
          "times are finite and do not fall");
    const std::string text = written(file);
    fuzz::require(written(steps_from_csv(text, "steps.csv", kMost)) == text,
                  "steps that are written are read back to the same bits");
  });
}
