// Asking the machine.
#include "app/cli/machine.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <fstream>
#include <memory>
#include <sstream>
#include <string_view>
#include <thread>

#include "render/gl/renderer.h"
#include "sim/error.h"

namespace pabd::cli {
namespace {

// The value of "key : value" in a file of /proc; empty when absent.
std::string proc_value(const char* file, std::string_view key) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    const auto colon = line.find(':');
    if (colon == std::string::npos || !line.starts_with(key)) continue;
    const auto start = line.find_first_not_of(" \t", colon + 1);
    return start == std::string::npos ? "" : line.substr(start);
  }
  return "";
}

std::string read_all(int fd) {
  std::string text;
  std::array<char, 4096> buffer;
  while (true) {
    const ssize_t got = ::read(fd, buffer.data(), buffer.size());
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return text;
    text.append(buffer.data(), static_cast<std::size_t>(got));
  }
}

}  // namespace

std::string capture(const std::vector<std::string>& arguments) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) return "";
  std::vector<char*> argv;
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  pid_t child = -1;
  const int failure = ::posix_spawnp(&child, argv[0], &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  ::close(ends[1]);
  std::string text;
  if (failure == 0) text = read_all(ends[0]);
  ::close(ends[0]);
  if (failure != 0) return "";
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? text : "";
}

GlFacts find_gl() {
  GlFacts facts;
  try {
    const auto context = create_headless_context(Backend::automatic, facts.attempts);
    context->make_current();
    facts.context = context->name();
    const Renderer renderer(*context, 64, 64);
    facts.renderer = renderer.gl_renderer();
    facts.version = renderer.gl_version();
  } catch (const Error& error) {
    if (facts.attempts.empty() || !facts.context.empty())
      facts.attempts.push_back({facts.context, error.what()});
    facts.context.clear();
  }
  return facts;
}

FfmpegFacts find_ffmpeg() {
  FfmpegFacts facts;
  const std::string banner = capture({"ffmpeg", "-hide_banner", "-version"});
  facts.found = !banner.empty();
  if (!facts.found) return facts;
  std::istringstream words(banner);  // "ffmpeg version 5.1.6-0+deb12u1 Copyright …"
  std::string word;
  words >> word >> word >> facts.version;
  const std::string encoders = capture({"ffmpeg", "-hide_banner", "-encoders"});
  facts.h264 = encoders.find(" libx264 ") != std::string::npos;
  facts.vp9 = encoders.find(" libvpx-vp9 ") != std::string::npos;
  return facts;
}

CpuFacts find_cpu() {
  CpuFacts facts;
  facts.model = proc_value("/proc/cpuinfo", "model name");
  facts.cores = std::thread::hardware_concurrency();
  const std::string flags = fmt::format(" {} ", proc_value("/proc/cpuinfo", "flags"));
  facts.simd = "baseline";
  for (const auto& [flag, name] :
       {std::pair{" avx512f ", "AVX-512"}, {" avx2 ", "AVX2"}, {" avx ", "AVX"}, {" sse4_2 ", "SSE4.2"}}) {
    if (flags.find(flag) != std::string::npos) {
      facts.simd = name;
      break;
    }
  }
  std::istringstream memory(proc_value("/proc/meminfo", "MemTotal"));
  double kib = 0;
  memory >> kib;
  facts.memory_gib = kib / (1024 * 1024);
  return facts;
}

}  // namespace pabd::cli
