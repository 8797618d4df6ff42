// SPDX-License-Identifier: MIT
// Text to standard output, standard error and files; every write is checked.
#pragma once

#include <filesystem>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "sim/base/atomic_file.h"
#include "sim/base/output_path.h"

namespace pabd::cli {

// Throws Error(file) when standard output does not take it all (disk full, reader gone).
void write_stdout(std::string_view text);
// Failures are ignored: there is nowhere left to report them.
void write_stderr(std::string_view text);
// A line with text that may come from an input.
void write_note(std::string_view text);
// A document, indented; text in it that is no UTF-8 is replaced.
std::string json_text(const nlohmann::ordered_json& document);
bool stderr_is_terminal();
bool stdout_is_terminal();

// A text output named by the user: a file that appears when it is whole, or "-" for standard output.
class TextOutput {
 public:
  // `option` names it in messages. Throws Error(bad_input) if the file exists and not `force`, or is one of
  // `inputs`, Error(file) if it cannot be made: before the work that it is to record.
  TextOutput(const std::string& option, const std::string& path, bool force, const InputFiles& inputs = {});

  void write(std::string_view text);  // throws Error(file)
  void finish();                      // publishes; throws Error(file)

 private:
  std::unique_ptr<AtomicFile> file_;  // null: standard output
};

}  // namespace pabd::cli
