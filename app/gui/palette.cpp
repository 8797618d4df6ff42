// SPDX-License-Identifier: MIT
// See palette.h.
#include "app/gui/palette.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "app/gui/key_table.h"
#include "app/gui/panels.h"
#include "app/gui/widgets.h"
#include "sim/base/utf8.h"

namespace pabd {
namespace {

constexpr int kEntryRows = 12;  // that are seen at once

using Act = std::function<void(const Snapshot&, const UiState&, Outbox&)>;

template <class C>
Act sends(C command) {
  return [command](const Snapshot&, const UiState&, Outbox& out) { out.send(command); };
}

std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> out;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t begin = text.find_first_not_of(' ', at);
    if (begin == text.npos) break;
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    out.push_back(text.substr(begin, end - begin));
    at = end;
  }
  return out;
}

// 2: every word begins a word of `hay`; 1: every word stands in it; 0: one does not.
int fit(const std::string& hay, const std::vector<std::string>& words) {
  int out = 2;
  for (const std::string& word : words) {
    std::size_t at = hay.find(word);
    if (at == hay.npos) return 0;
    while (at != hay.npos && at > 0 && std::isalnum(static_cast<unsigned char>(hay[at - 1])))
      at = hay.find(word, at + 1);
    if (at == hay.npos) out = 1;
  }
  return out;
}

void add_keyless(std::vector<PaletteEntry>& out) {
  const auto add = [&](const char* group, const std::string& words, Act act) {
    out.push_back({group, words, "", std::move(act)});
  };
  for (const WindowPanel* panel : window_panels())
    add("Panels", lower_case(panel->help) + " (" + panel->title + ")",
        sends(ViewCommand(command::Panel{panel->name, true})));
  for (const Slot slot : kSlots) {
    const std::string name = slot == Slot::left        ? "at the left"
                             : slot == Slot::right_top ? "top right"
                                                       : "bottom right";
    add("Panels", "show or hide the panels " + name, [slot](const Snapshot&, const UiState& ui, Outbox& o) {
      o.send(ViewCommand(command::Panel{ui.shown[slot]->name, !ui.open[slot]}));
    });
  }
  const std::pair<const char*, const char*> colors[] = {{"body", "tell bodies apart"},
                                                        {"projection", "‖A − R‖"},
                                                        {"speed", "speed"},
                                                        {"energy", "energy"},
                                                        {"component", "connected components"}};
  for (const auto& [name, words] : colors)
    add("View", std::string("colour of bodies: ") + words, sends(ViewCommand(command::ColorBy{name})));
  for (const auto& [name, words] :
       {std::pair{"back", "from the back"}, {"left", "from the left"}, {"bottom", "from below"}})
    add("View", words, sends(ViewCommand(command::LookFrom{name})));
  add("View", "fly along the camera keys, or stop",
      [](const Snapshot&, const UiState& ui, Outbox& o) { o.send(ViewCommand(command::Fly{!ui.fly})); });
  const auto ask = [&](const char* group, const char* words, const char* what) {
    add(group, words, sends(ViewCommand(command::Ask{what, ""})));
  };
  ask("Files", "save what differs from the scene as a patch", "save_patch");
  ask("Files", "apply a patch of parameters", "apply_patch");
  ask("Files", "save the camera keys", "save_camera");
  ask("Files", "load camera keys", "load_camera");
  add("Parameters", "reset all parameters to the scene's", sends(Command(command::ResetParams{"", Side::a})));
  add("A/B", "compare with a second simulation from here", sends(Command(command::Compare{})));
  add("A/B", "end the comparison", sends(Command(command::EndCompare{})));
  add("A/B", "show B as a ghost", sends(ViewCommand(command::CompareView{"ghost"})));
  add("A/B", "show A and B side by side", sends(ViewCommand(command::CompareView{"side"})));
  for (const double speed : {0.1, 0.25, 0.5, 1.0, 2.0})
    add("Time", "play at " + std::to_string(speed).substr(0, 4) + " of real time",
        sends(Command(command::Speed{speed})));
  add("Time", "play as fast as it goes", sends(Command(command::Speed{0})));
}

}  // namespace

const std::vector<PaletteEntry>& palette_entries() {
  static const std::vector<PaletteEntry> entries = [] {
    std::vector<PaletteEntry> out;
    for (const KeyBinding& binding : key_table()) {
      const auto same = std::find_if(out.begin(), out.end(), [&](const PaletteEntry& e) {
        return e.words == binding.help && e.group == binding.group;
      });
      if (same != out.end()) {
        same->keys += ", " + chord_text(binding.chord);
      } else {
        out.push_back({binding.group, binding.help, chord_text(binding.chord), binding.act});
      }
    }
    add_keyless(out);
    return out;
  }();
  return entries;
}

std::vector<const PaletteEntry*> find_entries(const std::vector<PaletteEntry>& entries,
                                              std::string_view text) {
  const std::vector<std::string> words = words_of(lower_case(text));
  std::vector<const PaletteEntry*> first, then;
  for (const PaletteEntry& entry : entries) {
    const int how = fit(lower_case(entry.group + " " + entry.words + " " + entry.keys), words);
    if (how > 0) (how == 2 ? first : then).push_back(&entry);
  }
  first.insert(first.end(), then.begin(), then.end());
  return first;
}

void Palette::draw(GuiFrame& f, int width, int height) {
  const bool opened = f.ui.palette && !open_;
  open_ = f.ui.palette;
  if (!open_) return;
  if (opened) {
    text_.clear();
    chosen_ = 0;
  }
  const float room_x = static_cast<float>(width) - f.px(24), row = ImGui::GetTextLineHeightWithSpacing();
  const float list_height =
      std::min(row * kEntryRows, std::max(row, 0.8f * static_cast<float>(height) - f.px(90)));
  ImGui::SetNextWindowPos({0.5f * static_cast<float>(width), 0.12f * static_cast<float>(height)},
                          ImGuiCond_Always, {0.5f, 0});
  ImGui::SetNextWindowSize({std::min(f.px(560), room_x), 0});
  if (opened) ImGui::SetNextWindowFocus();
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, f.px(8));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, f.px(1));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {f.px(14), f.px(12)});
  ImGui::Begin("##palette", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav);
  const auto pressed = [](ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key)); };
  const bool up = pressed(ImGuiKey_UpArrow), down = pressed(ImGuiKey_DownArrow);
  if (opened) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(-1);
  const std::string before = text_;
  const bool go = ImGui::InputTextWithHint("##words", "what should be done", &text_,
                                           ImGuiInputTextFlags_EnterReturnsTrue);
  if (text_ != before) chosen_ = 0;
  const auto found = find_entries(palette_entries(), text_);
  const int count = static_cast<int>(found.size());
  if (up || down) chosen_ += down ? 1 : -1;
  chosen_ = std::clamp(chosen_, 0, std::max(0, count - 1));
  const PaletteEntry* meant = nullptr;
  ImGui::BeginChild("##found", {0, list_height});
  if (found.empty()) muted_label(f, "nothing is called so");
  for (int i = 0; i < count; ++i) {
    const PaletteEntry& entry = *found[static_cast<std::size_t>(i)];
    ImGui::PushID(i);
    const float left = ImGui::GetCursorPosX();
    if (ImGui::Selectable("##entry", i == chosen_)) meant = &entry;
    if (i == chosen_ && (up || down)) ImGui::SetScrollHereY(0.5f);
    ImGui::SameLine(left + f.px(4));
    muted_label(f, entry.group);
    ImGui::SameLine(left + f.px(92));
    label(entry.words);
    if (!entry.keys.empty()) {
      const float keys = ImGui::CalcTextSize(ui_text(entry.keys).c_str()).x;
      ImGui::SameLine(std::max(ImGui::GetItemRectSize().x, ImGui::GetContentRegionMax().x - keys - f.px(6)));
      muted_label(f, entry.keys);
    }
    ImGui::PopID();
  }
  ImGui::EndChild();
  if (go && count > 0) meant = found[static_cast<std::size_t>(chosen_)];
  const bool elsewhere = !opened && ImGui::IsMouseClicked(ImGuiMouseButton_Left) &&
                         !ImGui::IsWindowHovered(ImGuiHoveredFlags_RootAndChildWindows);
  if (meant != nullptr || elsewhere || pressed(ImGuiKey_Escape))
    f.out.send(ViewCommand(command::Palette{false}));
  if (meant != nullptr) meant->act(f.sim, f.ui, f.out);
  ImGui::End();
  ImGui::PopStyleVar(3);
}

}  // namespace pabd
