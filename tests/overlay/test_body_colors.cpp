// SPDX-License-Identifier: MIT
// Colours of bodies: their numbers, and a range that two runs share and that never shrinks.
#include "app/overlay/body_colors.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "app/overlay/overlay_panel_table.h"
#include "app/overlay/overlay_panels.h"
#include "app/plots/svg_canvas.h"
#include "tests/support/tiny_model.h"

namespace pabd::test_body_colors {

namespace {

// A fixed body, and two with these speeds (m/s).
FrameView view_of(double one, double two) {
  TinyModel tiny;
  tiny.add_fixed(Box{{5, 1, 5}}, {0, -1, 0});
  for (const double v : {one, two}) {
    const Index i = tiny.add(Box{{0.5, 0.5, 0.5}}, {0, v, 0});
    tiny.state.v[static_cast<std::size_t>(i)] = {0, -v, 0};
  }
  FrameView view;
  view.model = std::make_shared<Model>(tiny.model);
  view.state = std::make_shared<State>(tiny.state);
  return view;
}

}  // namespace

TEST_CASE("colours by speed have a round range that two runs share, and that rests once it has grown") {
  const FrameView a = view_of(0.3, 1.2), b = view_of(0.1, 17);
  const BodyColors alone = body_colors(a, ColorQuantity::speed);
  REQUIRE(alone.values.size() == 3);
  CHECK(std::isnan(alone.values[0]));
  CHECK(alone.values[1] == Approx(0.3));
  CHECK(alone.values[2] == Approx(1.2));
  CHECK(alone.range.hi == 2);
  CHECK(alone.largest == Approx(1.2));
  for (const BodyColors& one :
       {body_colors(a, ColorQuantity::speed, largest_value(b, ColorQuantity::speed)),
        body_colors(b, ColorQuantity::speed, largest_value(a, ColorQuantity::speed))}) {
    CHECK(one.range.lo == 0);
    CHECK(one.range.hi == 20);
  }
  const BodyColors later = body_colors(a, ColorQuantity::speed, 17);
  CHECK(later.range.hi == 20);
  CHECK(later.largest == 17);
  CHECK(body_colors(a, ColorQuantity::body, 17).values.empty());
}

TEST_CASE("energies are kinetic and of contacts; what no report holds is grey") {
  FrameView view = view_of(2, 0);
  CHECK(std::isnan(body_colors(view, ColorQuantity::energy).values[1]));
  view.report.body_reports.resize(3);
  view.report.body_reports[2].contact_energy = 7;
  const BodyColors colors = body_colors(view, ColorQuantity::energy);
  CHECK(colors.values[1] == Approx(0.5 * 1000 * 4));  // 1 m³ of 1000 kg/m³
  CHECK(colors.values[2] == Approx(7));
  CHECK(colors.range.hi == 2000);
  CHECK(colors.range.lo == Approx(0.2));  // four decades
  CHECK(colors.range.logarithmic);
}

TEST_CASE("residuals are those of the components, in decades; without any there is a note") {
  FrameView view = view_of(2, 0);
  view.report.body_reports.resize(3);
  view.report.body_reports[1].island = 0;
  CHECK(body_colors(view, ColorQuantity::residual).note.find("residual 0") != std::string::npos);
  view.report.body_reports[1].residual = 3e-7;
  const BodyColors colors = body_colors(view, ColorQuantity::residual);
  CHECK(colors.values[1] == 3e-7);
  CHECK(std::isnan(colors.values[2]));  // alone
  CHECK(colors.range.hi == Approx(5e-7));
  CHECK(colors.range.logarithmic);
  CHECK(colors.title.find("d̂") != std::string::npos);
}

TEST_CASE("the legend of bodies says the quantity, its unit and the ends of the range") {
  const FontMetrics font;
  const FrameView view = view_of(0.3, 17);
  OverlayOptions options;
  options.show_with(PictureLayer::body_colors);
  const auto text = [&](const BodyColors& colors) {
    OverlayData data{"s", &view};
    data.colors = &colors;
    SvgCanvas canvas(font, 1280, 720);
    paint_panels(layout_panels(options, data, 1280, 720), data, canvas);
    return canvas.finish();
  };
  const std::string speed = text(body_colors(view, ColorQuantity::speed));
  CHECK(speed.find("speed, m/s") != std::string::npos);
  CHECK(speed.find(">10<") != std::string::npos);
  CHECK(text(body_colors(view, ColorQuantity::component)).find("no components") != std::string::npos);
  CHECK(text({}).find("text") == std::string::npos);  // bodies told apart need no legend
}

TEST_CASE("numbers of a range of three decades are a decade apart") {
  const ValueRange range{20, 20000, true};
  std::vector<double> numbers;
  for (const double t : range.places()) numbers.push_back(range.value(t));
  REQUIRE(numbers.size() == 4);
  for (std::size_t k = 0; k < 4; ++k) CHECK(numbers[k] == Approx(20 * std::pow(10, k)));
}

TEST_CASE("a place in a range and the value there are inverse") {
  for (const ValueRange& range : {ValueRange{0, 20, false}, ValueRange{2e-3, 20, true}}) {
    for (const double t : {0.0, 0.25, 1.0}) CHECK(range.place(range.value(t)) == Approx(t).margin(1e-12));
    CHECK(range.value(1) == Approx(20));
    CHECK(range.places() == std::vector<double>{0, 0.5, 1});  // four decades too
  }
}

}  // namespace pabd::test_body_colors
