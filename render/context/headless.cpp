// SPDX-License-Identifier: MIT
// The one place that knows every headless candidate and their order.
#include <fmt/format.h>
#include <malloc.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdlib>
#include <mutex>

#include "render/context/candidate.h"
#include "render/context/probe.h"
#include "sim/base/error.h"
#include "sim/base/input_file.h"

namespace pabd {
namespace {

constexpr unsigned kGlMajorVersion = 0x821B;
constexpr unsigned kGlMinorVersion = 0x821C;

std::vector<ContextFamily> families(Backend backend) {
  std::vector<ContextFamily> list;
  if (backend != Backend::osmesa) list.push_back({"EGL", add_egl_candidates});
  if (backend != Backend::egl) list.push_back({"OSMesa library", add_osmesa_candidates});
  return list;
}

std::vector<ContextCandidate> candidates(Backend backend) {
  prepare_software_gl();
  std::vector<ContextCandidate> list;
  for (const ContextFamily& family : families(backend)) family.add(list);
  return list;
}

// True once a context of `backend` was made in this process: its driver is loaded and has read its
// environment, and needs no proof again.
std::atomic<bool>& is_proven(Backend backend) {
  static std::array<std::atomic<bool>, 3> proven{};
  return proven[static_cast<std::size_t>(backend)];
}

// Mesa crashes where it finds no memory for its threads and shaders while it draws: better refused before.
void check_address_space() {
  constexpr std::size_t kNeeded = std::size_t{192} << 20;
  rlimit limit = {};
  if (::getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return;
  void* const room = ::mmap(nullptr, kNeeded, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (room != MAP_FAILED) {
    ::munmap(room, kNeeded);
    return;
  }
  // The first number of statm: pages in use.
  const double used = std::atof(read_if_possible("/proc/self/statm", 4096).c_str()) *
                      static_cast<double>(::sysconf(_SC_PAGESIZE));
  throw Error(
      ErrorKind::no_context,
      fmt::format(
          "the address space is limited to {} MB (ulimit -v), of which {:.0f} are in use, and {} more "
          "are needed to draw",
          limit.rlim_cur >> 20, used / (1 << 20), kNeeded >> 20));
}

std::vector<std::string>& trial_command() {
  static std::vector<std::string> command;
  return command;
}

std::vector<ContextAttempt> try_first(Backend backend) {
  std::vector<std::string> command = trial_command();
  if (!command.empty()) command.push_back(std::to_string(static_cast<int>(backend)));
  return probe_contexts(command);
}

bool crashed(const ContextFamily& family, const std::vector<ContextAttempt>& attempts) {
  return std::any_of(attempts.begin(), attempts.end(),
                     [&](const ContextAttempt& attempt) { return attempt.name == family.name; });
}

std::string explain(const std::vector<ContextAttempt>& attempts) {
  std::string text = fmt::format("no OpenGL {}.{} core context could be made:", kGlMajor, kGlMinor);
  for (const ContextAttempt& attempt : attempts)
    text += fmt::format(" {}: {};", attempt.name, attempt.failure);
  const std::string steered = steering_remedy();
  if (!steered.empty()) text += " " + steered + "; if that does not help,";
  text +=
      " install a software renderer with 'apt-get install libegl1 libgl1-mesa-dri libosmesa6', or start the "
      "container "
      "with 'docker run --gpus all -e NVIDIA_DRIVER_CAPABILITIES=graphics' to use an NVIDIA GPU";
  return text;
}

}  // namespace

void prepare_software_gl() {
  // As much as it takes and frees in a frame of many triangles. glibc gives freed memory back otherwise, to be mapped and
  // cleared again for the next frame: two thirds of the time of a picture with contacts and bonds.
  constexpr int kKept = 256 << 20, kAlone = 32 << 20;
  static std::once_flag once;
  std::call_once(once, [] {
    ::setenv("LP_NATIVE_VECTOR_WIDTH", "128", 0);
    ::mallopt(M_TRIM_THRESHOLD, kKept);
    ::mallopt(M_MMAP_THRESHOLD, kAlone);
  });
}

std::string steering_remedy() {
  static constexpr const char* steering[] = {"GALLIUM_DRIVER",
                                             "MESA_LOADER_DRIVER_OVERRIDE",
                                             "MESA_GL_VERSION_OVERRIDE",
                                             "MESA_GLSL_VERSION_OVERRIDE",
                                             "MESA_EXTENSION_OVERRIDE",
                                             "LIBGL_DRIVERS_PATH",
                                             "LIBGL_ALWAYS_SOFTWARE",
                                             "GALLIUM_OVERRIDE_CPU_CAPS",
                                             "EGL_PLATFORM",
                                             "__EGL_VENDOR_LIBRARY_FILENAMES",
                                             "__EGL_VENDOR_LIBRARY_DIRS",
                                             "__GLX_VENDOR_LIBRARY_NAME",
                                             "LD_LIBRARY_PATH",
                                             "LD_PRELOAD"};
  std::string names, values;
  for (const char* name : steering) {
    const char* value = std::getenv(name);
    if (value == nullptr || *value == '\0') continue;
    names += names.empty() ? name : std::string(" ") + name;
    values += fmt::format("{}{}={}", values.empty() ? "" : " ", name, value);
  }
  if (names.empty()) return {};
  return fmt::format("the environment chooses another driver ({}): try 'unset {}'", values, names);
}

std::string driver_remedy() {
  const std::string steered = steering_remedy();
  return steered.empty() ? "try another --backend" : steered;
}

std::string check_gl_version(GlContext& context) {
  using GetIntegerv = void (*)(unsigned, int*);
  const auto get_integer = reinterpret_cast<GetIntegerv>(context.proc_address("glGetIntegerv"));
  if (get_integer == nullptr) return "the driver has no glGetIntegerv";
  int major = 0, minor = 0;
  get_integer(kGlMajorVersion, &major);
  get_integer(kGlMinorVersion, &minor);
  if (major > kGlMajor || (major == kGlMajor && minor >= kGlMinor)) return {};
  return fmt::format("the driver offers OpenGL {}.{} only", major, minor);
}

void set_context_trial(std::vector<std::string> command) { trial_command() = std::move(command); }

void try_headless_contexts(const std::vector<std::string>& words) {
  prepare_software_gl();
  Backend backend = Backend::automatic;
  for (const Backend b : {Backend::egl, Backend::osmesa})
    if (!words.empty() && words.front() == std::to_string(static_cast<int>(b))) backend = b;
  try_contexts(families(backend), words);
}

std::unique_ptr<GlContext> create_headless_context(Backend backend, std::vector<ContextAttempt>& attempts) {
  prepare_software_gl();
  attempts.clear();
  if (!is_proven(backend)) attempts = try_first(backend);
  const bool probed = !attempts.empty();
  const bool hopeless = probed && !attempts.back().failure.empty();
  for (const ContextFamily& family : families(backend)) {
    if (hopeless || crashed(family, attempts)) continue;
    std::vector<ContextCandidate> list;
    family.add(list);
    for (const ContextCandidate& candidate : list) {
      if (probed && candidate.name != attempts.back().name) continue;
      if (!probed) attempts.push_back({candidate.name, ""});
      auto context = candidate.create(attempts.back().failure);
      if (context) {
        attempts.back().failure.clear();
        check_address_space();
        is_proven(backend) = true;
        return context;
      }
    }
  }
  throw Error(ErrorKind::no_context, explain(attempts));
}

std::vector<std::unique_ptr<GlContext>> create_every_headless_context(Backend backend,
                                                                      std::vector<ContextAttempt>& attempts) {
  attempts.clear();
  std::vector<std::unique_ptr<GlContext>> contexts;
  for (const ContextCandidate& candidate : candidates(backend)) {
    std::string failure;
    auto context = candidate.create(failure);
    attempts.push_back({candidate.name, failure});
    if (!context) continue;
    context->release();
    contexts.push_back(std::move(context));
  }
  return contexts;
}

}  // namespace pabd
