// SPDX-License-Identifier: MIT
// Maximum and minimum that are NaN where one of the two is: std::max(x, NaN) is x, which hides a failure.
#pragma once

#include <cmath>

namespace pabd {

inline double larger(double a, double b) { return a < b || std::isnan(b) ? b : a; }
inline double smaller(double a, double b) { return b < a || std::isnan(b) ? b : a; }

}  // namespace pabd
