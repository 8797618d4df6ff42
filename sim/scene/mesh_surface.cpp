// SPDX-License-Identifier: MIT
// What the three readers share.
#include "sim/scene/mesh_surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "sim/base/error.h"
#include "sim/scene/text.h"

namespace pabd {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

template <class Number>
bool parse(std::string_view word, Number& out) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  const char* end = word.data() + word.size();
  const auto result = std::from_chars(word.data(), end, out);
  return result.ec == std::errc{} && result.ptr == end;
}

}  // namespace

void refuse_mesh(const char* unit, std::uint64_t place, const std::string& message) {
  throw Error(ErrorKind::bad_input, fmt::format("{} {}: {}", unit, place, message));
}

void limit_points(std::uint64_t count, const char* unit, std::uint64_t place) {
  if (count <= kMostMeshPoints) return;
  refuse_mesh(unit, place,
              fmt::format("more than {} points; expected fewer, simplify the mesh", kMostMeshPoints));
}

void limit_faces(std::uint64_t count, const char* unit, std::uint64_t place) {
  if (count <= kMostMeshFaces) return;
  refuse_mesh(unit, place,
              fmt::format("more than {} faces; expected fewer, simplify the mesh", kMostMeshFaces));
}

bool MeshText::next_line() {
  const std::size_t end = text_.find('\n', at_);
  if (end == std::string_view::npos) {
    at_ = text_.size();
    return false;
  }
  at_ = end + 1;
  ++line_;
  return at_ < text_.size();
}

std::string_view MeshText::word() {
  while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
  const std::size_t start = at_;
  while (at_ < text_.size() && !is_blank(text_[at_]) && text_[at_] != '\n') ++at_;
  return text_.substr(start, at_ - start);
}

std::string_view MeshText::rest() {
  std::string_view out = text_.substr(at_, std::min(text_.find('\n', at_), text_.size()) - at_);
  while (!out.empty() && is_blank(out.front())) out.remove_prefix(1);
  while (!out.empty() && is_blank(out.back())) out.remove_suffix(1);
  return out;
}

std::string_view MeshText::word_anywhere() {
  while (true) {
    const std::string_view found = word();
    if (!found.empty() || !next_line()) return found;
  }
}

double MeshText::number(std::string_view word) const {
  double x = 0;
  if (!parse(word, x) || !std::isfinite(x)) {
    refuse(fmt::format("expected a finite number, got {}", word.empty() ? "nothing" : in_quotes(word)));
  }
  return x;
}

std::int64_t MeshText::integer(std::string_view word) const {
  std::int64_t n = 0;
  if (!parse(word, n)) {
    refuse(fmt::format("expected a whole number, got {}", word.empty() ? "nothing" : in_quotes(word)));
  }
  return n;
}

void MeshText::refuse(const std::string& message) const { refuse_mesh("line", line_, message); }

void require_closed(const MeshSurface& surface) {
  std::vector<std::uint32_t> order(surface.points.size()), number(surface.points.size());
  for (std::uint32_t k = 0; k < order.size(); ++k) order[k] = k;
  const auto compare = [&](std::uint32_t a, std::uint32_t b) {
    const Vec3 &p = surface.points[a], &q = surface.points[b];
    return std::lexicographical_compare(p.data(), p.data() + 3, q.data(), q.data() + 3);
  };
  std::sort(order.begin(), order.end(), compare);
  for (std::size_t k = 0; k < order.size(); ++k) {
    const bool fresh = k == 0 || surface.points[order[k]] != surface.points[order[k - 1]];
    number[order[k]] = fresh ? order[k] : number[order[k - 1]];
  }
  struct Edge {
    std::uint32_t low, high, face;
  };
  std::vector<Edge> edges;
  edges.reserve(surface.corners.size());
  for (std::uint32_t f = 0; f < surface.faces.size(); ++f) {
    const MeshSurface::Face& face = surface.faces[f];
    for (std::uint32_t k = 0; k < face.count; ++k) {
      const std::uint32_t a = number[surface.corners[face.first + k]];
      const std::uint32_t b = number[surface.corners[face.first + (k + 1) % face.count]];
      if (a != b) edges.push_back({std::min(a, b), std::max(a, b), f});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
    return a.low != b.low ? a.low < b.low : a.high != b.high ? a.high < b.high : a.face < b.face;
  });
  for (std::size_t k = 0; k < edges.size();) {
    std::size_t end = k;
    while (end < edges.size() && edges[end].low == edges[k].low && edges[end].high == edges[k].high) ++end;
    if ((end - k) % 2 != 0) {
      const Vec3 &p = surface.points[edges[k].low], &q = surface.points[edges[k].high];
      refuse_mesh(surface.place_unit, surface.faces[edges[k].face].place,
                  fmt::format("the surface is open at the edge from ({}, {}, {}) to ({}, {}, {}); expected a "
                              "closed surface",
                              p.x(), p.y(), p.z(), q.x(), q.y(), q.z()));
    }
    k = end;
  }
}

}  // namespace pabd
