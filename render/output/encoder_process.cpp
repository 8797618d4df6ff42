// The ffmpeg program, fed through a pipe.
#include "render/output/encoder_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>

#include "sim/error.h"

namespace pabd {
namespace {

constexpr std::size_t kept_messages = 4096;

struct Pipe {
  Descriptor read, write;
};

[[noreturn]] void fail_system(const std::string& name, int reason) {
  throw Error(ExitCode::encoder,
              fmt::format("{}: ffmpeg could not be started: {}", name, system_reason(reason)));
}

// Both ends above the standard three, so that placing them in the child cannot overwrite one with another.
Pipe open_pipe(const std::string& name) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) fail_system(name, errno);
  Descriptor low_read(ends[0]), low_write(ends[1]);
  Pipe pipe;
  pipe.read = Descriptor(::fcntl(low_read.get(), F_DUPFD_CLOEXEC, 3));
  pipe.write = Descriptor(::fcntl(low_write.get(), F_DUPFD_CLOEXEC, 3));
  if (pipe.read.get() < 0 || pipe.write.get() < 0) fail_system(name, errno);
  return pipe;
}

// Starts ffmpeg in its own process group with these descriptors as 0, 1 and 2. Returns 0 or errno.
int spawn(pid_t& pid, const std::vector<std::string>& arguments, const std::array<int, 3>& descriptors) {
  std::vector<char*> argv = {const_cast<char*>("ffmpeg")};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);

  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  for (int i = 0; i < 3; ++i)
    posix_spawn_file_actions_adddup2(&files, descriptors[static_cast<std::size_t>(i)], i);

  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes,
                           POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  posix_spawnattr_setpgroup(&attributes, 0);
  sigset_t signals;
  sigemptyset(&signals);
  posix_spawnattr_setsigmask(&attributes, &signals);
  for (int signal : {SIGPIPE, SIGINT, SIGTERM, SIGCHLD, SIGXFSZ}) sigaddset(&signals, signal);
  posix_spawnattr_setsigdefault(&attributes, &signals);

  const int reason = ::posix_spawnp(&pid, "ffmpeg", &files, &attributes, argv.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  return reason;
}

std::string one_line(std::string text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.pop_back();
  std::string line;
  for (char c : text) {
    if (c == '\n') {
      line += "; ";
    } else if (static_cast<unsigned char>(c) >= ' ') {
      line += c;
    }
  }
  return line;
}

}  // namespace

EncoderProcess::EncoderProcess(std::string name, const std::vector<std::string>& arguments)
    : name_(std::move(name)) {
  Pipe input = open_pipe(name_);
  Pipe progress = open_pipe(name_);
  Pipe messages = open_pipe(name_);
  const int reason = spawn(pid_, arguments, {input.read.get(), progress.write.get(), messages.write.get()});
  if (reason == ENOENT) {
    throw Error(ExitCode::encoder,
                fmt::format("{}: ffmpeg was not found in PATH; install it: apt-get install ffmpeg, "
                            "or write PNG files: frames/{{frame:04}}.png",
                            name_));
  }
  if (reason != 0) fail_system(name_, reason);
  // A frame should fit into few writes; being refused (a limit for users) only costs speed.
  ::fcntl(input.write.get(), F_SETPIPE_SZ, 1 << 20);
  input_ = std::move(input.write);
  progress_ = std::move(progress.read);
  messages_ = std::move(messages.read);
  listener_ = std::thread([this] { listen(); });
}

EncoderProcess::~EncoderProcess() {
  if (pid_ > 0 && !status_known_) {
    ::kill(-pid_, SIGKILL);
    wait_until_ended(true);
  }
  input_.close();
  if (listener_.joinable()) listener_.join();
}

// Empties both outputs of ffmpeg all the time: it would stop when one of them is full.
void EncoderProcess::listen() {
  std::array<char, 4096> text;
  std::array<pollfd, 2> sources = {{{progress_.get(), POLLIN, 0}, {messages_.get(), POLLIN, 0}}};
  while (sources[0].fd >= 0 || sources[1].fd >= 0) {
    if (::poll(sources.data(), sources.size(), -1) < 0) {
      if (errno == EINTR) continue;
      return;
    }
    for (std::size_t i = 0; i < sources.size(); ++i) {
      if (sources[i].fd < 0 || sources[i].revents == 0) continue;
      const ssize_t n = ::read(sources[i].fd, text.data(), text.size());
      if (n < 0 && (errno == EINTR || errno == EAGAIN)) continue;
      if (n <= 0) {
        sources[i].fd = -1;
      } else if (i == 0) {
        take_progress(text.data(), static_cast<std::size_t>(n));
      } else {
        take_messages(text.data(), static_cast<std::size_t>(n));
      }
    }
  }
}

void EncoderProcess::take_progress(const char* text, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) {
    if (text[i] != '\n') {
      if (progress_line_.size() < 256) progress_line_ += text[i];
      continue;
    }
    if (progress_line_.starts_with("frame=")) frames_ = std::strtol(progress_line_.c_str() + 6, nullptr, 10);
    progress_line_.clear();
  }
}

void EncoderProcess::take_messages(const char* text, std::size_t size) {
  tail_.append(text, size);
  if (tail_.size() > kept_messages) tail_.erase(0, tail_.size() - kept_messages);
}

bool EncoderProcess::wait_until_ended(bool forever) {
  using clock = std::chrono::steady_clock;
  const auto latest = clock::now() + std::chrono::seconds(2);
  while (true) {
    const pid_t ended = ::waitpid(pid_, &status_, forever ? 0 : WNOHANG);
    if (ended == pid_) {
      status_known_ = true;
      return true;
    }
    if (ended < 0 && errno == ECHILD) {  // somebody else in this program took the status
      status_known_ = true;
      status_ = -1;
      return true;
    }
    if (forever) continue;
    if (clock::now() > latest) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

void EncoderProcess::write(const void* data, std::size_t size) {
  const BlockSigpipe no_signal;
  const int reason = write_all(input_.get(), data, size);
  if (reason == 0) return;
  input_.close();
  if (!wait_until_ended(false)) {
    ::kill(-pid_, SIGKILL);
    wait_until_ended(true);
  }
  fail(reason == EPIPE ? "ffmpeg ended too early"
                       : fmt::format("ffmpeg took no frame: {}", system_reason(reason)));
}

long EncoderProcess::finish() {
  input_.close();
  wait_until_ended(true);
  if (listener_.joinable()) listener_.join();
  if (status_ != 0) fail("ffmpeg failed");
  return frames_;
}

void EncoderProcess::fail(const std::string& what) {
  if (listener_.joinable()) listener_.join();
  std::string end = "unknown status";
  if (status_ != -1 && WIFEXITED(status_)) end = fmt::format("status {}", WEXITSTATUS(status_));
  if (status_ != -1 && WIFSIGNALED(status_)) end = fmt::format("signal {}", WTERMSIG(status_));
  const std::string said = one_line(tail_);
  std::string remedy;
  if (said.find("Unknown encoder") != std::string::npos) {
    remedy = "; install a complete ffmpeg: apt-get install ffmpeg";
  } else if (said.find("No space left") != std::string::npos) {
    remedy = "; free some space or choose another disk";
  }
  throw Error(ExitCode::encoder, fmt::format("{}: {} ({}): {}{}", name_, what, end,
                                             said.empty() ? "it gave no reason" : said, remedy));
}

std::string ffmpeg_version() {
  try {
    Pipe output = open_pipe("ffmpeg");
    const Descriptor nowhere(::open("/dev/null", O_RDWR | O_CLOEXEC));
    pid_t pid = -1;
    if (spawn(pid, {"-version"}, {nowhere.get(), output.write.get(), nowhere.get()}) != 0) return "";
    output.write.close();
    std::string text;
    std::array<char, 1024> part;
    while (true) {
      const ssize_t n = ::read(output.read.get(), part.data(), part.size());
      if (n < 0 && errno == EINTR) continue;
      if (n <= 0) break;
      if (text.size() < kept_messages) text.append(part.data(), static_cast<std::size_t>(n));
    }
    while (::waitpid(pid, nullptr, 0) < 0 && errno == EINTR) {
    }
    return text.substr(0, text.find('\n'));
  } catch (const Error&) {
    return "";
  }
}

}  // namespace pabd
