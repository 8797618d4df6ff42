// SPDX-License-Identifier: MIT
// pabd plot, figure and compare.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "render/output/png.h"
#include "tests/cli/program.h"

namespace pabd::test_cli_plot {

using namespace test;

TEST_CASE("the barrier CSV holds B_N of the closed form") {
  const Outcome csv = run_pabd({"plot", "barrier", "-o", "-", "--N", "3", "--d-hat", "0.02", "--onset", "0"});
  REQUIRE(csv.exit_code == 0);
  const auto rows = lines_of(csv.out);
  CHECK(rows.at(0) == "plot,series,x,y");
  int checked = 0;
  const std::string first_plot = rows.at(1).substr(0, rows.at(1).find(','));
  for (const std::string& row : rows) {
    // Value curve: "plot,series,x,y" of the first plot.
    if (!row.starts_with(first_plot + ",") || row.front() == '"') continue;
    const auto y_at = row.rfind(',');
    const auto x_at = row.rfind(',', y_at - 1);
    const std::string x_text = row.substr(x_at + 1, y_at - x_at - 1);
    if (x_text.empty() || y_at + 1 == row.size()) continue;
    const double u = std::max(0.0, 1 - std::stod(x_text) / 0.02);
    CHECK(std::stod(row.substr(y_at + 1)) ==
          Approx(u + u * u / 2 + u * u * u / 3).epsilon(1e-12).margin(1e-15));
    ++checked;
  }
  CHECK(checked > 100);
}

TEST_CASE("without --onset the barrier that runs use is drawn") {
  const auto drawn = [](const std::vector<std::string>& onset) {
    std::vector<std::string> all{"plot", "barrier", "-o", "-", "--N", "3"};
    all.insert(all.end(), onset.begin(), onset.end());
    return run_pabd(all).out;
  };
  CHECK(drawn({}) == drawn({"--onset", "0.2"}));
  CHECK(drawn({}) != drawn({"--onset", "0"}));
  CHECK(run_pabd({"plot", "barrier", "-o", "-", "--format", "svg"}).out.find("ε = 0.2") != std::string::npos);
}

TEST_CASE("a barrier plot is written as PNG, SVG and CSV") {
  const CommandFolder folder;
  for (const char* name : {"a.png", "a.svg", "a.csv"}) {
    CAPTURE(name);
    const Outcome outcome = run_pabd({"plot", "barrier", "-o", folder / name, "--kind", "polynomial,log,even",
                                      "--d-hat", "0.01,0.02", "--kappa", "50", "--onset", "0.2"});
    CAPTURE(outcome.err);
    CHECK(outcome.exit_code == 0);
  }
  CHECK(pabd::read_png(folder / "a.png").width > 600);
  CHECK(pabd::read_png_text(folder / "a.png").at("Software").starts_with("pabd"));
  const std::string svg = read_text(folder / "a.svg");
  CHECK(svg.find("<svg") != std::string::npos);
  CHECK(svg.find("</svg>") != std::string::npos);
  CHECK(run_pabd({"plot", "barrier", "-o", "-", "--format", "svg", "--kind", "polynomial,log,even", "--d-hat",
                  "0.01,0.02", "--kappa", "50", "--onset", "0.2"})
            .out == svg);
  REQUIRE(run_pabd({"plot", "barrier", "-o", folder / "b.png", "--size", "900x500"}).exit_code == 0);
  CHECK(pabd::read_png(folder / "b.png").height == 500);
}

TEST_CASE("a barrier without a term of its order is refused, not drawn as 0") {
  const CommandFolder folder;
  const Outcome none = run_pabd({"plot", "barrier", "-o", folder / "b.svg", "--kind", "even", "--N", "1"});
  CHECK(none.exit_code == 2);
  CHECK(is_error_line(none.err, {"--N 1", "even", "2 or more"}));
  CHECK(run_pabd({"plot", "barrier", "-o", folder / "b.svg", "--kind", "even", "--N", "1,2"}).exit_code == 0);
}

TEST_CASE("a plot is a PDF too, and light on dark") {
  const CommandFolder folder;
  CHECK(run_pabd({"plot", "barrier", "-o", folder / "a.pdf"}).exit_code == 0);
  CHECK(read_text(folder / "a.pdf").starts_with("%PDF-1."));
  CHECK(run_pabd({"figure", "5", "-o", "-", "--format", "pdf"}).out.starts_with("%PDF-1."));
  REQUIRE(run_pabd({"plot", "barrier", "-o", folder / "d.png", "--style", "screen"}).exit_code == 0);
  REQUIRE(run_pabd({"plot", "barrier", "-o", folder / "l.png"}).exit_code == 0);
  CHECK(pabd::read_png(folder / "d.png").rgb[0] < 0x40);
  CHECK(pabd::read_png(folder / "l.png").rgb[0] == 0xFF);
  const Outcome drawing = run_pabd({"figure", "5", "-o", folder / "x.svg", "--style", "screen"});
  CHECK(drawing.exit_code == 2);
  CHECK(drawing.err.find("on white") != std::string::npos);
}

TEST_CASE("a barrier against its thickness") {
  const Outcome csv = run_pabd({"plot", "barrier", "-o", "-", "--against", "d-hat", "--N", "3", "--onset",
                                "0", "--d-hat", "0.01", "--gap", "0.004"});
  REQUIRE(csv.exit_code == 0);
  int marked = 0;
  for (const std::string& row : lines_of(csv.out)) {
    if (row.find("marked,0.01,") == std::string::npos || marked++ > 0) continue;
    // u = 0.6: 0.6 + 0.18 + 0.072
    CHECK(std::stod(row.substr(row.rfind(',') + 1)) == Approx(0.852));
  }
  CHECK(marked == 2);
  const auto error_of = [](const std::vector<std::string>& options) {
    std::vector<std::string> all{"plot", "barrier", "-o", "-"};
    all.insert(all.end(), options.begin(), options.end());
    const Outcome outcome = run_pabd(all);
    CHECK(outcome.exit_code == 2);
    return outcome.err;
  };
  CHECK(error_of({"--against", "colour"}).find("d-hat") != std::string::npos);
  CHECK(error_of({"--against", "kappa"}).find("--kappa") != std::string::npos);
  CHECK(error_of({"--gap", "0.001"}).find("--against") != std::string::npos);
  CHECK(error_of({"--N", "1,2", "--d-hat", "0.01,0.02", "--kappa", "1,2,3,4,5,6,7,8,9,10,11,12,13"})
            .find("rows") != std::string::npos);
}

TEST_CASE("the convergence plot has a line a method") {
  const Outcome both = run_pabd({"plot", "convergence", "two_boxes", "-o", "-", "--iterations", "30"});
  REQUIRE(both.exit_code == 0);
  CHECK(both.out.find("sissm") != std::string::npos);
  CHECK(both.out.find("descent") != std::string::npos);
  const Outcome one = run_pabd({"plot", "convergence", "two_boxes", "-o", "-", "--iterations", "30",
                                "--method", "descent", "--at-step", "4"});
  REQUIRE(one.exit_code == 0);
  CHECK(one.out.find("sissm") == std::string::npos);
  const CommandFolder folder;
  CHECK(run_pabd({"plot", "convergence", "two_boxes", "-o", folder / "c.png", "--iterations", "30"})
            .exit_code == 0);
  CHECK(pabd::read_png(folder / "c.png").width > 600);
}

TEST_CASE("with joints the convergence plot has newton and the joint error") {
  const Outcome all = run_pabd({"plot", "convergence", "pendulum", "-o", "-", "--iterations", "10"});
  REQUIRE(all.exit_code == 0);
  for (const char* words : {"Joints,sissm,", "Joints,descent,", "Joints,newton,1,", "Joints,newton,10,"}) {
    CHECK(all.out.find(words) != std::string::npos);
  }
  const Outcome two_boxes =
      run_pabd({"plot", "convergence", "two_boxes", "-o", "-", "--iterations", "10", "--method", "newton"});
  CHECK(two_boxes.exit_code == 0);
  CHECK(two_boxes.out.find("Joints") == std::string::npos);
  CHECK(run_pabd({"plot", "convergence", "pendulum", "-o", "-", "--method", "auto"}).exit_code == 2);
}

TEST_CASE("all figures of the supplement are drawn") {
  const CommandFolder folder;
  for (const char* number : {"1", "2", "3", "4", "5", "6", "7"}) {
    CAPTURE(number);
    const Outcome outcome = run_pabd({"figure", number, "-o", (folder / "figure") + number + ".png"});
    CAPTURE(outcome.err);
    CHECK(outcome.exit_code == 0);
  }
  CHECK(folder.names().size() == 7);
  CHECK(pabd::read_png(folder / "figure2.png").width == 1600);
  CHECK(pabd::read_png_text(folder / "figure6.png").count("Scene hash") == 1);
  for (const char* number : {"3", "4", "5"}) {
    CHECK(run_pabd({"figure", number, "-o", (folder / "figure") + number + ".svg"}).exit_code == 0);
    CHECK(lines_of(run_pabd({"figure", number, "-o", "-"}).out).at(0) == "point,x,y");
  }
  CHECK(run_pabd({"figure", "7", "-o", "-"}).out.find("polar") != std::string::npos);
}

TEST_CASE("compare tells equal from different by its exit code") {
  const CommandFolder folder;
  const auto render = [&](const char* name, const char* time) {
    REQUIRE(
        run_pabd({"render", "two_boxes", "--size", "160x90", "--quiet", "--time", time, "-o", folder / name})
            .exit_code == 0);
  };
  render("a.png", "0");
  render("b.png", "0");
  render("c.png", "0.3");

  CHECK(run_pabd({"compare", folder / "a.png", folder / "b.png"}).exit_code == 0);
  const Outcome differ =
      run_pabd({"compare", folder / "a.png", folder / "c.png", "--diff", folder / "d.png"});
  CHECK(differ.exit_code == 7);
  CHECK(differ.err.empty());
  CHECK(differ.out.starts_with("different (tier same): "));
  CHECK(line_count(differ.out) == 1);
  CHECK(pabd::read_png(folder / "d.png").width == 160);
  CHECK(run_pabd({"compare", folder / "a.png", folder / "c.png", "--diff", folder / "d.png"}).exit_code == 2);
  CHECK(run_pabd({"compare", folder / "a.png", folder / "c.png", "--quiet"}).out.empty());

  const auto json =
      nlohmann::json::parse(run_pabd({"compare", folder / "a.png", folder / "c.png", "--json"}).out);
  CHECK_FALSE(json["equal"].get<bool>());
  CHECK_FALSE(json["reason"].get<std::string>().empty());

  // Pictures of different, known renderer classes are compared across classes without being told so.
  const pabd::Image image = pabd::read_png(folder / "a.png");
  pabd::write_png(folder / "x.png", image, {{"GL_RENDERER", "softpipe"}});
  pabd::write_png(folder / "y.png", image, {{"GL_RENDERER", "llvmpipe (LLVM 15.0.6, 256 bits)"}});
  CHECK(run_pabd({"compare", folder / "x.png", folder / "y.png"}).out.starts_with("equal (tier cross"));

  write_text(folder / "text.png", "no picture");
  CHECK(run_pabd({"compare", folder / "a.png", folder / "text.png"}).exit_code == 2);
  CHECK(run_pabd({"compare", folder / "a.png", folder / "none.png"}).exit_code == 3);
}

TEST_CASE("E minus E_min of a converged solve falls to rounding and is never negative") {
  // Bodies that slide: the friction bounds change while a step is solved, and E with them.
  for (const auto& [scene, step] : std::vector<std::pair<const char*, const char*>>{
           {"incline", "1"}, {"incline", "30"}, {"stack", "20"}, {"shapes", "224"}}) {
    CAPTURE(scene, step);
    const Outcome csv =
        run_pabd({"plot", "convergence", scene, "-o", "-", "--at-step", step, "--method", "descent"});
    REQUIRE(csv.exit_code == 0);
    std::vector<double> gaps;
    for (const std::string& row : lines_of(csv.out)) {
      if (row.starts_with("Energy gap,descent,")) gaps.push_back(std::stod(row.substr(row.rfind(',') + 1)));
    }
    REQUIRE(gaps.size() > 5);
    for (const double gap : gaps) CHECK_FALSE(gap < 0);
    CHECK_FALSE(gaps.back() > 1e-9);  // J; NaN is within rounding
  }
}

}  // namespace pabd::test_cli_plot
