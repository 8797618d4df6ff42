// See script.h.
#include "app/gui/script.h"

#include <fmt/format.h>

#include <cmath>
#include <thread>

#include "app/gui/script_reader.h"
#include "app/gui/view_actions.h"
#include "app/workbench/command_json.h"
#include "render/output/png.h"
#include "sim/error.h"

namespace pabd {
namespace {

using ActionJson = nlohmann::ordered_json;

constexpr double kFrameSeconds = 1.0 / 60;
constexpr int kMostFrames = 10000;
constexpr auto kMostWait = std::chrono::seconds(60);

[[noreturn]] void refuse(const std::string& what, const std::string& why) {
  throw Error(ExitCode::bad_input, what + ": " + why);
}

// Fields of the script's own actions; absent: no value.
std::string text(const ActionJson& a, const char* field, const std::string& what,
                 const std::string& fallback = "") {
  if (!a.contains(field)) return fallback;
  if (!a[field].is_string()) refuse(what, fmt::format("\"{}\": expected a text", field));
  return a[field].get<std::string>();
}
double number(const ActionJson& a, const char* field, const std::string& what, double fallback) {
  if (!a.contains(field)) return fallback;
  if (!a[field].is_number()) refuse(what, fmt::format("\"{}\": expected a number", field));
  return a[field].get<double>();
}
Point point(const ActionJson& a, const char* field, const std::string& what) {
  const bool fits = a.contains(field) && a[field].is_array() && a[field].size() == 2 &&
                    a[field][0].is_number() && a[field][1].is_number();
  if (!fits) refuse(what, fmt::format("\"{}\": expected [x, y] in pixels", field));
  return {a[field][0].get<double>(), a[field][1].get<double>()};
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
  }

  void play(const ActionJson& a, const std::string& what) {
    const std::string name = a["do"];
    Command command;
    ViewCommand view;
    if (command_from_json(name, a, what, command)) {
      viewer_.send(command);
    } else if (command_from_json(name, a, what, view)) {
      try {
        viewer_.send(view);
      } catch (const Error& error) {  // to be seen in place, as what commands of the simulation answer
        viewer_.send(Command(command::Tell{error.what(), true}));
      }
    } else if (name == "key") {
      key(a, what);
    } else if (name == "mouse") {
      mouse(a, what);
    } else if (name == "type") {
      for (const char32_t c : decode_text(text(a, "text", what))) viewer_.handle(TextTyped{utf8(c)});
    } else if (name == "window") {
      window(a, what);
    } else if (name == "frame") {
      frame(a, what);
      return;
    } else if (name == "wait") {
      const int frames = static_cast<int>(std::min<double>(number(a, "frames", what, 1), kMostFrames));
      for (int i = 0; i < frames; ++i) draw();
      return;
    } else if (name == "expect") {
      settle();
      expect(a, what);
      return;
    } else if (name == "until") {
      until(a, what);
      return;
    }
    settle();
  }

 private:
  static std::string utf8(char32_t c) {
    std::string out;
    if (c < 0x80) {
      out += static_cast<char>(c);
    } else if (c < 0x800) {
      out += {static_cast<char>(0xC0 | c >> 6), static_cast<char>(0x80 | (c & 0x3F))};
    } else {
      out += {static_cast<char>(0xE0 | c >> 12), static_cast<char>(0x80 | (c >> 6 & 0x3F)),
              static_cast<char>(0x80 | (c & 0x3F))};
    }
    return out;
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
    if (!viewer_.snapshot().playing) runner_.settle();
    draw();
    if (!viewer_.snapshot().playing) runner_.settle();
    draw();
  }

  void key(const ActionJson& a, const std::string& what) {
    const KeyChord chord = parse_key_chord(text(a, "key", what));
    const std::string how = text(a, "how", what, "press");
    if (how != "release") viewer_.handle(KeyChanged{chord.key, chord.modifiers, true, false});
    if (how != "hold") viewer_.handle(KeyChanged{chord.key, {}, false, false});  // ctrl is let go too
  }

  void click(MouseButton button, bool pressed, const Modifiers& m) {
    viewer_.handle(MouseClicked{button, pressed, m});
    draw();
  }

  void mouse(const ActionJson& a, const std::string& what) {
    const Point at = point(a, "at", what);
    const MouseButton button = parse_mouse_button(text(a, "button", what, "left"));
    const std::string how = text(a, "how", what, a.contains("to") ? "drag" : "move");
    const Modifiers m =
        a.contains("with") ? parse_key_chord(text(a, "with", what) + "+a").modifiers : Modifiers{};
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
    if (how == "drag") {
      constexpr int kPieces = 8;
      const Point to = point(a, "to", what);
      click(button, true, m);
      for (int i = 1; i <= kPieces; ++i) {
        const double s = static_cast<double>(i) / kPieces;
        viewer_.handle(MouseMoved{at.x + s * (to.x - at.x), at.y + s * (to.y - at.y)});
        draw();
      }
      if (text(a, "end", what, "release") == "release") click(button, false, m);
    }
    if (m != Modifiers{}) viewer_.handle(KeyChanged{Key::ctrl, {}, false, false});  // let go of
    if (a.contains("wheel")) viewer_.handle(MouseScrolled{0, number(a, "wheel", what, 0)});
  }

  void window(const ActionJson& a, const std::string& what) {
    if (a.contains("size")) {
      const Point size = point(a, "size", what);
      if (!(size.x >= 64 && size.x <= 8192 && size.y >= 64 && size.y <= 8192))
        refuse(what, "\"size\": expected 64 to 8192 pixels");
      width_ = static_cast<int>(size.x);
      height_ = static_cast<int>(size.y);
    }
    const double scale = number(a, "scale", what, 0);
    if (scale != 0) {
      if (!(scale >= 0.5 && scale <= 4)) refuse(what, "\"scale\": expected 0.5 to 4");
      viewer_.set_screen_scale(scale);
    }
  }

  void frame(const ActionJson& a, const std::string& what) {
    settle();
    const std::filesystem::path path = options_.folder / text(a, "path", what);
    check_overwrite(what + ": " + path.string(), path, {options_.force, &options_.inputs});
    Image image;
    viewer_.renderer().queue_read();
    viewer_.renderer().fetch(image);
    write_png(path, part_of(image, text(a, "of", what, "window"), what), {{"Software", "pabd"}});
  }

  Image part_of(const Image& image, const std::string& part, const std::string& what) const {
    const GuiLayout& layout = viewer_.layout();
    if (part == "window") return image;
    if (part == "left") return cut(image, layout.slots[0]);
    if (part == "right_top") return cut(image, layout.slots[1]);
    if (part == "right_bottom") return cut(image, layout.slots[2]);
    if (part == "picture") return cut(image, layout.view);
    if (part == "toolbar") return cut(image, layout.toolbar);
    if (part == "timeline") return cut(image, layout.timeline);
    refuse(what, "\"of\": expected window, left, right_top, right_bottom, picture, toolbar or timeline");
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

  // Empty when it holds, else what is there instead.
  std::string failure(const ActionJson& a, const std::string& what) {
    const ActionJson document = state_document(viewer_.snapshot(), viewer_.ui());
    const std::string at = text(a, "at", what);
    const ActionJson* value = nullptr;
    try {
      value = &document.at(ActionJson::json_pointer(at));
    } catch (const ActionJson::exception&) {
      refuse(what, fmt::format("there is no {}", at));
    }
    const bool numeric = value->is_number();
    const double x = numeric ? value->get<double>() : 0;
    bool holds = true;
    if (a.contains("is"))
      holds = holds && (numeric && a["is"].is_number() ? x == a["is"].get<double>() : *value == a["is"]);
    if (a.contains("is_not")) holds = holds && !(*value == a["is_not"]);
    if (a.contains("near"))
      holds = holds && numeric && std::abs(x - number(a, "near", what, 0)) <= number(a, "within", what, 1e-9);
    if (a.contains("above")) holds = holds && numeric && x > number(a, "above", what, 0);
    if (a.contains("below")) holds = holds && numeric && x < number(a, "below", what, 0);
    if (a.contains("contains")) {
      const std::string all = value->is_string() ? value->get<std::string>() : value->dump();
      holds = holds && all.find(text(a, "contains", what)) != std::string::npos;
    }
    return holds ? ""
                 : fmt::format("{} is {}", at,
                               value->dump(-1, ' ', false, ActionJson::error_handler_t::replace));
  }

  void expect(const ActionJson& a, const std::string& what) {
    if (const std::string wrong = failure(a, what); !wrong.empty()) {
      ActionJson wanted = a;
      wanted.erase("do");
      throw Error(ExitCode::images_differ,
                  fmt::format("{}: expected {}, but {}", what, wanted.dump(), wrong));
    }
  }

  // For a simulation that plays: draws until it holds.
  void until(const ActionJson& a, const std::string& what) {
    const auto end = std::chrono::steady_clock::now() + kMostWait;
    do {
      draw();
      if (failure(a, what).empty()) return;
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    } while (std::chrono::steady_clock::now() < end);
    expect(a, what);
  }

  Viewer& viewer_;
  Runner& runner_;
  const ScriptOptions& options_;
  int width_, height_;
};

}  // namespace

Script::Script(const std::string& json, const std::string& source)
    : actions_(read_script(json, source)), source_(source) {}

std::string action_list() {
  return "Of the simulation:\n" + command_list<Command>() + "Of the view:\n" + command_list<ViewCommand>() +
         "As a person does it:\n"
         "  key               key [, how: press, hold, release]\n"
         "  mouse             at [, how: move, press, release, click, double_click] [, to] [, end: release, "
         "hold]\n"
         "                    [, button] [, with: ctrl, shift] [, wheel]\n"
         "  type              text\n"
         "  window            [size] [, scale]\n"
         "Of the script:\n"
         "  frame             path [, of: window, left, right_top, right_bottom, picture, toolbar, "
         "timeline]\n"
         "  expect, until     at, and any of: is, is_not, near [, within], above, below, contains\n"
         "  wait              [frames]\n";
}

void Script::run(Viewer& viewer, Runner& runner, const ScriptOptions& options) const {
  Player player(viewer, runner, options);
  for (std::size_t i = 0; i < actions_.size(); ++i) {
    ActionJson action = actions_[i];
    fill_in(action, options.folder.string());
    player.play(action, fmt::format("{}: action {}", source_, i));
    if (viewer.ui().quit) return;
  }
}

}  // namespace pabd
