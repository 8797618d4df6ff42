// SPDX-License-Identifier: MIT
// See picture_mouse.h.
#include "app/gui/picture_mouse.h"

#include <fmt/format.h>

#include <cmath>

#include "app/gui/pick.h"
#include "app/session/model_edit.h"
#include "sim/joint/joint_traits.h"

namespace pabd {
namespace {

constexpr double kTurn = 2.6;      // rad a height of the picture
constexpr double kNotch = 1.15;    // nearer a notch of the wheel
constexpr double kDragZoom = 3.0;  // e-folds a height of the picture
constexpr double kGlyphReach = 8;  // pixels of an ordinary screen around a glyph

struct Place {
  const RunView& run;
  const Rect& rect;
  Side side;
};

// The picture under a point of the window.
Place place_at(const GuiLayout& layout, const GuiFrame& f, double x, double y) {
  const bool b = f.sim.b && f.ui.side_by_side && layout.views[1].contains(Point{x, y});
  return b ? Place{*f.sim.b, layout.views[1], Side::b} : Place{f.sim.a, layout.views[0], Side::a};
}

std::vector<double> listed(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

void tell(GuiFrame& f, const std::string& text) { f.out.send(command::Tell{text, false}); }

// The joint that waited for `picked` as its second body.
AddJoint joint_between(const Joining& first, const RunView& run, const Selection& picked) {
  AddJoint joint;
  joint.type = joint_type(first.type).value_or(joint.type);
  const auto i = static_cast<std::size_t>(first.body), j = static_cast<std::size_t>(picked.index);
  joint.i = first.body;
  joint.j = picked.index;
  const Vec3 clicked = run.state->c[j] + run.state->R[j] * picked.at;
  joint.anchor = traits_of(joint.type).points ? Vec3(run.state->c[i] + run.state->R[i] * first.at) : clicked;
  joint.anchor_j = clicked;
  set_axes(run.state->R[j] * picked.normal, joint);
  return joint;
}

}  // namespace

void PictureMouse::handle(const WindowEvent& event, bool in_picture, const GuiLayout& layout, GuiFrame& f,
                          CameraPose& camera) {
  const Rect& place = layout.views[0];
  if (const auto* moved = std::get_if<MouseMoved>(&event)) {
    if (held_ >= 0 && !grip_) drag(moved->x - x_, moved->y - y_, place, camera);
    x_ = moved->x;
    y_ = moved->y;
    if (grip_) pull(layout, f, camera);
  } else if (const auto* click = std::get_if<MouseClicked>(&event)) {
    if (click->pressed && in_picture && held_ < 0) {
      press(*click, layout, f, camera);
    } else if (!click->pressed && held_ == static_cast<int>(click->button)) {
      held_ = -1;
      let_go(f.out);
    }
  } else if (const auto* scrolled = std::get_if<MouseScrolled>(&event)) {
    if (grip_) {
      grip_->depth *= std::pow(kNotch, -scrolled->y);
      pull(layout, f, camera);
    } else if (in_picture) {
      const Place at = place_at(layout, f, x_, y_);
      camera =
          zoom(camera, {at.rect.w, at.rect.h}, std::pow(kNotch, scrolled->y), x_ - at.rect.x, y_ - at.rect.y);
    }
  } else if (const auto* focus = std::get_if<FocusChanged>(&event)) {
    if (focus->focused) return;
    held_ = -1;
    space_ = false;
    let_go(f.out);
  } else if (const auto* key = std::get_if<KeyChanged>(&event)) {
    if (key->key == Key::escape && key->pressed) let_go(f.out);
  }
}

void PictureMouse::press(const MouseClicked& click, const GuiLayout& layout, GuiFrame& f,
                         const CameraPose& camera) {
  const bool left = click.button == MouseButton::left;
  held_ = static_cast<int>(click.button);
  shift_ = click.modifiers.shift;
  if (left && space_) {
    shoot(layout, f, camera);
    held_ = -1;
  } else if (left && click.modifiers.ctrl) {
    if (!grab(layout, f, camera)) held_ = -1;
  }
}

bool PictureMouse::grab(const GuiLayout& layout, GuiFrame& f, const CameraPose& camera) {
  const Place at = place_at(layout, f, x_, y_);
  const auto hit = pick_body(at.run, camera, {at.rect.w, at.rect.h}, x_ - at.rect.x, y_ - at.rect.y);
  if (!hit) return false;
  const auto i = static_cast<std::size_t>(hit->body);
  if (at.run.model->fixed[i]) {
    tell(f, at.run.model->name[i] + " is fixed and cannot be pulled");
    return false;
  }
  const Vec3 r = at.run.state->R[i].transpose() * (hit->point - at.run.state->c[i]);
  grip_ = Grip{at.run.model, hit->body, r, hit->depth, at.side};
  if (!f.sim.playing) tell(f, "paused: it follows when time goes on (space)");
  pull(layout, f, camera);
  return true;
}

void PictureMouse::pull(const GuiLayout& layout, GuiFrame& f, const CameraPose& camera) {
  const RunView& run = grip_->side == Side::b && f.sim.b ? *f.sim.b : f.sim.a;
  if (run.model != grip_->model) return let_go(f.out);  // the body may have another number now
  const Rect& rect = layout.views[grip_->side == Side::b ? 1 : 0];
  const ViewRay ray = ray_through(camera, {rect.w, rect.h}, x_ - rect.x, y_ - rect.y);
  const double along = -ray.direction.dot(axes_of(camera).back);
  const Vec3 target = ray.origin + grip_->depth / along * ray.direction;
  f.out.send(command::Pull{static_cast<int>(grip_->body), listed(grip_->r), listed(target), 0});
}

void PictureMouse::let_go(Outbox& out) {
  if (!grip_) return;
  grip_.reset();
  out.send(command::Release{});
}

void PictureMouse::shoot(const GuiLayout& layout, GuiFrame& f, const CameraPose& camera) {
  const Place at = place_at(layout, f, x_, y_);
  f.out.send(Command(aim(at.run, camera, {at.rect.w, at.rect.h}, x_ - at.rect.x, y_ - at.rect.y)));
  if (!f.sim.playing) tell(f, "paused: the ball flies when time goes on");
  shot_ = true;
}

bool PictureMouse::plays(const KeyChanged& space) {
  if (space.repeated) return false;
  if (space.pressed) {
    space_ = true;
    shot_ = false;
    return false;
  }
  const bool plays = space_ && !shot_;
  space_ = false;
  return plays;
}

void PictureMouse::select(const GuiLayout& layout, GuiFrame& f) const {
  const ImGuiIO& io = ImGui::GetIO();
  const double x = static_cast<double>(io.MousePos.x), y = static_cast<double>(io.MousePos.y);
  if (!ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left) || io.WantCaptureMouse || io.KeyCtrl || space_ ||
      !layout.view.contains(Point{x, y}))
    return;
  const Place at = place_at(layout, f, x, y);
  const Selection found =
      pick(at.run, f.ui, {at.rect.w, at.rect.h}, x - at.rect.x, y - at.rect.y, kGlyphReach * f.unit);
  if (f.ui.joining) {
    if (found.kind != Selection::Kind::body)
      return tell(f, "that is no body; double-click one, or press Esc");
    const Joining& first = *f.ui.joining;
    f.out.send(command::Edit{to_json(joint_between(first, at.run, found))});
    f.out.send(command::Join{""});
    return;
  }
  command::Select select{kSelectionKinds[static_cast<std::size_t>(found.kind)].name,
                         found.kind == Selection::Kind::none ? "" : std::to_string(found.index)};
  if (found.kind == Selection::Kind::body) {
    select.at = listed(found.at);
    select.normal = listed(found.normal);
  }
  f.out.send(ViewCommand(std::move(select)));
}

void PictureMouse::drag(double dx, double dy, const Rect& place, CameraPose& camera) const {
  const Viewport port{place.w, place.h};
  if (held_ == static_cast<int>(MouseButton::middle) || shift_) {
    camera = pan(camera, port, dx, dy);
  } else if (held_ == static_cast<int>(MouseButton::right)) {
    camera = zoom(camera, port, std::exp(-kDragZoom * dy / place.h), 0.5 * place.w, 0.5 * place.h);
  } else {
    camera = orbit(camera, -kTurn * dx / place.h, kTurn * dy / place.h);
  }
}

}  // namespace pabd
