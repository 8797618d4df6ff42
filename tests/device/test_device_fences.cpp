// SPDX-License-Identifier: MIT
// Fences of steps and questions that are under way go with those who asked.
#include <catch2/catch.hpp>

#include <cstring>

#include "render/device/compute_functions.h"
#include "render/device/device_solver.h"
#include "render/device/gl_fence.h"
#include "tests/device/device_scenes.h"
#include "tests/device/wrapped_context.h"

namespace pabd::test_device_fences {

using namespace testing;

namespace {

int made = 0, deleted = 0;
PFNGLFENCESYNCPROC make_fence = nullptr;
PFNGLDELETESYNCPROC delete_fence = nullptr;

// Counts them.
class CountingContext : public WrappedContext {
 public:
  explicit CountingContext(GlContext& inside) : WrappedContext(inside) { made = deleted = 0; }
  void* proc_address(const char* name) override {
    void* const inside = WrappedContext::proc_address(name);
    if (std::strcmp(name, "glFenceSync") == 0) {
      make_fence = reinterpret_cast<PFNGLFENCESYNCPROC>(inside);
      return reinterpret_cast<void*>(&count_made);
    }
    if (std::strcmp(name, "glDeleteSync") == 0) {
      delete_fence = reinterpret_cast<PFNGLDELETESYNCPROC>(inside);
      return reinterpret_cast<void*>(&count_deleted);
    }
    return inside;
  }

 private:
  static GLsync APIENTRY count_made(GLenum condition, GLbitfield flags) {
    ++made;
    return make_fence(condition, flags);
  }
  static void APIENTRY count_deleted(GLsync fence) {
    ++deleted;
    delete_fence(fence);
  }
};

}  // namespace

TEST_CASE("a solver that goes while steps are under way leaves no fence") {
  const auto context = any_context();
  CountingContext counting(*context);
  const Scene scene = mixed_heap(1);
  {
    DeviceSolver device(counting, scene.model, scene.initial);
    for (int k = 0; k < 3; ++k) device.enqueue(scene.params);
    CHECK(made > deleted);
  }
  CHECK(made >= 3);
  CHECK(deleted == made);
}

TEST_CASE("a fence is deleted once, wherever it was moved") {
  const auto context = any_context();
  CountingContext counting(*context);
  const ComputeFunctions gl(counting);
  {
    GlFence a(gl), none;
    GlFence b(std::move(a));
    none = std::move(b);
    none.wait();
    CHECK(none.passed());
    none = GlFence(gl);
    CHECK(deleted == 1);
  }
  CHECK(made == 2);
  CHECK(deleted == 2);
}

}  // namespace pabd::test_device_fences
