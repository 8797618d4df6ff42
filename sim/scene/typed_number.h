// SPDX-License-Identifier: MIT
// Numbers as people type them, with a unit behind them: in fields of the window, as options and with --set a unit that
// fits is read, any other one is refused. Files have numbers in SI units; a unit there is refused with the number to write.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace pabd {

// "5 cm" is 0.05 m; none where the text is no number with a unit that is known. `unit`: of scene files.
struct TypedQuantity {
  std::string number;
  std::string_view unit;
};
std::optional<TypedQuantity> typed_quantity(std::string_view text);

// What was typed where a number of that unit is expected, as --set takes it: "5 cm" in m is "0.05", "5 m" and "5" are "5",
// "auto 12.5 J" is "auto". What is not of that unit stays as it was typed.
std::string typed_number(std::string_view text, std::string_view unit);

// The number that the whole text is, if it is one.
std::optional<double> number_of_text(const std::string& text);

// Why what was typed is no number, whole or not, of that unit (empty: typed_number() gives one): "expected a number (s),
// got "5 m"".
std::string number_problem(const std::string& text, bool whole, std::string_view unit);

// For a message that refuses a text where a number of that unit is expected: "; write 0.005". Empty where the text is no
// number with such a unit, or with none.
std::string number_to_write(std::string_view text, std::string_view unit);

}  // namespace pabd
