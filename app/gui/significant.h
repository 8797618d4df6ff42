// SPDX-License-Identifier: MIT
// Numbers as a hand means them: a slider's place has more digits than anybody wants to see.
#pragma once

namespace pabd {

// x to so many significant digits: the number nearest to that decimal, as if it had been written down and read
// again. Digits: 1 to 15; |x| from 1e-15 to 1e20, else the last bit may differ.
double significant(double x, int digits);

}  // namespace pabd
