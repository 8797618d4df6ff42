// SPDX-License-Identifier: MIT
// Runs the built program as a user would, and looks at what it leaves behind.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "tests/support/files.h"

namespace pabd::test {

struct Outcome {
  int exit_code = -1;  // 128 + signal when a signal ended it
  std::string out;
  std::string err;
};

struct Setting {
  std::map<std::string, std::string> environment;  // on top of the test's own
  std::filesystem::path folder;                    // working directory; empty: the test's
  std::string out_to;                              // standard output goes there; empty: captured
  long long largest_file = -1;                     // ulimit -f in bytes; -1: none
  long long most_memory = -1;                      // ulimit -v in bytes; -1: none
};

// Runs pabd to its end.
Outcome run_pabd(const std::vector<std::string>& arguments, const Setting& setting = {});

// Runs a line of a shell to its end.
Outcome run_shell(const std::string& line, const Setting& setting = {});
// The same for any program in PATH.
Outcome run_command(const std::vector<std::string>& command, const Setting& setting = {});

// pabd while it runs.
class RunningPabd {
 public:
  explicit RunningPabd(const std::vector<std::string>& arguments, const Setting& setting = {});
  ~RunningPabd();  // kills it if nobody waited for it

  // Fails the test if `ready` (given what it wrote to standard error so far) does not hold within a minute.
  void wait_until(const std::function<bool(const std::string& err)>& ready);
  void signal(int number);
  Outcome wait();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

// Runs pabd, sends `signal` (`times` in a row) as soon as `ready` (given what it wrote to standard error so
// far) holds, and waits. Fails the test if `ready` does not hold within a minute.
Outcome run_pabd_interrupted(const std::vector<std::string>& arguments, int signal,
                             const std::function<bool(const std::string& err)>& ready, int times = 1);

// A fresh folder with a space in its name, for command lines; goes away with the object.
class CommandFolder {
 public:
  CommandFolder();
  ~CommandFolder();
  CommandFolder(const CommandFolder&) = delete;
  CommandFolder& operator=(const CommandFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  // Names in it, sorted. Temporary files of an unfinished output would show up here.
  std::vector<std::string> names() const;

 private:
  std::filesystem::path path_;
};

inline std::string read_text(const std::filesystem::path& path) { return read_bytes(path); }
inline void write_text(const std::filesystem::path& path, const std::string& text) {
  write_bytes(path, text);
}
std::vector<std::string> lines_of(const std::string& text);
std::size_t line_count(const std::string& text);
std::vector<double> column_of(const std::string& csv, const std::string& name);  // numbers without quotes

// True when `err` is exactly one line that begins with "pabd: error: " and contains every word.
bool is_error_line(const std::string& err, const std::vector<std::string>& words);

// A small scene: a crate 1 cm above a plane. `body`, `contact`, `top` are JSON members that are put in.
std::string small_scene(const std::string& body = "", const std::string& contact = "",
                        const std::string& top = "");

// Width, height, frames of a video, from ffprobe.
std::string probe_video(const std::string& file);

}  // namespace pabd::test
