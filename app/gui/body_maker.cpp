// SPDX-License-Identifier: MIT
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
  for (const Vec3& c : run.state->c) top = std::max(top, c.y());
  const Vec3 sky(place.x(), std::max(top, place.y()) + 1e3, place.z());
  if (run.poses) return out;
  const auto hit = ray_cast(*run.model, *run.state, Ray{sky, -Vec3::UnitY()});
  if (hit)
    out.position.y() =
        std::max(place.y(), hit->point.y() + kAir * half_height(shape) + run.params.contact.d_hat);
  return out;
}

void BodyMaker::draw(GuiFrame& f) {
  for (const ShapeKind* kind : shape_kinds()) {
    if (!kind->make) continue;
    if (kind != shape_kinds().front()) ImGui::SameLine(0, f.px(2));
    if (toggle_button(f, std::string(kind->name), kind == kind_, "Shape of the new body")) kind_ = kind;
  }
  const auto number = [&](double& value, const std::string& format, const std::string& help, float width) {
    ImGui::SetNextItemWidth(width);
    ImGui::InputDouble(("##" + format).c_str(), &value, 0, 0, format.c_str());
    tooltip(help);
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
      number(size_[static_cast<std::size_t>(k)], (whole ? std::string(size.key) : axis) + " %.3g m",
             whole ? help : help + " " + axis, width);
    }
  }
  number(density_, "density %.4g kg/m³", "Water has 1000, steel 7800", all);
  if (ImGui::Button("Add where the view looks", {all, 0})) {
    const AddBody body = body_at(f.sim.a, kind_->make(size_), density_, f.ui.camera.target);
    f.out.send(Command(command::Edit{to_json(body)}));
  }
  tooltip("In the middle of the picture, on top of what is there");
}

}  // namespace pabd
