// SPDX-License-Identifier: MIT
// A list whose views stay what they are.
#include <catch2/catch.hpp>

#include "app/session/shared_list.h"

namespace pabd::test_shared_list {

using pabd::SharedList;
using List = SharedList<int>;

namespace {

List numbers(int count) {
  List out;
  for (int i = 0; i < count; ++i) out.push_back(i);
  return out;
}

bool counts_from(const List::View& view, int first, std::size_t size) {
  bool same = view.size() == size;
  for (std::size_t i = 0; same && i < size; ++i) same = view[i] == first + static_cast<int>(i);
  return same;
}

}  // namespace

TEST_CASE("a view stays what it is while the list grows, is cut, and grows again") {
  List list = numbers(20);
  const List::View before = list.view();
  for (int i = 20; i < 500; ++i) list.push_back(i);
  CHECK(counts_from(before, 0, 20));
  CHECK(counts_from(list.view(), 0, 500));
  const List::View whole = list.view();
  list.truncate(30);
  list.push_back(-1);
  CHECK(list.size() == 31);
  CHECK(list.back() == -1);
  CHECK(whole[30] == 30);
  CHECK(counts_from(whole, 0, 500));
  list.drop_front(10);
  CHECK(list[0] == 10);
  for (int i = 0; i < 100; ++i) list.push_back(i);
  CHECK(list.size() == 121);
  CHECK(list[20] == -1);
  CHECK(counts_from(whole, 0, 500));
}

TEST_CASE("copies of a list go on without each other") {
  List a = numbers(17);  // not at the end of its block
  List b = a;
  b.push_back(100);
  a.push_back(200);
  CHECK(a.back() == 200);
  CHECK(b.back() == 100);
  List c = std::move(a);
  c.push_back(300);
  CHECK(c.size() == 19);
  CHECK(c[17] == 200);
  b = c;
  c.truncate(0);
  c.push_back(7);
  CHECK(b[0] == 0);
  CHECK(c.size() == 1);
}

TEST_CASE("an empty list has an empty view") {
  const List list;
  CHECK(list.view().empty());
  CHECK(list.view().begin() == list.view().end());
}

}  // namespace pabd::test_shared_list
