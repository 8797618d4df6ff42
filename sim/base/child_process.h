// SPDX-License-Identifier: MIT
// Another program, started without a shell, in a process group of its own.
#pragma once

#include <poll.h>
#include <sys/types.h>

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/base/descriptor.h"
#include "sim/base/leftovers.h"

namespace pabd {

// Ctrl-C in a terminal does not reach it. When it ends, or is ended, all that it started ends too.
class ChildProcess {
 public:
  ChildProcess() = default;
  ~ChildProcess() { end(); }
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  // Starts arguments[0] from PATH. Returns 0 or errno. Once only.
  int start(const std::vector<std::string>& arguments);

  // Its standard input, output and error.
  Descriptor input, output, errors;

  bool has_ended();         // does not wait
  void end();               // kills it if it has not ended
  void signal(int number);  // sends it one, if it has not ended

  // How it ended: "status 3", "signal 9"; its exit status, −1 after a signal. Precondition: it has ended.
  std::string ending() const;
  int exit_status() const;
  int ending_signal() const;  // 0: it ended by itself

 private:
  pid_t pid_ = -1;
  int status_ = -1;  // of waitpid; −1: unknown
  bool ended_ = false;
  Leftover leftover_;
};

struct ChildOutcome {
  bool found = false;  // it could be started
  bool too_slow = false;
  int status = -1;
  int signal = 0;      // that ended it; 0: none did
  std::string errors;  // the last 4 KiB of its standard error
};

// Runs a program to its end, without input; `line` gets each line of its output, cut to 4 KiB. It is ended
// when it says nothing for `patience` seconds, or has not ended after `longest`.
ChildOutcome run_child(const std::vector<std::string>& arguments, double patience,
                       const std::function<void(std::string_view line)>& line, double longest = 1e9);

// The last so many bytes of what was appended.
class Tail {
 public:
  void append(const char* text, std::size_t size);
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

// Splits what arrives in parts into lines.
class LineSplitter {
 public:
  explicit LineSplitter(std::function<void(std::string_view)> line) : line_(std::move(line)) {}
  void append(const char* text, std::size_t size);
  void finish();  // the last line may have no end

 private:
  std::function<void(std::string_view)> line_;
  std::string begun_;
};

// Reads once from each of the two pipes that poll() found ready: `sources` begins with the standard output,
// whose bytes go to `output`, and the standard error, whose text goes to `tail`; fd −1 in it once an output
// has ended. False when neither said anything or ended.
bool read_pipes(std::span<pollfd> sources, const std::function<void(std::string_view bytes)>& output,
                Tail& tail);

}  // namespace pabd
