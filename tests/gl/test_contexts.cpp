// SPDX-License-Identifier: MIT
// Every context that this machine offers draws the same bytes.
#include <unistd.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iterator>
#include <set>
#include <thread>

#include "render/gl/gl_objects.h"
#include "sim/base/error.h"
#include "tests/gl/drawn_scenes.h"
#include "tests/gl/render_fixture.h"
#include "tests/support/errors.h"
#include "tests/support/files.h"

namespace pabd::test_contexts {

namespace {

// Bodies of all shapes, shadows, contacts, bonds, lines and transparency in one frame.
VisualScene rich_scene() {
  const BrickPyramid pyramid(4, 0.02);
  VisualOptions options;
  options.bonds = options.contacts = true;
  options.d_hat = 0.02;
  VisualScene scene, more;
  build_visual(pyramid.tiny.model, pyramid.tiny.state, pyramid.report, options, scene);
  const TinyModel mixed = mixed_bodies(3);
  build_visual(mixed.model, mixed.state, {}, {}, more);
  for (int kind = 0; kind < kPrimitiveCount; ++kind) {
    for (Instance instance : more.instances[kind]) {
      instance.transform(2, 3) += 4;
      if (kind == 1) instance.color.w() = 0.5f;
      scene.instances[kind].push_back(instance);
    }
  }
  scene.lines.push_back({{-3, 0.5f, 3}, {3, 2.0f, 1}, {0.1f, 0.1f, 0.4f, 1}, 3, false});
  scene.camera.eye = {5, 3.5f, 10};
  return scene;
}

}  // namespace

TEST_CASE("every context draws the same bytes, in this order of preference") {
  std::vector<ContextAttempt> attempts;
  const auto contexts = create_every_headless_context(Backend::automatic, attempts);
  REQUIRE_FALSE(contexts.empty());
  for (const ContextAttempt& attempt : attempts) {
    WARN(attempt.name << ": " << (attempt.failure.empty() ? "works" : attempt.failure));
  }
  const VisualScene scene = rich_scene();
  Image first;
  std::string first_driver;
  for (const auto& context : contexts) {
    context->make_current();
    {
      Renderer renderer(*context, 320, 180);
      const Image image = render(renderer, scene);
      // Hardware and software drivers may differ; one driver may not, however it was reached.
      if (first.rgb.empty()) {
        first = image;
        first_driver = renderer.gl_renderer();
        keep_image("contexts", image);
      } else if (renderer.gl_renderer() == first_driver) {
        INFO(context->name());
        CHECK(image.rgb == first.rgb);
      }
      // And the same once more, after other frames have left their traces.
      renderer.draw({}, nullptr);
      CHECK(render(renderer, scene).rgb == image.rgb);
    }
    context->release();
  }
  const std::set<std::uint8_t> values(first.rgb.begin(), first.rgb.end());
  CHECK(values.size() > 100);  // a picture, not a plain colour
}

TEST_CASE("a context that is shared has the buffers of its partner, in another thread at the same time") {
  std::vector<ContextAttempt> attempts;
  for (const auto& context : create_every_headless_context(Backend::automatic, attempts)) {
    CAPTURE(context->name());
    context->make_current();
    const GlFunctions gl(*context);
    const std::vector<float> numbers = {1, 2, 3.5f, -4};
    const auto bytes = static_cast<GLsizeiptr>(numbers.size() * sizeof(float));
    const GlBuffer buffer(gl);
    gl.BindBuffer(GL_ARRAY_BUFFER, buffer.id());
    gl.BufferData(GL_ARRAY_BUFFER, bytes, numbers.data(), GL_STATIC_DRAW);
    gl.Finish();
    std::unique_ptr<GlContext> other = context->share();
    std::vector<float> found(numbers.size());
    std::string failure;
    std::thread([&] {
      try {
        const CurrentContext current(*other);
        const GlFunctions there(*other);
        there.BindBuffer(GL_ARRAY_BUFFER, buffer.id());
        if (const void* at = there.MapBufferRange(GL_ARRAY_BUFFER, 0, bytes, GL_MAP_READ_BIT)) {
          std::memcpy(found.data(), at, static_cast<std::size_t>(bytes));
          there.UnmapBuffer(GL_ARRAY_BUFFER);
        }
        // A buffer that is made there is known here.
        there.BufferData(GL_ARRAY_BUFFER, 2 * bytes, nullptr, GL_STATIC_DRAW);
        there.Finish();
      } catch (const Error& error) {
        failure = error.what();
      }
    }).join();
    CHECK(failure.empty());
    CHECK(found == numbers);
    gl.BindBuffer(GL_ARRAY_BUFFER, buffer.id());
    CHECK(gl.MapBufferRange(GL_ARRAY_BUFFER, 0, 2 * bytes, GL_MAP_READ_BIT) !=
          nullptr);  // this one is current still
    gl.UnmapBuffer(GL_ARRAY_BUFFER);
    other.reset();
    context->release();
  }
}

// Run in a process of its own by the next test: software GL reads its thread count once.
TEST_CASE("one frame into the file named by PABD_FRAME_FILE", "[.child]") {
  const char* path = std::getenv("PABD_FRAME_FILE");
  REQUIRE(path != nullptr);
  RenderFixture f(320, 180);
  const Image image = render(f.renderer, rich_scene());
  write_bytes(path, {reinterpret_cast<const char*>(image.rgb.data()), image.rgb.size()});
}

TEST_CASE("the number of the driver's threads does not show in the picture") {
  namespace fs = std::filesystem;
  const fs::path file = fs::temp_directory_path() / ("pabd_frame_" + std::to_string(::getpid()));
  RenderFixture f(320, 180);
  const Image expected = render(f.renderer, rich_scene());
  const fs::path self = fs::read_symlink("/proc/self/exe");
  for (const char* threads : {"0", "1", "3"}) {
    const std::string command = "LP_NUM_THREADS=" + std::string(threads) + " PABD_FRAME_FILE='" +
                                file.string() + "' '" + self.string() + "' '[.child]' > /dev/null";
    REQUIRE(std::system(command.c_str()) == 0);
    const std::string text = read_bytes(file);
    const std::vector<std::uint8_t> bytes(text.begin(), text.end());
    INFO(threads << " threads");
    CHECK(bytes == expected.rgb);
  }
  fs::remove(file);
}

TEST_CASE("each named backend is the one that answers") {
  std::vector<ContextAttempt> attempts;
  for (const Backend backend : {Backend::egl, Backend::osmesa}) {
    const auto found = create_every_headless_context(backend, attempts);
    for (const auto& context : found) {
      CHECK((context->name() == "OSMesa") == (backend == Backend::osmesa));
      int width = -1, height = -1;
      context->framebuffer_size(width, height);
      CHECK(width == 0);
      CHECK(height == 0);
      CHECK(context->proc_address("glGetString") != nullptr);
    }
  }
}

TEST_CASE("two renderers on two contexts live side by side") {
  std::vector<ContextAttempt> attempts;
  const auto a = create_headless_context(Backend::automatic, attempts);
  Renderer left(*a, 64, 48);
  const auto b = create_headless_context(Backend::automatic, attempts);
  {
    Renderer right(*b, 64, 48);
    VisualScene scene;
    scene.instances[0].push_back(flat_instance({0, 0, 0}, {1, 1, 1}, {1, 0, 0, 1}));
    scene.camera = front_camera(6);
    const Image from_right = render(right, scene);
    a->make_current();
    CHECK(render(left, scene).rgb == from_right.rgb);
    b->make_current();
  }
  a->make_current();
}

// A driver whose GPU is gone answers every question with the same error.
TEST_CASE("a context that is lost, and never stops to say so, is told once") {
  constexpr GLenum kLost = 0x0507;  // GL_CONTEXT_LOST
  std::vector<ContextAttempt> attempts;
  const auto context = create_headless_context(Backend::automatic, attempts);
  GlFunctions gl(*context);
  gl.GetError = []() -> GLenum { return kLost; };
  const Caught error = caught([&] { gl.check("drawing"); });
  CHECK(error.kind == ErrorKind::no_context);
  CHECK(error.says("drawing failed with GL_CONTEXT_LOST"));
  gl.forget_errors();
}

}  // namespace pabd::test_contexts
