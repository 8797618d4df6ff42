// SPDX-License-Identifier: MIT
// Names of numbered frames: one "{frame}" or "{frame:0W}" in a file name.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <system_error>

#include "render/output/frame_sink.h"
#include "sim/base/error.h"

namespace pabd {
namespace fs = std::filesystem;
namespace {

constexpr const char* remedy = "write one {frame} or {frame:04}, as in frames/{frame:04}.png";

struct FrameTemplate {
  fs::path folder;
  std::string before, after;  // in the file name
  int digits = 0;             // at least so many, filled with zeros; 0: as many as needed
};

[[noreturn]] void refuse(const std::string& out, const char* problem) {
  throw Error(ErrorKind::bad_input, fmt::format("{}: {}; {}", out, problem, remedy));
}

FrameTemplate parse(const std::string& out) {
  const fs::path path(out);
  const std::string name = path.filename().string();
  const std::string folder = path.parent_path().string();
  if (folder.find("{frame") != std::string::npos) refuse(out, "the frame number must be in the file name");
  const std::size_t open = name.find('{');
  const std::size_t close = name.find('}');
  if (open == std::string::npos) refuse(out, "the name holds no frame number");
  if (close == std::string::npos || close < open) refuse(out, "the braces do not match");
  if (name.find_first_of("{}", close + 1) != std::string::npos)
    refuse(out, "there is more than one field in braces");

  FrameTemplate result;
  result.folder = path.parent_path();
  result.before = name.substr(0, open);
  result.after = name.substr(close + 1);
  const std::string field = name.substr(open + 1, close - open - 1);
  if (field == "frame") return result;
  const bool width = field.size() == 8 && field.starts_with("frame:0") && field[7] >= '1' && field[7] <= '9';
  if (!width) refuse(out, "the field in braces is not understood");
  result.digits = field[7] - '0';
  return result;
}

// The number in a file name, if it is one that the template makes.
std::optional<int> number_in(const FrameTemplate& form, const std::string& name) {
  if (!name.starts_with(form.before) || !name.ends_with(form.after)) return {};
  if (name.size() <= form.before.size() + form.after.size()) return {};
  const std::string digits =
      name.substr(form.before.size(), name.size() - form.before.size() - form.after.size());
  int number = 0;
  const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (problem != std::errc() || end != digits.data() + digits.size() || number < 0) return {};
  if (fmt::format("{:0{}}", number, form.digits) != digits) return {};
  return number;
}

}  // namespace

bool is_frame_template(const std::string& out) { return out.find("{frame") != std::string::npos; }

fs::path frame_path(const std::string& out, int number) {
  const FrameTemplate form = parse(out);
  if (number < 0)
    throw Error(ErrorKind::bad_input, fmt::format("{}: frame {}: numbers start at 0", out, number));
  return form.folder / fmt::format("{}{:0{}}{}", form.before, number, form.digits, form.after);
}

int first_existing_frame(const std::string& out, int from) {
  const FrameTemplate form = parse(out);
  std::error_code none;  // a folder that cannot be listed is reported when it is written to
  int first = -1;
  for (fs::directory_iterator entry(form.folder.empty() ? fs::path(".") : form.folder, none), end;
       !none && entry != end; entry.increment(none)) {
    const std::optional<int> number = number_in(form, entry->path().filename().string());
    if (number && *number >= from && (first < 0 || *number < first)) first = *number;
  }
  return first;
}

int first_missing_frame(const std::string& out) {
  int number = 0;
  std::error_code none;
  while (fs::exists(frame_path(out, number), none)) ++number;
  return number;
}

}  // namespace pabd
