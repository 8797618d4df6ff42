// SPDX-License-Identifier: MIT
// STL, text and binary. Normals and colours in the file are not used.
//
// Binary: 80 bytes of anything, the number of triangles (32 bits, low byte first), then 50 bytes a triangle.
// Some binary files begin with "solid" too, so the size decides first.
#include <fmt/format.h>

#include <bit>
#include <cmath>

#include "sim/base/counted.h"
#include "sim/scene/mesh_surface.h"
#include "sim/scene/text.h"

namespace pabd {
namespace {

constexpr std::size_t kHeader = 84, kTriangle = 50;

std::uint32_t word_at(std::string_view bytes, std::size_t at) {
  std::uint32_t out = 0;
  for (std::size_t k = 0; k < 4; ++k)
    out |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + k])) << (8 * k);
  return out;
}

void add_triangle(MeshSurface& out, const Vec3 (&corner)[3], std::uint64_t place) {
  out.faces.push_back({static_cast<std::uint32_t>(out.corners.size()), 3, place});
  for (const Vec3& p : corner) {
    out.corners.push_back(static_cast<std::uint32_t>(out.points.size()));
    out.points.push_back(p);
  }
}

MeshSurface read_binary(std::string_view bytes, std::uint64_t count) {
  MeshSurface out;
  out.place_unit = "byte";
  limit_faces(count, "byte", 80);
  if (count == 0) refuse_mesh("byte", 80, "the file has no triangles; expected some");
  for (std::size_t at = kHeader; at < bytes.size(); at += kTriangle) {
    Vec3 corner[3];
    for (std::size_t k = 0; k < 9; ++k) {
      const float x = std::bit_cast<float>(word_at(bytes, at + 12 + 4 * k));
      if (!std::isfinite(x)) {
        refuse_mesh("byte", at + 12 + 4 * k, "a coordinate is not finite; expected finite numbers");
      }
      corner[k / 3][static_cast<Eigen::Index>(k % 3)] = static_cast<double>(x);
    }
    add_triangle(out, corner, at);
  }
  return out;
}

void expect(MeshText& text, std::string_view wanted) {
  const std::string_view word = text.word_anywhere();
  if (word != wanted) {
    text.refuse(fmt::format("expected \"{}\", got {}", wanted,
                            word.empty() ? "the end of the file" : in_quotes(word)));
  }
}

MeshSurface read_text(std::string_view bytes) {
  MeshText text(bytes);
  MeshSurface out;
  expect(text, "solid");
  text.next_line();  // the rest of the line is a name
  while (true) {
    const std::string_view word = text.word_anywhere();
    if (word == "endsolid") break;
    if (word != "facet") {
      text.refuse(fmt::format("expected \"facet\" or \"endsolid\", got {}",
                              word.empty() ? "the end of the file" : in_quotes(word)));
    }
    const std::uint64_t place = text.line();
    expect(text, "normal");
    for (int k = 0; k < 3; ++k) text.word_anywhere();  // often wrong, sometimes not even a number
    expect(text, "outer");
    expect(text, "loop");
    Vec3 corner[3];
    for (Vec3& p : corner) {
      expect(text, "vertex");
      for (int k = 0; k < 3; ++k) p[k] = text.number(text.word_anywhere());
    }
    expect(text, "endloop");
    expect(text, "endfacet");
    add_triangle(out, corner, place);
    limit_faces(out.faces.size(), "line", text.line());
  }
  if (out.faces.empty()) text.refuse("the file ends without a facet; expected some");
  return out;
}

}  // namespace

MeshSurface read_stl(std::string_view bytes) {
  const bool long_enough = bytes.size() >= kHeader;
  const std::uint64_t count = long_enough ? word_at(bytes, 80) : 0;
  if (long_enough && bytes.size() == kHeader + kTriangle * count) return read_binary(bytes, count);
  const std::size_t start = bytes.find_first_not_of(" \t\r\n");
  if (start != std::string_view::npos && bytes.substr(start).starts_with("solid")) return read_text(bytes);
  if (!long_enough) {
    refuse_mesh("byte", bytes.size(),
                "the file ends in its header; expected \"solid\" or 84 bytes of a binary header");
  }
  refuse_mesh("byte", 80,
              fmt::format("the header announces {} in {} bytes, but the file has {}; expected "
                          "equal sizes",
                          counted(count, "triangle"), kHeader + kTriangle * count, bytes.size()));
}

}  // namespace pabd
