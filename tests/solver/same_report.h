// SPDX-License-Identifier: MIT
// What two runs say of a step, compared to the last bit.
#pragma once

#include <catch2/catch.hpp>

#include "sim/solver/report.h"

namespace pabd::test {

inline void require_same(const StepReport& a, const StepReport& b) {
  CHECK(a.method == b.method);
  CHECK(a.status == b.status);
  CHECK(a.iterations == b.iterations);
  CHECK(a.contacts == b.contacts);
  const auto same = [](double x, double y) { return x == y || (x != x && y != y); };
  CHECK(same(a.kinetic, b.kinetic));
  CHECK(same(a.potential, b.potential));
  CHECK(same(a.elastic, b.elastic));
  CHECK(same(a.min_gap, b.min_gap));
  CHECK(same(a.max_joint_error, b.max_joint_error));
  CHECK(same(a.residual, b.residual));
  REQUIRE(a.records.size() == b.records.size());
  for (std::size_t k = 0; k < a.records.size(); ++k) CHECK(same(a.records[k].energy, b.records[k].energy));
  REQUIRE(a.contact_reports.size() == b.contact_reports.size());
  for (std::size_t k = 0; k < a.contact_reports.size(); ++k) {
    CHECK(same(a.contact_reports[k].d, b.contact_reports[k].d));
    CHECK(a.contact_reports[k].friction == b.contact_reports[k].friction);
  }
  REQUIRE(a.joint_reports.size() == b.joint_reports.size());
  for (std::size_t k = 0; k < a.joint_reports.size(); ++k)
    CHECK(a.joint_reports[k].force == b.joint_reports[k].force);
}

}  // namespace pabd::test
