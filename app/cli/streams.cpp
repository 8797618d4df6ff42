// SPDX-License-Identifier: MIT
// Checked text output.
#include "app/cli/streams.h"

#include <fmt/format.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "sim/base/descriptor.h"
#include "sim/base/error.h"

namespace pabd::cli {
void write_stdout(std::string_view text) {
  const int reason = write_all(STDOUT_FILENO, text.data(), text.size());
  if (reason == 0) return;
  throw Error(ErrorKind::file,
              fmt::format("standard output: {}; write to a file with room, or keep the reader open",
                          system_reason(reason)));
}

void write_stderr(std::string_view text) {
  static_cast<void>(write_all(STDERR_FILENO, text.data(), text.size()));
}

void write_note(std::string_view text) { write_stderr(one_line(text) + "\n"); }

std::string json_text(const nlohmann::ordered_json& document) {
  return document.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

bool stderr_is_terminal() { return ::isatty(STDERR_FILENO) == 1; }

bool stdout_is_terminal() { return ::isatty(STDOUT_FILENO) == 1; }

TextOutput::TextOutput(const std::string& option, const std::string& path, bool force,
                       const InputFiles& inputs) {
  if (path == "-") return;
  check_overwrite(option + " " + path, path, {force, &inputs});
  file_ = std::make_unique<AtomicFile>(path);
}

void TextOutput::write(std::string_view text) {
  if (file_) {
    file_->write(text);
  } else {
    write_stdout(text);
  }
}

void TextOutput::finish() {
  if (file_) file_->commit();
}

}  // namespace pabd::cli
