// SPDX-License-Identifier: MIT
// See available_cpus.h. The formats are those of proc(5) and of the kernel's cgroup-v1 and cgroup-v2
// documents.
#include "sim/base/available_cpus.h"

#include <sched.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "sim/base/input_file.h"

namespace fs = std::filesystem;

namespace pabd {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();
constexpr std::size_t kMostBytes = 1 << 20;

std::string text_of(const fs::path& path) { return read_if_possible(path, kMostBytes); }

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(separator), text.size());
    if (end > 0) parts.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return parts;
}

// Microseconds; 0 for "max", -1 and whatever is none.
double microseconds(std::string_view text) {
  std::int64_t value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return static_cast<double>(std::max<std::int64_t>(value, 0));
}

double ratio(double quota, double period) { return quota > 0 && period > 0 ? quota / period : kNone; }

// "150000 100000", or "max 100000".
double quota_v2(const fs::path& group) {
  const std::string text = text_of(group / "cpu.max");
  const auto words = split(std::string_view(text).substr(0, text.find('\n')), ' ');
  return words.size() == 2 ? ratio(microseconds(words[0]), microseconds(words[1])) : kNone;
}

double quota_v1(const fs::path& group) {
  return ratio(microseconds(text_of(group / "cpu.cfs_quota_us")),
               microseconds(text_of(group / "cpu.cfs_period_us")));
}

// mountinfo writes blanks and backslashes, which names of systemd's have, as \040 and \134.
std::string unescaped(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    int code = 0;
    const char* digits = text.data() + i + 1;
    const bool escape = text[i] == '\\' && i + 3 < text.size() &&
                        std::from_chars(digits, digits + 3, code, 8).ptr == digits + 3;
    out += escape ? static_cast<char>(code) : text[i];
    if (escape) i += 3;
  }
  return out;
}

// A mounted hierarchy that knows quotas: 36 35 0:30 ROOT POINT options … - cgroup2 cgroup2 options
struct Mount {
  std::string root, point;  // the group that is seen at `point`
  bool v2 = false;
};

bool names_cpu(std::string_view list) {
  const auto words = split(list, ',');
  return std::find(words.begin(), words.end(), "cpu") != words.end();
}

std::vector<Mount> find_mounts(std::string_view text) {
  std::vector<Mount> mounts;
  for (const std::string_view line : split(text, '\n')) {
    const auto words = split(line, ' ');
    const auto dash = std::find(words.begin(), words.end(), "-");
    if (words.size() < 6 || words.end() - dash < 4) continue;
    const bool v2 = dash[1] == "cgroup2";
    if (v2 || (dash[1] == "cgroup" && names_cpu(dash[3])))
      mounts.push_back({unescaped(words[3]), unescaped(words[4]), v2});
  }
  return mounts;
}

// The process's own group in the hierarchies of version 2, or in the one of version 1 that has quotas.
std::string own_group(std::string_view text, bool v2) {
  for (const std::string_view line : split(text, '\n')) {  // number:controllers:/path
    const std::size_t first = line.find(':'), second = line.find(':', first + 1);
    if (second == line.npos) continue;
    const std::string_view controllers = line.substr(first + 1, second - first - 1);
    if (v2 ? controllers.empty() : names_cpu(controllers)) return std::string(line.substr(second + 1));
  }
  return "/";
}

// Where `group` is below the mount's root; empty, which is the root, when it is outside of what is seen.
std::string below(const std::string& group, const std::string& root) {
  if (group.find("/..") != group.npos) return "";
  if (root == "/") return group;
  const bool inside = group.starts_with(root) && (group.size() == root.size() || group[root.size()] == '/');
  return inside ? group.substr(root.size()) : "";
}

int allowed_cpus() {
  for (int most = 1024; most <= 1 << 20; most *= 2) {  // too small a set is refused
    cpu_set_t* set = CPU_ALLOC(most);
    const std::size_t size = CPU_ALLOC_SIZE(most);
    const int count = set && ::sched_getaffinity(0, size, set) == 0 ? CPU_COUNT_S(size, set) : 0;
    CPU_FREE(set);
    if (count > 0) return count;
  }
  return std::numeric_limits<int>::max();
}

}  // namespace

double cgroup_quota(std::string_view cgroups, std::string_view mounts, const fs::path& root) {
  double least = kNone;
  for (const Mount& mount : find_mounts(mounts)) {
    const fs::path top = root / fs::path(mount.point).relative_path();
    fs::path group = top;
    const auto check = [&] { least = std::min(least, mount.v2 ? quota_v2(group) : quota_v1(group)); };
    check();
    for (const fs::path& name : fs::path(below(own_group(cgroups, mount.v2), mount.root)).relative_path()) {
      group /= name;
      check();
    }
  }
  return least;
}

CpuLimits cpu_limits() {
  CpuLimits limits;
  limits.cores = static_cast<int>(std::max(::sysconf(_SC_NPROCESSORS_ONLN), 1L));
  limits.allowed = std::min(allowed_cpus(), limits.cores);
  limits.quota = cgroup_quota(text_of("/proc/self/cgroup"), text_of("/proc/self/mountinfo"), "/");
  return limits;
}

int usable_cpus(const CpuLimits& limits) {
  const double least = std::min<double>(
      {std::ceil(limits.quota), static_cast<double>(limits.allowed), static_cast<double>(limits.cores)});
  return static_cast<int>(std::max(least, 1.0));
}

}  // namespace pabd
