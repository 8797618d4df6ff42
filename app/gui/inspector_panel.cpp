// SPDX-License-Identifier: MIT
// The numbers of the selection; without one the list of bodies and joints.
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

#include "app/gui/actions.h"
#include "app/gui/inspector_rows.h"
#include "app/gui/number_input.h"
#include "app/gui/panels.h"
#include "app/gui/widgets.h"
#include "app/session/model_edit.h"
#include "sim/base/counted.h"
#include "sim/base/utf8.h"
#include "sim/body/shape_kind.h"
#include "sim/collision/ray_cast.h"
#include "sim/joint/joint_traits.h"

namespace pabd {
namespace {

constexpr std::size_t kMostLines = 40;  // of contacts of one body

void choose(GuiFrame& f, const char* kind, std::size_t number) {
  f.out.send(command::Select{kind, std::to_string(number)});
}

void edit(GuiFrame& f, const ModelEdit& what) { f.out.send(command::Edit{to_json(what)}); }

bool contains(const std::string& text, const std::string& part) {
  return lower_case(text).find(lower_case(part)) != std::string::npos;
}

// A line to click: a name, and something about it on the right.
bool entry(const GuiFrame& f, const std::string& id, const std::string& name, const std::string& about) {
  const bool clicked = ImGui::Selectable(id.c_str());
  ImGui::SameLine(0, 0);
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + f.px(2));
  label(name);
  ImGui::SameLine(ImGui::GetContentRegionMax().x - f.px(4) - ImGui::CalcTextSize(ui_text(about).c_str()).x);
  muted_label(f, about);
  return clicked;
}

// A long list with a filter; only visible lines cost time.
class NameList {
 public:
  void draw(GuiFrame& f) {
    ImGui::SetNextItemWidth(-1);
    if (ImGui::InputTextWithHint("##filter", "find a body or joint by its name", &filter_)) model_.reset();
    refresh(f.sim.a.model);
    ImGui::BeginChild("##names", {0, std::max(f.px(110), ImGui::GetContentRegionAvail().y - f.px(158))});
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(found_.size()));
    while (clipper.Step()) {
      for (int row = clipper.DisplayStart; row < clipper.DisplayEnd; ++row)
        line(f, found_[static_cast<std::size_t>(row)]);
    }
    clipper.End();
    if (found_.empty()) muted_label(f, "nothing has that name");
    ImGui::EndChild();
  }

 private:
  struct Entry {
    bool joint;
    Index number;
  };

  void refresh(const std::shared_ptr<const Model>& model) {
    if (model == model_) return;
    model_ = model;
    found_.clear();
    for (Index i = 0; i < model->size(); ++i)
      if (contains(body_title(*model, i), filter_)) found_.push_back({false, i});
    for (std::size_t k = 0; k < model->joints.size(); ++k)
      if (contains(joint_title(*model, static_cast<Index>(k)), filter_))
        found_.push_back({true, static_cast<Index>(k)});
  }

  void line(GuiFrame& f, const Entry& e) const {
    const Model& model = *model_;
    const auto i = static_cast<std::size_t>(e.number);
    const std::string title = e.joint ? joint_title(model, e.number) : body_title(model, e.number);
    const std::string kind = e.joint ? std::string(to_string(model.joints[i].type)) + " joint"
                                     : (model.fixed[i] ? "fixed" : fmt::format("{:.4g} kg", model.mass[i]));
    if (entry(f, fmt::format("##{}{}", e.joint ? "j" : "b", e.number), title, kind))
      choose(f, e.joint ? "joint" : "body", i);
  }

  std::string filter_;
  std::shared_ptr<const Model> model_;
  std::vector<Entry> found_;
};

constexpr double kAir = 1.05;  // between a new body and what is below it, of its half height

double half_height(const Shape& shape) { return bounds(shape, Vec3::Zero(), Mat3::Identity()).hi.y(); }

// The body of that shape at `place`, lifted on top of what is there.
AddBody body_at(const RunView& run, const Shape& shape, double density, const Vec3& place) {
  AddBody out;
  out.shape = shape;
  out.density = density;
  out.position = place;
  // The top of everything that stands at this place, from above.
  double top = 0;
  for (const Vec3& c : run.state->c) top = std::max(top, c.y());
  const Vec3 sky(place.x(), std::max(top, place.y()) + 1e3, place.z());
  if (run.poses) return out;
  const auto hit = ray_cast(*run.model, *run.state, Ray{sky, -Vec3::UnitY()});
  if (hit)
    out.position.y() =
        std::max(place.y(), hit->point.y() + kAir * half_height(shape) + run.params.contact.d_hat);
  return out;
}

// The form that makes a body where the view looks.
class BodyMaker {
 public:
  void draw(GuiFrame& f) {
    for (const ShapeKind* kind : shape_kinds()) {
      if (!kind->make) continue;
      if (kind != shape_kinds().front()) same_line_if_room(button_width(std::string(kind->name)), f.px(2));
      if (toggle_button(f, std::string(kind->name), kind == kind_, "Shape of the new body")) kind_ = kind;
    }
    const auto number = [&](double& value, const NumberKind& kind, const std::string& help, float width) {
      field_.number(f, kind.name, kind, value, width);
      tooltip(help + "; with a unit or in " + kind.unit);
    };
    const float all = ImGui::GetContentRegionAvail().x, gap = f.px(6);
    int count = 0, k = 0;
    for (const ShapeSize& size : kind_->sizes) count += size.count;
    const float width = (all - static_cast<float>(count - 1) * gap) / static_cast<float>(count);
    for (const ShapeSize& size : kind_->sizes) {
      for (int part = 0; part < size.count; ++part, ++k) {
        const std::string axis(1, "xyz"[part]), help(size.help);
        const bool whole = size.count == 1;
        if (k > 0) ImGui::SameLine(0, gap);
        number(size_[static_cast<std::size_t>(k)],
               {.name = (whole ? std::string(size.key) : axis) + " ", .unit = "m", .digits = 3},
               whole ? help : help + " " + axis, width);
      }
    }
    number(density_, {.name = "density ", .unit = "kg/m³"}, "Water has 1000, steel 7800", all);
    if (ImGui::Button("Add where the view looks", {all, 0})) {
      const AddBody body = body_at(f.sim.a, kind_->make(size_), density_, f.ui.camera.target);
      f.out.send(command::Edit{to_json(body)});
    }
    tooltip("In the middle of the picture, on top of what is there");
  }

 private:
  const ShapeKind* kind_ = shape_kinds().front();  // of those with sizes
  Sizes size_{0.4, 0.4, 0.4};                      // m
  double density_ = 1000;                          // kg/m³
  TypedField field_;
};

class InspectorPanel final : public GuiPanel {
 public:
  void draw(GuiFrame& f) override {
    const RunView& run = f.sim.a;
    const Selection& s = f.ui.selection;
    const auto i = static_cast<std::size_t>(s.index);
    if (s.kind == Selection::Kind::body && i < run.model->shape.size()) return body(f, s.index);
    if (s.kind == Selection::Kind::joint && i < run.model->joints.size()) return joint(f, s.index);
    if (s.kind == Selection::Kind::contact) return contact(f, s);
    nothing(f);
  }

 private:
  void nothing(GuiFrame& f) {
    wrapped_muted_label(f, "Double-click a body, joint or contact in the picture, or choose one here.");
    heading(f, counted(f.sim.a.model->shape.size(), "body", "bodies") + ", " +
                   counted(f.sim.a.model->joints.size(), "joint"));
    list_.draw(f);
    heading(f, "new body");
    maker_.draw(f);
  }

  // Title, buttons and numbers; true when it is to be deleted.
  bool top(GuiFrame& f, const std::string& title, const InspectorRows& rows, const char* remove) {
    label(title);
    if (f.sim.b) {
      ImGui::SameLine();
      muted_label(f, "in A");
    }
    action_button(f, "frame");
    ImGui::SameLine(0, f.px(4));
    if (ImGui::Button("Copy numbers")) ImGui::SetClipboardText(as_text(title, rows).c_str());
    tooltip("Everything below as text");
    bool gone = false;
    if (remove) {
      ImGui::SameLine(0, f.px(4));
      gone = ImGui::Button("Delete");
      tooltip(remove);
    }
    same_line_if_room(button_width("List"), f.px(4));
    if (ImGui::Button("List")) f.out.send(command::Select{"none", ""});
    tooltip("Back to the list of bodies and joints (Esc)");
    for (const InspectorRow& row : rows) {
      if (row.value.empty()) {
        heading(f, row.name);
      } else {
        read_out(f, row.name, row.value, row.warn);
        tooltip(row.help);
      }
    }
    return gone;
  }

  void body(GuiFrame& f, Index number) {
    const Model& model = *f.sim.a.model;
    if (top(f, body_title(model, number), body_rows(f.sim.a, number),
            "Remove this body and its joints (Del); undo brings it back"))
      edit(f, RemoveBody{number});
    contacts_of(f, number);
    heading(f, "joints");
    for (std::size_t k = 0; k < model.joints.size(); ++k) {
      if (model.joints[k].i != number && model.joints[k].j != number) continue;
      if (ImGui::Selectable(
              ui_text(fmt::format("{}##joint{}", joint_title(model, static_cast<Index>(k)), k)).c_str()))
        choose(f, "joint", k);
    }
    join(f, number);
  }

  void contacts_of(GuiFrame& f, Index number) const {
    const auto& contacts = f.sim.a.report.contact_reports;
    std::size_t shown = 0, more = 0;
    for (std::size_t k = 0; k < contacts.size(); ++k) {
      const ContactReport& c = contacts[k];
      if (c.a != number && c.b != number) continue;
      if (++shown > kMostLines) {
        ++more;
        continue;
      }
      const std::string other = body_title(*f.sim.a.model, c.a == number ? c.b : c.a);
      if (entry(f, fmt::format("##contact{}", k), "with " + other, force_text(c.normal_force)))
        choose(f, "contact", k);
    }
    if (more > 0) muted_label(f, fmt::format("and {} more", more));
  }

  // A joint from here to what is double-clicked next, or to the world.
  void join(GuiFrame& f, Index number) {
    const RunView& run = f.sim.a;
    const auto i = static_cast<std::size_t>(number);
    ImGui::SetNextItemWidth(f.px(92));
    if (ImGui::BeginCombo("##type", to_string(type_))) {
      for (const JointType type : kJointTypes)
        if (ImGui::Selectable(to_string(type), type == type_)) type_ = type;
      ImGui::EndCombo();
    }
    tooltip("Type of the new joint");
    ImGui::SameLine(0, f.px(4));
    const bool waits = f.ui.joining.has_value();
    if (ImGui::Button(waits ? "double-click it…" : "Join to body…"))
      f.out.send(command::Join{waits ? "" : to_string(type_)});
    tooltip("Then double-click the second body where the joint shall be");
    same_line_if_room(button_width("To world"), f.px(4));
    ImGui::BeginDisabled(run.model->fixed[i] != 0);
    const bool world = ImGui::Button("To world");
    tooltip("Where this body was double-clicked, as it stands now");
    if (world) {
      AddJoint joint;
      joint.type = type_;
      joint.j = number;
      joint.anchor = joint.anchor_j = run.state->c[i] + run.state->R[i] * f.ui.selection.at;
      // A rod or a spring hangs it from above.
      const double radius = bounding_radius(run.model->shape[i]);
      if (traits_of(type_).points && std::isfinite(radius)) joint.anchor.y() += 2 * radius;
      set_axes(run.state->R[i] * f.ui.selection.normal, joint);
      edit(f, joint);
    }
    ImGui::EndDisabled();
  }

  void joint(GuiFrame& f, Index number) {
    const Model& model = *f.sim.a.model;
    if (top(f, joint_title(model, number), joint_rows(f.sim.a, number),
            "Remove this joint (Del); undo brings it back"))
      edit(f, RemoveJoint{number});
    const Joint& joint = model.joints[static_cast<std::size_t>(number)];
    ends(f, joint.i, joint.j);
  }

  void contact(GuiFrame& f, const Selection& s) {
    const Model& model = *f.sim.a.model;
    const auto i = static_cast<std::size_t>(s.index);
    if (s.index < 0 || i >= f.sim.a.report.contact_reports.size()) {
      wrapped_muted_label(f, "This contact is open now: its bodies are d̂ or more apart.");
    } else {
      const std::string title =
          fmt::format("contact of {} and {}", body_title(model, s.a), body_title(model, s.b));
      top(f, title, contact_rows(f.sim.a, s.index), nullptr);
    }
    if (s.a >= 0 && s.b >= 0) ends(f, s.a, s.b);
  }

  void ends(GuiFrame& f, Index a, Index b) const {
    heading(f, "bodies");
    for (const Index body : {a, b}) {
      if (body == kWorld || body >= f.sim.a.model->size()) continue;
      if (ImGui::Selectable(
              ui_text(fmt::format("{}##end{}", body_title(*f.sim.a.model, body), body)).c_str()))
        choose(f, "body", static_cast<std::size_t>(body));
    }
  }

  NameList list_;
  BodyMaker maker_;
  JointType type_ = JointType::spherical;
};

}  // namespace

const WindowPanel inspector_tab = {
    .name = "inspector",
    .title = "Inspector",
    .help = "The numbers of a body, joint or contact; double-click one in the picture",
    .slot = Slot::left,
    .make = make_panel<InspectorPanel>};

}  // namespace pabd
