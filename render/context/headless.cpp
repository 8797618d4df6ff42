// The one place that knows every headless candidate and their order.
#include <fmt/format.h>

#include <cstdlib>
#include <mutex>

#include "render/context/candidate.h"
#include "sim/error.h"

namespace pabd {
namespace {

constexpr unsigned kGlMajorVersion = 0x821B;
constexpr unsigned kGlMinorVersion = 0x821C;

std::vector<ContextCandidate> candidates(Backend backend) {
  fix_vector_width();
  std::vector<ContextCandidate> list;
  if (backend != Backend::osmesa) add_egl_candidates(list);
  if (backend != Backend::egl) add_osmesa_candidates(list);
  return list;
}

std::string explain(const std::vector<ContextAttempt>& attempts) {
  std::string text = fmt::format("no OpenGL {}.{} core context could be made:", kGlMajor, kGlMinor);
  for (const ContextAttempt& attempt : attempts)
    text += fmt::format(" {}: {};", attempt.name, attempt.failure);
  text +=
      " install a software renderer with 'apt-get install libegl1 libgl1-mesa-dri libosmesa6', or start the "
      "container "
      "with 'docker run --gpus all -e NVIDIA_DRIVER_CAPABILITIES=graphics' to use an NVIDIA GPU";
  return text;
}

}  // namespace

void fix_vector_width() {
  static std::once_flag once;
  std::call_once(once, [] { ::setenv("LP_NATIVE_VECTOR_WIDTH", "128", 0); });
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

std::unique_ptr<GlContext> create_headless_context(Backend backend, std::vector<ContextAttempt>& attempts) {
  attempts.clear();
  for (const ContextCandidate& candidate : candidates(backend)) {
    std::string failure;
    auto context = candidate.create(failure);
    attempts.push_back({candidate.name, failure});
    if (context) return context;
  }
  throw Error(ExitCode::no_gl, explain(attempts));
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
