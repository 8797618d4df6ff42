// SPDX-License-Identifier: MIT
// The SVG is well-formed XML and holds the texts.
#include <catch2/catch.hpp>

#include "app/plots/figure.h"
#include "app/plots/figures/barrier_curves.h"
#include "app/plots/figures/contact_pair.h"

namespace pabd::test_svg {

namespace {

// Tags open and close in order; attributes are quoted; no stray "<" or "&" in text. Enough XML for our own
// files.
bool well_formed(const std::string& xml) {
  std::vector<std::string> open;
  std::size_t i = 0;
  bool root_seen = false;
  while (i < xml.size()) {
    if (xml[i] == '&') {
      const std::size_t end = xml.find(';', i);
      if (end == std::string::npos || end - i > 6) return false;
    }
    if (xml[i] != '<') {
      if (open.empty() && !std::isspace(static_cast<unsigned char>(xml[i]))) return false;
      ++i;
      continue;
    }
    const std::size_t end = xml.find('>', i);
    if (end == std::string::npos) return false;
    std::string tag = xml.substr(i + 1, end - i - 1);
    i = end + 1;
    if (tag.find('<') != std::string::npos) return false;
    if (std::count(tag.begin(), tag.end(), '"') % 2 != 0) return false;
    if (tag[0] == '?') continue;
    const std::string name =
        tag.substr(tag[0] == '/' ? 1 : 0, tag.find_first_of(" /", 1) - (tag[0] == '/' ? 1 : 0));
    if (tag[0] == '/') {
      if (open.empty() || open.back() != tag.substr(1)) return false;
      open.pop_back();
    } else if (tag.back() != '/') {
      if (open.empty() && root_seen) return false;
      root_seen = true;
      open.push_back(name);
    }
  }
  return root_seen && open.empty();
}

}  // namespace

TEST_CASE("the checker itself tells good from bad") {
  CHECK(well_formed("<?xml version=\"1.0\"?><a><b x=\"1\"/>t &amp; u</a>"));
  CHECK_FALSE(well_formed("<a><b></a></b>"));
  CHECK_FALSE(well_formed("<a>"));
  CHECK_FALSE(well_formed("<a x=\"1></a>"));
  CHECK_FALSE(well_formed("<a>x & y</a>"));
}

TEST_CASE("figure 1 and figure 5 are well-formed and name d̂") {
  for (const std::string& svg : {figure_to_svg(figure1(), 1600, 700), picture_to_svg(figure5(), 1600, 700)}) {
    CHECK(well_formed(svg));
    CHECK(svg.find("d̂") != std::string::npos);
    CHECK(svg.find("width=\"1600\" height=\"700\"") != std::string::npos);
    CHECK(svg.find("nan") == std::string::npos);
    CHECK(svg.find("inf") == std::string::npos);
  }
}

TEST_CASE("texts with markup characters and hostile data stay well-formed") {
  Figure figure;
  figure.title = "a < b & \"c\" > d\n";
  Plot plot;
  Series series;
  series.name = "<script>";
  series.x = {0, 1, 2, 3};
  series.y = {1, std::numeric_limits<double>::quiet_NaN(), 1e308, -1e308};
  plot.series.push_back(series);
  figure.plots.push_back(plot);
  figure.plots.emplace_back();
  figure.columns = 2;
  const std::string svg = figure_to_svg(figure, 400, 300);
  CHECK(well_formed(svg));
  CHECK(svg.find("no data") != std::string::npos);
  CHECK(svg.find("<script>") == std::string::npos);
}

}  // namespace pabd::test_svg
