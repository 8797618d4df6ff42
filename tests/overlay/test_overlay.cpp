// SPDX-License-Identifier: MIT
// Draw data of frames and figures, without GL.
#include <imgui.h>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "app/overlay/overlay.h"
#include "app/overlay/overlay_panels.h"
#include "app/plots/figure.h"
#include "app/plots/figures/barrier_curves.h"
#include "app/plots/svg_canvas.h"

namespace pabd::test_overlay {

namespace {

// Every vertex finite, every index in range.
void check_draw_data(const ImDrawData* data, int width, int height) {
  REQUIRE(data);
  CHECK(data->DisplaySize.x == static_cast<float>(width));
  CHECK(data->DisplaySize.y == static_cast<float>(height));
  for (int l = 0; l < data->CmdListsCount; ++l) {
    const ImDrawList* list = data->CmdLists[l];
    for (const ImDrawVert& v : list->VtxBuffer) {
      REQUIRE(std::isfinite(v.pos.x));
      REQUIRE(std::isfinite(v.pos.y));
    }
    for (const ImDrawCmd& command : list->CmdBuffer) {
      for (unsigned i = 0; i < command.ElemCount; ++i) {
        const unsigned index = command.VtxOffset + list->IdxBuffer[static_cast<int>(command.IdxOffset + i)];
        REQUIRE(index < static_cast<unsigned>(list->VtxBuffer.Size));
      }
    }
  }
}

Reports some_history() {
  ReportList history;
  for (int i = 0; i < 300; ++i) {
    StepSummary step;
    step.time = i / 60.0;
    step.kinetic = std::abs(std::sin(0.1 * i));
    step.min_gap = std::numeric_limits<double>::infinity();
    add_report(history, step);
  }
  return history.view();
}

std::shared_ptr<const Model> joined(std::size_t joints) {
  auto model = std::make_shared<Model>();
  model->joints.resize(joints);
  for (std::size_t k = 0; k < joints; ++k) model->joints[k].type = static_cast<JointType>(k % 5);
  return model;
}

}  // namespace

TEST_CASE("frames of every size, with all panels, with and without data") {
  int uploads = 0;
  Overlay overlay([&](const unsigned char* rgba, int, int) {
    CHECK(rgba != nullptr);
    ++uploads;
    return nullptr;
  });
  OverlayOptions all = parse_panels("all");
  all.show(joints_overlay);
  FrameView view;
  view.model = joined(5);
  view.kappa = 120;
  view.history = some_history();
  StepReport& report = view.report;
  report.step = 300;
  report.records.resize(5);
  report.records[2].energy = std::numeric_limits<double>::quiet_NaN();
  report.contact_reports.resize(2);
  report.contact_reports[0].d = 0.004;
  report.contact_reports[1].d = std::numeric_limits<double>::quiet_NaN();
  const BondLaw law{BondPotential::hard, 4, 1e9, 0.01};
  const OverlayData full{"сцена 一 with a very very long name that cannot fit", &view, &law};
  for (const auto& [w, h] : {std::pair{640, 360}, {1280, 720}, {2560, 1440}, {64, 64}}) {
    check_draw_data(overlay.frame(all, full, nullptr, w, h), w, h);
    check_draw_data(overlay.frame(all, {}, nullptr, w, h), w, h);
    CHECK(overlay.frame(all, full, nullptr, w, h)->TotalVtxCount > (w < 640 ? 500 : 1000));
  }
  CHECK(overlay.frame({}, full, nullptr, 1280, 720)->TotalVtxCount == 0);
  // A second frame of the same size needs no new atlas.
  overlay.frame(all, full, nullptr, 1280, 720);
  const int before = uploads;
  overlay.frame(all, full, nullptr, 1280, 720);
  CHECK(uploads == before);
  CHECK(overlay.unknown_characters() == U"一");
}

TEST_CASE("figures paint to draw data; the same figure gives the same bytes") {
  Overlay one({}), two({});
  const Picture picture = figure_picture(figure1());
  const ImDrawData* a = one.paint(picture, 1600, 700);
  const ImDrawData* b = two.paint(picture, 1600, 700);
  check_draw_data(a, 1600, 700);
  REQUIRE(a->TotalVtxCount == b->TotalVtxCount);
  REQUIRE(a->CmdListsCount == b->CmdListsCount);
  for (int l = 0; l < a->CmdListsCount; ++l) {
    const auto &va = a->CmdLists[l]->VtxBuffer, &vb = b->CmdLists[l]->VtxBuffer;
    CHECK(
        std::equal(va.begin(), va.end(), vb.begin(), vb.end(), [](const ImDrawVert& p, const ImDrawVert& q) {
          return p.pos.x == q.pos.x && p.pos.y == q.pos.y && p.col == q.col && p.uv.x == q.uv.x &&
                 p.uv.y == q.uv.y;
        }));
  }
}

TEST_CASE("the legend of contacts says the quantity, its unit and the ends of the range") {
  const FontMetrics font;
  const FrameView view;
  OverlayData data{"s", &view};
  const auto text = [&] {
    SvgCanvas canvas(font, 1280, 720);
    paint_panels(layout_panels(parse_panels("legend"), data, 1280, 720), data, canvas);
    return canvas.finish();
  };
  const auto has = [](const std::string& svg, const char* words) {
    return svg.find(words) != std::string::npos;
  };
  CHECK(has(text(), "contact "));
  data.contacts_by = ContactQuantity::force;
  data.force_range = {20, 2000, true};
  const std::string force = text();
  CHECK(has(force, "normal force, N"));
  CHECK(has(force, ">200<"));
  data.contacts_by = ContactQuantity::friction;
  CHECK(has(text(), "friction "));
}

TEST_CASE("the parameters list the law of joints, soft or hard") {
  const FontMetrics font;
  FrameView view;
  view.kappa = 120;
  view.report.max_joint_error = 3.21e-9;
  BondLaw law{BondPotential::soft, 6, 1.234e9, 0.02};
  OverlayData data{"s", &view};
  const auto text = [&] {
    SvgCanvas canvas(font, 1280, 720);
    paint_panels(layout_panels(parse_panels("params"), data, 1280, 720), data, canvas);
    return canvas.finish();
  };
  const auto has = [](const std::string& svg, const char* words) {
    return svg.find(words) != std::string::npos;
  };
  const auto rows = [&] { return params_overlay.more_height(data) / 18; };
  CHECK(rows() == 0);
  CHECK_FALSE(has(text(), "joint"));
  CHECK_FALSE(has(text(), "integrator"));
  view.params.solver.integrator = Integrator::euler;
  CHECK(rows() == 1);
  CHECK(has(text(), "euler"));
  view.params.solver.integrator = Integrator::bdf2;
  view.model = joined(7);
  data.joint_law = &law;
  CHECK(rows() == 3);
  const std::string soft = text();
  CHECK(has(soft, "7, soft"));
  CHECK(has(soft, "1.23·10⁹ N/m"));
  CHECK(has(soft, "3.2·10⁻⁹ m"));
  CHECK_FALSE(has(soft, "joint scale"));
  law.potential = BondPotential::hard;
  CHECK(rows() == 4);
  const std::string hard = text();
  CHECK(has(hard, "7, hard"));
  CHECK(has(hard, "0.02 m"));
  CHECK(has(hard, "1.23·10⁹ J"));
}

TEST_CASE("labels are painted where the camera sees them, not behind the eye") {
  VisualScene scene;
  scene.camera.eye = {0, 0, 10};
  scene.camera.target = {0, 0, 0};
  scene.labels.push_back({{0, 0, 0}, "centre"});
  scene.labels.push_back({{0, 0, 20}, "behind"});
  const FontMetrics font;
  SvgCanvas canvas(font, 800, 600);
  paint_labels(scene, 800, 600, 1, canvas);
  const std::string svg = canvas.finish();
  CHECK(svg.find("x=\"400\" y=\"306.2\"") != std::string::npos);  // middle of the frame, half a capital lower
  CHECK(svg.find("behind") == std::string::npos);
}

TEST_CASE("panels over a dark picture are dark: nothing of them has an ink of the light theme") {
  const FontMetrics font;
  FrameView view;
  view.model = joined(5);
  view.history = some_history();
  view.report.records.resize(5);
  OverlayData data{"s", &view};
  data.caption = "A and B";
  OverlayOptions all = parse_panels("all");
  all.show(joints_overlay);
  const auto has = [&](const PictureTheme& theme, const char* ink) {
    data.theme = &theme;
    SvgCanvas canvas(font, 1280, 720);
    paint_panels(layout_panels(all, data, 1280, 720), data, canvas);
    return canvas.finish().find(ink) != std::string::npos;
  };
  for (const char* ink : {"#1f2933", "#5f6b78", "#ffffff\" fill-opacity=\"0.91"}) {
    CAPTURE(ink);
    CHECK(has(kPaperTheme, ink));
    CHECK_FALSE(has(kDarkTheme, ink));
  }
  CHECK(has(kDarkTheme, "#1e2329"));
}

TEST_CASE("contact colours are the picture's, in sRGB") {
  CHECK(contact_ink(1).b > contact_ink(1).r);
  CHECK(contact_ink(-0.5).r > 2 * contact_ink(-0.5).b);
}

}  // namespace pabd::test_overlay
