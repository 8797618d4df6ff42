// SPDX-License-Identifier: MIT
#include "tests/world/rollers.h"

#include <algorithm>

#include "sim/body/shape_kind.h"

namespace pabd::world {

double Round::k() const {
  switch (kind) {
    case Kind::ball:
      return 0.4;
    case Kind::hollow:
      return 2.0 / 3;
    case Kind::cylinder:
    case Kind::disc:
      return 0.5;
    case Kind::hoop:
      break;
  }
  return 1;
}

Shape Round::shape() const {
  if (is_ball()) return Sphere{radius};
  const double width = kind == Kind::cylinder ? 3 : kind == Kind::disc ? 0.1 : 0.5;
  return make_shape("cylinder", {radius, width * radius});
}

Roller on_slope(const Round& round, double degrees, double h, double friction) {
  Setting setting(h, friction, std::min(0.01, 0.05 * round.radius));
  setting.slope(degrees);
  const double up = round.radius + setting.builder.params.contact.d_hat;
  const std::string body = setting.add(round.shape(), 1, up * uphill_normal(degrees), along_z());
  Scene scene = setting.builder.build();
  const double r2 = round.radius * round.radius;
  if (round.kind == Kind::hollow) scene.model.J[1] = Mat3::Identity() * r2 / 3;
  if (round.kind == Kind::hoop) scene.model.J[1] = Vec3(r2 / 2, r2 / 50, r2 / 2).asDiagonal();
  Roller out{Run(std::move(scene)), body};
  out.run.go(0.5);
  return out;
}

std::string add_cart(Setting& setting, double degrees, double wheel_mass, double radius, double board_mass) {
  const Vec3 n = uphill_normal(degrees), t = downhill(degrees);
  const Vec3 middle = (radius + setting.builder.params.contact.d_hat) * n;
  const std::string board =
      setting.add(Box{Vec3(5, 0.6, 1.6) * radius}, board_mass, middle, about_z(-degrees));
  int number = 0;
  for (const double x : {-4.0, 4.0}) {
    for (const double z : {-2.2, 2.2}) {
      const Vec3 at = middle + x * radius * t + Vec3(0, 0, z * radius);
      const std::string name = "w" + std::to_string(number++);
      setting.add(spec::Body{.name = name,
                             .shape = make_shape("cylinder", {radius, radius}),
                             .mass = wheel_mass,
                             .position = at,
                             .orientation = along_z()});
      setting.join(JointType::hinge, board, name, at);
    }
  }
  return board;
}

void add_tiles(Setting& setting, double edge, int along, int across) {
  for (int i = -1; i < along - 1; ++i)
    for (int k = -1; k < across - 1; ++k)
      setting.add(Box{{edge / 2, 0.2, edge / 2}}, 0, {edge * i, -0.2, edge * k});
}

}  // namespace pabd::world
