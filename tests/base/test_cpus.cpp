// SPDX-License-Identifier: MIT
// How many CPUs a process may use: quotas in folders as Linux shows them, affinity, and what is rounded up.
#include <sched.h>

#include <catch2/catch.hpp>
#include <thread>

#include "sim/base/available_cpus.h"
#include "tests/support/temp_folder.h"

namespace pabd::test_cpus {

namespace fs = std::filesystem;

namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

// A made-up machine: files by their path.
class Machine {
 public:
  void write(const std::string& path, const std::string& text) {
    const fs::path file = folder_.path() / path;
    fs::create_directories(file.parent_path());
    write_bytes(file, text);
  }
  double quota(const std::string& cgroups, const std::string& mounts) const {
    return cgroup_quota(cgroups, mounts, folder_.path());
  }

 private:
  TempFolder folder_;
};

const std::string kV2 = "29 23 0:26 / /sys/fs/cgroup rw,nosuid shared:4 - cgroup2 cgroup2 rw,nsdelegate\n";
const std::string kV1 =
    "23 28 0:22 / /sys rw shared:7 - sysfs sysfs rw\n"
    "34 31 0:29 / /sys/fs/cgroup/cpuset rw shared:15 - cgroup cgroup rw,cpuset\n"
    "35 31 0:30 / /sys/fs/cgroup/cpu,cpuacct rw,relatime shared:16 - cgroup cgroup rw,cpu,cpuacct\n";

}  // namespace

TEST_CASE("version 2: the smallest quota from the own group up") {
  Machine machine;
  const std::string own = "0::/user.slice/job\n";
  CHECK(machine.quota(own, kV2) == kNone);  // no such files
  machine.write("sys/fs/cgroup/user.slice/job/cpu.max", "max 100000\n");
  CHECK(machine.quota(own, kV2) == kNone);
  machine.write("sys/fs/cgroup/user.slice/cpu.max", "150000 100000\n");
  CHECK(machine.quota(own, kV2) == 1.5);
  machine.write("sys/fs/cgroup/user.slice/job/cpu.max", "25000 50000\n");
  CHECK(machine.quota(own, kV2) == 0.5);
  machine.write("sys/fs/cgroup/user.slice/job/cpu.max", "400000 100000\n");
  CHECK(machine.quota(own, kV2) == 1.5);
  // Those of others do not count, nor does a name that only begins alike.
  machine.write("sys/fs/cgroup/user.slice/job2/cpu.max", "1000 100000\n");
  machine.write("sys/fs/cgroup/cpu.max", "700000 100000\n");
  CHECK(machine.quota(own, kV2) == 1.5);
  CHECK(machine.quota("0::/\n", kV2) == 7);
}

TEST_CASE("version 1: the hierarchy that has the controller cpu, and no other") {
  Machine machine;
  const std::string own = "4:memory:/mem\n3:cpuset:/set\n2:cpuacct,cpu:/docker/abc\n0::/else\n";
  machine.write("sys/fs/cgroup/cpu,cpuacct/docker/abc/cpu.cfs_quota_us", "-1\n");
  machine.write("sys/fs/cgroup/cpu,cpuacct/docker/abc/cpu.cfs_period_us", "100000\n");
  CHECK(machine.quota(own, kV1) == kNone);
  machine.write("sys/fs/cgroup/cpu,cpuacct/docker/cpu.cfs_quota_us", "250000\n");
  machine.write("sys/fs/cgroup/cpu,cpuacct/docker/cpu.cfs_period_us", "100000\n");
  machine.write("sys/fs/cgroup/cpuset/docker/abc/cpu.cfs_quota_us", "1000\n");
  machine.write("sys/fs/cgroup/cpuset/docker/abc/cpu.cfs_period_us", "100000\n");
  CHECK(machine.quota(own, kV1) == 2.5);
  // Both versions on one machine: both count.
  machine.write("sys/fs/cgroup/else/cpu.max", "100000 100000\n");
  CHECK(machine.quota(own, kV1 + kV2) == 1);
}

TEST_CASE("in a container the mount shows a part of the hierarchy") {
  Machine machine;
  machine.write("sys/fs/cgroup/cpu.max", "300000 100000\n");
  machine.write("sys/fs/cgroup/inner/cpu.max", "200000 100000\n");
  machine.write("sys/fs/cgroup/d/inner/cpu.max", "100000 100000\n");
  const std::string mount = "29 23 0:26 /docker/abc /sys/fs/cgroup ro - cgroup2 cgroup rw\n";
  CHECK(machine.quota("0::/docker/abc\n", mount) == 3);
  CHECK(machine.quota("0::/docker/abc/inner\n", mount) == 2);
  CHECK(machine.quota("0::/docker/abcd/inner\n", mount) == 3);  // outside of what is seen
  CHECK(machine.quota("0::/../other/inner\n", kV2) == 3);
  machine.write("cg/my job\\x2d1/cpu.max", "100000 100000\n");
  CHECK(machine.quota("0::/a\\x2db/my job\\x2d1\n", "29 23 0:26 /a\\134x2db /cg rw - cgroup2 c rw\n") == 1);
}

TEST_CASE("what is no list of groups or mounts, and no quota, limits nothing") {
  Machine machine;
  for (const char* text :
       {"", "max", "0 100000", "100000", "100000 0", "-5 100000", "a b", "1 2 3", "\n\n"}) {
    machine.write("sys/fs/cgroup/cpu.max", text);
    CAPTURE(text);
    CHECK(machine.quota("0::/\n", kV2) == kNone);
  }
  machine.write("sys/fs/cgroup/cpu.max", "100000 100000");
  for (const char* text :
       {"", "\n", "-", "- - - -", "29 23 0:26 / /sys/fs/cgroup rw - cgroup2",
        "29 23 0:26 / /sys/fs/cgroup rw cgroup2 cgroup2 rw", "29 23 0:26 \\1 \\ rw - cgroup2 c rw"})
    CHECK(machine.quota("0::/\n", text) == kNone);
  for (const char* text : {"", ":", "0:", "::", "0::", "nothing"}) CHECK(machine.quota(text, kV2) == 1);
}

TEST_CASE("the least of cores, affinity and quota, rounded up, at least one") {
  CHECK(usable_cpus({8, 8, kNone}) == 8);
  CHECK(usable_cpus({8, 3, kNone}) == 3);
  CHECK(usable_cpus({8, 3, 16}) == 3);
  CHECK(usable_cpus({8, 8, 1.5}) == 2);
  CHECK(usable_cpus({8, 8, 2}) == 2);
  CHECK(usable_cpus({8, 8, 0.01}) == 1);
  CHECK(usable_cpus({2, 8, kNone}) == 2);
  CHECK(usable_cpus({0, 0, 0}) == 1);
}

TEST_CASE("this process: never more than the cores, and one where it is kept to one") {
  const CpuLimits free = cpu_limits();
  CHECK(free.allowed >= 1);
  CHECK(free.allowed <= free.cores);
  CHECK(available_cpus() >= 1);
  CHECK(available_cpus() <= free.allowed);
  std::thread([] {  // a thread of its own: the affinity ends with it
    cpu_set_t all;
    REQUIRE(sched_getaffinity(0, sizeof all, &all) == 0);
    cpu_set_t one;
    CPU_ZERO(&one);
    for (int cpu = 0; cpu < CPU_SETSIZE && CPU_COUNT(&one) == 0; ++cpu)
      if (CPU_ISSET(cpu, &all)) CPU_SET(cpu, &one);
    REQUIRE(sched_setaffinity(0, sizeof one, &one) == 0);
    CHECK(cpu_limits().allowed == 1);
    CHECK(available_cpus() == 1);
  })
      .join();
}

}  // namespace pabd::test_cpus
