// SPDX-License-Identifier: MIT
// The EGL functions in use, looked up at run time, and EGL's error codes in words.
#include "render/context/egl_library.h"

#include <fmt/format.h>

#include <cstring>

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

}  // namespace

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

EglLibrary::EglLibrary() : library_(kEglNames) {
  if (!library_.is_open()) {
    failure_ = library_.error();
    return;
  }
  bool complete = true;
  const auto load = [&](auto& function, const char* name) {
    function = library_.find<std::remove_reference_t<decltype(function)>>(name);
    complete = complete && function != nullptr;
  };
  load(get_proc_address, "eglGetProcAddress");
  load(get_error, "eglGetError");
  load(query_string, "eglQueryString");
  load(initialize, "eglInitialize");
  load(bind_api, "eglBindAPI");
  load(choose_config, "eglChooseConfig");
  load(create_context, "eglCreateContext");
  load(destroy_context, "eglDestroyContext");
  load(make_current, "eglMakeCurrent");
  load(get_current_context, "eglGetCurrentContext");
  load(create_pbuffer_surface, "eglCreatePbufferSurface");
  load(destroy_surface, "eglDestroySurface");
  if (!complete) {
    failure_ = "libEGL.so.1 lacks functions of EGL 1.4";
    return;
  }

  const char* extensions = query_string(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  client_extensions_ = extensions != nullptr ? extensions : "";
  get_error();  // a library without client extensions leaves EGL_BAD_DISPLAY behind
  // Looked up whatever the extension string says: without a driver it is empty, and the calls tell more.
  const auto extension = [&](auto& function, const char* name) {
    function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(get_proc_address(name));
  };
  extension(get_platform_display, "eglGetPlatformDisplayEXT");
  extension(query_devices, "eglQueryDevicesEXT");
  extension(query_device_string, "eglQueryDeviceStringEXT");
  if (get_platform_display == nullptr) failure_ = "libEGL.so.1 lacks eglGetPlatformDisplayEXT";
}

bool EglLibrary::has_client_extension(const char* name) const {
  return has_word(client_extensions_.c_str(), name);
}

std::string EglLibrary::describe_error(const char* call) const {
  const EGLint code = get_error();
  for (const ErrorName& e : kErrors) {
    if (e.code == code) return fmt::format("{} failed with {:#x} {} ({})", call, code, e.name, e.meaning);
  }
  return fmt::format("{} failed with {:#x}", call, code);
}

}  // namespace pabd
