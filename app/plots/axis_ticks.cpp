// SPDX-License-Identifier: MIT
// Ranges, ticks and number formats of axes.
#include "app/plots/axis_ticks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pabd {
namespace {

constexpr const char* kMinus = "−";

// Replaces the hyphen of a formatted number by a true minus sign; "-0" becomes "0".
std::string with_minus(std::string text) {
  if (text.empty() || text[0] != '-') return text;
  if (text.find_first_of("123456789") == std::string::npos) return text.substr(1);
  return kMinus + text.substr(1);
}

double power10(int exponent) { return std::pow(10.0, exponent); }

int floor_log10(double v) { return static_cast<int>(std::floor(std::log10(v) + 1e-9)); }

// Smallest of 1, 2, 5 × 10^k that gives at most `max_major` intervals over `span`.
double nice_step(double span, int max_major, bool integer) {
  const double raw = span / std::max(1, max_major);
  const double decade = power10(floor_log10(raw));
  double step = 10 * decade;
  for (const double m : {1.0, 2.0, 5.0}) {
    if (m * decade >= raw * (1 - 1e-9)) {
      step = m * decade;
      break;
    }
  }
  return integer ? std::max(1.0, step) : step;
}

void linear_ticks(AxisScale& axis, int max_major, bool integer) {
  const double span = axis.hi - axis.lo;
  double step = nice_step(span, max_major, integer);
  // One label says nothing about the scale: rather a crowded axis.
  for (int more = max_major + 1; more <= 6 && std::floor(axis.hi / step) - std::ceil(axis.lo / step) < 1;
       ++more) {
    step = nice_step(span, more, integer);
  }
  const double largest = std::max(std::abs(axis.lo), std::abs(axis.hi));
  // Engineering factor: very large and very small labels are written in multiples of 10³ⁿ.
  int exponent = 0;
  if (largest >= 2e4 || largest < 2e-3)
    exponent = 3 * static_cast<int>(std::floor(floor_log10(largest) / 3.0));
  if (exponent != 0) axis.factor = "×" + power_of_ten(exponent);
  const int decimals = std::clamp(exponent - floor_log10(step), 0, 15);
  const double first = std::ceil(axis.lo / step - 1e-6);
  const double last = std::floor(axis.hi / step + 1e-6);
  // A range that is tiny beside its distance from 0 cannot be stepped through in double precision.
  if (!(last - first < 1000)) return;
  for (double k = first; k <= last; ++k) {
    const double value = k * step;
    const std::string label =
        k == 0 ? "0" : with_minus(fmt::format("{:.{}f}", value / power10(exponent), decimals));
    axis.ticks.push_back({value, label, true});
  }
}

void log_ticks(AxisScale& axis, int max_major) {
  const double lo = std::log10(axis.lo), hi = std::log10(axis.hi);
  const int first = static_cast<int>(std::floor(lo + 1e-9)), last = static_cast<int>(std::ceil(hi - 1e-9));
  const double decades = hi - lo;
  const auto inside = [&](double v) { return v >= axis.lo * (1 - 1e-9) && v <= axis.hi * (1 + 1e-9); };
  const int whole = static_cast<int>(std::floor(hi + 1e-9) - std::ceil(lo - 1e-9)) + 1;
  if (whole < 2) {  // less than two decades in sight: label 1, 2, 5, or give up on the log look
    for (int e = first; e <= last; ++e) {
      for (int m = 1; m < 10; ++m) {
        const double v = m * power10(e);
        if (!inside(v)) continue;
        const bool major = m == 1 || m == 2 || m == 5;
        axis.ticks.push_back({v, major ? format_value(v, 3) : std::string(), major});
      }
    }
    if (std::count_if(axis.ticks.begin(), axis.ticks.end(), [](const Tick& t) { return t.major; }) < 2) {
      axis.ticks.clear();
      linear_ticks(axis, max_major, false);
    }
    return;
  }
  const int stride = std::max(1, static_cast<int>(std::ceil(decades / std::max(1, max_major) - 1e-9)));
  for (int e = first; e <= last; ++e) {
    const bool major = ((e % stride) + stride) % stride == 0;
    if (inside(power10(e))) {
      axis.ticks.push_back({power10(e), major ? power_of_ten(e) : std::string(), major});
    }
    if (stride > 1) continue;
    for (int m = 2; m < 10; ++m) {
      if (inside(m * power10(e))) axis.ticks.push_back({m * power10(e), {}, false});
    }
  }
}

}  // namespace

double AxisScale::unit(double v) const {
  if (!std::isfinite(v) || (log && v <= 0)) return std::numeric_limits<double>::quiet_NaN();
  if (log) return (std::log10(v) - std::log10(lo)) / (std::log10(hi) - std::log10(lo));
  return (v - lo) / (hi - lo);
}

double AxisScale::value(double u) const {
  if (log) return std::pow(10.0, std::log10(lo) + u * (std::log10(hi) - std::log10(lo)));
  return lo + u * (hi - lo);
}

void DataRange::add(double v, bool log) {
  if (!std::isfinite(v) || (log && v <= 0)) return;
  lo = empty ? v : std::min(lo, v);
  hi = empty ? v : std::max(hi, v);
  empty = false;
}

AxisScale make_axis(double lo, double hi, bool log, int max_major, bool integer) {
  AxisScale axis;
  axis.lo = lo;
  axis.hi = hi;
  axis.log = log;
  if (log) {
    log_ticks(axis, max_major);
  } else {
    linear_ticks(axis, max_major, integer);
  }
  return axis;
}

AxisScale fit_axis(const Axis& axis, const DataRange& data, int max_major, double pad) {
  if (axis.lo < axis.hi && std::isfinite(axis.lo) && std::isfinite(axis.hi) && (!axis.log || axis.lo > 0)) {
    return make_axis(axis.lo, axis.hi, axis.log, max_major, axis.integer);
  }
  if (data.empty) return make_axis(axis.log ? 0.1 : 0, 1, axis.log, max_major, axis.integer);
  double lo = data.lo, hi = data.hi;
  if (axis.log) {
    double a = std::log10(lo), b = std::log10(hi);
    const double room = b - a > 1e-6 ? pad * (b - a) : 0.5;
    a = std::max(a - room, -307.0);
    b = std::min(b + room, 308.0);
    return make_axis(std::pow(10, a), std::pow(10, b), true, max_major);
  }
  const double largest = std::max(std::abs(lo), std::abs(hi));
  // All-equal (to rounding): show a tenth of the value around it.
  double span = std::max(hi - lo, axis.min_span);
  const double least = largest > 0 ? 1e-9 * largest : 0;
  if (!(span > least)) span = largest > 0 ? 0.2 * largest : 1;
  if (hi - lo < span) {
    // Data that touches 0 from above keeps its zero line at the bottom.
    if (lo >= 0 && lo < span * 1e-3) {
      hi = lo + span;
    } else {
      const double middle = lo + 0.5 * (hi - lo);
      lo = middle - 0.5 * span;
      hi = middle + 0.5 * span;
    }
  }
  const double room = pad * (hi - lo);
  lo = std::max(lo - room, -std::numeric_limits<double>::max() / 4);
  hi = std::min(hi + room, std::numeric_limits<double>::max() / 4);
  return make_axis(lo, hi, false, max_major, axis.integer);
}

std::string power_of_ten(int exponent) {
  if (exponent == 0) return "1";
  if (exponent == 1) return "10";
  constexpr const char* digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string out = "10";
  for (const char c : std::to_string(exponent)) out += c == '-' ? "⁻" : digits[c - '0'];
  return out;
}

std::string format_value(double v, int digits) {
  if (std::isnan(v)) return "not a number";
  if (std::isinf(v)) return v > 0 ? "∞" : "−∞";
  if (v == 0) return "0";
  // Round first so that 9.9996 counts as 10.
  const std::string scientific = fmt::format("{:.{}e}", v, std::max(0, digits - 1));
  const int exponent = std::stoi(scientific.substr(scientific.find('e') + 1));
  const auto trimmed = [](std::string text) {
    if (text.find('.') == std::string::npos) return text;
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text;
  };
  if (exponent >= -3 && exponent < 5) {
    return with_minus(trimmed(fmt::format("{:.{}f}", v, std::max(0, digits - 1 - exponent))));
  }
  const std::string mantissa = with_minus(trimmed(scientific.substr(0, scientific.find('e'))));
  if (mantissa == "1") return power_of_ten(exponent);
  return mantissa + "·" + power_of_ten(exponent);
}

}  // namespace pabd
