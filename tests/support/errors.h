// SPDX-License-Identifier: MIT
// What an action throws, for checks of kind and text.
#pragma once

#include <optional>
#include <string>

#include "sim/base/error.h"

namespace pabd {

struct Caught {
  std::optional<ErrorKind> kind;  // empty: nothing was thrown
  std::string text;
  bool says(const std::string& part) const { return text.find(part) != std::string::npos; }
};

template <class Action>
Caught caught(Action action) {
  try {
    action();
  } catch (const Error& error) {
    return {error.kind(), error.what()};
  }
  return {};
}

inline constexpr ErrorKind bad_input = ErrorKind::bad_input;
inline constexpr ErrorKind exists = ErrorKind::exists;
inline constexpr ErrorKind file_error = ErrorKind::file;
inline constexpr ErrorKind encoder_error = ErrorKind::encoder;
inline constexpr ErrorKind defect = ErrorKind::defect;

}  // namespace pabd
