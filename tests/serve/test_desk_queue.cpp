// SPDX-License-Identifier: MIT
// What waits for a desk: nobody who only watches fills it.
#include <catch2/catch.hpp>

#include "app/serve/desk_queue.h"

namespace pabd::test_desk_queue {

TEST_CASE("of what everybody may send, the newest of each visitor waits, and takes no place of input") {
  DeskQueue queue;
  for (std::uint32_t i = 0; i < 3 * ServedDesk::kMostInputs; ++i) {
    for (const VisitorId visitor : {1u, 2u}) {
      REQUIRE(queue.push(desk::Refresh{visitor}));
      REQUIRE(queue.push(desk::Shown{10 * i + visitor, 1, visitor}));
    }
  }
  for (std::size_t i = 0; i < ServedDesk::kMostInputs - 4; ++i)
    REQUIRE(queue.push(desk::Input{{TextTyped{"a"}}, 0}));
  CHECK_FALSE(queue.push(desk::Input{{TextTyped{"a"}}, 0}));
  CHECK(queue.push(desk::Shown{7, 1, 3}));
  const auto told = queue.take_acknowledgements();
  REQUIRE(told.size() == 3);
  const auto last = static_cast<std::uint32_t>(10 * (3 * ServedDesk::kMostInputs - 1));
  for (const VisitorId visitor : {1u, 2u}) {
    const auto& shown = std::get<desk::Shown>(told[visitor - 1]);
    CHECK(shown.visitor == visitor);
    CHECK(shown.frame == last + visitor);
  }
  CHECK(queue.take(std::chrono::duration<double>(0)).size() == ServedDesk::kMostInputs - 2);
}

TEST_CASE("a move after a move takes its place, unless something was between them") {
  DeskQueue queue;
  for (int i = 0; i < 5; ++i) CHECK(queue.push(desk::Input{{MouseMoved{1.0 * i, 0}}, 0}));
  CHECK(queue.push(desk::Input{{MouseClicked{}}, 0}));
  CHECK(queue.push(desk::Input{{MouseMoved{9, 0}}, 0}));
  const auto taken = queue.take(std::chrono::duration<double>(0));
  REQUIRE(taken.size() == 3);
  CHECK(std::get<MouseMoved>(std::get<desk::Input>(taken[0]).events.at(0)).x == 4);
}

}  // namespace pabd::test_desk_queue
