// SPDX-License-Identifier: MIT
// What becomes of what the program throws: one line on standard error, and an exit code.
#pragma once

#include <exception>
#include <string>

#include "sim/base/error.h"

namespace pabd::cli {

// Prints "pabd: error: …" and returns the exit code.
int report_error(ErrorKind kind, const std::string& message);
// The same for whatever was thrown. Out of memory and what the system refuses are no defects of the program.
int report_error(const std::exception_ptr& thrown);

}  // namespace pabd::cli
