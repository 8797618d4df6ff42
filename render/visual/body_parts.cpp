// SPDX-License-Identifier: MIT
// See body_parts.h.
#include "render/visual/body_parts.h"

#include <cmath>
#include <cstring>
#include <string>
#include <unordered_map>

#include "render/visual/palette.h"

namespace pabd {
namespace {

// What makes two lists of parts the same, as bytes.
std::string key_of(const std::vector<SurfacePart>& parts) {
  std::string key;
  const auto append = [&](const auto& value) {
    char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    key.append(bytes, sizeof value);
  };
  for (const SurfacePart& part : parts) {
    append(part.form);
    append(part.upside_down);
    append(part.hull != nullptr ? part.hull->data.get() : nullptr);
    for (int k = 0; k < 3; ++k) append(part.at[k]);
    for (int k = 0; k < 3; ++k) append(part.size[k]);
  }
  return key;
}

class Collector {
 public:
  explicit Collector(BodyParts& out) : out_(out) {}

  BodyParts::Range add(const Shape& shape) {
    surface_.clear();
    kind_of(shape).surface(shape, surface_);
    const auto first = static_cast<std::uint32_t>(out_.parts.size());
    const BodyParts::Range fresh{first, static_cast<std::uint32_t>(surface_.size())};
    const auto [at, is_new] = ranges_.try_emplace(key_of(surface_), fresh);
    if (is_new) {
      for (const SurfacePart& part : surface_) out_.parts.push_back(part_of(part));
    }
    return at->second;
  }

 private:
  BodyPart part_of(const SurfacePart& part) {
    BodyPart out{.primitive = primitive_of(part.form), .at = part.at.cast<float>()};
    if (out.primitive != Primitive::mesh) {
      out.size = scale_of(part).cast<float>();
      return out;
    }
    const HullData* hull = part.hull->data.get();
    const auto [at, is_new] = meshes_.try_emplace(hull, static_cast<int>(out_.meshes.size()));
    if (is_new) out_.meshes.push_back(triangles_of(*hull));
    out.mesh = at->second;
    out.size.setConstant(static_cast<float>(hull->bounding_radius));
    return out;
  }

  BodyParts& out_;
  std::vector<SurfacePart> surface_;
  std::unordered_map<std::string, BodyParts::Range> ranges_;
  std::unordered_map<const HullData*, int> meshes_;
};

}  // namespace

Primitive primitive_of(SurfaceForm form) {
  switch (form) {
    case SurfaceForm::box:
      return Primitive::cube;
    case SurfaceForm::ball:
      return Primitive::sphere;
    case SurfaceForm::half_ball:
      return Primitive::hemisphere;
    case SurfaceForm::tube:
    case SurfaceForm::cylinder:
      return Primitive::cylinder;
    case SurfaceForm::cone:
      return Primitive::cone;
    case SurfaceForm::polyhedron:
      break;
  }
  return Primitive::mesh;
}

// Turned about x, not mirrored: the faces keep their orientation.
Vec3 scale_of(const SurfacePart& part) {
  const double up = part.upside_down ? -1 : 1;
  return part.size.cwiseProduct(Vec3(1, up, up));
}

std::shared_ptr<const MeshData> triangles_of(const HullData& hull) {
  auto mesh = std::make_shared<MeshData>();
  for (const HullFace& face : hull.faces) {
    const auto corner = [&](int k) -> Vec3f {
      return (hull.vertices[hull.loop[face.first + k]] / hull.bounding_radius).cast<float>();
    };
    for (int k = 1; k + 1 < face.count; ++k) {
      for (const int j : {0, k, k + 1}) {
        mesh->corners.push_back(corner(j));
        mesh->normals.push_back(face.normal.cast<float>());
      }
    }
  }
  return mesh;
}

Vec4f color_of(const Model& model, const VisualOptions& options, Index body) {
  const bool fixed = model.fixed[body] != 0;
  const auto at = static_cast<std::size_t>(body);
  if (!options.values.empty() && !fixed) {
    const double value = at < options.values.size() ? options.values[at] : std::nan("");
    return std::isfinite(value) ? value_color(options.value_range.place(value)) : no_value_color();
  }
  if (at < options.looks.size() && options.looks[at].color) return linear_color(*options.looks[at].color);
  return body_color(body, fixed);
}

BodyParts body_parts(const Model& model, const VisualOptions& options) {
  BodyParts out;
  Collector collector(out);
  for (Index i = 0; i < model.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    const BodyLook look = at < options.looks.size() ? options.looks[at] : BodyLook{};
    out.of_body.push_back(look.opacity == 1 ? collector.add(model.shape[i]) : BodyParts::Range{});
    out.colors.push_back(color_of(model, options, i));
    out.checkers.push_back(look.checker ? 1 : 0);
    out.drawn += out.of_body.back().count;
  }
  return out;
}

void add_grounds(const Model& model, VisualScene& out) {
  for (const Shape& shape : model.shape) {
    if (!is_plane(shape)) continue;
    const Plane& plane = as<Plane>(shape);
    out.grounds.push_back({plane.normal.cast<float>(), static_cast<float>(plane.offset)});
  }
}

}  // namespace pabd
