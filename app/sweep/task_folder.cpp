// SPDX-License-Identifier: MIT
// See task_folder.h.
#include "app/sweep/task_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <set>
#include <system_error>
#include <unordered_set>

#include "sim/base/atomic_file.h"
#include "sim/base/counted.h"
#include "sim/base/error.h"
#include "sim/base/input_file.h"
#include "sim/base/output_path.h"
#include "sim/base/utf8.h"

namespace fs = std::filesystem;

namespace pabd {
namespace {

constexpr std::size_t kMostTaskBytes = std::size_t{16} << 20;

[[noreturn]] void fail(const fs::path& path, const char* what, const std::string& reason) {
  throw Error(ErrorKind::file, path.string(), fmt::format("{}: {}", what, reason));
}

void make_folder(const fs::path& path) {
  std::error_code failure;
  fs::create_directories(path, failure);
  if (failure) fail(path, "the folder cannot be made", failure.message());
}

// Whether the name still refers to the locked file: its last owner may have removed it.
bool is_named(int fd, const fs::path& path) {
  struct stat opened = {}, named = {};
  return ::fstat(fd, &opened) == 0 && ::stat(path.c_str(), &named) == 0 && opened.st_ino == named.st_ino &&
         opened.st_dev == named.st_dev;
}

// No descriptor: another process holds it.
Descriptor lock(const fs::path& path) {
  for (;;) {
    Descriptor file(::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666));
    if (file.get() < 0) fail(path, "cannot be made", system_reason(errno));
    if (::flock(file.get(), LOCK_EX | LOCK_NB) != 0) {
      if (errno == EINTR) continue;
      if (errno == EWOULDBLOCK) return {};
      fail(path, "cannot be locked", system_reason(errno));
    }
    if (is_named(file.get(), path)) return file;
  }
}

// Replaces the index of another plan by that of this one.
void count_anew(const fs::path& place, const SweepTask& task) {
  for (const char* name : {"task.json", "result.json"}) {
    const fs::path path = place / name;
    auto json = nlohmann::ordered_json::parse(read_if_possible(path, kMostTaskBytes), nullptr, false);
    if (!json.is_object() || !json.contains("index") || json["index"] == task.index) continue;
    json["index"] = task.index;
    write_file(path, json.dump(2) + "\n");
  }
}

// The programs that made results in `folder` that are not among `tasks`; "": unknown.
std::set<std::string> other_programs(const fs::path& folder, const std::vector<SweepTask>& tasks) {
  std::unordered_set<std::string_view> known;
  for (const SweepTask& task : tasks) known.insert(task.hash);
  std::set<std::string> out;
  std::error_code failure;
  fs::directory_iterator entries(folder / "tasks", failure);
  for (; !failure && entries != fs::directory_iterator(); entries.increment(failure)) {
    const std::string name = entries->path().filename().string();
    if (name.starts_with('.') || known.contains(name)) continue;
    const auto json = nlohmann::json::parse(read_if_possible(entries->path() / "task.json", kMostTaskBytes),
                                            nullptr, false);
    if (!json.is_object()) continue;
    const auto program = json.find("program");
    out.insert(program != json.end() && program->is_string() ? program->get<std::string>() : "");
  }
  return out;
}

}  // namespace

std::string made_by_others(const fs::path& folder, const SweepPlan& plan, const Scene& base,
                           const std::vector<SweepTask>& tasks, const std::vector<std::size_t>& chosen) {
  std::vector<std::size_t> open;
  for (const std::size_t i : chosen)
    if (!is_done(folder, tasks[i])) open.push_back(i);
  if (open.empty()) return {};
  std::set<std::size_t> made;
  std::string names;
  for (const std::string& program : other_programs(folder, tasks)) {
    const std::vector<SweepTask> theirs = tasks_of(plan, base, program);
    bool any = false;
    for (const std::size_t i : open) {
      if (!is_done(folder, theirs[i])) continue;
      any = true;
      made.insert(i);
    }
    if (!any) continue;
    const std::string name = program.empty() ? "an earlier version" : one_line(program);
    names += (names.empty() ? "" : ", ") + name;
  }
  if (made.empty()) return {};
  return fmt::format("{} {} done by {}, and {} made again by {}: versions may differ in results",
                     counted(made.size(), "task"), made.size() == 1 ? "was" : "were", names,
                     made.size() == 1 ? "is" : "are", sweep_program());
}

void prepare_sweep_folder(const fs::path& folder, const SweepPlan& plan, const std::vector<SweepTask>& tasks,
                          bool force) {
  make_folder(folder / "tasks");
  const fs::path path = folder / "plan.json";
  const std::string there = read_if_possible(path, kMostTaskBytes);
  if (there == plan.text) return;
  std::error_code ignored;
  if (!force && fs::exists(path, ignored))
    refuse_existing(folder.string(),
                    "the sweep of another plan; name another folder, or --force replaces the plan "
                    "and keeps the tasks that both have");
  for (const SweepTask& task : tasks)
    if (is_done(folder, task)) count_anew(task_path(folder, task), task);
  write_file(path, plan.text);
}

fs::path task_path(const fs::path& folder, const SweepTask& task) { return folder / "tasks" / task.hash; }

bool is_done(const fs::path& folder, const SweepTask& task) {
  std::error_code ignored;
  return fs::exists(task_path(folder, task) / "result.json", ignored);
}

std::string faults_of(const fs::path& folder, const SweepTask& task) {
  const auto json = nlohmann::json::parse(
      read_if_possible(task_path(folder, task) / "result.json", kMostTaskBytes), nullptr, false);
  const auto faults = json.is_object() ? json.find("faults") : json.end();
  return faults != json.end() && faults->is_string() ? one_line(faults->get<std::string>()) : "";
}

std::optional<TaskFolder> TaskFolder::take(const fs::path& folder, const SweepTask& task) {
  TaskFolder out;
  out.place_ = task_path(folder, task);
  out.partial_ = folder / "tasks" / ("." + task.hash + ".partial");
  out.lock_path_ = folder / "tasks" / ("." + task.hash + ".lock");
  out.lock_ = lock(out.lock_path_);
  if (out.lock_.get() < 0) return std::nullopt;
  out.done_ = is_done(folder, task);
  if (out.done_) {
    ::unlink(out.lock_path_.c_str());
  } else {
    make_folder(out.partial_);
    out.clean();
  }
  return out;
}

// Removes files of a process that was killed while writing; its checkpoint is complete.
void TaskFolder::clean() const {
  std::error_code failure;
  fs::directory_iterator entries(partial_, failure);
  for (; !failure && entries != fs::directory_iterator(); entries.increment(failure)) {
    std::error_code ignored;
    if (entries->path() != checkpoint()) fs::remove_all(entries->path(), ignored);
  }
  if (failure) fail(partial_, "cannot be read", failure.message());
}

void TaskFolder::write(const char* name, std::string_view bytes) {
  write_private_file(partial_ / name, bytes);
}

void TaskFolder::publish() {
  std::error_code ignored;
  fs::remove(checkpoint(), ignored);
  publish_folder(partial_, place_);  // over an empty folder, too: some schedulers make it before
  ::unlink(lock_path_.c_str());
}

}  // namespace pabd
