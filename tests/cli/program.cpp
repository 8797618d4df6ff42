// SPDX-License-Identifier: MIT
// Running the program under test.
#include "tests/cli/program.h"
#include "tests/support/places.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>

namespace fs = std::filesystem;

namespace pabd::test {

struct Child {
  pid_t pid = -1;
  std::string out_file, err_file;
};

namespace {

[[noreturn]] void become(const std::vector<std::string>& command, const Setting& setting,
                         const Child& files) {
  const auto redirect = [](const std::string& file, int target) {
    const int fd = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    if (fd < 0 || ::dup2(fd, target) < 0) ::_exit(120);
  };
  redirect(setting.out_to.empty() ? files.out_file : setting.out_to, STDOUT_FILENO);
  redirect(files.err_file, STDERR_FILENO);
  if (!setting.folder.empty() && ::chdir(setting.folder.c_str()) != 0) ::_exit(121);
  for (const auto& [key, value] : setting.environment) ::setenv(key.c_str(), value.c_str(), 1);
  if (setting.largest_file >= 0) {
    const rlimit limit{static_cast<rlim_t>(setting.largest_file), static_cast<rlim_t>(setting.largest_file)};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  if (setting.most_memory >= 0) {
    const rlimit limit{static_cast<rlim_t>(setting.most_memory), static_cast<rlim_t>(setting.most_memory)};
    ::setrlimit(RLIMIT_AS, &limit);
  }
  const rlimit no_core{0, 0};  // a crash that is wanted leaves no dump
  ::setrlimit(RLIMIT_CORE, &no_core);
  // As a person starts it, however the tests were started.
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE}) ::signal(number, SIG_DFL);
  std::vector<char*> argv;
  for (const std::string& argument : command) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  ::execvp(argv[0], argv.data());
  ::_exit(122);
}

Child start(const CommandFolder& folder, const std::vector<std::string>& command, const Setting& setting) {
  Child child;
  child.out_file = folder / "out";
  child.err_file = folder / "err";
  child.pid = ::fork();
  REQUIRE(child.pid >= 0);
  if (child.pid == 0) become(command, setting, child);
  return child;
}

Outcome wait_for(const Child& child, const Setting& setting) {
  int status = 0;
  while (::waitpid(child.pid, &status, 0) < 0) REQUIRE(errno == EINTR);
  Outcome outcome;
  outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  if (setting.out_to.empty()) outcome.out = read_text(child.out_file);
  outcome.err = read_text(child.err_file);
  return outcome;
}

std::vector<std::string> with_program(const std::vector<std::string>& arguments) {
  std::vector<std::string> command{places::program()};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return command;
}

}  // namespace

Outcome run_pabd(const std::vector<std::string>& arguments, const Setting& setting) {
  const CommandFolder folder;
  return wait_for(start(folder, with_program(arguments), setting), setting);
}

Outcome run_shell(const std::string& line, const Setting& setting) {
  const CommandFolder folder;
  return wait_for(start(folder, {"/bin/sh", "-c", line}, setting), setting);
}

Outcome run_command(const std::vector<std::string>& command, const Setting& setting) {
  const CommandFolder folder;
  return wait_for(start(folder, command, setting), setting);
}

struct RunningPabd::Impl {
  CommandFolder folder;
  Setting setting;
  Child child;
};

RunningPabd::RunningPabd(const std::vector<std::string>& arguments, const Setting& setting)
    : impl_(new Impl) {
  impl_->setting = setting;
  impl_->child = start(impl_->folder, with_program(arguments), setting);
}

RunningPabd::~RunningPabd() {
  if (impl_->child.pid < 0) return;
  ::kill(impl_->child.pid, SIGKILL);
  ::waitpid(impl_->child.pid, nullptr, 0);
}

void RunningPabd::wait_until(const std::function<bool(const std::string& err)>& ready) {
  bool is_ready = false;
  for (int i = 0; i < 12000 && !is_ready; ++i) {
    is_ready = fs::exists(impl_->child.err_file) && ready(read_text(impl_->child.err_file));
    if (!is_ready) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  INFO(read_text(impl_->child.err_file));
  REQUIRE(is_ready);
}

void RunningPabd::signal(int number) { ::kill(impl_->child.pid, number); }

Outcome RunningPabd::wait() {
  const Outcome outcome = wait_for(impl_->child, impl_->setting);
  impl_->child.pid = -1;
  return outcome;
}

Outcome run_pabd_interrupted(const std::vector<std::string>& arguments, int signal,
                             const std::function<bool(const std::string& err)>& ready, int times) {
  RunningPabd program(arguments);
  program.wait_until(ready);
  for (int i = 0; i < times; ++i) {
    program.signal(signal);
    // Two signals that wait at the same time count as one.
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return program.wait();
}

CommandFolder::CommandFolder() {
  std::string name = (fs::temp_directory_path() / "pabd test XXXXXX").string();
  REQUIRE(::mkdtemp(name.data()) != nullptr);
  path_ = name;
}

CommandFolder::~CommandFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

std::vector<std::string> CommandFolder::names() const {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(path_)) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::vector<double> column_of(const std::string& csv, const std::string& name) {
  std::vector<double> out;
  std::ptrdiff_t at = -1;
  for (const std::string& row : lines_of(csv)) {
    std::vector<std::string> cells;
    std::istringstream in(row);
    for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
    if (at >= 0) {
      out.push_back(std::stod(cells.at(static_cast<std::size_t>(at))));
      continue;
    }
    at = std::find(cells.begin(), cells.end(), name) - cells.begin();
  }
  return out;
}

std::size_t line_count(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

bool is_error_line(const std::string& err, const std::vector<std::string>& words) {
  if (!err.starts_with("pabd: error: ") || line_count(err) != 1 || err.back() != '\n') return false;
  return std::all_of(words.begin(), words.end(),
                     [&](const std::string& word) { return err.find(word) != err.npos; });
}

std::string small_scene(const std::string& body, const std::string& contact, const std::string& top) {
  return R"({ "format": "pabd-scene", "version": 1, "name": "small",
  )" + top +
         R"(
  "contact": { )" +
         contact + R"( },
  "bodies": [
    { "name": "ground", "shape": { "type": "plane", "normal": [0, 1, 0], "offset": 0 }, "fixed": true },
    { "name": "crate", )" +
         (body.empty() ? R"("shape": { "type": "box", "size": [1, 1, 1] })" : body) + R"(,
      "position": [0, 0.51, 0] } ] })";
}

std::string probe_video(const std::string& file) {
  const CommandFolder folder;
  const std::vector<std::string> command = {"ffprobe",
                                            "-v",
                                            "error",
                                            "-count_frames",
                                            "-select_streams",
                                            "v:0",
                                            "-show_entries",
                                            "stream=width,height,nb_read_frames",
                                            "-of",
                                            "csv=p=0",
                                            file};
  const Outcome outcome = wait_for(start(folder, command, {}), {});
  CAPTURE(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  return lines_of(outcome.out).at(0);
}

}  // namespace pabd::test
