// SPDX-License-Identifier: MIT
// Wavefront OBJ: points and faces. Everything about looks and structure is skipped; curves are refused, as
// are words that no OBJ file has.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "sim/base/counted.h"
#include "sim/scene/mesh_surface.h"
#include "sim/scene/text.h"

namespace pabd {
namespace {

constexpr std::array<std::string_view, 14> kSkipped{
    "vt", "vn", "vp", "g", "o", "s", "mg", "usemtl", "mtllib", "l", "bevel", "lod", "c_interp", "d_interp"};

void read_face(MeshText& text, MeshSurface& out, std::uint64_t& largest, std::uint64_t& largest_line) {
  MeshSurface::Face face{static_cast<std::uint32_t>(out.corners.size()), 0, text.line()};
  while (true) {
    const std::string_view word = text.word();
    if (word.empty() || word.front() == '#') break;
    // "7", "7/1", "7//3" or "7/1/3": only the point counts.
    const std::size_t slash = std::min(word.find('/'), word.size());
    if (word.find_first_not_of("0123456789+-/", slash) != std::string_view::npos)
      text.refuse(fmt::format("expected numbers of points, got {}", in_quotes(word)));
    std::int64_t n = text.integer(word.substr(0, slash));
    if (n < 0) n += static_cast<std::int64_t>(out.points.size()) + 1;  // −1 is the latest point
    if (n < 1 || n > static_cast<std::int64_t>(kMostMeshPoints)) {
      text.refuse(fmt::format("there is no point {}; expected 1 to {}", in_quotes(word), out.points.size()));
    }
    if (static_cast<std::uint64_t>(n) > largest) {
      largest = static_cast<std::uint64_t>(n);
      largest_line = text.line();
    }
    out.corners.push_back(static_cast<std::uint32_t>(n - 1));
    ++face.count;
    if (out.corners.size() > 4 * kMostMeshFaces) limit_faces(kMostMeshFaces + 1, "line", text.line());
  }
  if (face.count < 3)
    text.refuse(fmt::format("a face of {}; expected three or more", counted(face.count, "point")));
  out.faces.push_back(face);
  limit_faces(out.faces.size(), "line", text.line());
}

}  // namespace

MeshSurface read_obj(std::string_view bytes) {
  MeshText text(bytes);
  MeshSurface out;
  std::uint64_t largest = 0, largest_line = 1;
  do {
    const std::string_view key = text.word();
    if (key.empty() || key.front() == '#') continue;
    if (key == "v") {
      Vec3 p;
      for (int k = 0; k < 3; ++k) p[k] = text.number(text.word());
      out.points.push_back(p);
      limit_points(out.points.size(), "line", text.line());
    } else if (key == "f") {
      read_face(text, out, largest, largest_line);
    } else if (std::find(kSkipped.begin(), kSkipped.end(), key) == kSkipped.end() && key != "p") {
      text.refuse(
          fmt::format("unknown word {}; expected \"v\", \"f\" and other words of an OBJ file with "
                      "flat faces",
                      in_quotes(key)));
    }
  } while (text.next_line());
  if (largest > out.points.size()) {
    refuse_mesh("line", largest_line,
                fmt::format("there is no point {}; expected 1 to {}", largest, out.points.size()));
  }
  if (out.faces.empty()) text.refuse("the file ends without a face; expected \"f\" lines");
  return out;
}

}  // namespace pabd
