// SPDX-License-Identifier: MIT
// The CSV files: exactly the agreed columns, numbers that read back to the same bits.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <limits>
#include <sstream>

#include "sim/solver/step_numbers.h"
#include "sim/trace/trace.h"

namespace pabd::test_csv {

namespace {

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream in(line);
  for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
  return cells;
}

StepReport example() {
  StepReport r;
  r.step = 7;
  r.time = 7.0 / 60;
  r.method = SolverMethod::sissm;
  r.status = StepStatus::converged;
  r.iterations = 12;
  r.kinetic = 0.1;
  r.potential = -1.0 / 3;
  r.elastic = 1e-300;
  r.contacts = 8;
  r.max_penetration = 0;
  r.min_gap = std::numeric_limits<double>::infinity();
  r.max_normal_force = 12.5;
  r.max_joint_error = 5e-324;
  r.residual = 1e-7;
  r.times.total = 2.5;
  r.drive_work = -0.25;
  r.capped_bonds = 3;
  r.held_bodies = 2;
  r.halved_bodies = 5;
  r.halvings = 4;
  r.friction_excess = 0.125;
  r.kappa = 1250;
  r.left_pairs = 6;
  r.too_dense = 9;
  r.records.push_back({1.5, 1e-2, 0.1, 0.2, 0.3, 0.4, 0, 3e-3});
  r.records.push_back({1.25, 1e-3, 0.05, 0.06, 0.3, 0.4, 0, 2e-3});
  return r;
}

}  // namespace

TEST_CASE("steps CSV", "[trace]") {
  std::ostringstream out;
  write_steps_header(out);
  write_steps_row(out, example());
  CHECK(
      out.str() ==
      "step,time,method,status,iterations,kinetic,potential,elastic,contacts,max_penetration,min_gap,"
      "max_normal_force,max_joint_error,residual,drive_work,capped_bonds,held_bodies,halved_bodies,halvings,"
      "friction_excess,kappa,left_pairs,too_dense,step_ms\n"
      "7,0.11666666666666667,sissm,converged,12,0.1,-0.3333333333333333,1e-300,8,0,inf,12.5,5e-324,1e-07,"
      "-0.25,3,2,5,4,0.125,1250,6,9,2.5\n");
  const std::string row = out.str().substr(out.str().find('\n') + 1);
  const auto cells = split(row);
  REQUIRE(cells.size() == 24);
  CHECK(std::strtod(cells[1].c_str(), nullptr) == 7.0 / 60);
  CHECK(std::strtod(cells[6].c_str(), nullptr) == -1.0 / 3);
}

TEST_CASE("the list of a step's numbers is whole", "[trace]") {
  // Method and status are words, times differ in every run; all else that a summary holds is in the list, as wide as it is.
  std::size_t listed = 0;
  for (const StepNumber& number : step_numbers())
    listed +=
        std::visit([](const auto of) { return sizeof(std::declval<StepSummary>().*of); }, number.member);
  constexpr std::size_t kWords = 2, kPadding = 10;
  CHECK(listed + kWords + kPadding + sizeof(PhaseTimes) == sizeof(StepSummary));
}

TEST_CASE("iterations CSV", "[trace]") {
  std::ostringstream out;
  write_iterations_header(out);
  write_iterations_rows(out, example());
  CHECK(out.str() ==
        "step,iteration,energy,residual,max_penetration_before,max_penetration_after,max_joint_error,"
        "projection_change\n"
        "7,1,1.5,0.01,0.1,0.2,0,0.003\n"
        "7,2,1.25,0.001,0.05,0.06,0,0.002\n");
  std::ostringstream nothing;
  write_iterations_rows(nothing, StepReport{});
  CHECK(nothing.str().empty());
}

TEST_CASE("a step that failed has no numbers of where it ended, and no zeros", "[trace]") {
  StepReport r = example();
  r.status = StepStatus::non_finite;
  r.kinetic = r.potential = r.elastic = r.max_penetration = r.min_gap = r.max_joint_error = 0;
  r.contacts = 0;
  std::ostringstream out;
  write_steps_row(out, r);
  // The residual is that of the last iteration, which there was.
  CHECK(out.str() ==
        "7,0.11666666666666667,sissm,non_finite,12,nan,nan,nan,nan,nan,nan,nan,nan,1e-07,nan,3,2,5,4,nan,"
        "1250,6,"
        "9,2.5\n");
}

}  // namespace pabd::test_csv
