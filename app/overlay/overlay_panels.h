// SPDX-License-Identifier: MIT
// The panels of a layout and what else stands over a picture, drawn on any canvas.
#pragma once

#include "app/overlay/overlay.h"

namespace pabd {

// The colour of a contact at x = d/d̂ as the picture shows it, sRGB.
Color contact_ink(double x);

// Draws the laid-out panels: a translucent box each, with its content.
void paint_panels(const PanelLayout& layout, const OverlayData& data, Canvas& canvas);

// Height in px that a caption with so many details takes at the top of the free rectangle.
double caption_height(double scale, std::size_t details);

// The labels of a scene at their places in a frame of width × height px; those behind the eye are left out.
void paint_labels(const VisualScene& scene, int width, int height, double scale, Canvas& canvas);

}  // namespace pabd
