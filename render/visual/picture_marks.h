// SPDX-License-Identifier: MIT
// What can be shown in a picture beside bodies, contacts and bonds, by name: one table for command line and window.
#pragma once

#include <span>
#include <string_view>

namespace pabd {

struct PictureMarks {
  bool velocities = false, boxes = false;  // body_marks.h
  bool axes = false, scale = false;        // in the corners of the picture
  bool operator==(const PictureMarks&) const = default;
};

struct PictureMark {
  std::string_view name, help;
  bool PictureMarks::*on;
};

inline std::span<const PictureMark> picture_marks() {
  static constexpr PictureMark kMarks[] = {
      {"velocities", "arrows to where bodies would be 0.2 s later", &PictureMarks::velocities},
      {"boxes", "axis-aligned boxes of bodies, as collision detection sees them", &PictureMarks::boxes},
      {"axes", "the directions of x, y and z", &PictureMarks::axes},
      {"scale", "a bar of a round length, as large as in the middle of the picture", &PictureMarks::scale},
  };
  return kMarks;
}

}  // namespace pabd
