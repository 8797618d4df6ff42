// SPDX-License-Identifier: MIT
// Detection takes memory in its first calls only.
#include <catch2/catch.hpp>

#include "tests/collision/heap.h"
#include "tests/support/allocations.h"

namespace pabd::test_detect_allocation {

using namespace reference;

TEST_CASE("a warm call does not allocate") {
  const Setup setup = heap(300, 30);
  CollisionWorkspace workspace;
  std::vector<ContactPoint> out;
  for (int k = 0; k < 2; ++k) detect(setup.model, setup.c, setup.R, setup.reach, {}, 1, workspace, out);
  const std::vector<IndexPair> skip;
  const std::size_t before = test::allocations().count;
  detect(setup.model, setup.c, setup.R, setup.reach, skip, 1, workspace, out);
  CHECK(test::allocations().count - before == 0);
  CHECK(out.size() > 500);
}

}  // namespace pabd::test_detect_allocation
