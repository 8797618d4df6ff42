// Panels never overlap, stay inside, and leave a free rectangle, for every selection and many frame sizes.
#include <catch2/catch.hpp>

#include "app/overlay/panel_layout.h"
#include "sim/error.h"

using namespace pabd;

TEST_CASE("panels do not overlap and stay inside the frame") {
  const std::pair<int, int> sizes[] = {{640, 360},   {1280, 720}, {1920, 1080}, {2560, 1440}, {3840, 2160},
                                       {1080, 1920}, {720, 720},  {200, 150},   {64, 64},     {3000, 400}};
  for (const auto& [width, height] : sizes) {
    for (int bits = 1; bits < 128; ++bits) {
      const OverlayOptions options{(bits & 1) != 0,          (bits & 2) != 0,  (bits & 4) != 0,
                                   (bits & 8) != 0,          (bits & 16) != 0, (bits & 32) != 0,
                                   (bits & 32) != 0 ? 4 : 0, (bits & 64) != 0};
      const PanelLayout layout = layout_panels(options, width, height);
      INFO(width << "x" << height << " panels " << bits);
      REQUIRE(layout.panels.size() ==
              static_cast<std::size_t>(__builtin_popcount(static_cast<unsigned>(bits))));
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
  }
}

TEST_CASE("the picture stays visible: half the frame at 1280x720 and above, a quarter at 640x360") {
  const OverlayOptions all{true, true, true, true, true, true, 4};
  for (const int height : {360, 720, 1080, 1440, 2160}) {
    const PanelLayout layout = layout_panels(all, height * 16 / 9, height);
    CHECK(layout.free.w * layout.free.h > (height == 360 ? 0.25 : 0.45) * height * height * 16 / 9);
  }
  CHECK(layout_panels({}, 1280, 720).free.w == 1280);
}

TEST_CASE("panel names") {
  CHECK(parse_panels("params,plots").convergence);
  CHECK_FALSE(parse_panels("params,plots").legend);
  CHECK(parse_panels("all").legend);
  CHECK_FALSE(parse_panels("none").any());
  CHECK_FALSE(parse_panels("").any());
  for (const char* bad : {"parms", "params,", "plots params"}) {
    try {
      parse_panels(bad);
      FAIL("accepted " << bad);
    } catch (const Error& error) {
      CHECK(error.code() == ExitCode::bad_input);
      CHECK(std::string(error.what()).find("convergence") != std::string::npos);
    }
  }
}
