// SPDX-License-Identifier: MIT
// Triangle meshes of the primitives.
#include "render/visual/primitive_mesh.h"

#include <cmath>
#include <numbers>

namespace pabd {
namespace {

struct Builder {
  Mesh mesh;

  std::uint16_t vertex(double x, double y, double z, double nx, double ny, double nz) {
    const double n = std::sqrt(nx * nx + ny * ny + nz * nz);
    mesh.vertices.push_back(
        {{static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)},
         {static_cast<float>(nx / n), static_cast<float>(ny / n), static_cast<float>(nz / n)}});
    return static_cast<std::uint16_t>(mesh.vertices.size() - 1);
  }
  void triangle(int a, int b, int c) {
    for (const int i : {a, b, c}) mesh.indices.push_back(static_cast<std::uint16_t>(i));
  }
  void quad(int a, int b, int c, int d) {
    triangle(a, b, c);
    triangle(a, c, d);
  }

  // A disc at height y facing up (sign +1) or down (−1).
  void disc(double y, int sign, int segments) {
    const int centre = vertex(0, y, 0, 0, sign, 0);
    for (int i = 0; i < segments; ++i) {
      const double a = 2 * std::numbers::pi * i / segments;
      vertex(std::sin(a), y, std::cos(a), 0, sign, 0);
    }
    for (int i = 0; i < segments; ++i) {
      const int p = centre + 1 + i;
      const int q = centre + 1 + (i + 1) % segments;
      if (sign > 0) {
        triangle(centre, p, q);
      } else {
        triangle(centre, q, p);
      }
    }
  }

  // Rings of a surface of revolution, from top to bottom, joined by quads. `ring(j)` gives radius, height and
  // normal.
  template <class Ring>
  void revolve(int rings, int segments, Ring ring) {
    const int first = static_cast<int>(mesh.vertices.size());
    for (int j = 0; j <= rings; ++j) {
      const auto [r, y, nr, ny] = ring(j);
      for (int i = 0; i <= segments; ++i) {
        const double a = 2 * std::numbers::pi * (i % segments) / segments;
        vertex(r * std::sin(a), y, r * std::cos(a), nr * std::sin(a), ny, nr * std::cos(a));
      }
    }
    for (int j = 0; j < rings; ++j) {
      for (int i = 0; i < segments; ++i) {
        const int a = first + j * (segments + 1) + i;
        const int b = a + segments + 1;
        // Quads at a pole have one edge of no length; only the other triangle is drawn.
        const bool top_pole = mesh.vertices[a].position[1] == mesh.vertices[a + 1].position[1] &&
                              std::hypot(mesh.vertices[a].position[0], mesh.vertices[a].position[2]) < 1e-6f;
        const bool bottom_pole =
            std::hypot(mesh.vertices[b].position[0], mesh.vertices[b].position[2]) < 1e-6f;
        if (!bottom_pole) triangle(a, b, b + 1);
        if (!top_pole) triangle(a, b + 1, a + 1);
      }
    }
  }
};

struct RingShape {
  double radius, height, normal_radial, normal_up;
};

void cube(Builder& b) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const int sign : {-1, 1}) {
      double n[3] = {0, 0, 0};
      n[axis] = sign;
      const int u = (axis + 1) % 3;
      const int v = (axis + 2) % 3;
      const int first = static_cast<int>(b.mesh.vertices.size());
      for (const auto& [du, dv] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
        double p[3];
        p[axis] = sign;
        p[u] = du;
        p[v] = dv;
        b.vertex(p[0], p[1], p[2], n[0], n[1], n[2]);
      }
      if (sign > 0) {
        b.quad(first, first + 1, first + 2, first + 3);
      } else {
        b.quad(first, first + 3, first + 2, first + 1);
      }
    }
  }
}

// Rings from the north pole through `quarters` quarter turns of latitude.
void ball(Builder& b, int segments, int quarters) {
  const int rings = segments / 4 * quarters;
  b.revolve(rings, segments, [&](int j) {
    const double a = 0.5 * std::numbers::pi * quarters * j / rings;
    const double r = j == 0 || (quarters == 2 && j == rings) ? 0 : std::sin(a);
    const double y = std::cos(a);
    return RingShape{r, y, r, y};
  });
}

}  // namespace

Mesh make_mesh(Primitive primitive, int level) {
  const int segments = kSegments[level];
  Builder b;
  switch (primitive) {
    case Primitive::cube:
      cube(b);
      break;
    case Primitive::sphere:
      ball(b, segments, 2);
      break;
    case Primitive::hemisphere:
      ball(b, segments, 1);
      break;
    case Primitive::cylinder:
      b.revolve(1, segments, [](int j) { return RingShape{1.0, j == 0 ? 1.0 : -1.0, 1.0, 0.0}; });
      b.disc(1, 1, segments);
      b.disc(-1, -1, segments);
      break;
    case Primitive::cone:
      // The tip's radius is tiny, not zero, so that its normals stay those of the mantle.
      b.revolve(1, segments, [](int j) {
        return RingShape{j == 0 ? 1e-4 : 1.0, j == 0 ? 1.0 : 0.0, 1.0, 1.0};
      });
      b.disc(0, -1, segments);
      break;
    case Primitive::disc:
      b.disc(0, 1, segments);
      b.disc(0, -1, segments);
      break;
    case Primitive::mesh:  // none of its own
      break;
  }
  return std::move(b.mesh);
}

int level_for_radius(float radius, float tolerance) {
  for (int level = 0; level < kLevels - 1; ++level) {
    if (radius * (1 - std::cos(std::numbers::pi / kSegments[level])) <= static_cast<double>(tolerance))
      return level;
  }
  return kLevels - 1;
}

}  // namespace pabd
