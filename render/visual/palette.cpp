// SPDX-License-Identifier: MIT
// Palette of bodies and bonds, and the colour map of contacts.
//
//   x   d/d̂   palette of contacts: lightness grows with x, so that the order survives in grey and for every
//             kind of colour blindness
#include "render/visual/palette.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/visual/build_visual.h"
#include "sim/base/srgb.h"

namespace pabd {
namespace {

float linear_from_byte(std::uint32_t byte) {
  return static_cast<float>(linear_from_srgb((byte & 0xffu) / 255.0));
}

// Warm to cool, all of similar lightness and low chroma.
constexpr std::array<std::uint32_t, kBodyColors> kBodies = {
    0xc8775c,  // terracotta
    0x6d8fa6,  // slate blue
    0xe3d3b4,  // cream
    0x87a58e,  // sage
    0xd6ab6d,  // sand
    0x51677f,  // dusk
};

constexpr std::uint32_t kFixedBody = 0x9a9a98;

// Knots of the contact map; linear in linear light between them. Two reds meet at 0: whatever penetrates is
// darker.
constexpr std::array<ContactKnot, 8> kContactMap = {{
    {-1.0, 0.0667f, 0.0008f, 0.0053f},   // nearly black red
    {-1e-6, 0.2883f, 0.0025f, 0.0104f},  // deep red
    {0.0, 0.4729f, 0.0104f, 0.0094f},    // red
    {0.2, 0.6611f, 0.0779f, 0.0000f},    // vermilion
    {0.4, 0.7652f, 0.2297f, 0.0031f},    // orange
    {0.6, 0.7743f, 0.4526f, 0.0142f},    // yellow
    {0.8, 0.2650f, 0.7060f, 0.5200f},    // teal
    {1.0, 0.3086f, 0.7315f, 0.8699f},    // sky
}};

// Scrambles a number: neighbouring bodies get unrelated values (finaliser of a 32-bit mixing hash).
std::uint32_t scramble(std::uint32_t v) {
  v ^= v >> 16;
  v *= 0x7feb352du;
  v ^= v >> 15;
  v *= 0x846ca68bu;
  return v ^ (v >> 16);
}

}  // namespace

Vec4f srgb_color(std::uint32_t rrggbb) {
  return {linear_from_byte(rrggbb >> 16), linear_from_byte(rrggbb >> 8), linear_from_byte(rrggbb), 1.0f};
}

Vec4f linear_color(const Vec3& srgb) {
  Vec4f out;
  for (int i = 0; i < 3; ++i) out[i] = static_cast<float>(linear_from_srgb(srgb[i]));
  out.w() = 1;
  return out;
}

Vec4f body_color(Index number, bool fixed) {
  if (fixed) return srgb_color(kFixedBody);
  // Multiples of the golden ratio, modulo 1, are never close for neighbouring numbers: at least 0.38 apart,
  // more than two of the six bins.
  const double golden = 0.6180339887498949 * static_cast<double>(number);
  const double place = golden - std::floor(golden);
  const auto bin = std::min(static_cast<int>(place * kBodyColors), kBodyColors - 1);
  Vec4f color = srgb_color(kBodies[static_cast<std::size_t>(bin)]);
  const auto shade = static_cast<float>(scramble(static_cast<std::uint32_t>(number)) & 0xffffu) / 65535.0f;
  color.head<3>() *= 0.86f + 0.20f * shade;
  return color;
}

Vec4f bond_point_i_color() { return srgb_color(0x4b2e83); }
Vec4f bond_point_j_color() { return srgb_color(0xf3e9d2); }
Vec4f bond_line_color() { return srgb_color(0x2a2633); }

Vec4f joint_color(JointType type) {
  // In the order of the types; the last ones wait for new types.
  static constexpr std::uint32_t kInk[] = {0xb23a7a, 0x1f6fb2, 0x128a6a, 0x4a535f,
                                           0xc9631a, 0x6b4fc0, 0x7a6a12, 0x8c2f24};
  static_assert(std::size(kInk) >= kJointTypes.size());
  return srgb_color(kInk[static_cast<std::size_t>(type)]);
}

std::span<const ContactKnot> contact_knots() { return kContactMap; }

Vec4f contact_color(double x) {
  if (!(x > kContactMap.front().x)) x = kContactMap.front().x;  // NaN too: nothing good
  const auto above =
      std::find_if(kContactMap.begin(), kContactMap.end(), [x](const ContactKnot& k) { return k.x >= x; });
  if (above == kContactMap.begin()) return {above->r, above->g, above->b, 1};
  if (above == kContactMap.end())
    return {kContactMap.back().r, kContactMap.back().g, kContactMap.back().b, 1};
  const ContactKnot& lo = *(above - 1);
  const ContactKnot& hi = *above;
  const auto t = static_cast<float>((x - lo.x) / (hi.x - lo.x));
  return {lo.r + t * (hi.r - lo.r), lo.g + t * (hi.g - lo.g), lo.b + t * (hi.b - lo.b), 1};
}

}  // namespace pabd
