// SPDX-License-Identifier: MIT
// Headless contexts from EGL, whose library is opened at run time: one a device of EGL_EXT_device_enumeration, and EGL_MESA_platform_surfaceless.
//
// The default display, X11, Wayland and GBM are not tried: without a display server or device files they all
// end in EGL_NOT_INITIALIZED.
#define EGL_EGL_PROTOTYPES 0
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "render/context/candidate.h"
#include "render/context/shared_library.h"
#include "sim/base/error.h"

#ifndef EGL_PLATFORM_SURFACELESS_MESA
#define EGL_PLATFORM_SURFACELESS_MESA 0x31DD
#endif

namespace pabd {
namespace {

constexpr const char* kEglNames[] = {"libEGL.so.1", nullptr};

struct ErrorName {
  EGLint code;
  const char* name;
  const char* meaning;
};

constexpr ErrorName kErrors[] = {
    {EGL_SUCCESS, "EGL_SUCCESS", "no error reported"},
    {EGL_NOT_INITIALIZED, "EGL_NOT_INITIALIZED", "no driver could open this display"},
    {EGL_BAD_ACCESS, "EGL_BAD_ACCESS",
     "the context is current in another thread, or a device file is not accessible"},
    {EGL_BAD_ALLOC, "EGL_BAD_ALLOC", "out of memory"},
    {EGL_BAD_ATTRIBUTE, "EGL_BAD_ATTRIBUTE", "the driver does not know an attribute"},
    {EGL_BAD_CONFIG, "EGL_BAD_CONFIG", "the driver does not offer this configuration"},
    {EGL_BAD_CONTEXT, "EGL_BAD_CONTEXT", "not a context"},
    {EGL_BAD_CURRENT_SURFACE, "EGL_BAD_CURRENT_SURFACE", "the surface is gone"},
    {EGL_BAD_DISPLAY, "EGL_BAD_DISPLAY", "not a display"},
    {EGL_BAD_MATCH, "EGL_BAD_MATCH", "the driver does not offer this version of OpenGL"},
    {EGL_BAD_NATIVE_PIXMAP, "EGL_BAD_NATIVE_PIXMAP", "not a pixmap"},
    {EGL_BAD_NATIVE_WINDOW, "EGL_BAD_NATIVE_WINDOW", "not a window"},
    {EGL_BAD_PARAMETER, "EGL_BAD_PARAMETER", "the driver does not know this platform"},
    {EGL_BAD_SURFACE, "EGL_BAD_SURFACE", "not a surface"},
    {EGL_CONTEXT_LOST, "EGL_CONTEXT_LOST", "the device was reset"},
    {EGL_BAD_DEVICE_EXT, "EGL_BAD_DEVICE_EXT", "not a device"},
};

// True when the blank-separated list holds the whole word.
bool has_word(const char* list, const char* word) {
  if (list == nullptr) return false;
  const std::size_t length = std::strlen(word);
  for (const char* at = std::strstr(list, word); at != nullptr; at = std::strstr(at + 1, word)) {
    const bool starts = at == list || at[-1] == ' ';
    const bool ends = at[length] == ' ' || at[length] == '\0';
    if (starts && ends) return true;
  }
  return false;
}

// The functions in use, of EGL 1.4 and of extensions.
// clang-format off
#define PABD_EGL_CORE(X) \
  X(PFNEGLGETPROCADDRESSPROC, GetProcAddress) X(PFNEGLGETERRORPROC, GetError) \
  X(PFNEGLQUERYSTRINGPROC, QueryString) X(PFNEGLINITIALIZEPROC, Initialize) X(PFNEGLBINDAPIPROC, BindAPI) \
  X(PFNEGLCHOOSECONFIGPROC, ChooseConfig) X(PFNEGLCREATECONTEXTPROC, CreateContext) \
  X(PFNEGLDESTROYCONTEXTPROC, DestroyContext) X(PFNEGLMAKECURRENTPROC, MakeCurrent) \
  X(PFNEGLGETCURRENTCONTEXTPROC, GetCurrentContext) \
  X(PFNEGLCREATEPBUFFERSURFACEPROC, CreatePbufferSurface) X(PFNEGLDESTROYSURFACEPROC, DestroySurface)
#define PABD_EGL_EXTENSIONS(X) \
  X(PFNEGLQUERYDEVICESEXTPROC, QueryDevicesEXT) X(PFNEGLQUERYDEVICESTRINGEXTPROC, QueryDeviceStringEXT) \
  X(PFNEGLGETPLATFORMDISPLAYEXTPROC, GetPlatformDisplayEXT)
// clang-format on

class EglLibrary {
 public:
  EglLibrary() : library_(kEglNames) {
    if (!library_.is_open()) {
      failure_ = library_.error();
      return;
    }
#define PABD_LOAD(Type, name) name = library_.find<Type>("egl" #name);
    PABD_EGL_CORE(PABD_LOAD)
#undef PABD_LOAD
#define PABD_MISSING(Type, name) || name == nullptr
    if (false PABD_EGL_CORE(PABD_MISSING)) {
#undef PABD_MISSING
      failure_ = "libEGL.so.1 lacks functions of EGL 1.4";
      return;
    }
    // Looked up whatever the extension string says: without a driver it is empty, and the calls tell more.
#define PABD_LOAD(Type, name) name = reinterpret_cast<Type>(GetProcAddress("egl" #name));
    PABD_EGL_EXTENSIONS(PABD_LOAD)
#undef PABD_LOAD
    if (GetPlatformDisplayEXT == nullptr) failure_ = "libEGL.so.1 lacks eglGetPlatformDisplayEXT";
  }

  // Empty when the library is usable, otherwise why it is not.
  const std::string& failure() const { return failure_; }

#define PABD_DECLARE(Type, name) Type name = nullptr;
  PABD_EGL_CORE(PABD_DECLARE)
  PABD_EGL_EXTENSIONS(PABD_DECLARE)  // null where missing
#undef PABD_DECLARE

  // "eglInitialize: 0x3001 EGL_NOT_INITIALIZED (…meaning…)" from the error that is pending in this thread.
  std::string describe_error(const char* call) const {
    const EGLint code = GetError();
    for (const ErrorName& e : kErrors) {
      if (e.code == code) return fmt::format("{} failed with {:#x} {} ({})", call, code, e.name, e.meaning);
    }
    return fmt::format("{} failed with {:#x}", call, code);
  }

 private:
  SharedLibrary library_;
  std::string failure_;
};

class EglContext final : public GlContext {
 public:
  // `partner`: whose buffers it has, or null.
  EglContext(std::shared_ptr<const EglLibrary> egl, EGLDisplay display, std::string name,
             const EglContext* partner = nullptr)
      : egl_(std::move(egl)),
        display_(display),
        partner_(partner ? partner->context_ : EGL_NO_CONTEXT),
        name_(std::move(name)) {}

  // The display stays initialised: EGL hands out the same one to every context on a device.
  ~EglContext() override {
    if (context_ != EGL_NO_CONTEXT) {
      release();
      egl_->DestroyContext(display_, context_);
    }
    if (surface_ != EGL_NO_SURFACE) egl_->DestroySurface(display_, surface_);
  }

  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  // Empty on success, otherwise the reason. Current afterwards.
  std::string open() {
    std::string failure = create();
    if (!failure.empty()) return failure;
    if (!bind()) return egl_->describe_error("eglMakeCurrent");
    return check_gl_version(*this);
  }

  std::unique_ptr<GlContext> share() override {
    auto out = std::make_unique<EglContext>(egl_, display_, name_, this);
    if (const std::string failure = out->create(); !failure.empty())
      throw Error(ErrorKind::no_context, name_ + ": a context that shares buffers: " + failure);
    return out;
  }

  void make_current() override {
    if (!bind()) throw Error(ErrorKind::no_context, name_ + ": " + egl_->describe_error("eglMakeCurrent"));
  }

  void release() override {
    if (egl_->GetCurrentContext() == context_) {
      egl_->MakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    }
  }

  void* proc_address(const char* name) override {
    return reinterpret_cast<void*>(egl_->GetProcAddress(name));
  }
  std::string name() const override { return name_; }

 private:
  std::string create() {
    EGLint major = 0, minor = 0;
    if (!egl_->Initialize(display_, &major, &minor)) return egl_->describe_error("eglInitialize");
    if (!egl_->BindAPI(EGL_OPENGL_API)) return egl_->describe_error("eglBindAPI");
    const EGLint config_attributes[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE,
                                        EGL_PBUFFER_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!egl_->ChooseConfig(display_, config_attributes, &config, 1, &count)) {
      return egl_->describe_error("eglChooseConfig");
    }
    if (count == 0) return "the driver offers no configuration for OpenGL";
    for (const auto [wanted_major, wanted_minor] : kAskedVersions) {
      const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                   wanted_major,
                                   EGL_CONTEXT_MINOR_VERSION,
                                   wanted_minor,
                                   EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                   EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                   EGL_NONE};
      context_ = egl_->CreateContext(display_, config, partner_, attributes);
      if (context_ != EGL_NO_CONTEXT) break;
    }
    if (context_ == EGL_NO_CONTEXT) return egl_->describe_error("eglCreateContext");
    if (!has_word(egl_->QueryString(display_, EGL_EXTENSIONS), "EGL_KHR_surfaceless_context")) {
      const EGLint size[] = {EGL_WIDTH, 16, EGL_HEIGHT, 16, EGL_NONE};
      surface_ = egl_->CreatePbufferSurface(display_, config, size);
      if (surface_ == EGL_NO_SURFACE) return egl_->describe_error("eglCreatePbufferSurface");
    }
    return {};
  }

  bool bind() {
    // The API is a setting of the thread.
    return egl_->BindAPI(EGL_OPENGL_API) && egl_->MakeCurrent(display_, surface_, surface_, context_);
  }

  std::shared_ptr<const EglLibrary> egl_;
  EGLDisplay display_;
  EGLContext partner_, context_ = EGL_NO_CONTEXT;
  EGLSurface surface_ = EGL_NO_SURFACE;
  std::string name_;
};

std::unique_ptr<GlContext> open_display(const std::shared_ptr<const EglLibrary>& egl, EGLenum platform,
                                        void* native, const std::string& name, std::string& failure) {
  const EGLDisplay display = egl->GetPlatformDisplayEXT(platform, native, nullptr);
  if (display == EGL_NO_DISPLAY) {
    failure = "EGL_NO_DISPLAY: " + egl->describe_error("eglGetPlatformDisplayEXT");
    return nullptr;
  }
  auto context = std::make_unique<EglContext>(egl, display, name);
  failure = context->open();
  if (!failure.empty()) return nullptr;
  return context;
}

ContextCandidate failed_candidate(const std::string& name, const std::string& reason) {
  return {name, [reason](std::string& failure) {
            failure = reason;
            return std::unique_ptr<GlContext>();
          }};
}

struct Device {
  EGLDeviceEXT handle;
  bool software;
  std::string name;
};

std::vector<Device> list_devices(const EglLibrary& egl, std::string& failure) {
  if (egl.QueryDevicesEXT == nullptr) {
    failure = "libEGL.so.1 lacks eglQueryDevicesEXT";
    return {};
  }
  EGLint count = 0;
  if (!egl.QueryDevicesEXT(0, nullptr, &count)) {
    failure = egl.describe_error("eglQueryDevicesEXT");
    return {};
  }
  std::vector<EGLDeviceEXT> handles(static_cast<std::size_t>(std::max(count, 0)));
  if (count > 0 && !egl.QueryDevicesEXT(count, handles.data(), &count)) {
    failure = egl.describe_error("eglQueryDevicesEXT");
    return {};
  }
  handles.resize(static_cast<std::size_t>(std::clamp<EGLint>(count, 0, static_cast<EGLint>(handles.size()))));
  if (handles.empty()) {
    failure = "no EGL device (no driver is installed, or none is visible to this process)";
    return {};
  }
  std::vector<Device> devices;
  for (std::size_t i = 0; i < handles.size(); ++i) {
    const char* extensions =
        egl.QueryDeviceStringEXT != nullptr ? egl.QueryDeviceStringEXT(handles[i], EGL_EXTENSIONS) : nullptr;
    const bool software = has_word(extensions, "EGL_MESA_device_software");
    devices.push_back(
        {handles[i], software, fmt::format("EGL device {}{}", i, software ? " (software)" : "")});
  }
  std::stable_partition(devices.begin(), devices.end(), [](const Device& d) { return !d.software; });
  return devices;
}

}  // namespace

void add_egl_candidates(std::vector<ContextCandidate>& out) {
  const auto egl = std::make_shared<const EglLibrary>();
  if (!egl->failure().empty()) {
    out.push_back(failed_candidate("EGL", egl->failure()));
    return;
  }
  std::string failure;
  const std::vector<Device> devices = list_devices(*egl, failure);
  if (devices.empty()) out.push_back(failed_candidate("EGL device", failure));
  for (const Device& device : devices) {
    out.push_back({device.name, [egl, device](std::string& reason) {
                     return open_display(egl, EGL_PLATFORM_DEVICE_EXT, device.handle, device.name, reason);
                   }});
  }
  // Tried even where the extension string does not promise it: the error code says more than its absence.
  out.push_back({"EGL surfaceless", [egl](std::string& reason) {
                   return open_display(egl, EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY,
                                       "EGL surfaceless", reason);
                 }});
}

}  // namespace pabd
