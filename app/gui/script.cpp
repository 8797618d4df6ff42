// SPDX-License-Identifier: MIT
// See script.h.
#include "app/gui/script.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

#include "app/gui/named_files.h"
#include "app/gui/script_actions.h"
#include "app/workbench/command_json.h"
#include "render/output/png.h"
#include "sim/base/error.h"
#include "sim/base/utf8.h"

namespace pabd {
namespace {

using ActionJson = nlohmann::ordered_json;

constexpr double kFrameSeconds = 1.0 / 60;

[[noreturn]] void refuse(const std::string& what, const std::string& why) {
  throw Error(ErrorKind::bad_input, what, why);
}

// "{out}" → folder, in every text of an action.
void fill_in(ActionJson& value, const std::string& folder) {
  if (value.is_string()) {
    std::string s = value;
    for (std::size_t at = 0; (at = s.find("{out}", at)) != std::string::npos; at += folder.size())
      s.replace(at, 5, folder);
    value = s;
  } else if (value.is_structured()) {
    for (ActionJson& part : value) fill_in(part, folder);
  }
}

class Player {
 public:
  Player(Viewer& viewer, Runner& runner, const ScriptOptions& options)
      : viewer_(viewer), runner_(runner), options_(options), width_(options.width), height_(options.height) {
    settle();
    seen_ = newest();
  }

  // Throws Error when it is refused or fails, also when something else went wrong meanwhile.
  void play(AnyAction a, const std::string& what, bool may_fail) {
    what_ = &what;
    may_fail_ = may_fail;
    try {
      std::visit([this](auto& x) { take(x); }, a);
      fail_on_error();
    } catch (const Error& error) {
      if (!may_fail || error.kind() == ErrorKind::images_differ) throw;
    }
    seen_ = newest();
  }

 private:
  template <class AnyCommand>
  void take(AnyCommand& c) {
    each_file_name(c, [this](std::string& name, FileUse, bool) { name = in_folder(name); });
    // A scene may also be one that is shipped, or any that the command line takes.
    if constexpr (std::is_same_v<AnyCommand, Command>) {
      auto* load = std::get_if<command::Load>(&c);
      std::error_code ignored;
      if (load && std::filesystem::is_regular_file(in_folder(load->scene), ignored))
        load->scene = in_folder(load->scene);
    }
    viewer_.send(c);
    settle();
  }
  void take(ScriptAction& a) {
    std::visit([this](const auto& x) { act(x); }, a);
  }

  // Names of files are relative to the script's folder.
  std::string in_folder(const std::string& path) const {
    return path.empty() || path == "-" ? path : (options_.folder / path).string();
  }

  std::uint64_t newest() const {
    const auto& messages = viewer_.snapshot().messages;
    return messages.empty() ? 0 : messages.back().number;
  }

  void fail_on_error() const {
    if (may_fail_) return;
    for (const Message& m : viewer_.snapshot().messages) {
      if (m.number > seen_ && m.severity == Severity::error) throw Error(m.kind, *what_ + ": " + m.text);
    }
  }

  void draw() {
    if (options_.before_frame) options_.before_frame();
    viewer_.draw(width_, height_, kFrameSeconds);
    if (options_.after_frame) options_.after_frame();
  }

  // Until nothing is under way: events are taken, commands carried out, and the frame shows it.
  void settle() {
    do {
      draw();
    } while (viewer_.has_input());
    draw();  // what the last event started
    runner_.settle();
    draw();
    runner_.settle();
    draw();
  }

  void act(const action::Key& a) {
    const KeyChord chord = parse_key_chord(a.key);
    if (a.how != "release") viewer_.handle(KeyChanged{chord.key, chord.modifiers, true, false});
    if (a.how != "hold") viewer_.handle(KeyChanged{chord.key, {}, false, false});  // ctrl is let go too
    settle();
  }

  void act(const action::Type& a) {
    for (const char32_t c : decode_text(a.text)) {
      TextTyped typed;
      append_character(typed.text, c);
      viewer_.handle(typed);
    }
    settle();
  }

  void click(MouseButton button, bool pressed, const Modifiers& m) {
    viewer_.handle(MouseClicked{button, pressed, m});
    draw();
  }

  void act(const action::Mouse& a) {
    const Point at = Point{a.at[0], a.at[1]};
    const MouseButton button = parse_mouse_button(a.button);
    const std::string how = a.how == "move" && !a.to.empty() ? "drag" : a.how;
    const Modifiers m = a.with.empty() ? Modifiers{} : parse_key_chord(a.with + "+a").modifiers;
    viewer_.handle(MouseMoved{at.x, at.y});
    draw();
    draw();  // widgets learn of the pointer one frame before a press
    if (how == "press") click(button, true, m);
    if (how == "release") click(button, false, m);
    if (how == "click" || how == "double_click") {
      for (int i = how == "click" ? 1 : 0; i < 2; ++i) {
        click(button, true, m);
        click(button, false, m);
      }
    }
    if (how == "drag") drag(a, at, button, m);
    if (m != Modifiers{}) viewer_.handle(KeyChanged{Key::ctrl, {}, false, false});  // let go of
    if (a.wheel != 0) viewer_.handle(MouseScrolled{0, a.wheel});
    settle();
  }

  void drag(const action::Mouse& a, Point at, MouseButton button, const Modifiers& m) {
    constexpr int kPieces = 8;
    const Point to = Point{a.to[0], a.to[1]};
    click(button, true, m);
    for (int i = 1; i <= kPieces; ++i) {
      const double s = static_cast<double>(i) / kPieces;
      viewer_.handle(MouseMoved{at.x + s * (to.x - at.x), at.y + s * (to.y - at.y)});
      draw();
    }
    if (a.end == "release") click(button, false, m);
  }

  void act(const action::Window& a) {
    if (!a.size.empty()) {
      const int width = static_cast<int>(a.size[0]), height = static_cast<int>(a.size[1]);
      const std::string why = options_.refusal_of_window ? options_.refusal_of_window(width, height) : "";
      if (!why.empty()) refuse(*what_, "\"size\": " + why);
      width_ = width;
      height_ = height;
    }
    if (a.scale != 0) viewer_.set_screen_scale(a.scale);
    settle();
  }

  void act(const action::Frame& a) {
    settle();
    const std::filesystem::path path = viewer_.file_of(in_folder(a.path), FileUse::write);
    check_overwrite(*what_ + ": " + path.string(), path, {options_.force, &options_.inputs});
    Image image;
    viewer_.renderer().queue_read();
    viewer_.renderer().fetch(image);
    write_png(path, part_of(image, a.of), {{"Software", "pabd"}});
  }

  void act(const action::Wait& a) {
    for (int i = 0; i < a.frames; ++i) draw();
  }

  void act(const action::Print& a) {
    settle();
    if (options_.print) options_.print(a.at + " " + shown(value_at(a.at)) + "\n");
  }

  void act(const action::Expect& a) {
    settle();
    expect(a);
  }

  // Draws until it holds.
  void act(const action::Until& a) {
    const auto end =
        std::chrono::steady_clock::now() + std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                                               std::chrono::duration<double>(a.seconds));
    do {
      draw();
      fail_on_error();
      if (holds(a)) return;
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    } while (std::chrono::steady_clock::now() < end);
    expect(a);
  }

  Image part_of(const Image& image, const std::string& part) const {
    const GuiLayout& layout = viewer_.layout();
    for (const Slot slot : kSlots) {
      if (part == slot_name(slot)) return cut(image, layout.slots[slot]);
    }
    if (part == "picture") return cut(image, layout.view);
    if (part == "toolbar") return cut(image, layout.toolbar);
    if (part == "timeline") return cut(image, layout.timeline);
    return image;
  }

  static Image cut(const Image& image, const Rect& rect) {
    const auto pixel = [](double x, int most) {
      return std::clamp(static_cast<int>(std::lround(x)), 0, most);
    };
    const int x0 = pixel(rect.x, image.width - 1), y0 = pixel(rect.y, image.height - 1);
    Image out;
    out.resize(std::max(1, pixel(rect.right(), image.width) - x0),
               std::max(1, pixel(rect.bottom(), image.height) - y0));
    const std::size_t row = static_cast<std::size_t>(out.width) * 3;
    for (int y = 0; y < out.height; ++y) {
      const auto from = (static_cast<std::size_t>(y0 + y) * static_cast<std::size_t>(image.width) +
                         static_cast<std::size_t>(x0)) *
                        3;
      std::copy_n(image.rgb.begin() + static_cast<std::ptrdiff_t>(from), row,
                  out.rgb.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(y) * row));
    }
    return out;
  }

  ActionJson value_at(const std::string& at) const {
    const ActionJson document = state_document(viewer_.snapshot(), viewer_.ui(), viewer_.layout());
    try {
      return document.at(ActionJson::json_pointer(at));
    } catch (const ActionJson::exception&) {
      refuse(*what_, fmt::format("there is no {}", at));
    }
  }

  static std::string shown(const ActionJson& value) {
    return value.dump(-1, ' ', false, ActionJson::error_handler_t::replace);
  }

  bool holds(const action::Condition& a) const {
    const ActionJson value = value_at(a.at);
    const bool numeric = value.is_number();
    const double x = numeric ? value.get<double>() : 0;
    const auto equals = [&](const ActionJson& other) {
      return numeric && other.is_number() ? x == other.get<double>() : value == other;
    };
    if (a.is && !equals(*a.is)) return false;
    if (a.is_not && equals(*a.is_not)) return false;
    if (a.near && !(numeric && std::abs(x - *a.near) <= a.within.value_or(1e-9))) return false;
    if (a.above && !(numeric && x > *a.above)) return false;
    if (a.below && !(numeric && x < *a.below)) return false;
    if (!a.contains) return true;
    const std::string all = value.is_string() ? value.get<std::string>() : value.dump();
    return all.find(*a.contains) != std::string::npos;
  }

  void expect(const action::Condition& a) const {
    if (holds(a)) return;
    ActionJson wanted;
    action::Condition copy = a;
    copy.condition_fields([&](const command::Field& field, const auto& value) {
      if constexpr (requires { value.has_value(); }) {
        if (value) wanted[field.name] = *value;
      } else {
        wanted[field.name] = value;
      }
    });
    throw Error(ErrorKind::images_differ, fmt::format("{}: expected {}, but {} is {}", *what_, wanted.dump(),
                                                      a.at, shown(value_at(a.at))));
  }

  Viewer& viewer_;
  Runner& runner_;
  const ScriptOptions& options_;
  int width_, height_;
  std::uint64_t seen_ = 0;  // newest message before the action
  // Of the action that is carried out:
  const std::string* what_ = nullptr;  // file and number, for messages
  bool may_fail_ = false;
};

}  // namespace

Script::Script(const std::string& json, const std::string& source)
    : actions_(read_script(json, source)), source_(source) {}

void Script::run(Viewer& viewer, Runner& runner, const ScriptOptions& options) const {
  Player player(viewer, runner, options);
  const std::string folder = options.folder.empty() ? "" : std::filesystem::absolute(options.folder).string();
  for (std::size_t i = 0; i < actions_.size(); ++i) {
    if (options.before_action) options.before_action(i);
    ActionJson action = actions_[i];
    fill_in(action, folder);
    const std::string what = fmt::format("{}: action {}", source_, i);
    player.play(parse_action(action, what), what, action.value(kMayFail, false));
    if (viewer.ui().quit) return;
  }
}

}  // namespace pabd
