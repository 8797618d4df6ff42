// SPDX-License-Identifier: MIT
// What differs between two parameter sets, in words.
#include "app/overlay/parameter_words.h"

#include <catch2/catch.hpp>

#include "app/plots/rich_text.h"
#include "sim/scene/tuning.h"

namespace pabd::test_parameter_words {

namespace {

using Lines = std::vector<std::string>;

Lines words(const std::vector<std::string>& sets, double kappa_b = 50) {
  Params a;
  a.contact.kappa = 100;
  Params b = tuned(a, sets);
  Lines lines;
  for (const std::string& line : difference_words(a, 100, b, kappa_b)) lines.push_back(plain_text(line));
  return lines;
}

}  // namespace

TEST_CASE("one line a parameter that differs, with symbol and unit") {
  CHECK(words({}).empty());
  CHECK(words({"contact.kappa=50"}) == Lines{"κ 100 → 50 J"});
  CHECK(words({"contact.N=8"}) == Lines{"N 3 → 8"});
  CHECK(words({"contact.d_hat=0.02"}) == Lines{"d̂ 0.01 → 0.02 m"});
  CHECK(words({"contact.onset=0"}) == Lines{"ε 0.2 → 0"});
  CHECK(words({"solver.method=newton"}) == Lines{"solver auto → newton"});
  CHECK(words({"solver.iterations=5"}) == Lines{"iterations 20 → 5"});
  CHECK(words({"solver.tolerance=1e-9"}) == Lines{"tolerance 10⁻⁶ → 10⁻⁹"});
  CHECK(words({"time_step=0.01"}) == Lines{"h 0.01667 → 0.01 s"});
  CHECK(words({"gravity=[0,-1.62,0]"}) == Lines{"g (0, −9.81, 0) → (0, −1.62, 0) m/s²"});
  CHECK(words({"contact.friction.dynamic=0.25"}) == Lines{"μ_dynamic 0.5 → 0.25"});
  CHECK(words({"contact.N=8", "contact.kappa=50"}).size() == 2);
}

TEST_CASE("an automatic stiffness says what it came to, also where another parameter changed it") {
  CHECK(words({"contact.kappa=auto"}, 264) == Lines{"κ 100 → 264 J (auto)"});
  CHECK(words({"contact.kappa=7", "contact.barrier=log"}, 7) ==
        Lines{"barrier polynomial → log", "κ 100 J → 7 J/m²"});
  Params a, b;
  b.contact.d_hat = 0.02;
  const auto lines = difference_words(a, 100, b, 200);
  REQUIRE(lines.size() == 2);
  CHECK(plain_text(lines[1]) == "κ 100 → 200 J (auto)");
}

}  // namespace pabd::test_parameter_words
