// SPDX-License-Identifier: MIT
// A library opened at run time.
#include "render/context/shared_library.h"

#include <dlfcn.h>

namespace pabd {

SharedLibrary::SharedLibrary(const char* const* names) {
  for (; *names != nullptr && handle_ == nullptr; ++names) {
    handle_ = dlopen(*names, RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
    if (handle_ != nullptr) return;
    const char* reason = dlerror();
    if (error_.empty()) error_ = reason != nullptr ? reason : std::string(*names) + " does not open";
  }
}

void* SharedLibrary::symbol(const char* name) const {
  return handle_ != nullptr ? dlsym(handle_, name) : nullptr;
}

}  // namespace pabd
