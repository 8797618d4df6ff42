// A step that is warm takes no memory from the system, whatever the number of iterations.

#include <catch2/catch.hpp>
#include <cstdlib>
#include <new>

#include "sim/body/compound.h"
#include "sim/body/convex_hull.h"
#include "tests/physics/scenario.h"

#ifndef __SANITIZE_ADDRESS__  // the sanitizer brings its own operator new

namespace {
thread_local long allocations = 0;
}

void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  ++allocations;
  const auto a = static_cast<std::size_t>(alignment);
  if (void* memory = std::aligned_alloc(a, (size + a - 1) / a * a)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

using namespace pabd;

namespace {

Hull tetrahedron(double shift) {
  std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (Vec3& p : points) p.x() += shift;
  return Hull{make_hull(points).hull};
}

}  // namespace

TEST_CASE("a warm step allocates nothing") {
  for (const SolverMethod method : {SolverMethod::descent, SolverMethod::sissm}) {
    testing::World world;
    world.params.solver.method = method;
    world.params.solver.tolerance = 0;
    world.add_ground();
    for (int k = 0; k < 20; ++k) world.add_cube(1, 100, {1.5 * (k % 5), 0.509 + 1.01 * (k / 5), 0});
    world.add(make_compound({tetrahedron(0), tetrahedron(0.3)}), 100, {0, 0.3, 3});
    world.add(make_compound({tetrahedron(0), tetrahedron(0.3)}), 100, {0, 1.1, 3});
    StepWorkspace workspace;
    StepReport report;
    const StepOptions options{true, true, 1};
    for (int k = 0; k < 120; ++k) step(world.model, world.params, options, world.state, workspace, report);
    const long before = allocations;
    for (int k = 0; k < 10; ++k) step(world.model, world.params, options, world.state, workspace, report);
    const long during = allocations - before;
    INFO(to_string(method));
    CHECK(during == 0);
    CHECK(report.contacts > 0);
  }
}

#endif
