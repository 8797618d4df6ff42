// SPDX-License-Identifier: MIT
// A small picture of boxes, shadows and lines, computed ray by ray on the CPU: something for the comparison
// to look at that is like what the renderer draws and needs no GL.
#pragma once

#include "render/output/image.h"

namespace pabd {

struct PictureOptions {
  int width = 320;
  int height = 240;
  double turn = 0;        // of one box about its vertical axis, degrees
  double albedo = 1;      // factor on the boxes' colours
  bool small_box = true;  // a box of about 14 pixels
  bool line = true;       // one line of 1.5 pixels across the picture
  bool shadow = true;     // of the small box
  int samples = 0;        // 0: four samples a pixel on a rotated grid; 1: on a straight grid; 2: nine samples
};

Image draw_picture(const PictureOptions& options = {});

// The picture moved by whole pixels; the border repeats.
Image moved(const Image& image, int dx, int dy);

// Colours that depend on place and `seed`, smooth with noise: no two frames are the same.
Image test_frame(int width, int height, int seed);

}  // namespace pabd
