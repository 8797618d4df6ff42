// SPDX-License-Identifier: MIT
// A window of GLFW with an OpenGL 3.3 core context.
#include <fmt/format.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "render/context/candidate.h"
#include "render/context/display_loss.h"
#include "render/context/glfw_keys.h"
#include "render/context/window.h"
#include "sim/base/error.h"
#include "sim/base/utf8.h"

namespace pabd {
namespace {

constexpr const char* kRemedy =
    "; start it where there is a display (DISPLAY or WAYLAND_DISPLAY is set; over ssh: 'ssh -X'), or give "
    "--headless to draw without a window";

// GLFW's words for its last error.
std::string last_error() {
  const char* text = nullptr;
  if (glfwGetError(&text) == GLFW_NO_ERROR || text == nullptr) return "no reason is known";
  return text;
}

// GLFW itself, from its start to its end.
class Glfw {
 public:
  explicit Glfw(int display_lost_status) : loss_(display_lost_status) {
    prepare_software_gl();
    if (glfwInit() != GLFW_TRUE) throw Error(ErrorKind::no_context, "no window: " + last_error() + kRemedy);
    loss_.watch();
  }
  ~Glfw() {
    if (!lost()) glfwTerminate();
  }
  Glfw(const Glfw&) = delete;
  Glfw& operator=(const Glfw&) = delete;

  bool lost() const { return loss_.lost(); }
  void opened() { loss_.opened(); }

 private:
  DisplayLoss loss_;
};

// What a window or a hidden one is made with, but for the version.
void set_hints(int api, bool visible) {
  glfwDefaultWindowHints();
  glfwWindowHint(GLFW_CONTEXT_CREATION_API, api);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  glfwWindowHint(GLFW_VISIBLE, visible ? GLFW_TRUE : GLFW_FALSE);
  // Frames come whole: the window itself needs neither depth nor samples.
  for (const int hint : {GLFW_DEPTH_BITS, GLFW_STENCIL_BITS, GLFW_ALPHA_BITS, GLFW_SAMPLES})
    glfwWindowHint(hint, 0);
  glfwWindowHintString(GLFW_X11_CLASS_NAME, "pabd");
  glfwWindowHintString(GLFW_X11_INSTANCE_NAME, "pabd");
}

// Null, with the reason in last_error().
GLFWwindow* create_window(int width, int height, const char* title, GLFWwindow* partner) {
  for (const auto [major, minor] : kAskedVersions) {
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, major);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, minor);
    if (GLFWwindow* window = glfwCreateWindow(width, height, title, nullptr, partner)) return window;
  }
  return nullptr;
}

class GlfwContext : public GlContext {
 public:
  GlfwContext(Glfw& glfw, GLFWwindow* window, int api)
      : glfw_(glfw),
        window_(window),
        api_(api),
        name_(api == GLFW_EGL_CONTEXT_API ? "window (EGL)" : "window") {}

  void make_current() override {
    if (glfw_.lost()) return;
    glfwMakeContextCurrent(window_);
    if (glfwGetCurrentContext() != window_)
      throw Error(ErrorKind::no_context, "the window's GL context cannot be made current: " + last_error());
  }
  void release() override {
    if (!glfw_.lost() && glfwGetCurrentContext() == window_) glfwMakeContextCurrent(nullptr);
  }
  void* proc_address(const char* name) override { return reinterpret_cast<void*>(glfwGetProcAddress(name)); }
  void framebuffer_size(int& width, int& height) const override {
    width = height = 0;
    if (!glfw_.lost()) glfwGetFramebufferSize(window_, &width, &height);
    if (glfw_.lost()) width = height = 0;  // lost while it was asked
  }
  void present() override {
    if (glfw_.lost()) return;
    glfwSwapBuffers(window_);
    glfw_.opened();
  }
  std::string name() const override { return name_; }
  std::unique_ptr<GlContext> share() override;

 protected:
  Glfw& glfw_;
  GLFWwindow* window_;

 private:
  int api_;
  std::string name_;
};

// Of a window that is never shown: GLFW has no context without one.
class HiddenContext final : public GlfwContext {
 public:
  using GlfwContext::GlfwContext;
  ~HiddenContext() override {
    if (!glfw_.lost()) glfwDestroyWindow(window_);
  }
  HiddenContext(const HiddenContext&) = delete;
  HiddenContext& operator=(const HiddenContext&) = delete;
  void make_current() override {
    if (glfw_.lost()) throw Error(ErrorKind::no_context, "the display was lost");
    GlfwContext::make_current();
  }
  void framebuffer_size(int& width, int& height) const override { width = height = 0; }
  void present() override {}
};

std::unique_ptr<GlContext> GlfwContext::share() {
  set_hints(api_, false);
  GLFWwindow* window = glfw_.lost() ? nullptr : create_window(1, 1, "", window_);
  if (window == nullptr)
    throw Error(ErrorKind::no_context, "the window's GL context cannot be shared: " + last_error());
  return std::make_unique<HiddenContext>(glfw_, window, api_);
}

class GlfwWindow final : public Window {
 public:
  explicit GlfwWindow(const WindowOptions& options);
  ~GlfwWindow() override {
    if (window_ == nullptr || glfw_.lost()) return;
    context_->release();
    for (GLFWcursor* cursor : cursors_) {
      if (cursor != nullptr) glfwDestroyCursor(cursor);
    }
    glfwDestroyWindow(window_);
  }
  GlfwWindow(const GlfwWindow&) = delete;
  GlfwWindow& operator=(const GlfwWindow&) = delete;

  GlContext& context() override { return *context_; }

  std::vector<WindowEvent> poll(double wait) override;

  bool should_close() const override { return glfw_.lost() || glfwWindowShouldClose(window_) == GLFW_TRUE; }
  void keep_open() override {
    if (!glfw_.lost()) glfwSetWindowShouldClose(window_, GLFW_FALSE);
  }
  bool display_lost() const override { return glfw_.lost(); }
  bool answers() const override {
    int width = 0, height = 0;
    context_->framebuffer_size(width, height);  // asks the X server
    return !glfw_.lost();
  }

  double content_scale() const override {
    float x = 1, y = 1;
    if (!glfw_.lost()) glfwGetWindowContentScale(window_, &x, &y);
    return std::isfinite(x) && x > 0 ? static_cast<double>(x) : 1.0;
  }
  void size(int& width, int& height) const override { context_->framebuffer_size(width, height); }
  void set_title(const std::string& title) override {
    if (!glfw_.lost()) glfwSetWindowTitle(window_, title.c_str());
  }
  void set_cursor(MouseCursor cursor) override;

  std::string clipboard() const override {
    const char* text = glfw_.lost() ? nullptr : glfwGetClipboardString(window_);
    return text != nullptr ? text : "";
  }
  void set_clipboard(const std::string& text) override {
    if (!glfw_.lost()) glfwSetClipboardString(window_, text.c_str());
  }

 private:
  std::string create(const WindowOptions& options, int api, const char* name);
  void listen();
  // Pixels of the framebuffer in one of GLFW's screen units: 1 on X, the scale on some others.
  double pixels_per_unit() const {
    int units = 0, height = 0, pixels = 0;
    glfwGetWindowSize(window_, &units, &height);
    glfwGetFramebufferSize(window_, &pixels, &height);
    return units > 0 && pixels > 0 ? static_cast<double>(pixels) / units : 1.0;
  }

  static GlfwWindow& of(GLFWwindow* window) {
    return *static_cast<GlfwWindow*>(glfwGetWindowUserPointer(window));
  }
  template <class Event>
  static void send(GLFWwindow* window, Event event) {
    of(window).events_.push_back(std::move(event));
  }

  Glfw glfw_;
  GLFWwindow* window_ = nullptr;
  std::unique_ptr<GlfwContext> context_;
  std::vector<WindowEvent> events_;
  std::array<GLFWcursor*, 6> cursors_{};
  MouseCursor cursor_ = MouseCursor::arrow;
};

GlfwWindow::GlfwWindow(const WindowOptions& options) : glfw_(options.display_lost_status) {
  std::string tried;
  for (const auto& [api, name] : {std::pair{GLFW_NATIVE_CONTEXT_API, "the window system's own context"},
                                  std::pair{GLFW_EGL_CONTEXT_API, "EGL"}}) {
    const std::string failure = create(options, api, name);
    if (failure.empty()) {
      listen();
      return;
    }
    tried += fmt::format(" {}: {};", name, failure);
  }
  throw Error(
      ErrorKind::no_context,
      fmt::format(
          "no window with OpenGL {}.{} core could be opened:{} install a driver with 'apt-get install "
          "libgl1-mesa-dri libglx-mesa0', or give --headless to draw without a window",
          kGlMajor, kGlMinor, tried));
}

// Empty on success, otherwise the reason; then nothing is left behind.
std::string GlfwWindow::create(const WindowOptions& options, int api, const char* name) {
  set_hints(api, options.visible);
  window_ =
      create_window(std::max(options.width, 1), std::max(options.height, 1), options.title.c_str(), nullptr);
  if (window_ == nullptr) return last_error();
  context_ = std::make_unique<GlfwContext>(glfw_, window_, api);
  glfwMakeContextCurrent(window_);
  std::string failure = glfwGetCurrentContext() == window_ ? check_gl_version(*context_)
                                                           : fmt::format("{} cannot be made current", name);
  if (!failure.empty()) {
    context_.reset();
    glfwDestroyWindow(std::exchange(window_, nullptr));
    return failure;
  }
  glfwSetWindowSizeLimits(window_, options.least_width, options.least_height, GLFW_DONT_CARE, GLFW_DONT_CARE);
  return {};
}

void GlfwWindow::listen() {
  glfwSetWindowUserPointer(window_, this);
  glfwSetCursorPosCallback(window_, [](GLFWwindow* w, double x, double y) {
    const double scale = of(w).pixels_per_unit();
    send(w, MouseMoved{x * scale, y * scale});
  });
  glfwSetCursorEnterCallback(window_, [](GLFWwindow* w, int entered) {
    if (entered == GLFW_FALSE) send(w, MouseLeft{});
  });
  glfwSetMouseButtonCallback(window_, [](GLFWwindow* w, int button, int action, int bits) {
    if (button > GLFW_MOUSE_BUTTON_MIDDLE) return;
    send(w, MouseClicked{static_cast<MouseButton>(button), action == GLFW_PRESS, modifiers_of_glfw(bits)});
  });
  glfwSetScrollCallback(window_, [](GLFWwindow* w, double x, double y) { send(w, MouseScrolled{x, y}); });
  glfwSetKeyCallback(window_, [](GLFWwindow* w, int number, int scancode, int action, int bits) {
    const Key key = key_of_glfw(number, scancode);
    if (key == Key::none) return;
    Modifiers modifiers = modifiers_of_glfw(bits);
    const bool down = action != GLFW_RELEASE;
    // X reports the modifiers as they were before.
    if (key == Key::ctrl) modifiers.ctrl = down;
    if (key == Key::shift) modifiers.shift = down;
    if (key == Key::alt) modifiers.alt = down;
    if (key == Key::super) modifiers.super = down;
    send(w, KeyChanged{key, modifiers, down, action == GLFW_REPEAT});
  });
  glfwSetCharCallback(window_, [](GLFWwindow* w, unsigned code) {
    TextTyped typed;
    append_character(typed.text, code);
    send(w, typed);
  });
  glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* w, int x, int y) { send(w, WindowResized{x, y}); });
  glfwSetWindowContentScaleCallback(
      window_, [](GLFWwindow* w, float, float) { send(w, ScaleChanged{of(w).content_scale()}); });
  glfwSetWindowFocusCallback(window_,
                             [](GLFWwindow* w, int focused) { send(w, FocusChanged{focused == GLFW_TRUE}); });
  glfwSetWindowCloseCallback(window_, [](GLFWwindow* w) { send(w, CloseRequested{}); });
  glfwSetDropCallback(window_, [](GLFWwindow* w, int count, const char** paths) {
    send(w, FilesDropped{{paths, paths + count}});
  });
}

std::vector<WindowEvent> GlfwWindow::poll(double wait) {
  if (!glfw_.lost()) {
    if (wait > 0) {
      glfwWaitEventsTimeout(wait);
    } else {
      glfwPollEvents();
    }
    if (glfw_.lost()) events_.emplace_back(CloseRequested{});
  }
  return std::exchange(events_, {});
}

void GlfwWindow::set_cursor(MouseCursor cursor) {
  if (glfw_.lost() || cursor == cursor_) return;
  cursor_ = cursor;
  constexpr std::array<int, 6> kShapes = {GLFW_ARROW_CURSOR, GLFW_IBEAM_CURSOR,   GLFW_CROSSHAIR_CURSOR,
                                          GLFW_HAND_CURSOR,  GLFW_HRESIZE_CURSOR, GLFW_VRESIZE_CURSOR};
  const auto at = static_cast<std::size_t>(cursor);
  if (cursors_[at] == nullptr) cursors_[at] = glfwCreateStandardCursor(kShapes[at]);
  glfwSetCursor(window_, cursors_[at]);
}

}  // namespace

std::unique_ptr<Window> open_window(const WindowOptions& options) {
  return std::make_unique<GlfwWindow>(options);
}

}  // namespace pabd
