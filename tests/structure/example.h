// SPDX-License-Identifier: MIT
// A header with one name, for the test of names that others hide.
#pragma once

namespace example {

constexpr double kPlainLimit = 3;

}  // namespace example
