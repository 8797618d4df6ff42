// SPDX-License-Identifier: MIT
// A .zip that appears when it is whole, by libarchive. Its entries are not compressed, and the same entries give the
// same bytes.
#pragma once

#include <exception>
#include <memory>
#include <string>
#include <string_view>

#include "sim/base/atomic_file.h"

struct archive;

namespace pabd {

class ZipFile {
 public:
  explicit ZipFile(const std::string& path);  // throws Error(file)
  ~ZipFile();                                 // removes what was not committed
  ZipFile(const ZipFile&) = delete;
  ZipFile& operator=(const ZipFile&) = delete;

  // An entry of `size` bytes, which write() gives it in parts before the next entry. Throw Error(file).
  void begin(const std::string& name, std::size_t size);
  void write(std::string_view part);
  void commit();  // once

 private:
  static long put(::archive*, void* self, const void* data, std::size_t size);
  void check(long result);

  AtomicFile file_;
  std::string path_;
  ::archive* archive_;
  bool given_up_ = false;
  std::exception_ptr failed_;  // in put(), which libarchive calls
};

}  // namespace pabd
