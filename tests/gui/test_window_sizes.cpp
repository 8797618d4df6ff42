// SPDX-License-Identifier: MIT
// The whole window at many sizes, by the numbers of its widgets: whatever panel, menu, dialog or help is seen lies inside
// the window, and nothing in it is cut off or has to be scrolled to sideways.
#include <fmt/format.h>
#include <imgui_internal.h>

#include <catch2/catch.hpp>
#include <set>

#include "tests/gui/script_runner.h"

namespace pabd::test_window_sizes {

namespace {

struct Size {
  int width, height;
  double scale = 1;
};
constexpr Size kSizes[] = {{360, 640},  {360, 800},  {640, 360},   {800, 600},     {720, 1280},
                           {1000, 700}, {1280, 720}, {1920, 1080}, {720, 1280, 2}, {2560, 1440, 2}};

class TestWindow {
 public:
  TestWindow()
      : context_(create_headless_context(Backend::automatic, attempts_)),
        runner_(std::make_unique<Workbench>(bench(), command::Load{"two_boxes", {}, false})),
        viewer_(*context_, runner_, options()) {}

  void play(const std::string& json) {
    ScriptOptions options;
    options.folder = folder_.path();
    options.width = size_.width;
    options.height = size_.height;
    Script(json, "s").run(viewer_, runner_, options);
  }
  void resize(const Size& size) {
    size_ = size;
    viewer_.set_screen_scale(size.scale);
    settle();
  }
  // What a frame finds out of its widgets is used in the next ones.
  void settle() {
    for (int k = 0; k < 4; ++k) draw();
  }
  void click(double x, double y) {
    viewer_.handle(MouseMoved{x, y});
    draw();
    for (const bool pressed : {true, false}) {
      viewer_.handle(MouseClicked{MouseButton::left, pressed, {}});
      draw();
    }
    settle();
  }
  void press(Key key) {
    for (const bool pressed : {true, false}) {
      viewer_.handle(KeyChanged{key, {}, pressed, false});
      draw();
    }
    settle();
  }
  void scroll(double x, double y, double notches) {
    viewer_.handle(MouseMoved{x, y});
    draw();
    viewer_.handle(MouseScrolled{0, notches});
    settle();
  }
  // By a part of its name; null: it is not seen.
  static const ImGuiWindow* find(const std::string& name) {
    for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows)
      if (window->Active && std::string(window->Name).find(name) != std::string::npos) return window;
    return nullptr;
  }
  bool popup_open() const { return !ImGui::GetCurrentContext()->OpenPopupStack.empty(); }

  // What is outside of the window or cut.
  std::string faults() const {
    const ImRect all(0, 0, static_cast<float>(size_.width), static_cast<float>(size_.height));
    std::string out;
    for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows) {
      if (!window->Active || window->Hidden || window->IsFallbackWindow) continue;
      const ImRect at = window->Rect();
      if (!all.Contains(at) && !(window->Flags & ImGuiWindowFlags_ChildWindow))
        out +=
            fmt::format("{} is at {}, {} to {}, {}\n", window->Name, at.Min.x, at.Min.y, at.Max.x, at.Max.y);
      if (window->ScrollMax.x > 0.5f)
        out += fmt::format("{} is {} pixels too narrow\n", window->Name, window->ScrollMax.x);
      const bool bar = (window->Flags & ImGuiWindowFlags_NoScrollbar) != 0;
      if (bar && window->ScrollMax.y > 0.5f)
        out += fmt::format("{} is {} pixels too low\n", window->Name, window->ScrollMax.y);
    }
    return out;
  }
  std::string open_popup() const { return ImGui::GetCurrentContext()->OpenPopupStack.back().Window->Name; }
  Viewer& viewer() { return viewer_; }

 private:
  static WorkbenchOptions bench() {
    WorkbenchOptions out;
    out.find_scene = shipped_scene;
    return out;
  }
  static ViewerOptions options() {
    ViewerOptions out;
    out.steady = true;
    out.shipped_scenes = [] { return std::vector<std::filesystem::path>{shipped_scene("two_boxes")}; };
    return out;
  }
  void draw() { viewer_.draw(size_.width, size_.height, 1.0 / 60); }

  TempFolder folder_;
  std::vector<ContextAttempt> attempts_;
  std::unique_ptr<GlContext> context_;
  Runner runner_;
  Viewer viewer_;
  Size size_{1280, 720};
};

}  // namespace

TEST_CASE("every panel, dialog and the help fit into windows of many sizes") {
  TestWindow window;
  window.play(R"([{"do": "load", "scene": "four_bar", "force": true}, {"do": "step", "steps": 40},
                  {"do": "set", "key": "contact.kappa", "value": 123456.7},
                  {"do": "compare", "values": ["time_step=0.01"]}, {"do": "step", "steps": 3},
                  {"do": "select", "kind": "body", "item": "pen"}])");
  for (const Size& size : kSizes) {
    CAPTURE(size.width, size.height, size.scale);
    window.resize(size);
    for (const WindowPanel* panel : window_panels()) {
      CAPTURE(panel->name);
      window.viewer().send(ViewCommand(command::Panel{panel->name, true}));
      window.settle();
      CHECK(window.faults() == "");
    }
    for (const Choice& quantity : kSeriesViews) {
      CAPTURE(quantity.name);
      window.viewer().send(ViewCommand(command::SeriesView{quantity.name, "max_penetration", "kinetic"}));
      window.viewer().send(ViewCommand(command::Panel{"series", true}));
      window.settle();
      CHECK(window.faults() == "");
    }
    for (const DialogKind& dialog : kDialogs) {
      CAPTURE(dialog.name);
      window.viewer().send(ViewCommand(command::Ask{dialog.name}));
      window.settle();
      REQUIRE(window.popup_open());
      CHECK(window.faults() == "");
      window.viewer().send(ViewCommand(command::Ask{}));
      window.settle();
    }
    window.viewer().send(ViewCommand(command::Help{true}));
    window.settle();
    CHECK(window.faults() == "");
    window.viewer().send(ViewCommand(command::Help{false}));
    window.viewer().send(ViewCommand(command::Palette{true}));
    window.settle();
    CHECK(window.faults() == "");
    window.viewer().send(ViewCommand(command::Palette{false}));
    window.settle();
  }
}

TEST_CASE("whatever the toolbar opens lies inside the window") {
  TestWindow window;
  for (const Size& size : {Size{360, 640}, {640, 360}, {800, 600}, {1000, 700}, {1280, 720}}) {
    CAPTURE(size.width, size.height);
    window.resize(size);
    std::set<std::string> opened;
    for (double x = 20; x < size.width; x += 30) {
      window.click(x, 0.5 * window.viewer().layout().toolbar.h);
      CHECK(window.faults() == "");
      if (window.popup_open()) opened.insert(window.open_popup());
      for (int k = 0; k < 4 && window.popup_open(); ++k) window.press(Key::escape);
      window.viewer().send(ViewCommand(command::Help{false}));
      window.settle();
      REQUIRE_FALSE(window.popup_open());
    }
    // Lists of colours (which have one name), the menus of panels and view, the dialog of another scene; in a narrow
    // window one menu stands in for some.
    CHECK(opened.size() >= (size.width >= 1000 ? 4u : 2u));
  }
}

TEST_CASE("the help of a small window is scrolled to its end by the wheel") {
  TestWindow window;
  window.resize({360, 640});
  window.viewer().send(ViewCommand(command::Help{true}));
  window.settle();
  const ImGuiWindow* help = window.find("##all");
  REQUIRE(help != nullptr);
  CHECK(help->ScrollMax.y > 300);
  CHECK(help->Scroll.y == 0);
  // Rows above the top of the window are rounded the other way: all of them together are a little higher.
  for (int k = 0; k < 5; ++k) window.scroll(180, 300, -1000);
  CHECK(help->Scroll.y == help->ScrollMax.y);
}

}  // namespace pabd::test_window_sizes
