// SPDX-License-Identifier: MIT
// A library opened at run time.
#pragma once

#include <dlfcn.h>

#include <string>

namespace pabd {

// Never closed again: GL drivers keep threads and exit handlers that must not lose their code.
class SharedLibrary {
 public:
  // Takes the first of `names` (a null-terminated list) that opens; error() tells why none did.
  explicit SharedLibrary(const char* const* names) {
    for (; *names != nullptr && handle_ == nullptr; ++names) {
      handle_ = dlopen(*names, RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
      if (handle_ != nullptr) return;
      const char* reason = dlerror();
      if (error_.empty()) error_ = reason != nullptr ? reason : std::string(*names) + " does not open";
    }
  }

  bool is_open() const { return handle_ != nullptr; }
  const std::string& error() const { return error_; }

  // The function `name`, or null.
  template <class Function>
  Function find(const char* name) const {
    return handle_ != nullptr ? reinterpret_cast<Function>(dlsym(handle_, name)) : nullptr;
  }

 private:
  void* handle_ = nullptr;
  std::string error_;
};

}  // namespace pabd
