// SPDX-License-Identifier: MIT
// Panels never overlap, stay inside, and leave a free rectangle, for every selection and many frame sizes;
// what a table says of a panel is found by names, help and places.
#include <catch2/catch.hpp>

#include "app/overlay/overlay.h"
#include "app/overlay/panel_layout.h"
#include "sim/base/error.h"

namespace pabd::test_panel_layout {

using Catch::Matchers::Contains;

namespace {

// With joints of a hard law, so that the parameters have four rows more, and every legend something to say.
OverlayData data_with_joints() {
  static const BondLaw law{BondPotential::hard, 4, 1e9, 0.01};
  static const FrameView view = [] {
    auto model = std::make_shared<Model>();
    for (const JointType type : kJointTypes) model->joints.emplace_back().type = type;
    FrameView out;
    out.model = std::move(model);
    return out;
  }();
  static const BodyColors colors{{}, {}, 0, "speed, m/s", {}};
  OverlayData data;
  data.view = &view;
  data.joint_law = &law;
  data.colors = &colors;
  return data;
}

void check_layout(const OverlayOptions& options, const OverlayData& data, int width, int height) {
  const PanelLayout layout = layout_panels(options, data, width, height);
  // What a small frame has is readable; who asks for one panel gets it.
  CHECK((layout.scale >= 0.62 || layout.panels.size() == 1));
  CHECK((layout.free.w * layout.free.h >= 0.25 * width * height || layout.panels.size() == 1));
  CHECK(layout.panels.size() >= 1);
  const bool room = width >= 1280 && height >= 720;
  CHECK(layout.panels.size() >= (room ? options.shown().size() : 1));
  const Rect frame{0, 0, static_cast<double>(width), static_cast<double>(height)};
  for (std::size_t i = 0; i < layout.panels.size(); ++i) {
    const Rect& rect = layout.panels[i].rect;
    CHECK(rect.w > 0);
    CHECK(rect.h > 0);
    CHECK(frame.contains(rect));
    CHECK_FALSE(layout.free.overlaps(rect));
    for (std::size_t k = 0; k < i; ++k) CHECK_FALSE(rect.overlaps(layout.panels[k].rect));
  }
  CHECK(frame.contains(layout.free));
}

constexpr std::pair<int, int> kSizes[] = {{640, 360},   {1280, 720}, {1920, 1080}, {2560, 1440}, {3840, 2160},
                                          {1080, 1920}, {720, 720},  {200, 150},   {64, 64},     {3000, 400}};

}  // namespace

TEST_CASE("panels do not overlap and stay inside the frame") {
  const PanelTable table = overlay_panels();
  for (const auto& [width, height] : kSizes) {
    for (unsigned bits = 1; bits < 1u << table.size(); ++bits) {
      OverlayOptions options;
      for (std::size_t i = 0; i < table.size(); ++i) {
        if ((bits >> i & 1) != 0) options.show(*table[i]);
      }
      INFO(width << "x" << height << " panels " << bits);
      check_layout(options, data_with_joints(), width, height);
    }
  }
}

TEST_CASE("a small frame has those of its panels that can be read, the parameters first") {
  const auto names = [](int width, int height) {
    std::string out;
    for (const PlacedPanel& placed :
         layout_panels(parse_panels("all"), data_with_joints(), width, height).panels)
      out += (out.empty() ? "" : " ") + std::string(placed.panel->name);
    return out;
  };
  CHECK(names(1280, 720) == "params barrier convergence series legend");
  CHECK(names(640, 360) == "params barrier convergence series legend");
  CHECK(names(480, 270) == "params");
  CHECK(names(320, 180) == "params");
  // In a portrait frame the picture is below the panels, as wide as the frame.
  CHECK(layout_panels(parse_panels("params,barrier"), data_with_joints(), 400, 700).free.w == 400);
}

TEST_CASE("the picture stays visible: half the frame at 1280x720 and above, a quarter at 640x360") {
  OverlayOptions all = parse_panels("all");
  all.show(joints_overlay);
  for (const int height : {360, 720, 1080, 1440, 2160}) {
    const PanelLayout layout = layout_panels(all, data_with_joints(), height * 16 / 9, height);
    CHECK(layout.free.w * layout.free.h > (height == 360 ? 0.25 : 0.45) * height * height * 16 / 9);
  }
  CHECK(layout_panels({}, {}, 1280, 720).free.w == 1280);
}

TEST_CASE("in square and portrait frames panels are above and below a picture as wide as the frame") {
  for (const auto& [width, height] : {std::pair{720, 1280}, {1080, 1920}, {900, 900}, {2160, 3840}}) {
    CAPTURE(width, height);
    const PanelLayout layout = layout_panels(parse_panels("plots,legend"), data_with_joints(), width, height);
    CHECK(layout.panels.size() == 4);
    CHECK(layout.free.w == width);
    CHECK(layout.free.h > 0.4 * height);
    for (const PlacedPanel& placed : layout.panels) {
      const bool below = placed.rect.y >= layout.free.bottom();
      CHECK(below == (placed.panel->place == PanelPlace::column));
    }
  }
}

TEST_CASE("the legend of joints comes with bonds, where there are joints") {
  OverlayOptions options;
  options.show_with(PictureLayer::bonds);
  CHECK(options.shows(joints_overlay));
  CHECK_FALSE(options.shows(legend_overlay));
  CHECK(layout_panels(options, data_with_joints(), 1280, 720).panels.size() == 1);
  CHECK(layout_panels(options, {}, 1280, 720).panels.empty());
}

TEST_CASE("panel names") {
  CHECK(parse_panels("params,plots").shows(convergence_overlay));
  CHECK_FALSE(parse_panels("params,plots").shows(legend_overlay));
  CHECK(parse_panels("all").shows(legend_overlay));
  CHECK_FALSE(parse_panels("all").shows(difference_overlay));
  CHECK(parse_panels("none").shown().empty());
  CHECK(parse_panels("").shown().empty());
  CHECK(panel_names() == "params, barrier, convergence, series, legend, difference, plots");
  for (const char* bad : {"parms", "params,", "plots params", "joints"}) {
    try {
      parse_panels(bad);
      FAIL("accepted " << bad);
    } catch (const Error& error) {
      CHECK(error.kind() == ErrorKind::bad_input);
      CHECK(std::string(error.what()).find("convergence") != std::string::npos);
    }
  }
}

TEST_CASE("a made-up panel in a table is found by names, help, needs and places") {
  const OverlayPanel clock = {
      .name = "clock", .place = PanelPlace::top_left, .width = 90, .height = 30, .iterations = true};
  const OverlayPanel spectrum = {.name = "spectrum", .width = 400, .height = 100, .other_run = true};
  std::vector<const OverlayPanel*> all(overlay_panels().begin(), overlay_panels().end());
  all.push_back(&clock);
  all.push_back(&spectrum);
  const PanelTable table = all;

  CHECK(parse_panels("params,clock", table).shows(clock));
  CHECK(parse_panels("all", table).shows(clock));
  CHECK_FALSE(parse_panels("all,plots", table).shows(spectrum));
  CHECK(parse_panels("clock", table).needing(&OverlayPanel::iterations) == &clock);
  CHECK(parse_panels("clock", table).needing(&OverlayPanel::other_run) == nullptr);
  CHECK_THROWS_WITH(parse_panels("clocks", table), Contains("difference, clock, spectrum, plots"));
  CHECK_THROWS_WITH(parse_panels("clock"), Contains("no such panel"));
  CHECK_THAT(panel_help(table),
             Contains("clock, spectrum (with --ab), plots (barrier, convergence, series)"));

  for (const auto& [width, height] : kSizes) {
    INFO(width << "x" << height);
    check_layout(parse_panels("all,spectrum", table), data_with_joints(), width, height);
  }
  // Below the parameters, as large as it wishes; the plots become as wide as the widest.
  const PanelLayout layout =
      layout_panels(parse_panels("params,clock,series,spectrum", table), {}, 1280, 720);
  REQUIRE(layout.panels.size() == 4);
  CHECK(layout.panels[1].panel == &clock);
  CHECK(layout.panels[1].rect.y > layout.panels[0].rect.bottom());
  CHECK(layout.panels[1].rect.w == 90);
  CHECK(layout.panels[1].rect.h == Approx(30).margin(1));
  CHECK(layout.panels[2].rect.w == 400);
}

}  // namespace pabd::test_panel_layout
