// SPDX-License-Identifier: MIT
// Where bodies are in a picture, by points of their surfaces and the matrices that pictures are drawn with. No GL.
#pragma once

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <memory>
#include <vector>

#include "app/session/session.h"
#include "render/visual/bounds.h"
#include "sim/body/shape_kind.h"
#include "sim/scene/scene.h"

namespace pabd::seen_bodies {

struct Extent {
  double x0 = 1e9, y0 = 1e9, x1 = -1e9, y1 = -1e9;
  float nearest = 1e9f;  // to the eye; negative: behind it
  bool is_empty() const { return x0 > x1; }
  void add(const Mat4f& clip, const Vec3& p) {
    const Vec4f c = clip * p.cast<float>().homogeneous();
    nearest = std::min(nearest, c.w());
    const double x = 0.5 + 0.5 * c.x() / c.w(), y = 0.5 - 0.5 * c.y() / c.w();
    x0 = std::min(x0, x), x1 = std::max(x1, x), y0 = std::min(y0, y), y1 = std::max(y1, y);
  }
};

// The surface of a body by points of its own frame: an independent way to say where it is. Support points in many
// directions where a shape has them, corners of parts else.
inline std::vector<Vec3> surface_of(const Shape& shape) {
  std::vector<Vec3> out;
  std::vector<SurfacePart> parts;
  kind_of(shape).surface(shape, parts);
  for (const SurfacePart& part : parts) {
    if (part.form == SurfaceForm::polyhedron) {
      for (const Vec3& vertex : part.hull->data->vertices) out.push_back(part.at + vertex);
      continue;
    }
    const int around = part.form == SurfaceForm::box ? 1 : 16;
    for (int i = 0; i < 8; ++i) {
      for (int k = 0; k < around; ++k) {
        const double a = 2 * kPi * k / 16, b = kPi * (i / 7.0 - 0.5);
        Vec3 p;
        if (part.form == SurfaceForm::box) {
          p = Vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
        } else if (part.form == SurfaceForm::ball || part.form == SurfaceForm::half_ball) {
          p = Vec3(std::cos(b) * std::cos(a), std::sin(b), std::cos(b) * std::sin(a));
        } else {
          p = Vec3(std::cos(a), part.form == SurfaceForm::cone ? 0 : i % 2 == 0 ? 1 : -1, std::sin(a));
        }
        out.push_back(part.at + part.size.cwiseProduct(p));
      }
    }
  }
  return out;
}

struct Start {
  std::shared_ptr<const Scene> scene;
  FrameView view;
  std::vector<std::vector<Vec3>> surface;  // of the bodies that are in the picture; of others nothing
};

inline Start open_scene(std::shared_ptr<const Scene> scene) {
  Start out;
  out.scene = std::move(scene);
  out.view = Session(out.scene).view();
  const Model& model = out.scene->model;
  const std::vector<std::uint8_t> seen = bodies_in_picture(model, out.scene->initial);
  out.surface.resize(seen.size());
  for (std::size_t i = 0; i < seen.size(); ++i)
    if (seen[i]) out.surface[i] = surface_of(model.shape[i]);
  return out;
}
inline Start open(const std::filesystem::path& file) {
  return open_scene(std::make_shared<const Scene>(load_scene(file)));
}

// Of all bodies in the picture.
inline Extent extent_of(const Camera& camera, double aspect, const Start& start, const State& state) {
  const Mat4f clip =
      projection_matrix(camera, static_cast<float>(aspect), 0.01f, 1000.0f) * view_matrix(camera);
  Extent out;
  for (std::size_t i = 0; i < start.surface.size(); ++i)
    for (const Vec3& p : start.surface[i]) out.add(clip, state.c[i] + state.R[i] * p);
  REQUIRE(out.nearest > 0);
  return out;
}

}  // namespace pabd::seen_bodies
