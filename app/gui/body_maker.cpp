// See body_maker.h.
#include "app/gui/body_maker.h"

#include <algorithm>

#include "app/gui/widgets.h"
#include "sim/collision/ray_cast.h"

namespace pabd {
namespace {

constexpr double kAir = 1.05;  // between a new body and what is below it, of its half height

double half_height(const Shape& shape) { return bounds(shape, Vec3::Zero(), Mat3::Identity()).hi.y(); }

}  // namespace

AddBody body_at(const RunView& run, const Shape& shape, double density, const Vec3& place) {
  AddBody out;
  out.shape = shape;
  out.density = density;
  out.position = place;
  // The top of everything that stands at this place, from above.
  double top = 0;
  for (const Vec3& c : run.state.c) top = std::max(top, c.y());
  const Vec3 sky(place.x(), std::max(top, place.y()) + 1e3, place.z());
  const auto hit = ray_cast(*run.model, run.state, Ray{sky, -Vec3::UnitY()});
  if (hit)
    out.position.y() =
        std::max(place.y(), hit->point.y() + kAir * half_height(shape) + run.params.contact.d_hat);
  return out;
}

void BodyMaker::draw(GuiFrame& f) {
  static constexpr const char* kShapes[] = {"box", "sphere", "capsule"};
  for (int i = 0; i < 3; ++i) {
    if (i > 0) ImGui::SameLine(0, f.px(2));
    if (toggle_button(f, kShapes[i], i == shape_, "Shape of the new body")) shape_ = i;
  }
  const auto number = [&](const char* id, double& value, const char* format, const char* help, float width) {
    ImGui::SetNextItemWidth(width);
    ImGui::InputDouble(id, &value, 0, 0, format);
    tooltip(help);
  };
  const float all = ImGui::GetContentRegionAvail().x, gap = f.px(6);
  const float third = (all - 2 * gap) / 3, half = (all - gap) / 2;
  if (shape_ == 0) {
    number("##x", size_[0], "x %.3g m", "Edge along x", third);
    ImGui::SameLine(0, gap);
    number("##y", size_[1], "y %.3g m", "Edge along y", third);
    ImGui::SameLine(0, gap);
    number("##z", size_[2], "z %.3g m", "Edge along z", third);
  } else {
    number("##r", size_[0], "radius %.3g m", "Radius", shape_ == 1 ? all : half);
    if (shape_ == 2) {
      ImGui::SameLine(0, gap);
      number("##l", size_[1], "length %.3g m", "Between the centres of the two caps; along y", half);
    }
  }
  number("##density", density_, "density %.4g kg/m³", "Water has 1000, steel 7800", all);
  if (ImGui::Button("Add where the view looks", {all, 0})) {
    Shape shape = Box{0.5 * Vec3(size_[0], size_[1], size_[2])};
    if (shape_ == 1) shape = Sphere{size_[0]};
    if (shape_ == 2) shape = Capsule{size_[0], size_[1]};
    f.out.send(Command(command::Edit{to_json(body_at(f.sim.a, shape, density_, f.ui.camera.target))}));
  }
  tooltip("In the middle of the picture, on top of what is there");
}

}  // namespace pabd
