// SPDX-License-Identifier: MIT
// Who does what: what schedulers say, and that every task is done by exactly one.
#include <catch2/catch.hpp>
#include <map>

#include "app/sweep/share.h"
#include "sim/base/error.h"

namespace pabd::test_share {

namespace {

Environment with(std::map<std::string, std::string> variables) {
  return [variables = std::move(variables)](const char* name) -> const char* {
    const auto found = variables.find(name);
    return found == variables.end() ? nullptr : found->second.c_str();
  };
}

using Tasks = std::vector<std::size_t>;

}  // namespace

TEST_CASE("each scheduler's variable says which task") {
  CHECK_FALSE(scheduled_share(with({})).has_value());
  CHECK_FALSE(scheduled_share(with({{"OMPI_COMM_WORLD_RANK", "1"}})).has_value());  // of how many?
  CHECK(tasks_in(*scheduled_share(with({{"SLURM_ARRAY_TASK_ID", "3"}})), 5, 1) == Tasks{3});
  CHECK(tasks_in(*scheduled_share(with({{"PBS_ARRAY_INDEX", "0"}})), 5, 1) == Tasks{0});
  CHECK(tasks_in(*scheduled_share(with({{"PARALLEL_SEQ", "1"}})), 5, 1) == Tasks{0});  // counts from 1
  for (const std::string mpi : {"OMPI_COMM_WORLD_", "PMI_"}) {
    const auto share = scheduled_share(with({{mpi + "RANK", "1"}, {mpi + "SIZE", "2"}}));
    CHECK(tasks_in(*share, 5, 1) == Tasks{1, 3});
    CHECK(tasks_in(*share, 7, 2) == Tasks{2, 3, 6});
  }
}

TEST_CASE("what is no such number is refused") {
  for (const char* text : {"", "x", "-1", "1x", "99999999999999999999"}) {
    if (*text == '\0') continue;
    CHECK_THROWS_AS(scheduled_share(with({{"SLURM_ARRAY_TASK_ID", text}})), Error);
  }
  CHECK_THROWS_AS(scheduled_share(with({{"PARALLEL_SEQ", "0"}})), Error);
  CHECK_THROWS_AS(scheduled_share(with({{"PMI_RANK", "2"}, {"PMI_SIZE", "2"}})), Error);
  CHECK_THROWS_AS(tasks_in({5, 1, true, ""}, 5, 1), Error);
  CHECK_THROWS_AS(tasks_in({3, 1, true, ""}, 5, 2), Error);
}

TEST_CASE("shares are every task once") {
  for (const std::size_t chunk : {1, 3}) {
    for (const std::size_t ranks : {1, 2, 7}) {
      std::vector<int> done(20, 0);
      for (std::size_t rank = 0; rank < ranks; ++rank)
        for (const std::size_t i : tasks_in({rank, ranks, false, ""}, 20, chunk)) ++done[i];
      CHECK(done == std::vector<int>(20, 1));
    }
    std::vector<int> done(20, 0);
    for (std::size_t c = 0; c < (20 + chunk - 1) / chunk; ++c)
      for (const std::size_t i : tasks_in({c, 1, true, ""}, 20, chunk)) ++done[i];
    CHECK(done == std::vector<int>(20, 1));
  }
}

TEST_CASE("CPUs as schedulers say") {
  CHECK(scheduled_cpus(with({{"SLURM_CPUS_PER_TASK", "4"}, {"SLURM_CPUS_ON_NODE", "8"}}), false) == 4);
  CHECK(scheduled_cpus(with({{"SLURM_CPUS_PER_TASK", "4"}, {"SLURM_CPUS_ON_NODE", "8"}}), true) == 8);
  CHECK(scheduled_cpus(with({{"NCPUS", "6"}}), true) == 6);
  CHECK_FALSE(scheduled_cpus(with({{"NCPUS", "6"}}), false).has_value());
}

}  // namespace pabd::test_share
