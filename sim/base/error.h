// SPDX-License-Identifier: MIT
// The one exception of the project. Thrown only at boundaries (files, GL context, encoder), never for
// physics.
#pragma once

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "sim/base/utf8.h"

namespace pabd {

// What went wrong, for whoever decides by it: the command line makes an exit code of it.
enum class ErrorKind {
  bad_input,      // what was given does not fit: a scene, a value, an option, an action
  exists,         // bad input, in that an output is there already and was not to be replaced
  file,           // a file cannot be read or written
  no_context,     // there is no GL context, or it cannot do what is needed
  diverged,       // the simulation is no longer finite
  encoder,        // the video encoder failed
  images_differ,  // pictures differ, or an expectation failed
  defect,         // of the program: a precondition does not hold
};

// what(): one line, "source: message", with the place (file, JSON pointer or line), what was expected, and the remedy. Text of
// inputs in it is escaped here, so that it is safe to show anywhere. Callers decide by kind() and source(), never by the text.
class Error : public std::runtime_error {
 public:
  Error(ErrorKind kind, const std::string& message) : std::runtime_error(one_line(message)), kind_(kind) {}
  // `source`: what the message is about, as its maker knows it: a file, an action of a script.
  Error(ErrorKind kind, std::string source, std::string_view message)
      : std::runtime_error(one_line(source + ": " + std::string(message))),
        kind_(kind),
        source_(std::move(source)),
        message_at_(one_line(source_ + ":").size() + 1) {}

  ErrorKind kind() const { return kind_; }
  // Empty when the message has none of its own.
  const std::string& source() const { return source_; }
  // what() without the source.
  std::string_view message() const {
    const std::string_view all = what();
    return all.substr(std::min(message_at_, all.size()));
  }

 private:
  ErrorKind kind_;
  std::string source_;
  std::size_t message_at_ = 0;
};

}  // namespace pabd
