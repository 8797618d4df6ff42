// SPDX-License-Identifier: MIT
// The EGL functions in use, looked up at run time.
#pragma once

#define EGL_EGL_PROTOTYPES 0
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <string>

#include "render/context/shared_library.h"

namespace pabd {

class EglLibrary {
 public:
  EglLibrary();

  // Empty when the library is usable, otherwise why it is not.
  const std::string& failure() const { return failure_; }
  bool has_client_extension(const char* name) const;

  PFNEGLGETPROCADDRESSPROC get_proc_address = nullptr;
  PFNEGLGETERRORPROC get_error = nullptr;
  PFNEGLQUERYSTRINGPROC query_string = nullptr;
  PFNEGLINITIALIZEPROC initialize = nullptr;
  PFNEGLBINDAPIPROC bind_api = nullptr;
  PFNEGLCHOOSECONFIGPROC choose_config = nullptr;
  PFNEGLCREATECONTEXTPROC create_context = nullptr;
  PFNEGLDESTROYCONTEXTPROC destroy_context = nullptr;
  PFNEGLMAKECURRENTPROC make_current = nullptr;
  PFNEGLGETCURRENTCONTEXTPROC get_current_context = nullptr;
  PFNEGLCREATEPBUFFERSURFACEPROC create_pbuffer_surface = nullptr;
  PFNEGLDESTROYSURFACEPROC destroy_surface = nullptr;
  // Extensions, null where missing.
  PFNEGLQUERYDEVICESEXTPROC query_devices = nullptr;
  PFNEGLQUERYDEVICESTRINGEXTPROC query_device_string = nullptr;
  PFNEGLGETPLATFORMDISPLAYEXTPROC get_platform_display = nullptr;

  // "eglInitialize: 0x3001 EGL_NOT_INITIALIZED (…meaning…)" from the error that is pending in this thread.
  std::string describe_error(const char* call) const;

 private:
  SharedLibrary library_;
  std::string failure_;
  std::string client_extensions_;
};

// True when the blank-separated list holds the whole word.
bool has_word(const char* list, const char* word);

}  // namespace pabd
