// A file that appears under its name only when it is whole.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace pabd {

class AtomicFile {
 public:
  // Opens a temporary file beside `path`. Throws Error(file) with path and reason.
  explicit AtomicFile(std::filesystem::path path);
  ~AtomicFile();  // removes the temporary file unless committed
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  void write(const void* data, std::size_t size);  // throws Error(file)
  void write(std::string_view text) { write(text.data(), text.size()); }
  void commit();  // flush, fsync, rename; throws Error(file)

  const std::filesystem::path& temporary() const { return temporary_; }

 private:
  std::filesystem::path path_;
  std::filesystem::path temporary_;
  int fd_ = -1;
};

}  // namespace pabd
