// SPDX-License-Identifier: MIT
// A GL context, wherever it comes from: a window (window.h) or none.
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace pabd {

// OpenGL 3.3 core or better, as one thread at a time may use it.
class GlContext {
 public:
  virtual ~GlContext() = default;
  // Makes it current in the calling thread. It may be current in one thread at a time: call release() in the
  // old thread before. Throws Error(no_context).
  virtual void make_current() = 0;
  virtual void release() = 0;
  virtual void* proc_address(const char* name) = 0;  // null when the driver does not know it
  // Of the screen; 0×0 and nothing to do when off-screen only.
  virtual void framebuffer_size(int& width, int& height) const { width = height = 0; }
  virtual void present() {}
  virtual std::string name() const = 0;  // "EGL device 0", "EGL surfaceless", "OSMesa", "window"
  // Another one without a framebuffer that has the same buffers and fences (and textures, but no framebuffers and vertex
  // arrays), for another thread. Current nowhere, and gone before this one. What is current in the calling thread stays; of
  // a window made and destroyed in the main thread. Throws Error(no_context).
  virtual std::unique_ptr<GlContext> share() = 0;
};

// A context is current in this thread while this lives. Throws Error(no_context).
class CurrentContext {
 public:
  explicit CurrentContext(GlContext& context) : context_(context) { context_.make_current(); }
  ~CurrentContext() { context_.release(); }
  CurrentContext(const CurrentContext&) = delete;
  CurrentContext& operator=(const CurrentContext&) = delete;

 private:
  GlContext& context_;
};

// Where a context without a display comes from; automatic: EGL, then OSMesa.
enum class Backend { automatic, egl, osmesa };

// One candidate that was tried, and why it was not taken (empty: it was).
struct ContextAttempt {
  std::string name;
  std::string failure;
};

// Tries EGL device list (hardware first), EGL surfaceless, OSMesa in this order (or only the named ones) for
// GL 3.3 core or better. The context is current on return. Fills `attempts`. Throws Error(no_context) with
// every attempt and the variable, package or container flag that helps. In a program that has said how it tries
// contexts (below), a driver that crashes is one that does not work; it is tried once a process for each backend.
std::unique_ptr<GlContext> create_headless_context(Backend backend, std::vector<ContextAttempt>& attempts);

// `command` starts this program again, so that it calls try_headless_contexts() with the words that follow.
// Once, before the first context; without it, contexts are made in this process untried.
void set_context_trial(std::vector<std::string> command);
[[noreturn]] void try_headless_contexts(const std::vector<std::string>& words);

// What helps when variables of the environment choose a driver that cannot do what is needed: "… try 'unset
// GALLIUM_DRIVER'". Empty when none of them is set.
std::string steering_remedy();
std::string driver_remedy();  // the same, or else "try another --backend"

// Every candidate that works on this machine, for tests and diagnosis; none: an empty list. None is current.
std::vector<std::unique_ptr<GlContext>> create_every_headless_context(Backend backend,
                                                                      std::vector<ContextAttempt>& attempts);

}  // namespace pabd
