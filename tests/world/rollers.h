// SPDX-License-Identifier: MIT
// Round bodies and carts that are about to roll.
#pragma once

#include <string>

#include "tests/world/world.h"

namespace pabd::world {

enum class Kind { ball, hollow, cylinder, disc, hoop };

struct Round {
  Kind kind;
  double radius;  // m

  bool is_ball() const { return kind == Kind::ball || kind == Kind::hollow; }
  double k() const;  // I/(m r²) of its turning about z
  Shape shape() const;
};

// A round body of 1 kg, its axis along z, and what it lies on.
struct Roller {
  Run run;
  std::string body;
};
// On a slope, half a second after it was let go.
Roller on_slope(const Round& round, double degrees, double h, double friction);

// A board of that mass on four wheels, on a slope. Gives back the name of the board; its wheels are w0 to w3.
std::string add_cart(Setting& setting, double degrees, double wheel_mass, double radius, double board_mass);

// A square floor of fixed boxes, their upper side at y = 0, from (-edge, -edge) on.
void add_tiles(Setting& setting, double edge, int along, int across);

}  // namespace pabd::world
