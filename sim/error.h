// The one exception of the project. Thrown only at boundaries (files, GL context, encoder), never for
// physics.
#pragma once

#include <stdexcept>
#include <string>

#include "sim/base/utf8.h"

namespace pabd {

enum class ExitCode : int {
  done = 0,
  defect = 1,
  bad_input = 2,
  file = 3,
  no_gl = 4,
  diverged = 5,
  encoder = 6,
  images_differ = 7,
};

// what(): one line with the place (file, JSON pointer or line), what was expected, and the remedy. Text of
// inputs in it is escaped here, for every message alike: wherever it is shown, it does nothing but be read.
class Error : public std::runtime_error {
 public:
  Error(ExitCode code, const std::string& message) : std::runtime_error(one_line(message)), code_(code) {}
  ExitCode code() const { return code_; }

 private:
  ExitCode code_;
};

}  // namespace pabd
