// SPDX-License-Identifier: MIT
// See samples.h.
#include "app/sweep/samples.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/random/sobol.hpp>
#include <charconv>
#include <cmath>
#include <numeric>
#include <utility>

#include "sim/scene/random.h"

namespace pabd {
namespace {

// Of one axis; axes must not share their numbers.
Random stream(std::uint64_t seed, std::size_t axis) { return Random(mixed(seed) ^ mixed(axis + 1)); }

double between(const NumberRange& range, double u) {
  if (range.log) return range.from * std::pow(range.to / range.from, u);
  return range.from + (range.to - range.from) * u;
}

}  // namespace

double rounded(double x) {
  const std::string text = fmt::format("{:.11e}", x);
  double out = x;
  std::from_chars(text.data(), text.data() + text.size(), out);
  return out;
}

std::vector<double> spaced(const NumberRange& range, std::size_t count) {
  std::vector<double> out(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double u = count > 1 ? static_cast<double>(i) / static_cast<double>(count - 1) : 0;
    const double x = i > 0 && i + 1 == count ? range.to : between(range, u);
    out[i] = range.whole ? std::round(x) : rounded(x);
  }
  return out;
}

double at_part(const NumberRange& range, double u) {
  if (!range.whole) return rounded(between(range, u));
  const double lo = std::min(range.from, range.to), hi = std::max(range.from, range.to);
  // Of equal factors the parts begin and end between the numbers, too.
  if (range.log) return std::clamp(std::floor(between({lo, hi + 1, true, true}, u)), lo, hi);
  return std::clamp(lo + std::floor(u * (hi - lo + 1)), lo, hi);
}

UnitPoints sobol_points(std::size_t count, std::size_t axes, std::uint64_t seed) {
  std::vector<std::uint64_t> shift(axes, 0);
  for (std::size_t k = 0; seed != 0 && k < axes; ++k) shift[k] = stream(seed, k).bits();
  UnitPoints points(count, std::vector<double>(axes));
  boost::random::sobol sequence(axes);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < axes; ++k) {
      const std::uint64_t bits = i == 0 ? 0 : sequence();  // Boost leaves out the origin
      points[i][k] = static_cast<double>((bits ^ shift[k]) >> 11) * 0x1p-53;
    }
  }
  return points;
}

UnitPoints latin_hypercube_points(std::size_t count, std::size_t axes, std::uint64_t seed) {
  UnitPoints points(count, std::vector<double>(axes));
  std::vector<std::size_t> parts(count);
  for (std::size_t k = 0; k < axes; ++k) {
    Random random = stream(seed, k);
    std::iota(parts.begin(), parts.end(), std::size_t{0});
    for (std::size_t i = count; i-- > 1;) {  // Fisher and Yates
      const auto j = static_cast<std::size_t>(random.uniform() * static_cast<double>(i + 1));
      std::swap(parts[i], parts[j]);
    }
    for (std::size_t i = 0; i < count; ++i) {
      const double u = (static_cast<double>(parts[i]) + random.uniform()) / static_cast<double>(count);
      points[i][k] = std::min(u, 1 - 0x1p-53);
    }
  }
  return points;
}

}  // namespace pabd
