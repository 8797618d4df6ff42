// Checked text output.
#include "app/cli/streams.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <utility>

#include "sim/error.h"

namespace pabd::cli {
namespace {

// False with errno set when not all of it could be written.
bool write_all(int fd, std::string_view text) {
  while (!text.empty()) {
    const ssize_t done = ::write(fd, text.data(), text.size());
    if (done < 0 && errno == EINTR) continue;
    if (done <= 0) return false;
    text.remove_prefix(static_cast<std::size_t>(done));
  }
  return true;
}

}  // namespace

void write_stdout(std::string_view text) {
  if (write_all(STDOUT_FILENO, text)) return;
  throw Error(ExitCode::file,
              fmt::format("standard output: {}; write to a file with room, or keep the reader open",
                          std::strerror(errno)));
}

void write_stderr(std::string_view text) { static_cast<void>(write_all(STDERR_FILENO, text)); }

bool stderr_is_terminal() { return ::isatty(STDERR_FILENO) == 1; }

bool stdout_is_terminal() { return ::isatty(STDOUT_FILENO) == 1; }

std::string read_file(const std::filesystem::path& path) {
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (file) text << file.rdbuf();
  // An empty file sets failbit on `text` only; a directory opens and then cannot be read.
  if (!file || file.bad() || std::filesystem::is_directory(path)) {
    const char* reason =
        std::filesystem::is_directory(path) ? "is a directory" : std::strerror(errno ? errno : EIO);
    throw Error(ExitCode::file, fmt::format("{}: cannot be read ({})", path.string(), reason));
  }
  return text.str();
}

TextOutput::TextOutput(std::string option, const std::string& path, bool force) {
  if (path == "-") return;
  check_overwrite(option, path, force);
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

void check_overwrite(const std::string& option, const std::filesystem::path& path, bool force) {
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  if (std::filesystem::is_directory(status)) {
    throw Error(ExitCode::bad_input,
                fmt::format("{} {}: is a directory; name a file in it", option, path.string()));
  }
  // A device such as /dev/full is not overwritten, whatever is written to it.
  if (!force && std::filesystem::is_regular_file(status)) {
    throw Error(
        ExitCode::bad_input,
        fmt::format("{} {}: exists; --force overwrites it, or choose another name", option, path.string()));
  }
}

}  // namespace pabd::cli
