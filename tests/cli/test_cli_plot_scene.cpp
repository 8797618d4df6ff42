// SPDX-License-Identifier: MIT
// pabd plot barrier and reactions of a scene.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "render/output/png.h"
#include "tests/cli/program.h"

namespace pabd::test_cli_plot_scene {

using namespace test;

namespace {

// The x and y of the rows that have `words`.
std::vector<std::pair<double, double>> points_of(const std::string& csv, const std::string& words) {
  std::vector<std::pair<double, double>> out;
  for (const std::string& row : lines_of(csv)) {
    if (row.find(words) == row.npos) continue;
    const auto y_at = row.rfind(','), x_at = row.rfind(',', y_at - 1);
    out.emplace_back(std::stod(row.substr(x_at + 1)), std::stod(row.substr(y_at + 1)));
  }
  return out;
}

std::vector<double> heights_of(const std::string& csv, const std::string& words) {
  std::vector<double> out;
  for (const auto& [x, y] : points_of(csv, words)) out.push_back(y);
  return out;
}

void refused(std::vector<std::string> command, const std::vector<std::string>& words) {
  command.insert(command.begin(), "plot");
  command.insert(command.end(), {"-o", "-"});
  const Outcome outcome = run_pabd(command);
  CAPTURE(command, outcome.err);
  CHECK(outcome.exit_code == 2);
  CHECK(is_error_line(outcome.err, words));
}

}  // namespace

TEST_CASE("the law of a scene: every contact of the step stands on the curve of its parameters") {
  const std::vector<std::string> law{"--set", "contact.N=2",    "--set", "contact.kappa=500",
                                     "--set", "contact.onset=0"};
  const CommandFolder folder;
  std::vector<std::string> run{"run",     "two_boxes", "--steps",           "45",
                               "--quiet", "--trace",   folder / "steps.csv"};
  run.insert(run.end(), law.begin(), law.end());
  REQUIRE(run_pabd(run).exit_code == 0);
  const std::string trace = read_text(folder / "steps.csv");
  std::vector<std::string> plot{"plot", "barrier", "two_boxes", "-o", "-", "--at-step", "45"};
  plot.insert(plot.end(), law.begin(), law.end());
  const Outcome outcome = run_pabd(plot);
  CAPTURE(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  const auto energies = points_of(outcome.out, "\"Ψ [J], contacts\""),
             forces = points_of(outcome.out, "\"Ψ′ [N], contacts\"");
  REQUIRE(energies.size() == column_of(trace, "contacts").back());
  REQUIRE(forces.size() == energies.size());
  REQUIRE(energies.size() > 3);
  double most = 0, least = 1;
  for (std::size_t k = 0; k < energies.size(); ++k) {
    const double u = 1 - energies[k].first / 0.05;
    CHECK(energies[k].second == Approx(500 * (u + u * u / 2)).epsilon(1e-12));
    CHECK(forces[k].second == Approx(-500 * (1 + u) / 0.05).epsilon(1e-12));
    most = std::max(most, -forces[k].second);
    least = std::min(least, energies[k].first);
  }
  CHECK(most == Approx(column_of(trace, "max_normal_force").back()).epsilon(1e-9));
  CHECK(least == Approx(column_of(trace, "min_gap").back()).epsilon(1e-12));
}

TEST_CASE("the law of a scene says its parameters, κ as it came out") {
  const CommandFolder folder;
  for (const char* name : {"a.png", "a.svg"})
    CHECK(
        run_pabd({"plot", "barrier", "two_boxes", "-o", folder / name, "--time", "0.5", "--size", "800x500"})
            .exit_code == 0);
  CHECK(pabd::read_png(folder / "a.png").height == 500);
  const std::string svg = read_text(folder / "a.svg");
  for (const char* words : {"step 30", "N = 3", "κ = ", "ε = 0.2", "Ψ [J]"}) {
    CAPTURE(words);
    CHECK(svg.find(words) != std::string::npos);
  }
  refused({"barrier", "two_boxes", "--N", "3"}, {"--N", "SCENE"});
  refused({"barrier", "two_boxes", "--onset", "0"}, {"--onset", "SCENE"});
  refused({"barrier", "--time", "1"}, {"--time", "SCENE"});
  refused({"barrier", "--set", "contact.N=2"}, {"--set", "SCENE"});
  refused({"barrier", "two_boxes", "--at-step", "0"}, {"--at-step 0"});
}

TEST_CASE("reactions are those of --joints, the strongest joints first") {
  const CommandFolder folder;
  REQUIRE(run_pabd({"run", "four_bar", "--steps", "20", "--quiet", "--joints", folder / "joints.csv"})
              .exit_code == 0);
  const std::string rows = read_text(folder / "joints.csv");
  const auto joint = column_of(rows, "joint"), x = column_of(rows, "force_x"), y = column_of(rows, "force_y"),
             z = column_of(rows, "force_z"), error = column_of(rows, "error");
  std::vector<std::vector<double>> force(6), opened(6);
  for (std::size_t k = 0; k < joint.size(); ++k) {
    force.at(static_cast<std::size_t>(joint[k]))
        .push_back(std::sqrt(x[k] * x[k] + y[k] * y[k] + z[k] * z[k]));
    opened.at(static_cast<std::size_t>(joint[k])).push_back(error[k]);
  }
  const Outcome all = run_pabd({"plot", "reactions", "four_bar", "-o", "-", "--steps", "20"});
  CAPTURE(all.err);
  REQUIRE(all.exit_code == 0);
  const auto close = [](const std::vector<double>& a, const std::vector<double>& b) {
    REQUIRE(a.size() == b.size());
    for (std::size_t k = 0; k < a.size(); ++k) CHECK(a[k] == Approx(b[k]).epsilon(1e-14));
  };
  close(heights_of(all.out, "joint,drive,"), force[0]);
  close(heights_of(all.out, "joint,joint 3,"), force[3]);
  close(heights_of(all.out, "together,drive,"), opened[0]);
  // The first row is of the largest force of all.
  double most = 0;
  for (const auto& of : force) most = std::max(most, *std::max_element(of.begin(), of.end()));
  const std::string first = lines_of(all.out).at(1);
  const std::string words = first.substr(0, first.find(',', first.find(',') + 1) + 1);
  const auto strongest = heights_of(all.out, words);
  CHECK(*std::max_element(strongest.begin(), strongest.end()) == Approx(most));

  const Outcome two = run_pabd({"plot", "reactions", "four_bar", "-o", "-", "--steps", "20", "--joint",
                                "joint 3", "--joint", "drive"});
  REQUIRE(two.exit_code == 0);
  CHECK(two.out.find(",joint 3,") < two.out.find(",drive,"));
  CHECK(two.out.find("joint 1") == std::string::npos);
}

TEST_CASE("joints that there are not are refused in one line, with those that there are") {
  refused({"reactions", "four_bar", "--joint", "knee"}, {"--joint knee", "drive", "joint 1"});
  refused({"reactions", "two_boxes"}, {"two_boxes", "no joints"});
  refused({"reactions", "four_bar", "--steps", "0"}, {"--steps 0"});
  refused({"reactions", "four_bar", "--time", "-1"}, {"--time -1"});
}

}  // namespace pabd::test_cli_plot_scene
