// Everything that can be tuned while it runs: a slider and a field for the exact value each, what differs
// from the scene marked, with a way back.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "app/gui/panels.h"
#include "app/gui/widgets.h"
#include "sim/scene/tuning.h"

namespace pabd {
namespace {

enum class Kind : std::uint8_t { real, log, integer, log_integer, choice };

struct Row {
  const char* key;
  const char* symbol;
  const char* help;
  Kind kind;
  double lo, hi;  // of the slider; the field takes everything that is allowed
  const char* unit;
  std::array<const char*, 4> choices;
};

constexpr Row kContact[] = {
    {"contact.barrier",
     "barrier",
     "Which potential Ψ keeps bodies apart: the polynomial sum S(5), its even part, or the log barrier S(4)",
     Kind::choice,
     0,
     0,
     "",
     {"polynomial", "even", "log", nullptr}},
    {"contact.N",
     "order N",
     "Highest order of the polynomial barrier: higher is softer far from the surface and steeper where "
     "bodies overlap",
     Kind::integer,
     1,
     32,
     "",
     {}},
    {"contact.d_hat", "thickness d̂", "Distance at which contacts begin to push", Kind::log, 1e-5, 1, "m", {}},
    {"contact.kappa",
     "stiffness κ",
     "Height of the barrier. auto: ten times the heaviest body rests on four contacts at d = 0.9 d̂",
     Kind::log,
     1e-3,
     1e9,
     "J",
     {}},
    {"contact.onset",
     "onset ε",
     "Part of d̂ over which the force rises from zero; 0 is the printed formula, whose force jumps",
     Kind::real,
     0,
     0.9,
     "",
     {}},
    {"contact.friction.static",
     "friction μ, static",
     "Largest friction force over normal force while sticking",
     Kind::real,
     0,
     1.5,
     "",
     {}},
    {"contact.friction.dynamic",
     "friction μ, dynamic",
     "The same while sliding; not above the static one",
     Kind::real,
     0,
     1.5,
     "",
     {}},
};
constexpr Row kSolver[] = {
    {"solver.method",
     "solver",
     "sissm is the paper's; descent is for large piles; newton solves what hangs together at once; auto "
     "chooses for each island",
     Kind::choice,
     0,
     0,
     "",
     {"auto", "sissm", "descent", "newton"}},
    {"solver.projection",
     "projection",
     "How the affine matrix becomes a rotation. auto: polar for sissm, tangent for descent",
     Kind::choice,
     0,
     0,
     "",
     {"auto", "polar", "weighted", "tangent"}},
    {"solver.iterations", "iterations", "At most so many in a step", Kind::log_integer, 1, 1000, "", {}},
    {"solver.tolerance",
     "tolerance",
     "A step ends when no body moves by more than this part of d̂ in an iteration",
     Kind::log,
     1e-12,
     1,
     "",
     {}},
    {"solver.relaxation",
     "relaxation",
     "Part of the Jacobi step that sissm takes",
     Kind::real,
     0.05,
     1,
     "",
     {}},
};
constexpr Row kWorldRows[] = {
    {"time_step", "time step h", "Simulated seconds a step", Kind::log, 1e-4, 0.1, "s", {}},
};

bool is_changed(const RunView& run, const std::string& key) {
  return std::any_of(run.changed.begin(), run.changed.end(), [&](const auto& c) { return c.first == key; });
}

double number(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  return end == text.c_str() ? 0 : value;
}

class ParametersPanel final : public GuiPanel {
 public:
  const char* name() const override { return "parameters"; }
  const char* title() const override { return "Parameters"; }
  const char* help() const override { return "What can be tuned while the simulation runs"; }
  Slot slot() const override { return Slot::left; }

  void draw(GuiFrame& f) override {
    if (f.sim.b) {
      side_button(f, Side::a, "A");
      ImGui::SameLine();
      side_button(f, Side::b, "B");
      ImGui::SameLine();
      muted_label(f, "which of the two");
    } else {
      side_ = Side::a;
    }
    const RunView& run = side_ == Side::b && f.sim.b ? *f.sim.b : f.sim.a;
    actions(f, run);
    heading(f, "Contact");
    for (const Row& row : kContact) draw_row(f, run, row);
    heading(f, "Solver");
    for (const Row& row : kSolver) draw_row(f, run, row);
    heading(f, "World");
    for (const Row& row : kWorldRows) draw_row(f, run, row);
    gravity(f, run);
    heading(f, "Keep");
    keep(f, run);
  }

 private:
  void side_button(GuiFrame& f, Side side, const char* text) {
    if (toggle_button(f, text, side_ == side, "Parameters of this simulation")) side_ = side;
  }

  void actions(GuiFrame& f, const RunView& run) {
    if (icon_button(f, "undo", f.sim.can_undo ? "Undo: " + f.sim.undo_text + " (ctrl+z)" : "Nothing to undo",
                    f.sim.can_undo))
      f.out.send(Command(command::Undo{}));
    ImGui::SameLine();
    if (icon_button(f, "redo", f.sim.can_redo ? "Redo: " + f.sim.redo_text + " (ctrl+y)" : "Nothing to redo",
                    f.sim.can_redo))
      f.out.send(Command(command::Redo{}));
    ImGui::SameLine();
    ImGui::BeginDisabled(run.changed.empty());
    if (ImGui::Button("Reset all")) f.out.send(Command(command::ResetParams{"", side_}));
    ImGui::EndDisabled();
    tooltip("Every parameter back to what the scene says");
    ImGui::SameLine();
    muted_label(f, run.changed.empty() ? "as in the scene" : fmt::format("{} changed", run.changed.size()));
  }

  void set(GuiFrame& f, const char* key, const std::string& value, bool more) {
    f.out.send(Command(command::Set{key, value, side_, more}));
  }

  // Name with a mark, the way back, and room for the widgets.
  void begin_row(GuiFrame& f, const RunView& run, const char* key, const char* symbol, const char* help) {
    const bool changed = is_changed(run, key);
    ImGui::PushID(key);
    const float left = ImGui::GetCursorPosX();
    ImGui::AlignTextToFramePadding();
    if (changed) {
      const ImVec2 at = ImGui::GetCursorScreenPos();
      ImGui::GetWindowDrawList()->AddRectFilled({at.x - f.px(9), at.y},
                                                {at.x - f.px(6), at.y + ImGui::GetFrameHeight()},
                                                packed(f.theme().color(1)));
    }
    if (!changed) ImGui::PushStyleColor(ImGuiCol_Text, im_color(f.theme().muted));
    label(symbol);
    if (!changed) ImGui::PopStyleColor();
    tooltip(fmt::format("{}\n{}{}", help, key,
                        changed ? fmt::format("\nscene: {}", tuned_value(f.sim.scene->params, key)) : ""));
    ImGui::SameLine(left + label_width(f));
  }
  void end_row(GuiFrame& f, const RunView& run, const char* key) {
    if (is_changed(run, key)) {
      ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::GetFrameHeight() * 1.15f);
      if (icon_button(f, "reset", "Back to the scene's value"))
        f.out.send(Command(command::ResetParams{key, side_}));
    }
    ImGui::PopID();
  }
  float label_width(const GuiFrame& f) const { return f.px(112); }
  float widget_width() const {
    return ImGui::GetContentRegionAvail().x - ImGui::GetFrameHeight() * 1.15f -
           ImGui::GetStyle().ItemSpacing.x;
  }

  void draw_row(GuiFrame& f, const RunView& run, const Row& row) {
    begin_row(f, run, row.key, row.symbol, row.help);
    if (row.kind == Kind::choice) {
      choice(f, run, row);
    } else {
      slider(f, run, row);
    }
    end_row(f, run, row.key);
  }

  void choice(GuiFrame& f, const RunView& run, const Row& row) {
    const std::string now = tuned_value(run.params, row.key);
    ImGui::SetNextItemWidth(widget_width());
    if (!ImGui::BeginCombo("##choice", now.c_str())) return;
    for (const char* word : row.choices) {
      if (word && ImGui::Selectable(word, now == word)) set(f, row.key, word, false);
    }
    ImGui::EndCombo();
  }

  void slider(GuiFrame& f, const RunView& run, const Row& row) {
    const bool kappa = std::strcmp(row.key, "contact.kappa") == 0;
    const std::string text = tuned_value(run.params, row.key);
    const bool automatic = text == "auto";
    double value = automatic ? run.kappa : number(text);
    const bool whole = row.kind == Kind::integer || row.kind == Kind::log_integer;
    const float field = f.px(78), width = widget_width();
    ImGui::SetNextItemWidth(std::max(f.px(20), width - field - ImGui::GetStyle().ItemInnerSpacing.x));
    const bool log = row.kind == Kind::log || row.kind == Kind::log_integer;
    double moved = std::clamp(value, row.lo, row.hi);
    const bool slid =
        ImGui::SliderScalar("##slider", ImGuiDataType_Double, &moved, &row.lo, &row.hi, "",
                            (log ? ImGuiSliderFlags_Logarithmic : 0) | ImGuiSliderFlags_NoInput);
    if (ImGui::IsItemActivated()) dragging_ = false;
    if (slid) {
      set(f, row.key, whole ? fmt::format("{}", std::lround(moved)) : fmt::format("{:.4g}", moved),
          dragging_);
      dragging_ = true;
    }
    ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
    ImGui::SetNextItemWidth(field);
    const std::string format = whole ? "%.0f" : automatic ? "auto %.3g" : "%.6g";
    ImGui::InputDouble("##field", &value, 0, 0, format.c_str(), ImGuiInputTextFlags_AutoSelectAll);
    if (ImGui::IsItemDeactivatedAfterEdit())
      set(f, row.key, whole ? fmt::format("{}", std::lround(value)) : fmt::format("{}", value), false);
    tooltip(std::string(row.unit).empty()
                ? "Exact value"
                : fmt::format("Exact value, {}",
                              kappa && run.params.contact.barrier == BarrierKind::log ? "J/m²" : row.unit));
    if (kappa && !automatic) {
      ImGui::SetCursorPosX(ImGui::GetCursorPosX() + label_width(f));
      if (ImGui::SmallButton("auto")) set(f, row.key, "auto", false);
      tooltip("κ such that ten times the heaviest movable body rests on four contacts at d = 0.9 d̂");
    }
  }

  void gravity(GuiFrame& f, const RunView& run) {
    begin_row(f, run, "gravity", "gravity", "Acceleration along x, y and z, m/s²");
    double g[3] = {run.params.gravity.x(), run.params.gravity.y(), run.params.gravity.z()};
    ImGui::SetNextItemWidth(widget_width());
    ImGui::InputScalarN("##gravity", ImGuiDataType_Double, g, 3, nullptr, nullptr, "%.4g");
    if (ImGui::IsItemDeactivatedAfterEdit())
      set(f, "gravity", fmt::format("[{},{},{}]", g[0], g[1], g[2]), false);
    end_row(f, run, "gravity");
  }

  void keep(GuiFrame& f, const RunView&) {
    const auto ask = [&](const char* text, const char* what, const char* help) {
      if (ImGui::Button(text)) f.out.send(ViewCommand(command::Ask{what}));
      tooltip(help);
    };
    ask("Save scene…", "save_scene", "The scene file with these parameters (ctrl+s)");
    ImGui::SameLine();
    ask("Save patch…", "save_patch", "Only what differs from the scene, for --ab and for other scenes");
    ask("Apply patch…", "apply_patch", "Parameters from a patch file");
    ImGui::SameLine();
    if (ImGui::Button("Copy command")) f.out.send(ViewCommand(command::CopyCommand{}));
    tooltip("'pabd render …' with these parameters and this camera, to the clipboard (ctrl+shift+c)");
  }

  Side side_ = Side::a;
  bool dragging_ = false;  // the slider that is held has sent something already
};

}  // namespace

std::unique_ptr<GuiPanel> make_parameters_panel() { return std::make_unique<ParametersPanel>(); }

}  // namespace pabd
