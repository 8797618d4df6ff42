// What an action throws, for checks of code and text.
#pragma once

#include <string>

#include "sim/error.h"

namespace pabd {

struct Caught {
  int code = -1;  // -1: nothing was thrown
  std::string text;
  bool says(const std::string& part) const { return text.find(part) != std::string::npos; }
};

template <class Action>
Caught caught(Action action) {
  try {
    action();
  } catch (const Error& error) {
    return {static_cast<int>(error.code()), error.what()};
  }
  return {};
}

inline constexpr int bad_input = static_cast<int>(ExitCode::bad_input);
inline constexpr int file_error = static_cast<int>(ExitCode::file);
inline constexpr int encoder_error = static_cast<int>(ExitCode::encoder);
inline constexpr int defect = static_cast<int>(ExitCode::defect);

}  // namespace pabd
