// SPDX-License-Identifier: MIT
// The barrier panel against d̂, N and κ, against closed forms.
#include <catch2/catch.hpp>
#include <cmath>

#include "app/plots/figures/barrier_over.h"
#include "tests/plots/printed_barrier.h"

namespace pabd::test_barrier_over {

namespace {

ContactParams printed(int N, double d_hat) {
  ContactParams contact;
  contact.N = N;
  contact.d_hat = d_hat;
  contact.onset = 0;
  return contact;
}

std::vector<ContactReport> contacts_at(const std::vector<double>& gaps) {
  std::vector<ContactReport> out;
  for (const double d : gaps) {
    ContactReport report{};
    report.y_a = report.y_b = report.n = report.friction = Vec3::Zero();
    report.d = d;
    out.push_back(report);
  }
  return out;
}

}  // namespace

TEST_CASE("typical gaps: the deepest, the middle, and nine tenths; equal ones once") {
  std::vector<double> gaps;
  for (int k = 0; k < 100; ++k) gaps.push_back(0.009 - 1e-4 * k);
  gaps.push_back(0.5);  // not active
  const auto typical = typical_gaps(0.01, contacts_at(gaps));
  REQUIRE(typical.size() == 3);
  CHECK(typical[0].d == Approx(0.009 - 99e-4));
  CHECK(typical[1].d == Approx(0.009 - 49e-4));
  CHECK(typical[2].d == Approx(0.009 - 9e-4));
  CHECK(typical_gaps(0.01, contacts_at({0.004, 0.004, 0.004})).size() == 1);
  const auto none = typical_gaps(0.01, {});
  REQUIRE(none.size() == 3);
  CHECK(none[1].d == 0);
}

TEST_CASE("against d̂, N and κ each curve is Ψ at its gap, and the present value is marked on it") {
  const ContactParams contact = printed(3, 0.01);
  const std::vector<double> gaps{-0.002, 0.003, 0.006};
  const double kappa = 70;
  for (const auto abscissa : {BarrierAbscissa::d_hat, BarrierAbscissa::order, BarrierAbscissa::kappa}) {
    CAPTURE(static_cast<int>(abscissa));
    const BarrierPanel panel = barrier_over(contact, kappa, contacts_at(gaps), abscissa, {});
    CHECK(panel.contacts == 3);
    REQUIRE(panel.plot.series.size() == 7);
    for (std::size_t c = 0; c < 3; ++c) {
      const Series &curve = panel.plot.series[c], &mark = panel.plot.series[4 + c];
      const auto expected = [&](double x) {
        switch (abscissa) {
          case BarrierAbscissa::d_hat:
            return kappa * printed_sum(3, gaps[c] / x);
          case BarrierAbscissa::order:
            return kappa * printed_sum(static_cast<int>(x), gaps[c] / 0.01);
          default:
            return x * printed_sum(3, gaps[c] / 0.01);
        }
      };
      for (std::size_t k = 0; k < curve.x.size(); ++k)
        CHECK(curve.y[k] == Approx(expected(curve.x[k])).epsilon(1e-9).margin(1e-9));
      CHECK(mark.color == curve.color);
      REQUIRE(mark.y.size() == 1);
      CHECK(mark.y[0] == Approx(kappa * printed_sum(3, gaps[c] / 0.01)));
      CHECK(mark.y[0] < panel.plot.y.hi);
    }
    const double now = abscissa == BarrierAbscissa::d_hat   ? 0.01
                       : abscissa == BarrierAbscissa::order ? 3
                                                            : 70;
    CHECK(panel.plot.series[3].x == std::vector<double>{now});
    // Only against d̂ can the line be taken hold of.
    CHECK(std::isnan(panel.d_hat) == (abscissa != BarrierAbscissa::d_hat));
    CHECK_FALSE(panel.kappa);
  }
}

TEST_CASE("slopes, logarithms and bare barriers against d̂") {
  const ContactParams contact = printed(2, 0.02);
  BarrierPanelOptions options;
  options.quantity = BarrierQuantity::slope;
  options.log_y = true;
  options.energy = false;
  const BarrierPanel panel = barrier_over(contact, 5, contacts_at({0.004}), BarrierAbscissa::d_hat, options);
  CHECK(panel.plot.y.log);
  CHECK(panel.plot.y.label == "−B_{N}′ [1/m]");
  const Series& curve = panel.plot.series[0];
  for (std::size_t k = 0; k < curve.x.size(); k += 11) {
    const double x = 0.004 / curve.x[k];
    if (std::abs(x - 1) < 1e-9) continue;
    CHECK(curve.y[k] == Approx(x < 1 ? (1 + (1 - x)) / curve.x[k] : 0).margin(1e-9));
  }
}

}  // namespace pabd::test_barrier_over
