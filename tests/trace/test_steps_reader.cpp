// SPDX-License-Identifier: MIT
// A steps CSV is read back to the same bits, and what is none is refused with its line.
#include <catch2/catch.hpp>
#include <limits>
#include <sstream>

#include "sim/base/error.h"
#include "sim/solver/step_numbers.h"
#include "sim/trace/trace.h"

namespace pabd::test_steps_reader {

namespace {

std::string text_of(const std::vector<StepSummary>& steps) {
  std::ostringstream out;
  write_steps_header(out);
  for (const StepSummary& step : steps) write_steps_row(out, step);
  return out.str();
}

StepSummary numbered(int k) {
  StepSummary step;
  step.status = StepStatus::converged;
  int n = 0;
  for (const StepNumber& number : step_numbers())
    std::visit(
        [&](const auto of) {
          auto& value = step.*of;
          value = static_cast<std::remove_reference_t<decltype(value)>>(100 * k + ++n +
                                                                        (number.whole() ? 0 : 1.0 / 3));
        },
        number.member);
  step.min_gap = k == 1 ? std::numeric_limits<double>::infinity() : -5e-324;
  step.times.total = 2.5;
  return step;
}

std::string refusal(const std::string& text, std::size_t most = 100) {
  try {
    steps_from_csv(text, "steps.csv", most);
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::bad_input);
    return error.what();
  }
  return "taken";
}

}  // namespace

TEST_CASE("a steps CSV that is written is read back to the same bits", "[trace]") {
  const std::vector<StepSummary> steps{numbered(1), numbered(2), numbered(3)};
  const StepsFile file = steps_from_csv(text_of(steps), "steps.csv", 3);
  REQUIRE(file.steps.size() == 3);
  for (std::size_t k = 0; k < 3; ++k) {
    for (const StepNumber& number : step_numbers()) {
      CAPTURE(k, number.name);
      CHECK(number.value(file.steps[k]) == number.value(steps[k]));
      CHECK(file.has(number.name));
    }
    CHECK(file.steps[k].times.total == 2.5);
  }
  CHECK(file.has(kStepTime));
  CHECK_FALSE(file.has("method"));
}

TEST_CASE("a step that failed is left out of what is read", "[trace]") {
  StepSummary failed = numbered(2);
  failed.status = StepStatus::non_finite;
  CHECK(steps_from_csv(text_of({numbered(1), failed}), "steps.csv", 9).steps.size() == 1);
}

TEST_CASE("columns may be missing, in another order and unknown; lines may end as on Windows", "[trace]") {
  const StepsFile file =
      steps_from_csv("kinetic,mood,time\r\n1.5,\"good\",0.25\r\n-nan,bad,0.5\r\n", "steps.csv", 9);
  REQUIRE(file.steps.size() == 2);
  CHECK(file.steps[0].kinetic == 1.5);
  CHECK(file.steps[0].time == 0.25);
  CHECK(std::isnan(file.steps[1].kinetic));
  CHECK(file.columns == std::vector<std::string>{"kinetic", "time"});
}

TEST_CASE("what is no steps CSV is refused with its line", "[trace]") {
  const auto has = [](const std::string& message, const std::string& words) {
    CAPTURE(message);
    CHECK(message.find(words) != message.npos);
  };
  has(refusal(""), "steps.csv: line 1: no column \"time\"");
  has(refusal("a,b\n1,2\n"), "pabd run --trace");
  has(refusal("time\n"), "no steps");
  has(refusal("time,time\n1,2\n"), "two columns \"time\"");
  has(refusal("time,kinetic\n1,2\n3\n"), "line 3: 1 values; expected 2");
  has(refusal("time,kinetic\n1,2,3\n"), "line 2: 3 values; expected 2");
  has(refusal("time,kinetic\n1,two\n"), "line 2: kinetic \"two\": expected a number");
  has(refusal("time,kinetic\n1,\n"), "expected a number");
  has(refusal("time,kinetic\n1,1e999\n"), "expected a number");
  has(refusal("time,kinetic\n1, 2\n"), "expected a number");
  has(refusal("time,contacts\n1,2.5\n"), "contacts \"2.5\": expected a whole number");
  has(refusal("time,contacts\n1,3000000000\n"), "expected a whole number");
  has(refusal("time,step\n1,1e300\n"), "expected a whole number");
  has(refusal("time,step\n1,nan\n"), "expected a whole number");
  has(refusal("time\nnan\n"), "time nan");
  has(refusal("time\ninf\n"), "time inf");
  has(refusal("time\n2\n1\n"), "line 3: time 1: expected one that is not before");
  has(refusal("time\n1\n2\n3\n", 2), "line 4: more than 2 steps");
  has(refusal(std::string("time\n1\0\n", 8)), "expected a number");
}

}  // namespace pabd::test_steps_reader
