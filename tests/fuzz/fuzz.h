// SPDX-License-Identifier: MIT
// What the targets share. One program has them all: `fuzz --target=obj …`; libFuzzer calls the target with bytes of its making.
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

// A file of its own for each: PABD_FUZZ_TARGET(obj, bytes) { … }
struct Target {
  Target(const char* name, void (*run)(std::string_view));
};
#define PABD_FUZZ_TARGET(name, bytes)                                \
  static void fuzz_##name(std::string_view bytes);                   \
  static const pabd::fuzz::Target name##_target(#name, fuzz_##name); \
  static void fuzz_##name(std::string_view bytes)

}  // namespace pabd::fuzz
