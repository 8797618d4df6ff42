// SPDX-License-Identifier: MIT
// See read_body.h.
#include "sim/scene/read_body.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "sim/base/error.h"
#include "sim/body/compound.h"
#include "sim/body/convex_hull.h"
#include "sim/body/mass_properties.h"
#include "sim/body/shape_kind.h"
#include "sim/scene/fields.h"
#include "sim/scene/rotation.h"
#include "sim/scene/text.h"

namespace pabd {

namespace {

constexpr std::string_view kMeshFile = "an OBJ, STL or PLY file";
constexpr std::size_t kMostCorners = 4096;  // of a part; the hull has fewer

// Every name of the table once.
std::vector<std::string_view> shape_names() {
  std::vector<std::string_view> out;
  for (const ShapeKind* kind : shape_kinds())
    if (out.empty() || kind->name != out.back()) out.push_back(kind->name);
  return out;
}

// Convex hull of one file, read and entered into the hash. What is in the file counts, not its name.
Hull read_hull(const ObjectReader& in, const Node& file, double scale, MeshLibrary& meshes) {
  const std::string name = file.file_name(kMeshFile);
  try {
    const MeshLibrary::Entry& entry = meshes.load(name, scale);
    in.record("file", entry.digest);
    return entry.hull;
  } catch (const Error& error) {
    file.fail(error.what());
  }
}

// Convex parts by their corners. Without `even` density the origin of the numbers is the body's.
Shape read_parts(const ObjectReader& in, const Node& list, bool even) {
  for (const std::string_view key : {"file", "scale"})
    if (in.has(key)) in.fail_key(key, "\"parts\" says it all; remove one of the two");
  const std::size_t count = list.array_size();
  if (count < 1 || count > kMostParts)
    list.fail(fmt::format("{} parts; expected 1 to {} lists of corners", count, kMostParts));
  std::vector<Hull> hulls;
  for (std::size_t k = 0; k < count; ++k) {
    const Node part = list.element(k);
    const std::size_t corners = part.array_size();
    if (corners > kMostCorners)
      part.fail(fmt::format("{} corners; expected at most {}", corners, kMostCorners));
    in.record("parts", static_cast<double>(corners));
    std::vector<Vec3> points;
    for (std::size_t p = 0; p < corners; ++p) {
      points.push_back(part.element(p).vec3(kPositionRange));
      in.record("parts", points.back());
    }
    HullResult result = make_hull(points);
    if (!result.hull) part.fail(result.problem);
    hulls.push_back(Hull{std::move(result.hull)});
  }
  if (!even) return make_compound_about(hulls, Vec3::Zero());
  if (hulls.size() == 1) return hulls.front();
  return make_compound(hulls);
}

// The body's origin is the centre of mass, wherever the file has its own. Several files are the convex parts
// of one body, in common coordinates.
Shape read_mesh(const ObjectReader& in, MeshLibrary& meshes, bool even) {
  if (const auto parts = in.find("parts")) return read_parts(in, *parts, even);
  const Node file = in.require("file", "the name of an OBJ, STL or PLY file, a list of them, or \"parts\"");
  spec::Mesh mesh;
  mesh.fields(FieldReader(in));
  if (!file.value().is_array()) return read_hull(in, file, mesh.scale, meshes);
  if (mesh.files.size() == 1) return read_hull(in, file.element(0), mesh.scale, meshes);
  for (std::size_t k = 0; k < mesh.files.size(); ++k) read_hull(in, file.element(k), mesh.scale, meshes);
  return meshes.load_parts(mesh.files, mesh.scale);
}

// A shape that is given by its sizes.
Shape read_sizes(const ObjectReader& in, const ShapeKind& kind) {
  Sizes sizes{};
  double* next = sizes.data();
  for (const ShapeSize& size : kind.sizes) {
    if (size.count == 1) {
      *next = in.number(size.key, kSizeRange);
    } else {
      const Vec3 edges = in.vec3(size.key, kSizeRange);
      std::copy(edges.begin(), edges.end(), next);
    }
    next += size.count;
  }
  return kind.make(sizes);
}

Shape read_shape(const Node& node, MeshLibrary& meshes, bool even) {
  static const std::vector<std::string_view> names = shape_names();
  const std::string_view name = names[type_of_entry(node, names)];
  const ShapeKind& kind = **std::find_if(shape_kinds().begin(), shape_kinds().end(),
                                         [&](const ShapeKind* row) { return row->name == name; });
  const ObjectReader in(node, kind.keys);
  in.record("type", kind.name);
  if (kind.make) return read_sizes(in, kind);
  if (kind.name != "plane") return read_mesh(in, meshes, even);
  spec::PlaneKeys plane;
  plane.fields(FieldReader(in));
  return Plane{plane.normal, plane.offset};
}

// The keys of a body; shapes come from `meshes`.
struct BodyFields : FieldReader {
  BodyFields(const ObjectReader& in, MeshLibrary& library) : FieldReader(in), meshes(library) {}
  using FieldReader::operator();
  void operator()(const Field& field, std::variant<Shape, spec::Mesh>& shape) const {
    shape = read_shape(in_.require(field.key, "an object such as { \"type\": \"box\", \"size\": [1, 1, 1] }"),
                       meshes, !in_.has("inertia"));
  }
  MeshLibrary& meshes;
};

// The second moment that belongs to "inertia": Ixx, Iyy, Izz, Ixy, Ixz, Iyz.
std::optional<Mat3> moment_of(const spec::Body& entry, const ObjectReader& in) {
  if (!entry.inertia) return std::nullopt;
  if (!entry.mass) in.fail_key("inertia", "needs \"mass\" beside it; expected both");
  const std::array<double, 6>& I = *entry.inertia;
  Mat3 tensor;
  tensor << I[0], I[3], I[4], I[3], I[1], I[5], I[4], I[5], I[2];
  const Mat3 J = second_moment_of(tensor);
  constexpr double kThin = 1e-6;  // of tr J: laminas and rods get so much across, and files are rounded
  const Eigen::SelfAdjointEigenSolver<Mat3> spread(J);
  const double thin = kThin * J.trace();
  if (!(thin > 0) || !(spread.eigenvalues()[0] >= -thin))
    in.fail_key("inertia",
                "no body has these moments; expected positive ones of which none is more than the other two "
                "together");
  if (spread.eigenvalues()[0] >= thin) return J;
  const Mat3& axes = spread.eigenvectors();
  return axes * spread.eigenvalues().cwiseMax(thin).asDiagonal() * axes.transpose();
}

// A plane is placed by its normal and offset and never moves, so the rest of a body's keys would say nothing.
void refuse_on_plane(const ObjectReader& in) {
  if (const auto fixed = in.find("fixed"); fixed && !fixed->boolean()) {
    fixed->fail("a plane is always fixed; expected true, or leave the key out");
  }
  for (const std::string_view key :
       {"density", "mass", "inertia", "center_of_mass", "position", "orientation", "velocity",
        "angular_velocity", "force", "torque", "color", "material"}) {
    if (in.has(key)) in.fail_key(key, "a plane has only a normal and an offset; remove this key");
  }
}

void refuse_on_fixed(const spec::Body& entry, const ObjectReader& in) {
  if (!entry.velocity->isZero(0)) in.fail_key("velocity", "a fixed body does not move; expected [0, 0, 0]");
  if (!entry.angular_velocity->isZero(0))
    in.fail_key("angular_velocity", "a fixed body does not turn; expected [0, 0, 0]");
  for (const std::string_view key : {"force", "torque"})
    if (in.has(key)) in.fail_key(key, "a fixed body does not move; remove this key");
}

}  // namespace

BodySpec read_body(const Node& node, std::size_t index, MeshLibrary& meshes) {
  static const auto kKeys = keys_of_entry(spec::Body{});
  const ObjectReader in(node, kKeys);
  spec::Body entry;
  entry.fields(BodyFields(in, meshes));
  if (entry.is_ground()) refuse_on_plane(in);
  if (entry.fixed) refuse_on_fixed(entry, in);

  BodySpec body;
  body.name = entry.name.empty() ? fmt::format("body {}", index) : entry.name;
  body.shape = std::get<Shape>(entry.shape);
  body.fixed = entry.fixed;
  body.mass = mass_of(entry);
  body.J = moment_of(entry, in);
  body.c = *entry.position;
  if (entry.orientation) body.R = rotation_of(*entry.orientation);
  if (entry.center_of_mass) {
    body.shape = with_centre_of_mass(body.shape, *entry.center_of_mass);
    body.c += body.R * *entry.center_of_mass;
  }
  body.v = *entry.velocity;
  body.omega = *entry.angular_velocity * (kPi / 180);
  body.surface_velocity = entry.surface_velocity;
  if (entry.force || entry.torque) body.external = ExternalForce{entry.force, entry.torque};
  if (entry.color) body.look.color = entry.color->rgb;
  if (entry.material) {
    body.look.opacity = entry.material->opacity;
    body.look.checker = entry.material->checker;
  }
  body.touch = touch_of(entry);
  return body;
}

}  // namespace pabd
