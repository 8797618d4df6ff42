// SPDX-License-Identifier: MIT
// See file_list.h.
#include "app/gui/file_list.h"

#include <algorithm>
#include <cctype>
#include <sstream>

#include "sim/base/error.h"
#include "sim/base/input_file.h"

namespace pabd {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostSniffed = std::size_t{1} << 20;  // larger ones are scenes

bool digit(char c) { return c >= '0' && c <= '9'; }
char small(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

// The digits from `i` on without zeros in front; `i` moves behind them.
std::string number_at(const std::string& text, std::size_t& i) {
  while (i < text.size() && text[i] == '0') ++i;
  const std::size_t begin = i;
  while (i < text.size() && digit(text[i])) ++i;
  return text.substr(begin, i - begin);
}

}  // namespace

bool natural_less(const std::string& a, const std::string& b) {
  std::size_t i = 0, j = 0;
  while (i < a.size() && j < b.size()) {
    if (digit(a[i]) && digit(b[j])) {
      const std::string x = number_at(a, i), y = number_at(b, j);
      if (x.size() != y.size()) return x.size() < y.size();
      if (x != y) return x < y;
      continue;
    }
    const char x = small(a[i++]), y = small(b[j++]);
    if (x != y) return static_cast<unsigned char>(x) < static_cast<unsigned char>(y);
  }
  const std::size_t left_a = a.size() - i, left_b = b.size() - j;
  return left_a != left_b ? left_a < left_b : a < b;
}

std::vector<FileEntry> list_files(const fs::path& folder, const std::string& endings, std::size_t most) {
  const auto fits = [&](const std::string& name) {
    std::istringstream all(endings);
    for (std::string ending; all >> ending;)
      if (name.ends_with(ending)) return true;
    return false;
  };
  std::vector<FileEntry> folders, files;
  std::error_code failed;
  for (fs::directory_iterator at(folder, fs::directory_options::skip_permission_denied, failed), end;
       !failed && at != end; at.increment(failed)) {
    const std::string name = at->path().filename().string();
    if (name.starts_with('.')) continue;
    std::error_code unknown;
    if (at->is_directory(unknown)) {
      if (folders.size() < most) folders.push_back({name, true});
    } else if (at->is_regular_file(unknown) && files.size() < most && fits(name)) {
      files.push_back({name, false});
    }
  }
  const auto by_name = [](const FileEntry& x, const FileEntry& y) { return natural_less(x.name, y.name); };
  std::sort(folders.begin(), folders.end(), by_name);
  std::sort(files.begin(), files.end(), by_name);
  folders.insert(folders.end(), files.begin(), files.end());
  return folders;
}

DroppedKind kind_of_dropped(const std::string& path) {
  if (path.ends_with(".pabdrec")) return DroppedKind::recording;
  std::error_code unknown;
  if (fs::is_regular_file(fs::path(path) / "plan.json", unknown)) return DroppedKind::sweep;
  if (!path.ends_with(".json") || !fs::is_regular_file(path, unknown)) return DroppedKind::scene;
  std::string head;
  try {
    head = read_file(path, kMostSniffed, "a JSON file");
  } catch (const Error&) {
    return DroppedKind::scene;
  }
  if (head.find("\"pabd-camera\"") != head.npos) return DroppedKind::camera;
  const std::size_t first = head.find_first_not_of(" \t\r\n");
  const bool object = first != head.npos && head[first] == '{';
  return object && head.find("\"format\"") == head.npos ? DroppedKind::patch : DroppedKind::scene;
}

fs::path folder_of_typed(const std::string& text) {
  std::error_code ignored;
  if (!text.empty() && fs::is_directory(text, ignored)) return text;
  const fs::path parent = fs::path(text).parent_path();
  return parent.empty() ? fs::path(".") : parent;
}

std::string in_folder(const fs::path& folder, const std::string& name) {
  return folder == fs::path(".") ? name : (folder / name).lexically_normal().string();
}

}  // namespace pabd
