// SPDX-License-Identifier: MIT
// Who controls.
#include <catch2/catch.hpp>

#include "app/serve/roles.h"

namespace pabd::test_roles {

TEST_CASE("the first who may controls; others watch until it is handed over") {
  Roles roles;
  const VisitorId watcher = roles.arrive("w", false, 0)->id;
  CHECK_FALSE(roles.controller());
  const VisitorId a = roles.arrive("a", true, 1)->id, b = roles.arrive("b", true, 2)->id,
                  c = roles.arrive("c", true, 3)->id;
  CHECK(roles.controls(a));
  CHECK_FALSE(roles.give(b));
  roles.ask(watcher);
  CHECK_FALSE(roles.somebody_asks());  // it may not
  roles.ask(c);
  CHECK(roles.somebody_asks());
  CHECK(roles.give(a));
  CHECK(roles.controls(c));
  CHECK_FALSE(roles.somebody_asks());
  CHECK(roles.give(c));
  CHECK(roles.controls(a));  // who has been here longest
  CHECK(roles.present() == 4);
}

TEST_CASE("nobody to hand it to: it stays") {
  Roles roles;
  const VisitorId a = roles.arrive("a", true, 0)->id;
  roles.arrive("w", false, 0);
  CHECK_FALSE(roles.give(a));
  CHECK(roles.controls(a));
}

TEST_CASE("a lost controller comes back to its role; after 10 s another one has it") {
  Roles roles;
  const VisitorId a = roles.arrive("a", true, 0)->id, b = roles.arrive("b", true, 0)->id;
  roles.leave(a, 100);
  roles.tick(109);
  CHECK_FALSE(roles.controller());
  const auto back = roles.arrive("a", true, 109);
  REQUIRE(back);
  CHECK(back->came_back);
  CHECK(back->id != a);
  CHECK(roles.controls(back->id));
  roles.leave(back->id, 200);
  roles.tick(210);
  CHECK(roles.controls(b));
  const auto late = roles.arrive("a", true, 211);
  CHECK_FALSE(roles.controls(late->id));
}

TEST_CASE("alone, a role waits a minute; then the next who may has it") {
  Roles roles;
  const VisitorId a = roles.arrive("a", true, 0)->id;
  roles.leave(a, 0);
  roles.tick(59);
  CHECK(roles.controls(roles.arrive("a", true, 59.5)->id));
  Roles others;
  const VisitorId lost = others.arrive("a", true, 0)->id;
  others.leave(lost, 0);
  CHECK_FALSE(others.controls(others.arrive("b", true, 5)->id));
  others.tick(11);
  CHECK(others.controller());
}

TEST_CASE("who closed the page and opens the link again need not wait for himself") {
  Roles roles;
  const VisitorId a = roles.arrive("a", true, 0)->id;
  roles.arrive("w", false, 0);  // one who only watches waits for nothing
  roles.leave(a, 1, true);
  const VisitorId b = roles.arrive("b", true, 1.1)->id;
  CHECK(roles.controls(b));
  CHECK_FALSE(roles.controls(roles.arrive("a", true, 1.2)->id));  // it closed; another one took over

  Roles early;  // the new page is there before the old one is gone: that may be loaded again, for a moment
  const VisitorId old = early.arrive("a", true, 0)->id, next = early.arrive("b", true, 0.9)->id;
  early.leave(old, 1, true);
  early.tick(2.9);
  CHECK_FALSE(early.controls(next));
  early.tick(3);
  CHECK(early.controls(next));

  Roles reloaded;
  const VisitorId page = reloaded.arrive("a", true, 0)->id;
  reloaded.arrive("b", true, 0);
  reloaded.leave(page, 1, true);
  reloaded.tick(2);
  CHECK(reloaded.controls(reloaded.arrive("a", true, 2)->id));
}

TEST_CASE("the same page twice: the newer connection takes the place, but not with a lesser link") {
  Roles roles;
  const VisitorId a = roles.arrive("a", true, 0)->id;
  const auto again = roles.arrive("a", true, 1);
  REQUIRE(again->replaced);
  CHECK(*again->replaced == a);
  CHECK(roles.controls(again->id));
  CHECK(roles.present() == 1);
  roles.leave(a, 2);  // the older one's end comes late, and means nothing
  CHECK(roles.controls(again->id));
  const auto watcher = roles.arrive("a", false, 3);
  CHECK_FALSE(watcher->replaced);
  CHECK(roles.controls(again->id));
}

TEST_CASE("there are 16 at a time") {
  Roles roles;
  for (std::size_t i = 0; i < Roles::kMost; ++i) CHECK(roles.arrive("v" + std::to_string(i), i % 2 == 0, 0));
  CHECK_FALSE(roles.arrive("one more", true, 0));
  CHECK(roles.arrive("v3", false, 0));  // who was here
  roles.leave(1, 1);
  CHECK(roles.arrive("one more", true, 1));
  CHECK_FALSE(roles.arrive("v0", true, 2));  // its place is taken
  CHECK(roles.present() == Roles::kMost);
}

}  // namespace pabd::test_roles
