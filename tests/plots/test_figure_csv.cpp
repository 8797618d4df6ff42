// SPDX-License-Identifier: MIT
// A figure as CSV reads back to the very same numbers.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <sstream>

#include "app/plots/figure.h"

namespace pabd::test_figure_csv {

TEST_CASE("CSV holds every point, exactly") {
  Figure figure;
  Plot plot;
  plot.title = "Barrier B_{N}(d), \"printed\"";
  Series series;
  series.name = "N = 3";
  series.x = {0.1, 1.0 / 3, 1e-300, -5};
  series.y = {std::nextafter(1.0, 2.0), 2.5e17, std::numeric_limits<double>::infinity(),
              std::numeric_limits<double>::quiet_NaN()};
  plot.series.push_back(series);
  Series level;
  level.name = "level";
  level.style = SeriesStyle::level;
  level.y = {0.25};
  plot.series.push_back(level);
  figure.plots.push_back(plot);

  std::istringstream in(figure_to_csv(figure));
  std::string line;
  std::getline(in, line);
  CHECK(line == "plot,series,x,y");
  const std::string prefix = "\"Barrier B_N(d), \"\"printed\"\"\",N = 3,";
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    REQUIRE(std::getline(in, line));
    REQUIRE(line.substr(0, prefix.size()) == prefix);
    const std::string numbers = line.substr(prefix.size());
    const std::size_t comma = numbers.find(',');
    CHECK(std::strtod(numbers.c_str(), nullptr) == series.x[i]);
    const double y = std::strtod(numbers.c_str() + comma + 1, nullptr);
    CHECK((y == series.y[i] || (std::isnan(y) && std::isnan(series.y[i]))));
  }
  REQUIRE(std::getline(in, line));
  CHECK(line.substr(line.size() - 12) == ",level,,0.25");
  CHECK_FALSE(std::getline(in, line));
}

}  // namespace pabd::test_figure_csv
