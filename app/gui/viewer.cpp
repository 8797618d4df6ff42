// SPDX-License-Identifier: MIT
// See viewer.h.
#include "app/gui/viewer.h"

#include <fmt/format.h>
#include <imgui_internal.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <map>

#include "app/gui/actions.h"
#include "app/gui/camera_motion.h"
#include "app/gui/dialogs.h"
#include "app/gui/frame_costs.h"
#include "app/gui/imgui_input.h"
#include "app/gui/live_picture.h"
#include "app/gui/named_files.h"
#include "app/gui/observer.h"
#include "app/gui/panels.h"
#include "app/gui/pick.h"
#include "app/gui/picture_mouse.h"
#include "app/gui/picture_notes.h"
#include "app/gui/pictures.h"
#include "app/gui/scene_list.h"
#include "app/gui/scene_view.h"
#include "app/gui/sweep_reader.h"
#include "app/gui/view_actions.h"
#include "app/gui/warm_up.h"
#include "app/gui/widgets.h"
#include "sim/base/error.h"

namespace pabd {
namespace {

constexpr int kStartWidth = 1280, kStartHeight = 720;
constexpr std::size_t kMostTextSizes = 24;  // text sizes that are kept

double seconds_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

struct Viewer::Impl {
  Runner& runner;
  ViewerOptions options;
  ImGuiContext* imgui;
  Renderer renderer;
  FontMetrics metrics;
  FontAtlas fonts;
  UiState ui;
  std::shared_ptr<const Snapshot> sim;
  std::uint64_t scene_serial = 0;
  std::string followed;  // file of the scene that the camera was set for
  ImGuiInput input;
  PictureMouse mouse;
  DevicePicture device;
  SceneView view;
  LivePicture live;
  double plain_composing = 0;  // s that a frame without a new picture took
  FrameCosts costs;
  GuiLayout layout;
  std::map<const WindowPanel*, std::unique_ptr<GuiPanel>> panels;
  std::vector<std::pair<KeyChord, const UserAction*>> keys;
  TimelineBar timeline;
  MessageList messages;
  Dialogs dialogs;
  Palette palette;
  SceneList scenes;
  bool scenes_shown = false;
  SweepReader sweeps;
  Studio studio;
  CameraMotion motion;
  WarmUp warm;
  bool shown_once = false;  // the first frame
  int width = kStartWidth, height = kStartHeight;
  bool themed_dark = false;
  double themed_unit = 0;
  Observer observer;

  Impl(GlContext& context, Runner& r, const ViewerOptions& o)
      : runner(r),
        options(o),
        imgui(make_gui_context()),
        renderer(context, kStartWidth, kStartHeight),
        fonts(*ImGui::GetIO().Fonts, [this](const unsigned char* rgba, int w,
                                            int h) { return renderer.upload_font_atlas(rgba, w, h); }),
        ui(o.start),
        sim(runner.latest()),
        device(context),
        scenes(o.shipped_scenes, o.steady, o.files),
        sweeps(renderer, o.steady, o.files == nullptr),
        studio(context, r, o.steady,
               [this](Severity severity, const std::string& text) { tell(severity, text); }),
        observer(r) {
    ImGuiIO& io = ImGui::GetIO();
    io.ClipboardUserData = this;
    io.GetClipboardTextFn = [](void* self) { return static_cast<Impl*>(self)->clipboard_text(); };
    io.SetClipboardTextFn = [](void* self, const char* text) { static_cast<Impl*>(self)->copy(text); };
    for (const WindowPanel* panel : window_panels()) panels.emplace(panel, panel->make());
    for (const UserAction& action : user_actions()) {
      for (const KeyChord& chord : action.chords()) keys.emplace_back(chord, &action);
    }
    layout = layout_gui(ui, width, height, unit(), false);
    observer.observe(*sim, ui, takes_states());
  }
  ~Impl() { ImGui::DestroyContext(imgui); }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  double unit() const { return options.screen_scale * ui.scale; }
  Viewport port() const { return {std::max(1.0, layout.views[0].w), std::max(1.0, layout.views[0].h)}; }

  std::string clipboard_buffer;
  const char* clipboard_text() {
    clipboard_buffer = options.clipboard ? options.clipboard() : clipboard_buffer;
    return clipboard_buffer.c_str();
  }
  void copy(const std::string& text) {
    clipboard_buffer = text;
    if (options.set_clipboard) options.set_clipboard(text);
  }

  void tell(Severity severity, const std::string& text) {
    runner.send(command::Tell{text, severity == Severity::error});
  }

  // Every command is sent here, so that every name of a file is checked.
  template <class Commands, class Do>
  void carry(Commands c, const Do& carry_out) {
    const FileRoot* files = options.files.get();
    try {
      each_file_name(c, [&](std::string& name, FileUse use, bool is_folder) {
        name = is_folder && files && !name.empty() ? files->folder_of(name) : named_file(files, name, use);
      });
      carry_out(c);
    } catch (const Error& error) {
      const std::string name = std::visit([](const auto& x) { return std::string(x.name); }, c);
      runner.send(command::Tell{error.what(), true, name, error.kind()});
    }
  }
  void try_to(const ViewCommand& c) {
    carry(c, [this](const ViewCommand& named) { act(named); });
  }
  void send(const Command& c) {
    carry(c, [this](const Command& named) { runner.send(named); });
  }

  void act(const ViewCommand& c) {
    sim = observer.with_states(sim);
    apply_view_command(c, *sim, port(), ui);
    studio.act(c, *sim, ui);
    // What it loads is the sweep's: names of files were checked when that was opened.
    if (const auto* run = std::get_if<command::LoadRun>(&c)) runner.send(load_of(ui.sweep, *run));
    if (std::holds_alternative<command::CopyCommand>(c)) {
      copy(render_command(*sim, ui));
      tell(Severity::note, "copied: " + clipboard_buffer);
    } else if (const auto* quit = std::get_if<command::Quit>(&c)) {
      if (!options.can_quit) {
        tell(Severity::note, "this window is served: close the page, it goes on without");
        ui.dialog.clear();
      } else if (studio.recorder().busy() && !quit->force) {
        tell(Severity::error, "a video is being made: stop or cancel it first");
      } else if ((!sim->at_stake.empty() || ui.keys_unsaved) && !quit->force) {
        ui.dialog = "quit";
      } else {
        ui.quit = true;
      }
    }
  }

  bool warms() const { return shown_once && !options.steady && !warm.done() && !sim->playing; }
  bool takes_states() const {
    return pabd::takes_states(*sim, ui) || studio.busy() || !device.can_draw(sim->a);
  }

  void handle_keys(const WindowEvent& event, Outbox& out) {
    const auto* key = std::get_if<KeyChanged>(&event);
    if (!key || ImGui::GetIO().WantTextInput) return;
    if (!ui.dialog.empty() || ui.palette) return;
    if (key->key == Key::escape && key->pressed && close_popup()) return;
    if (key->key == Key::space ? !mouse.plays(*key) : !key->pressed) return;
    if (mouse.pulling() && key->key == Key::escape) return;  // ends the pull only
    Modifiers modifiers = key->modifiers;
    if (mouse.pulling()) modifiers.ctrl = false;  // held for the pull
    for (const auto& [chord, action] : keys) {
      if (chord.key == key->key && chord.modifiers == modifiers) action->act(*sim, ui, out);
    }
  }

  // The list or menu that is open, if there is one.
  static bool close_popup() {
    const int open = ImGui::GetCurrentContext()->OpenPopupStack.Size;
    if (open > 0) ImGui::ClosePopupToLevel(open - 1, true);
    return open > 0;
  }

  void take_events(GuiFrame& frame) {
    const ImGuiIO& io = ImGui::GetIO();
    for (const WindowEvent& event : input.feed(ImGui::GetIO())) {
      handle_keys(event, frame.out);
      const bool in_picture = layout.view.contains(Point{static_cast<double>(io.MousePos.x),
                                                         static_cast<double>(io.MousePos.y)}) &&
                              !io.WantCaptureMouse;
      mouse.handle(event, in_picture, layout, frame, ui.camera);
      if (std::holds_alternative<CloseRequested>(event)) frame.out.send(command::Quit{});
      if (const auto* dropped = std::get_if<FilesDropped>(&event)) {
        if (!dropped->paths.empty()) open_dropped(*sim, dropped->paths.back(), frame.out);
      }
    }
  }

  void restyle() {
    if (themed_dark == ui.dark && themed_unit == unit()) return;
    if (themed_unit != unit() && fonts.size_count() > kMostTextSizes) fonts.forget_sizes();
    themed_dark = ui.dark;
    themed_unit = unit();
    apply_gui_theme(ImGui::GetStyle(), ui.dark, unit());
  }

  void draw_interface(GuiFrame& frame, double seconds) {
    if (!ui.hidden) {
      begin_fixed("##toolbar", layout.toolbar, ImGuiWindowFlags_NoScrollbar);
      draw_toolbar(frame);
      ImGui::End();
      for (const Slot slot : kSlots) draw_slot(frame, slot, *panels.at(ui.shown[slot]));
      begin_fixed("##timeline", layout.timeline, ImGuiWindowFlags_NoScrollbar);
      timeline.draw(frame);
      ImGui::End();
    }
    dialogs.look(*sim, ui);
    messages.draw(frame, layout.view, seconds, dialogs.answered());
    draw_recording(frame, layout.view);
    draw_file_offer(frame, layout.view);
    draw_costs(frame, layout.view);
    if (ui.help) draw_help(frame, width, height);
    palette.draw(frame, width, height);
    dialogs.draw(frame, width, height);
  }

  void send_all(Outbox& out) {
    for (const Command& c : out.commands) send(c);
    for (const ViewCommand& c : out.view) try_to(c);
    observer.observe(*sim, ui, takes_states());
  }

  // The state of the view that belongs to the scene is reset with another one.
  void follow_scene(const Snapshot& before) {
    if (sim->scene_serial == scene_serial) {
      ui.selection = follow(ui.selection, before.a, sim->a);
      if (ui.joining && before.a.model != sim->a.model) ui.joining.reset();
      return;
    }
    scene_serial = sim->scene_serial;
    if (sim->scene_path.empty() || sim->scene_path != followed) {  // else: the same one again
      frame_ahead(sim->scene, port(), ui);
      ui.fly = false;
    }
    followed = sim->scene_path;
    note_loaded(ui.sweep, *sim);
    ui.selection = {};
    ui.follow.reset();
    ui.trails.clear();
    ui.zoom = {};
    ui.joining.reset();
    remember_scene(sim->scene_path, ui.recent);
    scenes_shown = false;  // another folder, perhaps
  }

  // Pictures of scenes are made while somebody looks at them.
  void list_scenes() {
    const bool shown = ui.shows(scenes_tab);
    if (shown && !scenes_shown) scenes.look(sim->scene_path, ui.recent, renderer);
    if (shown) scenes.update(renderer);
    scenes_shown = shown;
  }

  void read_sweep() {
    if (const auto answer = sweeps.update(ui.sweep))
      runner.send(command::Tell{answer->text, answer->failed, command::OpenSweep::name, answer->kind});
  }

  enum class Hand { there, away };  // away: no events, and no files that show the window
  void draw(double seconds, Hand hand) {
    ImGui::SetCurrentContext(imgui);
    const auto latest = runner.latest();
    const auto last = std::exchange(sim, options.steady ? latest : live.choose(latest, seconds_now()));
    if (takes_states() ||
        (hand == Hand::there && observer.asks(input.events(), layout.view, ImGui::GetTime())))
      sim = observer.with_states(sim);
    costs.begin();
    layout = layout_gui(ui, width, height, unit(), sim->b && ui.side_by_side);
    follow_scene(*last);
    list_scenes();
    read_sweep();
    reframe(port(), ui);
    motion.move(*sim, port(), ui);
    restyle();
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
    io.DeltaTime = static_cast<float>(std::clamp(seconds, 1e-4, 1.0));
    Outbox out;
    GuiFrame frame{*sim,    ui,     layout,         unit(),
                   fonts,  //
                   metrics, out,    scenes,         studio.recorder(),
                   costs,   sweeps, options.steady, options.files.get()};
    if (hand == Hand::there) take_events(frame);
    ImFont* font = fonts.font(kTextSize * unit());
    if (fonts.stale()) {
      fonts.bake();
      font = fonts.font(kTextSize * unit());
    }
    io.FontDefault = font;
    ImGui::NewFrame();
    mouse.select(layout, frame);
    draw_picture_notes(frame, layout);
    draw_interface(frame, seconds);
    ImGui::Render();
    costs.done(FrameCosts::interface);
    const double before = seconds_now();
    const LivePicture::Plan plan = options.steady ? LivePicture::Plan{} : live.plan(*sim, ui, seconds_now());
    const bool drawn =
        plan.draw && view.draw(*sim, ui, motion.trails(), layout, plan.quality, plan.scale, renderer, device);
    const double between = seconds_now();
    observer.tell_of(device);
    costs.done(FrameCosts::picture);
    std::vector<ViewPlace> places;
    for (int i = 0; i < (sim->b && ui.side_by_side ? 2 : 1); ++i) {
      const Rect& r = layout.views[static_cast<std::size_t>(i)];
      places.push_back({i, static_cast<int>(std::lround(r.x)), static_cast<int>(std::lround(r.y)),
                        static_cast<int>(std::lround(r.w)), static_cast<int>(std::lround(r.h))});
    }
    renderer.compose(width, height, places, window_background(ui.dark), ImGui::GetDrawData());
    // Software GL draws when the picture is used.
    const double composing = seconds_now() - between;
    if (!drawn) plain_composing = composing;
    // Pictures from GPU memory take no time from the simulation.
    if (drawn)
      live.took(plan,
                sim->a.poses ? 0 : 1000 * (between - before + std::max(0.0, composing - plain_composing)));
    // After the first picture at rest is there.
    if (warms() && !drawn && hand == Hand::there && input.empty()) warm.draw(renderer);
    shown_once = true;
    if (hand == Hand::there) studio.work(*sim, ui, width, height, renderer);
    costs.done(FrameCosts::compose);
    send_all(out);
  }
};

Viewer::Viewer(GlContext& context, Runner& runner, const ViewerOptions& options)
    : impl_(std::make_unique<Impl>(context, runner, options)) {}
Viewer::~Viewer() = default;

void Viewer::handle(const WindowEvent& event) { impl_->input.add(event); }
void Viewer::send(const Command& command) { impl_->send(command); }
void Viewer::send(const ViewCommand& command) { impl_->try_to(command); }

void Viewer::draw(int width, int height, double seconds) {
  impl_->width = width;
  impl_->height = height;
  impl_->draw(seconds, Impl::Hand::there);
}

void Viewer::draw_aside(int width, int height) {
  ImVec2& pointer = impl_->imgui->IO.MousePos;
  const ImVec2 before = std::exchange(pointer, {-FLT_MAX, -FLT_MAX});
  impl_->width = width;
  impl_->height = height;
  impl_->draw(0, Impl::Hand::away);
  pointer = before;
}

bool Viewer::button_held() const {
  const auto& down = impl_->imgui->IO.MouseDown;
  return std::any_of(std::begin(down), std::end(down), [](bool one) { return one; });
}

Renderer& Viewer::renderer() { return impl_->renderer; }
const UiState& Viewer::ui() const { return impl_->ui; }
const Snapshot& Viewer::snapshot() const { return *impl_->sim; }
void Viewer::set_screen_scale(double scale) { impl_->options.screen_scale = scale; }
const GuiLayout& Viewer::layout() const { return impl_->layout; }
MouseCursor Viewer::cursor() const { return imgui_cursor(); }
std::size_t Viewer::waiting_events() const { return impl_->input.waiting(); }
bool Viewer::wants_text() const { return ImGui::GetIO().WantTextInput; }
std::string Viewer::file_of(const std::string& name, FileUse use) const {
  return named_file(impl_->options.files.get(), name, use);
}
bool Viewer::has_input() const {
  return !impl_->input.empty() || impl_->warms() || impl_->studio.busy() ||
         (impl_->scenes_shown && impl_->scenes.busy()) || impl_->sweeps.busy();
}

}  // namespace pabd
