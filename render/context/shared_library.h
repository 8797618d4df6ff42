// SPDX-License-Identifier: MIT
// A library opened at run time.
#pragma once

#include <string>

namespace pabd {

// Never closed again: GL drivers keep threads and exit handlers that must not lose their code.
class SharedLibrary {
 public:
  // Takes the first of `names` (a null-terminated list) that opens; error() tells why none did.
  explicit SharedLibrary(const char* const* names);

  bool is_open() const { return handle_ != nullptr; }
  const std::string& error() const { return error_; }

  // The function `name`, or null.
  template <class Function>
  Function find(const char* name) const {
    return reinterpret_cast<Function>(symbol(name));
  }

 private:
  void* symbol(const char* name) const;

  void* handle_ = nullptr;
  std::string error_;
};

}  // namespace pabd
