// A published snapshot costs the same however long the run is: what is counted are allocations and their
// bytes, not time.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <new>

#include "app/workbench/workbench.h"
#include "tests/output/temp_folder.h"

#ifndef __SANITIZE_ADDRESS__  // the sanitizer brings its own operator new

namespace {
thread_local std::size_t allocations = 0, bytes = 0;

void* counted(void* memory, std::size_t size) {
  ++allocations;
  bytes += size;
  if (memory) return memory;
  throw std::bad_alloc();
}
}  // namespace

void* operator new(std::size_t size) { return counted(std::malloc(size), size); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  const auto a = static_cast<std::size_t>(alignment);
  return counted(std::aligned_alloc(a, (size + a - 1) / a * a), size);
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

using namespace pabd;

namespace {

struct Cost {
  std::size_t allocations, bytes;
};

Cost cost_of_snapshot(Workbench& bench) {
  const Snapshot warm = bench.snapshot();
  const std::size_t count = allocations, size = bytes;
  const Snapshot snapshot = bench.snapshot();
  return {allocations - count, bytes - size};
}

}  // namespace

TEST_CASE("a snapshot of a long run takes as many allocations and bytes as one of a short run") {
  const TempFolder folder;
  const std::string scene = (folder / "ball.json").string();
  std::ofstream(scene) << R"({"format": "pabd-scene", "version": 1, "name": "ball", "gravity": [0, 0, 0],
    "bodies": [{"shape": {"type": "sphere", "radius": 1}, "velocity": [1, 0, 0]}]})";
  Workbench bench({}, command::Load{scene, {}, false});
  bench.apply(command::Compare{{"contact.N=5"}});
  bench.apply(command::Step{200});
  bench.apply(command::Seek{0.5});
  bench.apply(command::Set{"contact.N", "4"});  // leaves a future
  bench.apply(command::Step{70});
  REQUIRE(bench.run().state().step == 100);
  const Cost early = cost_of_snapshot(bench);
  bench.apply(command::Step{99900});
  const Snapshot s = bench.snapshot();
  REQUIRE(s.a.history.size() == 100001);
  REQUIRE(s.b->history.size() == 100001);
  REQUIRE(s.distances.size() > 99000);
  const Cost late = cost_of_snapshot(bench);
  CHECK(late.allocations == early.allocations);
  CHECK(late.bytes <= early.bytes + 16);  // digits of the number of moments, in words
  CHECK(late.bytes < 20000);
}

#endif
