// SPDX-License-Identifier: MIT
// pabd plot series: of a scene, and of a trace.
#include <catch2/catch.hpp>
#include <cmath>

#include "render/output/png.h"
#include "tests/cli/program.h"

namespace pabd::test_cli_plot_series {

using namespace test;

namespace {

// y of the series "PLOT,SERIES" of a plot's CSV.
std::vector<double> values_of(const std::string& csv, const std::string& series) {
  std::vector<double> out;
  for (const std::string& row : lines_of(csv))
    if (row.starts_with(series + ",")) out.push_back(std::stod(row.substr(row.rfind(',') + 1)));
  return out;
}

}  // namespace

TEST_CASE("a series has the numbers of the trace, and a trace is drawn as its scene is") {
  const CommandFolder folder;
  REQUIRE(
      run_pabd({"run", "two_boxes", "--time", "0.5", "--quiet", "--trace", folder / "steps.csv"}).exit_code ==
      0);
  const std::string trace = read_text(folder / "steps.csv");
  const Outcome scene = run_pabd({"plot", "series", "two_boxes", "-o", "-", "--time", "0.5"});
  CAPTURE(scene.err);
  REQUIRE(scene.exit_code == 0);
  CHECK(run_pabd({"plot", "series", folder / "steps.csv", "-o", "-"}).out == scene.out);
  CHECK(values_of(scene.out, "Energy,kinetic") == column_of(trace, "kinetic"));
  CHECK(values_of(scene.out, "Contacts,largest penetration") == column_of(trace, "max_penetration"));

  const std::string columns = "max_normal_force,kinetic,total,contacts,iterations";
  const Outcome chosen =
      run_pabd({"plot", "series", "two_boxes", "-o", "-", "--steps", "30", "--columns", columns});
  REQUIRE(chosen.exit_code == 0);
  CHECK(run_pabd({"plot", "series", folder / "steps.csv", "-o", "-", "--columns", columns}).out ==
        chosen.out);
  CHECK(values_of(chosen.out, "Forces,largest f_n [N]") == column_of(trace, "max_normal_force"));
  CHECK(values_of(chosen.out, "Counts,contacts") == column_of(trace, "contacts"));
  const auto total = values_of(chosen.out, "Energies,total energy");
  REQUIRE(total.size() == 30);
  CHECK(total[29] == column_of(trace, "kinetic")[29] + column_of(trace, "potential")[29] +
                         column_of(trace, "elastic")[29]);
  CHECK(values_of(run_pabd({"plot", "series", folder / "steps.csv", "-o", "-", "--columns", "step_ms"}).out,
                  "Times,wall clock [ms]") == column_of(trace, "step_ms"));
}

TEST_CASE("a series is written as a picture of the size that is asked for") {
  const CommandFolder folder;
  for (const char* name : {"a.png", "a.svg", "a.pdf"}) {
    CAPTURE(name);
    const Outcome outcome = run_pabd(
        {"plot", "series", "four_bar", "-o", folder / name, "--time", "0.2", "--log", "--size", "900x400"});
    CAPTURE(outcome.err);
    CHECK(outcome.exit_code == 0);
  }
  CHECK(pabd::read_png(folder / "a.png").width == 900);
  const std::string svg = read_text(folder / "a.svg");
  for (const char* words : {"time [s]", "energy [J]", "largest error [m]", "four-bar linkage", "log axes"}) {
    CAPTURE(words);
    CHECK(svg.find(words) != std::string::npos);
  }
}

TEST_CASE("a file that is no trace, and options that do not fit, are refused in one line") {
  const CommandFolder folder;
  write_text(folder / "short.csv", "step,time,kinetic\n1,0.1,2\n");
  write_text(folder / "bad.csv", "step,time,kinetic\n1,0.1,\x1b[31mred\n");
  write_text(folder / "joints.csv", "name,force_x\na,1\n");
  const auto refused = [&](const std::vector<std::string>& options, int code,
                           const std::vector<std::string>& words) {
    std::vector<std::string> all{"plot", "series"};
    all.insert(all.end(), options.begin(), options.end());
    all.insert(all.end(), {"-o", folder / "x.svg"});
    const Outcome outcome = run_pabd(all);
    CAPTURE(options, outcome.err);
    CHECK(outcome.exit_code == code);
    CHECK(is_error_line(outcome.err, words));
  };
  refused({folder / "short.csv"}, 2, {"no column \"potential\"", "--columns"});
  refused({folder / "short.csv", "--columns", "total"}, 2, {"no column \"potential\""});
  refused({folder / "bad.csv", "--columns", "kinetic"}, 2, {"line 2", "kinetic", "expected a number"});
  refused({folder / "joints.csv"}, 2, {"no column \"time\"", "pabd run --trace"});
  refused({folder / "none.csv"}, 3, {"none.csv"});
  refused({folder / "short.csv", "--columns", "kinetic", "--time", "1"}, 2, {"as it is", "--time"});
  refused({folder / "short.csv", "--columns", "kinetic", "--set", "contact.N=2"}, 2, {"as it is"});
  refused({"two_boxes", "--columns", "mood"}, 2, {"mood", "max_penetration"});
  refused({"two_boxes", "--time", "0"}, 2, {"--time"});
  refused({"two_boxes", "--time", "nan"}, 2, {"--time"});
  refused({"two_boxes", "--steps", "2000000000"}, 2, {"--steps", "1000000"});
  CHECK(run_pabd({"plot", "series", folder / "short.csv", "--columns", "kinetic", "-o", folder / "short.csv",
                  "--force"})
            .exit_code == 2);
  CHECK(read_text(folder / "short.csv").starts_with("step,"));
  CHECK(run_pabd({"plot", "series", folder / "short.csv", "--columns", "kinetic", "-o", folder / "x.svg"})
            .exit_code == 0);
}

}  // namespace pabd::test_cli_plot_series
