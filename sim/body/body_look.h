// SPDX-License-Identifier: MIT
// How a body wants to be drawn, where its scene says so. Nothing that a simulation depends on.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "sim/math/types.h"

namespace pabd {

struct BodyLook {
  std::optional<Vec3> color;  // sRGB, 0 … 1; none: one of the palette
  double opacity = 1;         // 0 … 1
  bool checker = false;       // with darker fields, so that it is seen how it turns

  bool operator==(const BodyLook& other) const {
    return color == other.color && opacity == other.opacity && checker == other.checker;
  }
};

// By the body's name: bodies come and go while a scene is edited, names stay.
using BodyLooks = std::map<std::string, BodyLook, std::less<>>;

}  // namespace pabd
