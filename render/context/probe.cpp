// SPDX-License-Identifier: MIT
// See probe.h. The child tells of each candidate before it tries it, so that the last one told of is the one
// that crashed; then another child tries the rest.
#include "render/context/probe.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <map>

#include "sim/base/descriptor.h"

namespace pabd {
namespace {

using Verdicts = std::map<std::string, std::string>;  // of candidates and families that need no trying

constexpr double kPatience = 30;  // s
constexpr int kMostChildren = 32;

void tell(int fd, const std::string& text) {
  static_cast<void>(write_all(fd, text.c_str(), text.size() + 1));
}

// Every name is followed by its failure; the first that is empty is the last.
void try_all(const std::vector<ContextFamily>& families, const Verdicts& known, int fd) {
  for (const ContextFamily& family : families) {
    tell(fd, family.name);
    if (const auto verdict = known.find(family.name); verdict != known.end()) {
      tell(fd, verdict->second);
      continue;
    }
    std::vector<ContextCandidate> list;
    family.add(list);
    tell(fd, "listed");
    for (const ContextCandidate& candidate : list) {
      tell(fd, candidate.name);
      std::string failure;
      if (const auto verdict = known.find(candidate.name); verdict != known.end()) {
        failure = verdict->second;
      } else {
        // Not destroyed: the process ends at once, and a driver may crash at that, too.
        if (candidate.create(failure).release() != nullptr) failure.clear();
      }
      tell(fd, failure);
      if (failure.empty()) return;
    }
  }
}

[[noreturn]] void be_child(const std::vector<ContextFamily>& families, const Verdicts& known, int fd) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL})
    ::signal(signal, SIG_DFL);
  const rlimit no_core = {0, 0};
  ::setrlimit(RLIMIT_CORE, &no_core);
  // What drivers say comes once, from the process that keeps the context.
  const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  for (const int standard : {STDOUT_FILENO, STDERR_FILENO}) ::dup2(nowhere, standard);
  try {
    try_all(families, known, fd);
  } catch (...) {
    ::_exit(1);
  }
  ::_exit(0);
}

// What the child says until it ends. False when it says nothing for too long.
bool hear(int fd, std::string& said) {
  using Clock = std::chrono::steady_clock;
  std::array<char, 4096> part;
  for (auto heard = Clock::now();;) {
    pollfd source = {fd, POLLIN, 0};
    const int ready = ::poll(&source, 1, 100);
    if (std::chrono::duration<double>(Clock::now() - heard).count() > kPatience) return false;
    if (ready <= 0) continue;
    const ssize_t n = read_some(fd, part.data(), part.size());
    if (n <= 0) return true;
    said.append(part.data(), static_cast<std::size_t>(n));
    heard = Clock::now();
  }
}

std::vector<std::string> words_of(const std::string& said) {
  std::vector<std::string> words;
  std::size_t begin = 0;
  for (std::size_t end; (end = said.find('\0', begin)) != std::string::npos; begin = end + 1)
    words.push_back(said.substr(begin, end - begin));
  return words;
}

}  // namespace

std::vector<ContextAttempt> probe_contexts(const std::vector<ContextFamily>& families) {
  Verdicts known;
  for (int child = 0; child < kMostChildren; ++child) {
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) return {};
    const Descriptor read_end(ends[0]);
    Descriptor write_end(ends[1]);
    const pid_t pid = ::fork();
    if (pid < 0) return {};
    if (pid == 0) be_child(families, known, write_end.get());
    write_end.close();
    std::string said;
    const bool answered = hear(read_end.get(), said);
    if (!answered) ::kill(pid, SIGKILL);
    int status = 0;
    while (::waitpid(pid, &status, 0) < 0 && errno == EINTR) {
    }
    const std::vector<std::string> words = words_of(said);
    if (words.size() % 2 == 0) {
      std::vector<ContextAttempt> attempts;
      for (std::size_t i = 0; i + 1 < words.size(); i += 2)
        if (words[i + 1] != "listed") attempts.push_back({words[i], words[i + 1]});
      return attempts;
    }
    known[words.back()] = !answered ? fmt::format("the driver did not answer within {:g} s", kPatience)
                          : WIFSIGNALED(status)
                              ? fmt::format("the driver crashed (signal {})", WTERMSIG(status))
                              : "the driver ended the process";
  }
  return {};
}

}  // namespace pabd
