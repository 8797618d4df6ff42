// SPDX-License-Identifier: MIT
// A unit that is typed is the one that is taken, or the text is refused; it is never dropped.
#include "sim/scene/typed_number.h"

#include <catch2/catch.hpp>

#include "sim/scene/tuning.h"

namespace pabd::test_typed_number {

TEST_CASE("numbers are read in the unit that is typed behind them") {
  struct Row {
    const char *typed, *unit, *taken;
  };
  for (const Row& row : {Row{"5 cm", "m", "0.05"},
                         {"5cm", "m", "0.05"},
                         {" 2.5e1 mm ", "m", "0.025"},
                         {"5 m", "m", "5"},
                         {"5", "m", "5"},
                         {"20 ms", "s", "0.02"},
                         {"36 km/h", "m/s", "10"},
                         {"3 kJ", "J", "3000"},
                         {"1e-2", "", "1e-2"},
                         {"90 deg", "degrees", "90"},
                         {"2 kN", "N", "2000"},
                         {"2 kN m", "N m", "2000"},
                         {"7.8 g/cm³", "kg/m³", "7800"},
                         {"auto", "J", "auto"},
                         {"auto 12.5 J", "J", "auto"}}) {
    CAPTURE(row.typed, row.unit);
    CHECK(typed_number(row.typed, row.unit) == row.taken);
  }
}

TEST_CASE("a unit that is not the field's is refused, not dropped") {
  for (const char* typed : {"5 furlong", "5 s", "5 cm 3", "5 m²", "5 J"}) {
    const std::string text = typed_number(typed, "m");
    CAPTURE(typed, text);
    CHECK(text == typed);
    CHECK_THROWS(tuned(Params{}, {"contact.d_hat=" + text}));
  }
}

}  // namespace pabd::test_typed_number
