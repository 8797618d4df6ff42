// SPDX-License-Identifier: MIT
// pabd bench: a table with a row a scene, the same as JSON. Times are whatever they are.
#include <catch2/catch.hpp>
#include <csignal>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/cli/bench_table.h"
#include "tests/cli/program.h"

namespace pabd::test_cli_bench {

using namespace test;
using nlohmann::json;

namespace {

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream in(line.substr(1));
  for (std::string cell; std::getline(in, cell, '|');) {
    const auto first = cell.find_first_not_of(' '), last = cell.find_last_not_of(' ');
    cells.push_back(first == cell.npos ? "" : cell.substr(first, last - first + 1));
  }
  return cells;
}

// The rows of the table, its head first, without the line below that.
std::vector<std::vector<std::string>> table_of(const std::string& text) {
  std::vector<std::vector<std::string>> rows;
  for (const std::string& line : lines_of(text)) {
    if (line.starts_with("|") && !line.starts_with("|--")) rows.push_back(cells_of(line));
  }
  return rows;
}

}  // namespace

TEST_CASE("the median is that of the steps, whatever their order") {
  using pabd::cli::median;
  CHECK(median({}) == 0);
  CHECK(median({3}) == 3);
  CHECK(median({5, 1, 100}) == 5);
  CHECK(median({4, 1, 100, 3}) == 3.5);
}

TEST_CASE("a row a scene with what they did, and the machine above") {
  const CommandFolder folder;
  const Outcome outcome = run_pabd({"bench", "stack", "pendulum", "--steps", "12", "--threads", "1",
                                    "--repeat", "2", "--json", folder / "bench.json"});
  CAPTURE(outcome.out, outcome.err);
  REQUIRE(outcome.exit_code == 0);
  CHECK(outcome.out.starts_with("pabd 0."));
  for (const char* words : {" UTC, 1 thread, 2 repetitions", " cores", "load "})
    CHECK(outcome.out.find(words) != std::string::npos);
  const auto rows = table_of(outcome.out);
  REQUIRE(rows.size() == 3);
  CHECK(rows[0] == std::vector<std::string>{"scene", "bodies", "joints", "solver", "steps", "ms/step",
                                            "CPU ms/step", "iterations a step", "contacts",
                                            "largest overlap, mm", "largest joint error, m",
                                            "kinetic energy at the end, J", "status"});
  for (const auto& row : rows) CHECK(row.size() == 13);
  CHECK(rows[1][0] == "stack");
  CHECK(rows[1][1] == "11");
  CHECK(rows[1][2] == "0");
  CHECK(rows[1][3] == "newton");
  CHECK(rows[1][4] == "12");
  CHECK(rows[1][10] == "–");
  CHECK(rows[2][0] == "pendulum");
  CHECK(rows[2][2] == "2");
  CHECK(rows[2][3] == "newton");
  CHECK(rows[2][12] == "converged 12");

  const json all = json::parse(read_text(folder / "bench.json"));
  CHECK(all["threads"] == 1);
  CHECK(all["repeat"] == 2);
  CHECK(all["cpu"]["cores"].get<int>() >= 1);
  CHECK_FALSE(all["build"].get<std::string>().empty());
  REQUIRE(all["scenes"].size() == 2);
  for (std::size_t k = 0; k < 2; ++k) {
    const json& scene = all["scenes"][k];
    const auto& row = rows[k + 1];
    CAPTURE(scene.dump());
    CHECK(scene["scene"] == row[0]);
    CHECK(std::to_string(scene["bodies"].get<int>()) == row[1]);
    CHECK(scene["steps"] == 12);
    CHECK(scene["solver"] == json{{row[3], 12}});
    CHECK(scene["median_ms"].get<double>() > 0);
    CHECK(scene["median_ms"].get<double>() == Approx(std::stod(row[5])).epsilon(1e-3));
    CHECK(scene["median_cpu_ms"].get<double>() == Approx(std::stod(row[6])).epsilon(1e-3));
    CHECK(scene["mean_ms"].get<double>() > 0);
    CHECK(scene["iterations_a_step"].get<double>() == Approx(std::stod(row[7])).margin(0.051));
    CHECK(1e3 * scene["max_penetration"].get<double>() == Approx(std::stod(row[9])).epsilon(0.01));
    CHECK(scene["kinetic"].get<double>() == Approx(std::stod(row[11])).epsilon(0.01));
    // It is the run that 'pabd run' makes.
    const Outcome run = run_pabd({"run", row[0], "--steps", "12", "--quiet", "--trace", "-", "--state",
                                  folder / "end.json", "--force"});
    CHECK(scene["state"] == json::parse(read_text(folder / "end.json"))["hash"]);
    const auto kinetic = column_of(run.out, "kinetic"), overlaps = column_of(run.out, "max_penetration"),
               errors = column_of(run.out, "max_joint_error");
    REQUIRE(kinetic.size() == 12);
    CHECK(scene["kinetic"] == kinetic.back());
    CHECK(scene["max_penetration"] == *std::max_element(overlaps.begin(), overlaps.end()));
    CHECK(scene["max_joint_error"] == *std::max_element(errors.begin(), errors.end()));
  }
}

TEST_CASE("--solvers measures auto against descent and newton") {
  const CommandFolder folder;
  const Outcome outcome = run_pabd({"bench", "stack", "pendulum", "--steps", "5", "--threads", "1",
                                    "--solvers", "--json", folder / "bench.json"});
  REQUIRE(outcome.exit_code == 0);
  const auto rows = table_of(outcome.out);
  REQUIRE(rows.size() == 1 + 6 + 1 + 2);
  CHECK(rows[1][0] == "stack, auto");
  CHECK(rows[2][0] == "stack, descent");
  CHECK(rows[2][3] == "descent");
  CHECK(rows[6][0] == "pendulum, newton");
  CHECK(rows[6][3] == "newton");
  CHECK(rows[7].back() == "auto / the cheaper");
  for (const std::size_t k : {8u, 9u}) {
    const double cheaper = std::min(std::stod(rows[k][2]), std::stod(rows[k][3]));
    CHECK(std::stod(rows[k][4]) == Approx(std::stod(rows[k][1]) / cheaper).margin(0.02));
  }
  CHECK(json::parse(read_text(folder / "bench.json"))["scenes"][5]["asked"] == "newton");
}

TEST_CASE("--time counts as for 'run', --set holds for every scene, --json - stands in place of the table") {
  const Outcome outcome = run_pabd({"bench", "stack", "two_boxes", "--time", "0.1", "--set", "time_step=0.01",
                                    "--set", "solver.method=sissm", "--quiet", "--json", "-"});
  REQUIRE(outcome.exit_code == 0);
  CHECK(outcome.err.empty());
  const json all = json::parse(outcome.out);
  for (const json& scene : all["scenes"]) {
    CHECK(scene["steps"] == 10);
    CHECK(scene["solver"] == json{{"sissm", 10}});
  }
}

TEST_CASE("without names all shipped scenes are measured") {
  const Outcome outcome = run_pabd({"bench", "--steps", "1", "--quiet"});
  REQUIRE(outcome.exit_code == 0);
  std::string names, listed;
  const auto rows = table_of(outcome.out);
  for (std::size_t k = 1; k < rows.size(); ++k) names += rows[k][0] + "\n";
  for (const json& scene : json::parse(run_pabd({"scenes", "--json"}).out))
    listed += scene["name"].get<std::string>() + "\n";
  CHECK(names == listed);
}

TEST_CASE("what is wrong with the last scene or an option is said before the first step") {
  const CommandFolder folder;
  const std::string out = folder / "bench.json";
  const Outcome name = run_pabd({"bench", "stack", "pendulm", "--json", out});
  CHECK(name.exit_code == 3);
  CHECK(is_error_line(name.err, {"pendulm", "did you mean \"pendulum\"?", "pabd scenes"}));
  write_text(folder / "broken.json", "{");
  CHECK(run_pabd({"bench", "stack", folder / "broken.json", "--json", out}).exit_code == 2);
  const std::vector<std::pair<std::string, std::vector<std::string>>> wrong = {
      {"--steps", {"bench", "stack", "--steps", "0"}},
      {"--repeat", {"bench", "stack", "--repeat", "0"}},
      {"--time", {"bench", "stack", "--time", "0"}},
      {"--time", {"bench", "stack", "--time", "nan"}},
      {"--time", {"bench", "stack", "--time", "1000000"}},
      {"--json", {"bench", folder / "broken.json", "--json", folder / "broken.json"}},
  };
  for (const auto& [word, command] : wrong) {
    CAPTURE(command);
    const Outcome outcome = run_pabd(command);
    CAPTURE(outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.out.empty());
    if (word != "--json") CHECK(is_error_line(outcome.err, {word, "expected"}));
  }
  CHECK(folder.names() == std::vector<std::string>{"broken.json"});
  write_text(out, "mine");
  const Outcome exists = run_pabd({"bench", "stack", "--steps", "1", "--json", out});
  CHECK(exists.exit_code == 2);
  CHECK(is_error_line(exists.err, {"--json", "--force"}));
}

TEST_CASE("a scene that diverges is told of, and the others are measured all the same") {
  // The log barrier has no force for boxes that start inside each other.
  const Outcome outcome =
      run_pabd({"bench", "two_boxes", "spin", "--set", "contact.barrier=log", "--steps", "3", "--quiet"});
  CAPTURE(outcome.out);
  CHECK(outcome.exit_code == 5);
  CHECK(is_error_line(outcome.err, {"two_boxes", "step 1", "diverged"}));
  const auto rows = table_of(outcome.out);
  REQUIRE(rows.size() == 3);
  CHECK(rows[1][12].find("non_finite 1") != std::string::npos);
  CHECK(rows[2][4] == "3");
}

TEST_CASE("an interrupted bench tells what it has") {
  const CommandFolder folder;
  const auto begun = [](const std::string& err) { return err.find(" steps of pile ") != std::string::npos; };
  const Outcome outcome = run_pabd_interrupted(
      {"bench", "spin", "pile", "stack", "--steps", "5000", "--json", folder / "bench.json"}, SIGINT, begun);
  CHECK(outcome.exit_code == 130);
  const auto rows = table_of(outcome.out);
  REQUIRE(rows.size() == 3);
  CHECK(rows[1][4] == "5000");
  CHECK(rows[2][0] == "pile");
  const int steps = std::stoi(rows[2][4]);
  CHECK(steps > 0);
  CHECK(steps < 5000);
  const json all = json::parse(read_text(folder / "bench.json"));
  REQUIRE(all["scenes"].size() == 2);
  CHECK(all["scenes"][1]["steps"] == steps);
}

}  // namespace pabd::test_cli_bench
