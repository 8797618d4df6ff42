// SPDX-License-Identifier: MIT
// The map of values: a straight spiral in OKLab (Ottosson 2020), where distance is what the eye calls
// difference.
//
//   t          place in the map                                0 … 1
//   L          lightness, 0.44 + 0.45 t
//   C          chroma, constant: the largest that screens have along the whole way
//   h          hue, from violet blue (290°) over teal to yellow (100°)
//   a, b       C cos h, C sin h
#include "render/visual/value_map.h"

#include <algorithm>

#include "render/visual/palette.h"
#include "sim/math/types.h"

namespace pabd {
namespace {

constexpr double kDark = 0.44, kLight = 0.89;
constexpr double kChroma = 0.1;
constexpr double kFirstHue = 290, kLastHue = 100;  // degrees

double round_up(double x) {
  const double power = std::pow(10, std::floor(std::log10(x)));
  for (const double step : {1.0, 2.0, 5.0}) {
    if (x <= step * power * (1 + 1e-9)) return step * power;
  }
  return 10 * power;
}

}  // namespace

double ValueRange::place(double value) const {
  if (std::isnan(value)) return value;
  if (!(lo < hi) || (logarithmic && !(lo > 0))) return 0;
  const double inside = std::clamp(value, lo, hi);
  return logarithmic ? std::log(inside / lo) / std::log(hi / lo) : (inside - lo) / (hi - lo);
}

double ValueRange::value(double place) const {
  return logarithmic ? lo * std::pow(hi / lo, place) : lo + place * (hi - lo);
}

std::vector<double> ValueRange::places() const {
  const long decades = logarithmic ? std::lround(std::log10(hi / lo)) : 0;
  if (decades < 1 || decades > 3) return {0, 0.5, 1};
  std::vector<double> out;
  for (long k = 0; k <= decades; ++k) out.push_back(static_cast<double>(k) / static_cast<double>(decades));
  return out;
}

ValueRange round_range(double largest, double least, bool logarithmic, int decades) {
  const double hi = round_up(std::max(largest, least));
  return {logarithmic ? hi * std::pow(10, -decades) : 0, hi, logarithmic};
}

Vec4f value_color(double t) {
  if (std::isnan(t)) return no_value_color();
  t = std::clamp(t, 0.0, 1.0);
  const double L = kDark + (kLight - kDark) * t;
  const double h = (kFirstHue + (kLastHue - kFirstHue) * t) * kPi / 180;
  const double a = kChroma * std::cos(h), b = kChroma * std::sin(h);
  // OKLab to the cube roots of the cones' answers, and those to linear sRGB.
  Mat3 to_roots, to_rgb;
  to_roots << 1, 0.3963377774, 0.2158037573, 1, -0.1055613458, -0.0638541728, 1, -0.0894841775, -1.2914855480;
  to_rgb << 4.0767416621, -3.3077115913, 0.2309699292, -1.2684380046, 2.6097574011, -0.3413193965,
      -0.0041960863, -0.7034186147, 1.7076147010;
  const Vec3 rgb = to_rgb * (to_roots * Vec3(L, a, b)).array().cube().matrix();
  Vec4f color;
  color << rgb.cwiseMax(0).cwiseMin(1).cast<float>(), 1;
  return color;
}

Vec4f no_value_color() { return srgb_color(0x9a9a98); }

}  // namespace pabd
