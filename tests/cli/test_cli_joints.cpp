// SPDX-License-Identifier: MIT
// pabd run --joints: a row a joint and step.
#include <catch2/catch.hpp>
#include <sstream>

#include "tests/cli/program.h"

namespace pabd::test_cli_joints {

using namespace test;

namespace {

std::vector<std::string> fields_of(const std::string& row) {
  std::vector<std::string> out;
  std::istringstream in(row);
  for (std::string field; std::getline(in, field, ',');) out.push_back(field);
  return out;
}

}  // namespace

TEST_CASE("--joints writes a row a joint and step: at rest the first joint of a chain carries its weight") {
  const CommandFolder folder;
  write_text(folder / "chain.json", R"({"format": "pabd-scene", "version": 1, "gravity": [0, -10, 0],
    "bodies": [{"name": "ball", "shape": {"type": "sphere", "radius": 0.2}, "mass": 4, "position": [0, -1, 0]},
               {"name": "last", "shape": {"type": "sphere", "radius": 0.2}, "mass": 1, "position": [0, -2, 0]}],
    "joints": [{"name": "top", "type": "spherical", "bodies": [null, "ball"], "anchor": [0, 0, 0]},
               {"type": "hinge", "bodies": ["ball", "last"], "anchor": [0, -1.5, 0], "axis": [0, 0, 1]}]})");
  const Outcome outcome =
      run_pabd({"run", folder / "chain.json", "--steps", "60", "--quiet", "--joints", folder / "joints.csv"});
  CAPTURE(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  const auto rows = lines_of(read_text(folder / "joints.csv"));
  REQUIRE(rows.size() == 1 + 2 * 60);
  CHECK(rows[0] ==
        "step,time,joint,name,force_x,force_y,force_z,moment_x,moment_y,moment_z,axial_force,axial_moment,"
        "error");
  const auto top = fields_of(rows[119]), lower = fields_of(rows[120]);
  REQUIRE(top.size() == 13);
  CHECK(top[0] == "60");
  CHECK(std::stod(top[1]) == Approx(1));
  CHECK(top[2] == "0");
  CHECK(top[3] == "top");
  CHECK(std::stod(top[5]) == Approx(50).epsilon(5e-6));
  CHECK(lower[2] == "1");
  CHECK(std::stod(lower[5]) == Approx(10).epsilon(5e-6));
  CHECK(std::abs(std::stod(lower[11])) < 5e-5);
  CHECK(std::stod(top[12]) >= 0);
  CHECK(std::stod(top[12]) < 1e-6);
}

TEST_CASE("--joints to standard output, of a scene without joints, and onto another output") {
  const Outcome none = run_pabd({"run", "spin", "--steps", "2", "--quiet", "--joints", "-"});
  REQUIRE(none.exit_code == 0);
  CHECK(lines_of(none.out).size() == 1);
  const CommandFolder folder;
  const Outcome twice = run_pabd(
      {"run", "pendulum", "--steps", "2", "--joints", folder / "a.csv", "--trace", folder / "a.csv"});
  CHECK(twice.exit_code == 2);
  CHECK(is_error_line(twice.err, {"--joints"}));
}

}  // namespace pabd::test_cli_joints
