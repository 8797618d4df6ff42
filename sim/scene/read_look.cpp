// SPDX-License-Identifier: MIT
// See read_look.h.
#include "sim/scene/read_look.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

#include "sim/scene/keys.h"

namespace pabd {
namespace {

constexpr std::string_view kExpected = "\"#rrggbb\", or [r, g, b] with numbers from 0 to 1";

Vec3 hex_color(const Node& node, std::string_view text) {
  std::uint32_t rgb = 0;
  const bool digits =
      text.size() == 7 && text[0] == '#' &&
      std::all_of(text.begin() + 1, text.end(), [](unsigned char c) { return std::isxdigit(c) != 0; });
  if (!digits) node.fail_expected(kExpected);
  std::from_chars(text.data() + 1, text.data() + text.size(), rgb, 16);
  return Vec3((rgb >> 16) & 0xffu, (rgb >> 8) & 0xffu, rgb & 0xffu) / 255;
}

Vec3 color_of(const Node& node) {
  if (node.value().is_string()) return hex_color(node, node.text(100));
  if (!node.value().is_array()) node.fail_expected(kExpected);
  return node.vec3({0, 1});
}

}  // namespace

BodyLook read_look(const ObjectReader& body) {
  BodyLook look;
  if (const auto color = body.find("color")) {
    look.color = color_of(*color);
    body.record("color", *look.color);
  }
  if (const auto material = body.find("material")) {
    const ObjectReader in(*material, keys::material);
    look.opacity = in.number("opacity", {0, 1}, 1);
    look.checker = in.boolean("checker", false);
  }
  return look;
}

void add_look(const BodyLook& look, OrderedJson& out) {
  if (look.color) {
    const Vec3 bytes = 255 * *look.color;
    const Vec3 whole = bytes.array().round();
    // Exactly what "#rrggbb" is read as; else all digits.
    if (whole / 255 == *look.color) {
      out["color"] = fmt::format("#{:02x}{:02x}{:02x}", static_cast<int>(whole.x()),
                                 static_cast<int>(whole.y()), static_cast<int>(whole.z()));
    } else {
      out["color"] = json_of(*look.color);
    }
  }
  if (look.opacity == 1 && !look.checker) return;
  OrderedJson& material = out["material"] = OrderedJson::object();
  if (look.opacity != 1) material["opacity"] = look.opacity;
  if (look.checker) material["checker"] = true;
}

}  // namespace pabd
