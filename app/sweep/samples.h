// SPDX-License-Identifier: MIT
// Values of swept parameters: evenly spaced numbers, and sample points.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pabd {

inline constexpr std::size_t kMostAxes = 100;

// Precondition of its users: `from` and `to` are finite, with `log` above 0.
struct NumberRange {
  double from = 0, to = 1;
  bool log = false;    // evenly spaced in the logarithm
  bool whole = false;  // only whole numbers
};

// To 12 significant digits, so that the result does not depend on the last bit of the math library.
double rounded(double x);

// `count` ≥ 1 numbers from `from` to `to`, both included; one: `from`.
std::vector<double> spaced(const NumberRange& range, std::size_t count);

// The value at u in [0, 1). In a whole range all numbers, both ends included, are equally likely.
double at_part(const NumberRange& range, double u);

// Points in [0, 1)^axes, one a row. axes: 1 … kMostAxes.
using UnitPoints = std::vector<std::vector<double>>;

// The sequence of Sobol with the direction numbers of Joe and Kuo (2008, "new-joe-kuo-6.21201"), from its origin on. A
// seed other than 0 adds a random binary fraction to each axis, bit by bit without carry (Cranley and Patterson's
// shift for nets): what is even stays so.
UnitPoints sobol_points(std::size_t count, std::size_t axes, std::uint64_t seed);

// McKay, Beckman and Conover (1979): in each of `count` equal parts of each axis lies one point, anywhere in it.
UnitPoints latin_hypercube_points(std::size_t count, std::size_t axes, std::uint64_t seed);

}  // namespace pabd
