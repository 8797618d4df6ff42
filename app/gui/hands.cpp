// See hands.h.
#include "app/gui/hands.h"

#include <cmath>

namespace pabd {
namespace {

constexpr double kTurn = 2.6;      // rad a height of the picture
constexpr double kNotch = 1.15;    // nearer a notch of the wheel
constexpr double kDragZoom = 3.0;  // e-folds a height of the picture

}  // namespace

void Hands::handle(const WindowEvent& event, bool in_picture, const Rect& place, const GuiFrame&,
                   CameraPose& camera) {
  if (const auto* moved = std::get_if<MouseMoved>(&event)) {
    if (held_ >= 0) drag(moved->x - x_, moved->y - y_, place, camera);
    x_ = moved->x;
    y_ = moved->y;
  } else if (const auto* click = std::get_if<MouseClicked>(&event)) {
    if (click->pressed && in_picture && held_ < 0) {
      held_ = static_cast<int>(click->button);
      shift_ = click->modifiers.shift;
    } else if (!click->pressed && held_ == static_cast<int>(click->button)) {
      held_ = -1;
    }
  } else if (const auto* scrolled = std::get_if<MouseScrolled>(&event)) {
    if (in_picture)
      camera = zoom(camera, {place.w, place.h}, std::pow(kNotch, scrolled->y), x_ - place.x, y_ - place.y);
  } else if (const auto* focus = std::get_if<FocusChanged>(&event)) {
    if (!focus->focused) held_ = -1;
  }
}

void Hands::drag(double dx, double dy, const Rect& place, CameraPose& camera) const {
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
