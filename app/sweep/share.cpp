// SPDX-License-Identifier: MIT
// See share.h.
#include "app/sweep/share.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <string_view>

#include "sim/base/counted.h"
#include "sim/base/error.h"

namespace pabd {
namespace {

constexpr std::size_t kMost = 1'000'000'000;

std::size_t number_of(const char* name, const char* text, std::size_t least) {
  const std::string_view view = text;
  std::size_t value = 0;
  const auto [end, failure] = std::from_chars(view.data(), view.data() + view.size(), value);
  if (failure != std::errc() || end != view.data() + view.size() || value < least || value > kMost)
    throw Error(
        ErrorKind::bad_input, name,
        fmt::format("expected a whole number, {} or more, got \"{}\"; --task N says which task, --task all "
                    "does all of them",
                    least, text));
  return value;
}

}  // namespace

Environment own_environment() {
  return [](const char* name) -> const char* { return std::getenv(name); };
}

std::optional<TaskShare> scheduled_share(const Environment& environment) {
  struct One {
    const char* name;
    std::size_t first;
  };
  for (const One& one : {One{"SLURM_ARRAY_TASK_ID", 0}, One{"PBS_ARRAY_INDEX", 0}, One{"PARALLEL_SEQ", 1}}) {
    const char* text = environment(one.name);
    if (text == nullptr || *text == '\0') continue;
    return TaskShare{number_of(one.name, text, one.first) - one.first, 1, true,
                     fmt::format("{}={}", one.name, text)};
  }
  for (const auto& [rank, size] :
       {std::pair{"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"}, {"PMI_RANK", "PMI_SIZE"}}) {
    const char* rank_text = environment(rank);
    const char* size_text = environment(size);
    if (rank_text == nullptr || size_text == nullptr) continue;
    const std::size_t stride = number_of(size, size_text, 1), first = number_of(rank, rank_text, 0);
    if (first >= stride)
      throw Error(ErrorKind::bad_input, rank,
                  fmt::format("is {}, of {} only; ranks count from 0", first, stride));
    return TaskShare{first, stride, false, fmt::format("{}={} of {}", rank, first, stride)};
  }
  return std::nullopt;
}

std::vector<std::size_t> tasks_in(const TaskShare& share, std::size_t count, std::size_t chunk) {
  const std::size_t chunks = (count + chunk - 1) / chunk;
  if (share.one && share.first >= chunks)
    throw Error(
        ErrorKind::bad_input, share.from.empty() ? fmt::format("--task {}", share.first) : share.from,
        fmt::format("this plan has {}{}, counted from 0", counted(static_cast<std::int64_t>(count), "task"),
                    chunk > 1 ? fmt::format(" in {} chunks of {}", chunks, chunk) : ""));
  std::vector<std::size_t> out;
  for (std::size_t c = share.first; c < chunks; c += share.stride) {
    for (std::size_t i = c * chunk; i < std::min(count, (c + 1) * chunk); ++i) out.push_back(i);
    if (share.one) break;
  }
  return out;
}

std::optional<int> scheduled_cpus(const Environment& environment, bool whole_node) {
  const std::vector<const char*> names = whole_node ? std::vector<const char*>{"SLURM_CPUS_ON_NODE", "NCPUS"}
                                                    : std::vector<const char*>{"SLURM_CPUS_PER_TASK"};
  for (const char* name : names) {
    const char* text = environment(name);
    if (text != nullptr && *text != '\0') return static_cast<int>(number_of(name, text, 1));
  }
  return std::nullopt;
}

}  // namespace pabd
