// SPDX-License-Identifier: MIT
// Owns the ImGui context and turns what is painted into draw data.
#include "app/overlay/overlay.h"

#include <imgui.h>

#include <algorithm>

#include "app/overlay/font_atlas.h"
#include "app/overlay/imgui_canvas.h"
#include "app/overlay/overlay_panels.h"
#include "app/overlay/view_marks.h"

namespace pabd {
namespace {

constexpr std::size_t kMostTextSizes = 24;  // text sizes kept when the frame size changes
constexpr int kMostPasses = 4;              // sizes first, then characters that only those fonts can miss

}  // namespace

struct Overlay::Impl {
  ImGuiContext* context;
  FontMetrics metrics;
  FontAtlas atlas;
  int width = 0, height = 0;

  static ImGuiContext* make_context() {
    ImGuiContext* previous = ImGui::GetCurrentContext();
    ImGuiContext* fresh = new_imgui_context();
    ImGuiStyle& style = ImGui::GetStyle();
    style.AntiAliasedLinesUseTex = false;  // widths that are no whole number of pixels
    style.CurveTessellationTol = 0.5f;
    if (previous) ImGui::SetCurrentContext(previous);
    return fresh;
  }
  static ImFontAtlas& fonts_of(ImGuiContext* context) {
    ImGui::SetCurrentContext(context);
    return *ImGui::GetIO().Fonts;
  }

  explicit Impl(UploadAtlas upload) : context(make_context()), atlas(fonts_of(context), std::move(upload)) {}
  ~Impl() { ImGui::DestroyContext(context); }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  const ImDrawData* draw(int w, int h, const std::function<void(Canvas&)>& paint) {
    ImGui::SetCurrentContext(context);
    if ((w != width || h != height) && atlas.size_count() > kMostTextSizes) atlas.forget_sizes();
    width = w;
    height = h;
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(w), static_cast<float>(h)};
    io.DeltaTime = 1.0f / 60.0f;
    for (int pass = 0;; ++pass) {
      if (atlas.stale()) atlas.bake();
      ImGui::NewFrame();
      ImGuiCanvas canvas(metrics, atlas, *ImGui::GetBackgroundDrawList());
      paint(canvas);
      ImGui::Render();
      if (!atlas.stale() || pass + 1 == kMostPasses) return ImGui::GetDrawData();
    }
  }
};

Overlay::Overlay(UploadAtlas upload) : impl_(std::make_unique<Impl>(std::move(upload))) {}
Overlay::~Overlay() = default;

const ImDrawData* Overlay::frame(const OverlayOptions& options, const OverlayData& data,
                                 const VisualScene* scene, int width, int height) {
  const PanelLayout layout = layout_panels(options, data, width, height);
  const double scale = std::max(0.72, std::min(width / 1280.0, height / 720.0));
  return impl_->draw(width, height, [&](Canvas& canvas) {
    if (scene) {
      paint_labels(*scene, width, height, scale, canvas);
      const Rect free = layout.panels.empty() ? Rect{0, 0, double(width), double(height)} : layout.free;
      if (data.axes) paint_axes(scene->camera, scene->theme->inks, free, scale, canvas);
      if (data.scale) paint_scale_bar(scene->camera, scene->theme->inks, height, free, scale, canvas);
    }
    paint_panels(layout, data, canvas);
  });
}

const ImDrawData* Overlay::paint(const Picture& picture, int width, int height) {
  return impl_->draw(width, height, [&](Canvas& canvas) { picture(canvas, width, height); });
}

std::u32string Overlay::unknown_characters() const { return impl_->atlas.unknown(); }

}  // namespace pabd
