// SPDX-License-Identifier: MIT
// What panels say in place of a plot.
#include <catch2/catch.hpp>

#include "app/gui/panel_plots.h"

namespace pabd::test_panel_words {

TEST_CASE("a step whose iterations nobody recorded did not touch nothing") {
  StepReport report;
  CHECK(why_no_curve(report, false).find("No step yet") == 0);
  report.step = 7;
  report.status = StepStatus::converged;
  CHECK(why_no_curve(report, false) == "Step 7: no iterations: nothing touches.");
  CHECK(why_no_curve(report, true).find("GPU") != std::string::npos);
  report.contacts = 3;
  CHECK(why_no_curve(report, false) == "Step 7: no iterations: all bodies rest.");
  report.contacts = 0;
  report.iterations = 2;  // joints alone
  CHECK(why_no_curve(report, false).find("not recorded") != std::string::npos);
}

TEST_CASE("the overview of convergence tells of curves that are held and not shown") {
  Snapshot sim;
  sim.a.model = std::make_shared<Model>();
  UiState ui;
  ui.convergence = "all";
  CHECK(convergence_panels_of(sim, ui).front().title.empty());
  sim.held.resize(2);
  CHECK(convergence_panels_of(sim, ui).front().title == "2 held curves not shown: choose one quantity");
}

}  // namespace pabd::test_panel_words
