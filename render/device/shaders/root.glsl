// SPDX-License-Identifier: MIT
// Square roots to all digits: of a double, one driver's sqrt, length, normalize and inversesqrt are good to those of a
// float. A step of Newton's doubles the digits.
float root(float x) { return sqrt(x); }
double root(double x) {
  double y = sqrt(x);
  return y > 0 ? 0.5lf * (y + x / y) : y;
}
