// SPDX-License-Identifier: MIT
// Directions and sizes in a picture: an axes cross and a scale bar.
#pragma once

#include <string>

#include "app/plots/canvas.h"
#include "render/visual/visual_scene.h"

namespace pabd {

// x, y and z as the camera sees them, in the bottom left corner of `free`. `scale` is of texts and lines.
void paint_axes(const Camera& camera, const MarkInks& inks, const Rect& free, double scale, Canvas& canvas);

// A bar in the bottom right corner of `free`, as long as 1, 2 or 5 times a power of ten metres is at the target, in a
// picture of so many pixels' height.
void paint_scale_bar(const Camera& camera, const MarkInks& inks, double picture_height, const Rect& free,
                     double scale, Canvas& canvas);

// The longest round length, m, of at most `most` pixels of `pixel` m.
double round_length(double pixel, double most);
// "2 m", "50 cm", "5 mm", "1 km".
std::string length_text(double metres);

}  // namespace pabd
