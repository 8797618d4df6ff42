// SPDX-License-Identifier: MIT
// The range that a message names is the one that holds.
#include <fmt/format.h>

#include <cmath>
#include <regex>

#include "sim/scene/keys.h"
#include "tests/scene/scene_helpers.h"

namespace pabd::test_ranges {

using namespace test;

namespace {

// Why --set KEY=VALUE is refused; empty: it is not.
std::string refusal(const std::string& key, const std::string& value) {
  std::vector<std::string> overrides{key + "=" + value};
  if (key.starts_with("camera."))
    overrides.insert(overrides.begin(), R"(camera={"eye":[1,2,3],"target":[0,0,0]})");
  if (key == "contact.friction.dynamic") overrides.emplace_back("contact.friction.static=100");
  try {
    parse(with_body(R"("gravity": [0, -9.81, 0])"), overrides);
    return {};
  } catch (const Error& error) {
    return error.what();
  }
}

struct Named {
  double lo, hi;
  bool with_lo, with_hi, whole;
};

// "a whole number from 1 to 32", "a width from 0 to below 1", "a number above 0 and up to 1", "a number between 1 and
// 170, ends excluded"; none: the message names no range.
std::optional<Named> named_range(const std::string& message) {
  static const std::regex pattern(
      "expected (?:\"auto\" or )?an? (whole )?[a-z]+ (from|above|between) ([^ ]+) "
      "(to below|to|and up to|and up to below|and) ([^ ,]+)");
  std::smatch m;
  if (!std::regex_search(message, m, pattern)) return {};
  return Named{std::stod(m[3]), std::stod(m[5]), m[2] == "from", m[4] == "to" || m[4] == "and up to",
               m[1].matched};
}

std::string as_text(double x) { return fmt::format("{}", x); }

}  // namespace

TEST_CASE("every range that a message names holds, with its ends", "[scene]") {
  int found = 0;
  for (const std::string& key : scene_keys()) {
    if (key == "name" || key == "description") continue;
    const bool vector = key == "gravity";
    const auto refused = [&](const std::string& value) { return refusal(vector ? "gravity.1" : key, value); };
    const std::string message = refused("word");
    const auto range = named_range(message);
    CAPTURE(key, message);
    // What has none: words, true or false, a list of numbers.
    if (!range) {
      CHECK_THAT(message, Catch::Matches(".*expected (\"|true or false|an array of 3 numbers).*"));
      continue;
    }
    ++found;
    REQUIRE(range->lo < range->hi);
    const double step_lo = range->whole ? 1 : std::max(1e-9 * std::abs(range->lo), 1e-15),
                 step_hi = range->whole ? 1 : 1e-9 * std::abs(range->hi);
    CHECK(refused(as_text(range->lo)).empty() == range->with_lo);
    CHECK(refused(as_text(range->hi)).empty() == range->with_hi);
    CHECK(refused(as_text(range->lo + step_lo)).empty());
    CHECK(refused(as_text(range->hi - step_hi)).empty());
    for (const std::string& wrong :
         {as_text(range->lo - step_lo), as_text(range->hi + step_hi), std::string("NaN"),
          std::string("1e999"), std::string("true"), std::string("null"), std::string("[1]"),
          std::string("-1e300"), std::string("1e300"), as_text(range->lo + 0.5)}) {
      const std::string why = refused(wrong);
      if (wrong == as_text(range->lo + 0.5) && !range->whole) continue;
      CAPTURE(wrong, why);
      const auto again = named_range(why);
      REQUIRE(again);
      CHECK(again->lo == range->lo);
      CHECK(again->hi == range->hi);
      CHECK(again->with_lo == range->with_lo);
      CHECK(again->with_hi == range->with_hi);
      CHECK(again->whole == range->whole);
    }
  }
  CHECK(found > 20);
}

TEST_CASE("the dynamic friction is told how large it may be", "[scene]") {
  const std::string below_static = R"("contact": { "friction": { "static": 0.3, "dynamic": 0.4 } })";
  check_refused(with_body(below_static), {"0.4 is out of range", "from 0 to 0.3, not above the static one"});
  check_refused(with_body(R"("contact": { "friction": "rough" })"),
                {"/contact/friction", "a coefficient from 0 to 100, or an object"});
}

TEST_CASE("a number with a unit is read where somebody sets it, and in a file is told the number to write",
          "[scene]") {
  const auto with = [](const std::string& set) {
    return parse_scene(with_body(R"("gravity": [0, -9.81, 0])"), "s", ".", {set});
  };
  CHECK(with("contact.d_hat=5mm").params.contact.d_hat == 0.005);
  CHECK(with("contact.d_hat=0.3 mm").params.contact.d_hat == 0.0003);
  CHECK(with("contact.kappa=2 kJ").params.contact.kappa == 2000);
  CHECK(with("time_step=20ms").params.h == 0.02);
  CHECK(with("duration=2min").duration == 120);
  CHECK(with("gravity.1=-500 cm/s²").params.gravity.y() == -5);
  CHECK(with("bodies.0.density=2 g/cm³").model.mass[0] == with("bodies.0.density=2000").model.mass[0]);
  // Text stays text.
  CHECK(with(R"(bodies.0.name="5 mm")").model.name[0] == "5 mm");
  for (const auto& [set, why] :
       {std::pair{"contact.d_hat=5 s", "expected a number (m), got one in s (from --set contact.d_hat=5 s)"},
        {"contact.N=5 mm", "a whole number from 1 to"},
        {"time_step=5 mm", "(s), got one in m"},
        {"contact.d_hat=5 furlong", "(m), got the text"},
        {"contact.friction=0.3 N", "got one in N"},
        {"bodies.0.density=5 kg", "(kg/m³), got one in kg"}}) {
    CAPTURE(set);
    check_refused(with_body(R"("gravity": [0, -9.81, 0])"), {why}, {set});
  }
  check_refused(with_body(R"("contact": { "d_hat": "5 mm" })"), {"/contact/d_hat", "; write 0.005"});
  // Another unit is none of it.
  try {
    parse(with_body(R"("contact": { "d_hat": "5 kg" })"));
    FAIL("it was taken");
  } catch (const Error& error) {
    CHECK_THAT(error.what(), Catch::Contains("(m), got the text \"5 kg\"") && !Catch::Contains("write"));
  }
}

}  // namespace pabd::test_ranges
