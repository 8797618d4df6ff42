// SPDX-License-Identifier: MIT
// What the targets share: each defines `fuzz`, which libFuzzer calls with bytes of its making.
//
// A reader may take them or throw the project's error: in one line, in UTF-8 without control characters, with
// the code of a bad input. Whatever else happens ends the run: another exception, a sanitizer, a property
// that does not hold.
#pragma once

#include <string>
#include <string_view>

#include "sim/base/error.h"

namespace pabd::fuzz {

// Ends the program, so that the input is kept, unless `holds`.
void require(bool holds, const char* property);

// Of an error that a reader threw.
void check_error(const Error& error);

// Calls `read` and checks how it refuses. False when it did.
template <class Read>
bool accepts(const Read& read) {
  try {
    read();
    return true;
  } catch (const Error& error) {
    check_error(error);
    return false;
  }
}

}  // namespace pabd::fuzz

// Of each target.
void fuzz(std::string_view bytes);
