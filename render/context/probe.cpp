// SPDX-License-Identifier: MIT
// See probe.h. The child names each candidate before it tries it, so that the last name is of the one that
// crashed; then another child tries the rest. A line for a name, a line for its failure.
#include "render/context/probe.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <map>

#include "sim/base/child_process.h"
#include "sim/base/descriptor.h"
#include "sim/base/utf8.h"

namespace pabd {
namespace {

constexpr double kPatience = 30;  // s
constexpr int kMostChildren = 32;
constexpr const char* kListed = "listed";  // in place of a failure, for a family
constexpr const char* kSkipped = "skipped";

void say(int fd, const std::string& text) {
  const std::string line = one_line(text) + "\n";
  static_cast<void>(write_all(fd, line.data(), line.size()));
}

}  // namespace

void try_contexts(const std::vector<ContextFamily>& families, const std::vector<std::string>& skip) {
  // Started by posix_spawn: to fork a process with threads would copy locks that drivers hold in it.
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL})
    ::signal(signal, SIG_DFL);
  const rlimit no_core = {0, 0};
  ::setrlimit(RLIMIT_CORE, &no_core);
  // What drivers print comes once, from the process that keeps the context.
  const int out = ::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 3);
  const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  for (const int standard : {STDOUT_FILENO, STDERR_FILENO}) ::dup2(nowhere, standard);
  const auto skipped = [&](const std::string& name) {
    return std::find(skip.begin(), skip.end(), one_line(name)) != skip.end();
  };
  for (const ContextFamily& family : families) {
    say(out, family.name);
    std::vector<ContextCandidate> list;
    if (!skipped(family.name)) family.add(list);
    say(out, skipped(family.name) ? kSkipped : kListed);
    for (const ContextCandidate& candidate : list) {
      say(out, candidate.name);
      std::string failure = kSkipped;
      // Not destroyed: the process ends at once, and a driver may crash at that, too.
      const bool made = !skipped(candidate.name) && candidate.create(failure).release() != nullptr;
      say(out, made ? "" : failure);
      if (made) ::_exit(0);
    }
  }
  ::_exit(0);
}

std::vector<ContextAttempt> probe_contexts(const std::vector<std::string>& command) {
  std::map<std::string, std::string> known;  // why one is skipped
  if (command.empty()) return {};
  for (int child = 0; child < kMostChildren; ++child) {
    std::vector<std::string> arguments = command, said;
    for (const auto& [name, failure] : known) arguments.push_back(name);
    const ChildOutcome outcome =
        run_child(arguments, kPatience, [&](std::string_view line) { said.emplace_back(line); });
    if (said.empty()) return {};  // it did not start, or is another program
    if (said.size() % 2 == 0) {
      std::vector<ContextAttempt> attempts;
      for (std::size_t i = 0; i < said.size(); i += 2) {
        const std::string& failure = said[i + 1];
        if (failure != kListed) attempts.push_back({said[i], failure == kSkipped ? known[said[i]] : failure});
      }
      return attempts;
    }
    known[said.back()] = outcome.too_slow ? fmt::format("the driver did not answer within {:g} s", kPatience)
                         : outcome.signal > 0 ? fmt::format("the driver crashed (signal {})", outcome.signal)
                                              : "the driver ended the process";
  }
  return {};
}

}  // namespace pabd
