// SPDX-License-Identifier: MIT
// Light and background of pictures. Linear-light RGB.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace pabd {

// Of what is written on the picture: axes x, y and z, lines and words, and what lies around them. sRGB, 0 … 255; the
// halo's fourth number is its opacity.
struct MarkInks {
  std::uint8_t axes[3][3], text[3], halo[4];

  bool operator==(const MarkInks&) const = default;
};
inline constexpr MarkInks kInksOnLight{
    {{200, 50, 47}, {46, 135, 60}, {38, 92, 190}}, {31, 41, 51}, {255, 255, 255, 200}};
inline constexpr MarkInks kInksOnDark{
    {{255, 120, 112}, {104, 214, 124}, {122, 172, 255}}, {232, 235, 240}, {10, 12, 16, 200}};

//   displayed = albedo · (ambient(n) + sun · max(n·l, 0) · visibility) + highlight
//   ambient(n) = mix(bounce, sky, ½ + ½ n·up)
struct PictureTheme {
  std::string_view name, help;
  float sun[3], sky[3], bounce[3];
  float top[3], bottom[3];   // of the background
  float floor[3];            // where it is fully lit
  bool transparent = false;  // no floor, and nothing behind the bodies
  MarkInks inks = kInksOnLight;

  bool operator==(const PictureTheme&) const = default;
};

inline constexpr PictureTheme kStudioTheme{"studio",
                                           "light grey",
                                           {0.92f, 0.87f, 0.80f},
                                           {0.47f, 0.50f, 0.55f},
                                           {0.30f, 0.29f, 0.28f},
                                           {0.62f, 0.68f, 0.75f},
                                           {0.83f, 0.84f, 0.85f},
                                           {0.72f, 0.72f, 0.715f}};
inline constexpr PictureTheme kDarkTheme{"dark",
                                         "nearly black, for dark slides",
                                         {0.95f, 0.90f, 0.84f},
                                         {0.40f, 0.44f, 0.52f},
                                         {0.16f, 0.16f, 0.18f},
                                         {0.010f, 0.012f, 0.017f},
                                         {0.030f, 0.034f, 0.042f},
                                         {0.040f, 0.043f, 0.050f},
                                         false,
                                         kInksOnDark};
inline constexpr PictureTheme kPaperTheme{"paper",
                                          "white, for print",
                                          {0.92f, 0.88f, 0.83f},
                                          {0.50f, 0.52f, 0.55f},
                                          {0.34f, 0.33f, 0.32f},
                                          {1.0f, 1.0f, 1.0f},
                                          {1.0f, 1.0f, 1.0f},
                                          {1.0f, 1.0f, 1.0f}};

// Opacity follows from the difference between a picture on black and one on white.
inline constexpr PictureTheme on_plain(const PictureTheme& light, float level) {
  PictureTheme out = light;
  out.name = "transparent";
  out.help = "nothing behind the bodies: PNG files with alpha";
  for (auto* color : {&out.top, &out.bottom, &out.floor})
    for (float& channel : *color) channel = level;
  out.transparent = true;
  return out;
}
inline constexpr PictureTheme kOnBlackTheme = on_plain(kStudioTheme, 0),
                              kOnWhiteTheme = on_plain(kStudioTheme, 1);

inline std::span<const PictureTheme* const> picture_themes() {
  static constexpr const PictureTheme* kAll[] = {&kStudioTheme, &kDarkTheme, &kPaperTheme, &kOnBlackTheme};
  return kAll;
}

}  // namespace pabd
