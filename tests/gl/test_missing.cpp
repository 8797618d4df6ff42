// SPDX-License-Identifier: MIT
// A machine without GL drivers, played with libglvnd's own variable: readable reasons, no crash.
#include <catch2/catch.hpp>
#include <cstdlib>

#include "render/context/context.h"
#include "render/context/shared_library.h"
#include "sim/base/error.h"

namespace pabd::test_missing {

namespace {

struct NoVendor {
  NoVendor() { setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent.json", 1); }
};
const NoVendor no_vendor;  // before main, before anything loads libEGL

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("EGL without a driver: Error(no_context), one line with every attempt and the remedies") {
  std::vector<ContextAttempt> attempts;
  try {
    create_headless_context(Backend::egl, attempts);
    FAIL("a context without a driver");
  } catch (const Error& error) {
    const std::string text = error.what();
    WARN(text);
    CHECK(error.kind() == ErrorKind::no_context);
    CHECK(contains(text, "OpenGL 3.3"));
    CHECK(contains(text, "EGL device"));
    CHECK(contains(text, "EGL surfaceless"));
    CHECK(contains(text, "apt-get install libegl1 libgl1-mesa-dri libosmesa6"));
    CHECK(contains(text, "NVIDIA_DRIVER_CAPABILITIES=graphics"));
    CHECK_FALSE(contains(text, "\n"));
  }
  REQUIRE(attempts.size() >= 2);
  for (const ContextAttempt& attempt : attempts) {
    CHECK_FALSE(attempt.name.empty());
    CHECK_FALSE(attempt.failure.empty());
  }
}

TEST_CASE("without EGL drivers the automatic choice falls back to OSMesa or explains itself") {
  std::vector<ContextAttempt> attempts;
  try {
    const auto context = create_headless_context(Backend::automatic, attempts);
    CHECK(context->name() == "OSMesa");
    CHECK(attempts.back().name == "OSMesa");
    CHECK(attempts.back().failure.empty());
    CHECK(attempts.size() >= 3);
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::no_context);
    CHECK(contains(error.what(), "OSMesa"));
  }
}

TEST_CASE("a library that is not installed is a reason, not a crash") {
  const char* const names[] = {"libpabd-does-not-exist.so.1", nullptr};
  const SharedLibrary library(names);
  CHECK_FALSE(library.is_open());
  CHECK(contains(library.error(), "libpabd-does-not-exist.so.1"));
  CHECK(library.find<void (*)()>("anything") == nullptr);
}

}  // namespace pabd::test_missing
