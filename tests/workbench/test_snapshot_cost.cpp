// SPDX-License-Identifier: MIT
// A published snapshot costs the same however long the run is: what is counted are allocations and their
// bytes, not time.
#include <catch2/catch.hpp>
#include <filesystem>

#include "app/workbench/workbench.h"
#include "tests/support/allocations.h"
#include "tests/support/temp_folder.h"

namespace pabd::test_snapshot_cost {

namespace {

test::Allocations cost_of_snapshot(Workbench& bench) {
  const Snapshot warm = bench.snapshot();
  const test::Allocations before = test::allocations();
  const Snapshot snapshot = bench.snapshot();
  const test::Allocations after = test::allocations();
  return {after.count - before.count, after.bytes - before.bytes};
}

}  // namespace

TEST_CASE("a snapshot of a long run takes as many allocations and bytes as one of a short run") {
  const TempFolder folder;
  const std::string scene = (folder / "ball.json").string();
  write_bytes(scene, R"({"format": "pabd-scene", "version": 1, "name": "ball", "gravity": [0, 0, 0],
    "bodies": [{"shape": {"type": "sphere", "radius": 1}, "velocity": [1, 0, 0]}]})");
  Workbench bench({}, command::Load{scene, {}, false});
  bench.apply(command::Compare{{"contact.N=5"}});
  bench.apply(command::Step{200});
  bench.apply(command::Seek{0.5});
  bench.apply(command::Set{"contact.N", "4"});  // leaves a future
  bench.apply(command::Step{70});
  REQUIRE(bench.run().state().step == 100);
  const test::Allocations early = cost_of_snapshot(bench);
  REQUIRE(early.count > 0);  // it does count
  bench.apply(command::Step{99900});
  const Snapshot s = bench.snapshot();
  REQUIRE(s.a.history.size() == 100001);
  REQUIRE(s.b->history.size() == 100001);
  REQUIRE(s.distances.size() > 99000);
  const test::Allocations late = cost_of_snapshot(bench);
  CHECK(late.count == early.count);
  CHECK(late.bytes <= early.bytes + 16);  // digits of the number of moments, in words
  CHECK(late.bytes < 20000);
}

}  // namespace pabd::test_snapshot_cost
