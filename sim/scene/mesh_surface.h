// SPDX-License-Identifier: MIT
// Faces as they stand in a mesh file, and the readers of the three formats. Internal to sim/scene.
//
// A reader throws Error(bad_input) with a message that begins with the line or byte; it knows no file names.
// Nothing in a file is trusted: counts are checked against what is there, indices against the points.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "sim/math/types.h"

namespace pabd {

inline constexpr std::size_t kMostMeshBytes = std::size_t{64} << 20;
inline constexpr std::size_t kMostMeshFaces = 200'000;
inline constexpr std::size_t kMostMeshPoints = 3 * kMostMeshFaces;

struct MeshSurface {
  struct Face {
    std::uint32_t first, count;  // range of `corners`; count ≥ 3
    std::uint64_t place;         // line or byte of the file
  };
  std::vector<Vec3> points;            // finite
  std::vector<std::uint32_t> corners;  // numbers of points, all valid
  std::vector<Face> faces;
  const char* place_unit = "line";  // or "byte"
};

// The kind is told by the name's ending without dot, in small letters: "obj", "stl" or "ply".
MeshSurface read_surface(std::string_view bytes, std::string_view ending);
// That ending, and the bytes of a file of at most kMostMeshBytes. Throws Error(bad_input) without the name.
std::string ending_of(const std::filesystem::path& file);
std::string read_mesh_file(const std::filesystem::path& file);

MeshSurface read_obj(std::string_view text);
MeshSurface read_stl(std::string_view bytes);  // text or binary
MeshSurface read_ply(std::string_view bytes);  // text, binary of either byte order

// Refuses a surface with an edge that belongs to one face only (more exactly: to an odd number). Points at
// the same place count as one.
void require_closed(const MeshSurface& surface);

[[noreturn]] void refuse_mesh(const char* unit, std::uint64_t place, const std::string& message);

// Refuse more than the limits above.
void limit_points(std::uint64_t count, const char* unit, std::uint64_t place);
void limit_faces(std::uint64_t count, const char* unit, std::uint64_t place);

// Walks over words and lines of a text; '#' is no comment here.
class MeshText {
 public:
  explicit MeshText(std::string_view text) : text_(text) {}

  std::uint64_t line() const { return line_; }
  std::size_t position() const { return at_; }
  bool next_line();                  // to the start of the following line; false at the end of the text
  std::string_view word();           // next word of this line; empty at its end
  std::string_view rest();           // of this line, without blanks at its ends
  std::string_view word_anywhere();  // next word of this or a later line; empty at the end of the text
  double number(std::string_view word) const;         // finite, or refused
  std::int64_t integer(std::string_view word) const;  // or refused
  [[noreturn]] void refuse(const std::string& message) const;

 private:
  std::string_view text_;
  std::size_t at_ = 0;
  std::uint64_t line_ = 1;
};

}  // namespace pabd
