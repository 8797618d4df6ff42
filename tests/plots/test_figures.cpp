// SPDX-License-Identifier: MIT
// Figure data against closed forms.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

#include "app/plots/figure.h"
#include "app/plots/figures/barrier_curves.h"
#include "app/plots/figures/contact_pair.h"
#include "app/plots/figures/convergence.h"
#include "app/plots/figures/reactions.h"
#include "app/plots/figures/slider_joint.h"
#include "app/plots/figures/spherical_joint.h"
#include "app/plots/figures/time_panel.h"
#include "sim/scene/scene.h"
#include "tests/plots/printed_barrier.h"
#include "tests/support/places.h"

namespace pabd::test_figures {

namespace {

constexpr double kRelative = 1e-12;

IterationRecord record(double energy, double residual, double before, double after) {
  IterationRecord r{};
  r.energy = energy;
  r.residual = residual;
  r.min_gap_before = before;
  r.min_gap_after = after;
  return r;
}

// Of step 7, converged.
StepReport report_of(const std::vector<IterationRecord>& records) {
  StepReport report;
  report.step = 7;
  report.status = StepStatus::converged;
  report.records = records;
  report.iterations = static_cast<int>(records.size());
  return report;
}

}  // namespace

TEST_CASE("figure 1 shows B_N as printed and its derivative") {
  const Figure figure = figure1();
  REQUIRE(figure.plots.size() == 2);
  const int orders[] = {1, 2, 3, 4, 8};
  for (std::size_t s = 0; s < 5; ++s) {
    const Series& series = figure.plots[0].series[s];
    REQUIRE(series.x.size() > 400);
    for (std::size_t k = 0; k < series.x.size(); k += 37) {
      CHECK(series.y[k] ==
            Approx(printed_sum(orders[s], series.x[k] / 0.01)).epsilon(kRelative).margin(1e-14));
    }
  }
  const double thickness[] = {0.005, 0.01, 0.015, 0.02};
  for (std::size_t s = 0; s < 4; ++s) {
    const Series& series = figure.plots[1].series[s];
    for (std::size_t k = 0; k < series.x.size(); k += 37) {
      const double u = 1 - series.x[k] / thickness[s];
      const double expected = u > 0 ? -(1 + u + u * u) / thickness[s] : 0;
      CHECK(series.y[k] == Approx(expected).epsilon(kRelative).margin(1e-10));
    }
  }
}

TEST_CASE("live barrier plot marks every active contact on both curves") {
  ContactParams contact;
  contact.N = 3;
  contact.d_hat = 0.01;
  contact.onset = 0;
  std::vector<ContactReport> reports(3);
  reports[0].d = 0.005;
  reports[1].d = -0.02;  // deeper than the usual range
  reports[2].d = 0.5;    // not active
  const Plot plot = contact_barrier_plot(contact, reports, [](double x) {
    return Color{x < 0 ? std::uint8_t{1} : std::uint8_t{2}, 0, 0, 255};
  });
  const Series& marks = plot.series[3];
  REQUIRE(marks.x.size() == 2);
  CHECK(marks.y[0] == Approx(0.5 + 0.125 + 0.125 / 3));
  CHECK(plot.series[4].y[0] == Approx(-175.0));
  CHECK(marks.marker_colors[0].r == 2);
  CHECK(marks.marker_colors[1].r == 1);
  CHECK(plot.x.lo < -0.02);
  // The strip counts each of them once, the deepest in its first bars.
  const Series& strip = plot.series.back();
  REQUIRE(strip.style == SeriesStyle::strip);
  CHECK(strip.name == "2 contacts, 1 overlapping");
  CHECK(std::accumulate(strip.y.begin(), strip.y.end(), 0.0) == 2.0);
  for (std::size_t k = 0; k < strip.x.size(); ++k) {
    const bool holds = std::any_of(reports.begin(), reports.end(), [&](const ContactReport& r) {
      return std::abs(r.d - strip.x[k]) < 0.5 * strip.bar_width;
    });
    CAPTURE(strip.x[k]);
    CHECK(holds == (strip.y[k] > 0));
  }
  // On a range that is asked for, as two pictures side by side need it.
  const Plot wide = contact_barrier_plot(
      contact, reports, [](double) { return Color{}; }, PlotRange{-0.05, 0.02});
  CHECK(wide.x.lo == -0.05);
  CHECK(wide.series[0].x.front() == -0.05);
  CHECK(wide.series[0].x.back() == Approx(0.02));
}

TEST_CASE("the law of a scene with its contacts: potential in J, force in N, named in the CSV") {
  ContactParams contact;
  contact.N = 3;
  contact.d_hat = 0.01;
  contact.onset = 0;
  std::vector<ContactReport> reports(1);
  reports[0].d = 0.005;
  const auto grey = [](double) { return Color{}; };
  const Figure figure = contact_barrier_figure(contact, 50, 60, reports, grey);
  CHECK(figure.title == "Contact potential and force law at step 60, printed formula (ε = 0)");
  const Plot& plot = figure.plots.at(0);
  CHECK(plot.y.label == "Ψ [J]");
  CHECK(plot.y_right.label == "Ψ′ [N]");
  CHECK(plot.series[3].y[0] == Approx(50 * (0.5 + 0.125 + 0.125 / 3)));
  CHECK(plot.series[4].y[0] == Approx(50 * -175.0));
  CHECK(figure_to_csv(figure).find("\"Ψ [J], contacts\",0.005,") != std::string::npos);
  // κ of the log barrier is in J/m²: Ψ = −κ (d − d̂)² ln(d/d̂).
  contact.barrier = BarrierKind::log;
  const Figure log = contact_barrier_figure(contact, 1e6, 60, reports, grey);
  CHECK(log.title == "Contact potential and force law at step 60");
  CHECK(log.plots[0].series[3].y[0] == Approx(1e6 * 2.5e-5 * std::log(2.0)));
}

TEST_CASE("reactions: the strongest joints first, each with a look of its own") {
  std::vector<JointSeries> joints;
  for (int k = 0; k < 10; ++k)
    joints.push_back({"joint " + std::to_string(k), {1.0 * (k * 7 % 10), 0.5}, {1e-9, 2e-9}});
  keep_strongest(joints, 8);
  const Figure figure = reactions_figure({0.1, 0.2}, joints);
  REQUIRE(figure.plots.size() == 2);
  CHECK(figure.plots[0].y.label == "force [N]");
  CHECK(figure.plots[1].y.label == "error [m]");
  CHECK(figure.plots[1].y.log);
  REQUIRE(figure.plots[0].series.size() == 8);
  std::set<std::pair<int, int>> looks;
  for (std::size_t k = 0; k < 8; ++k) {
    CHECK(figure.plots[0].series[k].y[0] == 9.0 - static_cast<double>(k));
    CHECK(figure.plots[1].series[k].name == figure.plots[0].series[k].name);
    CHECK(looks.insert({figure.plots[0].series[k].color, figure.plots[0].series[k].dash}).second);
  }
  CHECK(figure.plots[1].series[0].y == std::vector<double>{1e-9, 2e-9});
}

TEST_CASE("convergence figure: gaps above the minimum, penetration with its sign") {
  const std::vector<MethodRun> runs{{"sissm", {record(3, 1, 0.2, 0.1), record(2, 0.5, 0.3, 0.15)}},
                                    {"descent", {record(2, 1, 0.1, 0.1), record(1, 0.1, 0.2, 0.2)}}};
  const Figure figure = convergence_figure(runs, Minimiser{0.5, 0.25});
  REQUIRE(figure.plots.size() == 3);
  CHECK(figure.plots[0].series[0].y == std::vector<double>{2.5, 1.5});
  CHECK(figure.plots[0].series[0].x == std::vector<double>{1, 2});
  CHECK(figure.plots[1].series[1].y == std::vector<double>{1, 0.1});
  // after and before for sissm, one curve for descent, the level.
  REQUIRE(figure.plots[2].series.size() == 4);
  CHECK(figure.plots[2].series[0].y == std::vector<double>{-0.1, -0.15});
  CHECK(figure.plots[2].series[1].y == std::vector<double>{-0.2, -0.3});
  CHECK(figure.plots[2].series[3].y == std::vector<double>{-0.25});
  // What solved a softened step has an E of its own, and says so.
  std::vector<MethodRun> two = runs;
  two[0].records.push_back(record(0.25, 0.1, 0.1, 0.1));
  two[0].softened = 71;
  const Figure apart = convergence_figure(two, Minimiser{0.5, 0.25});
  REQUIRE(apart.plots.size() == 4);
  REQUIRE(apart.plots[0].series.size() == 1);
  CHECK(apart.plots[0].series[0].name == "descent");
  CHECK(apart.plots[0].series[0].y == std::vector<double>{1.5, 0.5});
  CHECK(apart.plots[1].title == "Energy gap with 71 bonds softened");
  CHECK(apart.plots[1].y.label == "E − E_{end} [J]");
  REQUIRE(apart.plots[1].series.size() == 1);
  CHECK(apart.plots[1].series[0].name == "sissm");
  CHECK(apart.plots[1].series[0].y[1] == 1.75);
  CHECK(apart.plots[2].series.size() == 2);
  CHECK(apart.caption.find("E_{min} = 0.5 J") != std::string::npos);
  CHECK(apart.caption.find("sissm softened 71 bonds: its E is another function") != std::string::npos);
  // Without a reference the least value is the minimum and leaves the log axis.
  const Figure own = convergence_figure(runs, std::nullopt);
  CHECK(own.plots[0].series[1].y[0] == 1);
  CHECK(std::isnan(own.plots[0].series[1].y[1]));
}

TEST_CASE("E minus E_min is never negative: it is measured from what solves end with") {
  // Friction bounds that are not right yet: the second iteration lies below the minimum of the step.
  const std::vector<IterationRecord> records{record(4, 1, 0.1, 0.1), record(0.9, 0.5, 0.1, 0.1),
                                             record(1.5, 0.1, 0.1, 0.1), record(1, 0.01, 0.1, 0.1)};
  const auto gaps = [&](const std::optional<Minimiser>& minimiser) {
    return convergence_figure({{"descent", records}}, minimiser).plots[0].series[0].y;
  };
  const auto at_reference = gaps(Minimiser{1, 0.1});
  CHECK(at_reference[0] == 3);
  CHECK(std::isnan(at_reference[1]));
  CHECK(at_reference[2] == 0.5);
  CHECK(std::isnan(at_reference[3]));
  CHECK(gaps(Minimiser{0.75, 0.1}) == std::vector<double>{3.25, 0.15000000000000002, 0.75, 0.25});
  // A reference that a solve gets below is none, and is not called the minimum.
  const Figure below = convergence_figure({{"descent", records}}, Minimiser{1.25, 0.1});
  CHECK(below.plots[0].series[0].y[0] == 3);
  CHECK(below.plots[0].y.label == "E − E_{end} [J]");
  CHECK(below.caption.find("minimum") == std::string::npos);
  const Figure above = convergence_figure({{"descent", records}}, Minimiser{1, 0.1});
  CHECK(above.plots[0].y.label == "E − E_{min} [J]");
  CHECK(above.caption.find("minimum") != std::string::npos);
  const Plot live = convergence_plot(report_of(records));
  CHECK(live.series[0].y[0] == 3);
  CHECK(std::isnan(live.series[0].y[1]));
}

TEST_CASE("the live convergence plot of a step without iterations says why it has no curves") {
  StepReport report = report_of({});
  CHECK(convergence_plot(report).none == "no iterations: nothing touches");
  report.contacts = 4;
  CHECK(convergence_plot(report).none == "no iterations: all bodies rest");
  report.iterations = 3;  // not recorded
  CHECK(convergence_plot(report).none == "no data");
  report.iterations = 0;
  report.status = StepStatus::non_finite;
  CHECK(convergence_plot(report).none == "no data");
}

TEST_CASE("convergence with joints: their error in a plot of its own, contacts only where there are any") {
  constexpr double inf = std::numeric_limits<double>::infinity();
  std::vector<IterationRecord> records{record(3, 1, inf, inf), record(2, 0.5, inf, inf)};
  records[0].max_joint_error = 1e-3;
  records[1].max_joint_error = 1e-6;
  const Figure hanging = convergence_figure({{"newton", records}}, std::nullopt);
  REQUIRE(hanging.plots.size() == 3);
  CHECK(hanging.columns == 3);
  CHECK(hanging.plots[2].title == "Joints");
  CHECK(hanging.plots[2].y.log);
  CHECK(hanging.plots[2].series[0].y == std::vector<double>{1e-3, 1e-6});
  records[1].min_gap_after = records[1].min_gap_before = 0.1;
  const Figure touching = convergence_figure({{"newton", records}}, std::nullopt);
  REQUIRE(touching.plots.size() == 4);
  CHECK(touching.columns == 2);
  CHECK(touching.plots[2].title == "Deepest contact");
  // The live plot does not change its curves from step to step.
  CHECK(convergence_plot(report_of(records)).series.size() == 4);
  const Plot live = convergence_plot(report_of(records), true);
  REQUIRE(live.series.size() == 5);
  CHECK(live.series[4].y == std::vector<double>{1e-3, 1e-6});
}

TEST_CASE("figure 7: its curves stay apart, the weighted one at the minimum, and its caption says why") {
  const Scene scene = load_scene(std::string(places::scenes()) + "/two_boxes.json");
  const Figure figure = figure7(scene.model, scene.params, scene.initial, 40);
  const std::vector<Series>& curves = figure.plots.at(0).series;
  REQUIRE(curves.size() == 5);
  const auto end = [&](std::size_t k) { return curves[k].y.back(); };
  for (const std::size_t before : {0, 2}) {
    const std::vector<double>& y = curves[before].y;
    CHECK(y.back() == Approx(y[y.size() - 2]).epsilon(1e-6));  // flat
    CHECK(end(before + 1) - end(before) > 0.01);
  }
  CHECK(end(3) == Approx(end(4)).epsilon(1e-4));
  CHECK(figure.caption.find("stay apart by what the contact force squeezes") != std::string::npos);
}

TEST_CASE("time series with joints: their error beside the penetration, on a logarithmic axis") {
  std::vector<StepSummary> reports(2);
  reports[0].max_joint_error = 2e-9;
  reports[1].max_joint_error = 3e-9;
  const Figure figure = time_series_figure(reports);
  REQUIRE(figure.plots.size() == 3);
  CHECK(figure.plots[2].series[0].y == std::vector<double>{2e-9, 3e-9});
  reports[1].max_penetration = 1e-4;
  const Plot live = time_series_plot(reports, 0.01, true);
  CHECK(live.y.log);
  REQUIRE(live.series.size() == 4);
  CHECK(live.series[3].y == std::vector<double>{2e-9, 3e-9});
  CHECK_FALSE(live.series[3].right_axis);
  const Plot free = time_series_plot(reports, 0.01);
  CHECK_FALSE(free.y.log);
  CHECK(free.series.size() == 3);
}

TEST_CASE("time series: no axis for what never was") {
  std::vector<StepSummary> reports(2);
  reports[0].time = 0.1;
  reports[1].time = 0.2;
  reports[1].kinetic = 3;
  const Plot energies = time_series_plot(reports, 0.01, true);
  REQUIRE(energies.series.size() == 2);
  CHECK(energies.y.label == "energy [J]");
  CHECK(energies.y_right.label.empty());
  for (const Series& series : energies.series) CHECK_FALSE(series.right_axis);

  std::vector<StepSummary> joint = reports;
  joint[1].max_joint_error = 1e-9;
  CHECK(time_series_plot(joint, 0.01, true).y.label == "largest error [m]");

  // What only the other run has needs its axis too, and both runs stand on the same ones.
  std::vector<StepSummary> deep = reports;
  deep[1].max_penetration = 1e-3;
  const Plot two = time_series_plot(reports, 0.01, false, deep);
  REQUIRE(two.series.size() == 6);
  CHECK(two.y.label == "penetration [m]");
  for (const std::size_t k : {0, 1, 2}) {
    CHECK(two.series[k].right_axis == two.series[k + 3].right_axis);
    CHECK(two.series[k].color == two.series[k + 3].color);
    CHECK(two.series[k + 3].style == SeriesStyle::dashed);
  }
}

TEST_CASE("time series: potential energy counts from its first value") {
  std::vector<StepSummary> reports(2);
  reports[0].time = 0.1;
  reports[0].potential = 100;
  reports[0].kinetic = 1;
  reports[1].time = 0.2;
  reports[1].potential = 90;
  reports[1].kinetic = 8;
  reports[1].elastic = 1;
  const Figure figure = time_series_figure(reports);
  CHECK(figure.plots[1].series[1].y == std::vector<double>{0, -10});
  CHECK(figure.plots[1].series[3].y == std::vector<double>{1, -1});
}

TEST_CASE("figure 3: points of a spherical joint as S(8) and S(9) say") {
  const SphericalJoint joint{{1, 2}, {0.5, 0}, 0.7, 0.2, 0.5};
  // R_i r_1 at 0.7 rad, R(θ) R_j r_1 at 0.5 + 0.2: the bond is met.
  const SphericalJointPoints at = spherical_joint_points(joint);
  CHECK((at.y_i1 - Vec2(1 + 0.5 * std::cos(0.7), 2 + 0.5 * std::sin(0.7))).norm() < 1e-15);
  CHECK((at.y_i1 - at.y_j1).norm() < 1e-15);
  CHECK((at.y_i2 - at.y_j2).norm() < 1e-15);
  CHECK((at.y_i1 + at.y_i2 - 2 * joint.y_0).norm() < 1e-15);  // equidistant
  // The shipped figure shows a gap: a chord of α_i − α_j − θ.
  const SphericalJoint shipped;
  const SphericalJointPoints gap = spherical_joint_points(shipped);
  CHECK((gap.y_i1 - gap.y_j1).norm() ==
        Approx(2 * std::sin(0.5 * (shipped.angle_i - shipped.angle_j - shipped.theta))));
  CHECK((gap.y_i2 - gap.y_j2).norm() == Approx((gap.y_i1 - gap.y_j1).norm()));
}

TEST_CASE("figure 4: points of a slider joint as S(14-16) say") {
  const SliderJoint joint;
  const SliderJointPoints at = slider_joint_points(joint);
  CHECK(at.n_j.norm() == Approx(1));
  CHECK(((joint.y_i0 - at.p_j0).dot(at.n_j)) == Approx(0).margin(1e-15));  // a projection
  CHECK((at.p_j0 - joint.y_j0).norm() == Approx(at.lambda));
  CHECK((at.p_j1 - at.y_j1 - at.lambda * at.n_j).norm() < 1e-15);
  CHECK((at.p_j2 - at.y_j2 - at.lambda * at.n_j).norm() < 1e-15);
  CHECK((0.5 * (at.y_i1 + at.y_i2) - joint.y_i0).norm() < 1e-15);
  // A carriage on the line meets its bonds, wherever it is.
  SliderJoint met = joint;
  met.angle_i = met.angle_j;
  met.y_i0 = met.y_j0 - 3 * at.n_j;
  const SliderJointPoints on = slider_joint_points(met);
  CHECK(on.lambda == Approx(-3));
  CHECK((on.y_i1 - on.p_j1).norm() < 1e-14);
  CHECK((on.y_i2 - on.p_j2).norm() < 1e-14);
}

TEST_CASE("figure 5: projections split the offset into normal and tangential parts") {
  const ContactPair pair;
  const ContactProjection at = project_contact(pair.y_i, pair.y_j, pair.n);
  const Vec2 n = pair.n.normalized();
  CHECK(at.d > 0);
  CHECK(at.d < pair.d_hat);
  CHECK((at.normal - pair.y_i).dot(n) == Approx(at.d));
  CHECK(std::abs((at.normal - pair.y_j).dot(n)) < 1e-15);
  CHECK(std::abs((at.tangential - pair.y_i).dot(n)) < 1e-15);
  CHECK((at.normal + at.tangential - pair.y_i - pair.y_j).norm() < 1e-15);
  CHECK(project_contact({1, 2}, {4, -1}, {0, 2}).d == Approx(-3));
}

}  // namespace pabd::test_figures
