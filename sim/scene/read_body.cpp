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
#include "sim/scene/keys.h"
#include "sim/scene/read_external.h"
#include "sim/scene/read_look.h"
#include "sim/scene/read_rotation.h"
#include "sim/scene/read_touch.h"
#include "sim/scene/text.h"

namespace pabd {

namespace {

constexpr std::string_view kMeshFile = "an OBJ, STL or PLY file";
constexpr std::size_t kMostCorners = 4096;  // of a part; the hull has fewer

// Every name of the table once, with its place there.
std::vector<Choice> shape_choices() {
  std::vector<Choice> out;
  for (std::size_t k = 0; k < shape_kinds().size(); ++k) {
    const std::string_view name = shape_kinds()[k]->name;
    if (out.empty() || name != out.back().word) out.push_back({name, static_cast<int>(k)});
  }
  return out;
}

Plane read_plane(const ObjectReader& in) {
  Plane plane{Vec3::UnitY(), 0};
  if (const auto normal = in.find("normal")) plane.normal = normal->unit_vector();
  in.record("normal", plane.normal);
  plane.offset = in.number("offset", kPositionRange, 0);
  return plane;
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
  const double scale = in.number("scale", {1e-6, 1e6}, 1);
  if (!file.value().is_array()) return read_hull(in, file, scale, meshes);
  const std::size_t parts = file.array_size();
  if (parts < 1 || parts > kMostParts) {
    file.fail(fmt::format("{} parts; expected 1 to {} files", parts, kMostParts));
  }
  if (parts == 1) return read_hull(in, file.element(0), scale, meshes);
  std::vector<std::string> names;
  for (std::size_t k = 0; k < parts; ++k) {
    const Node part = file.element(k);
    read_hull(in, part, scale, meshes);
    names.push_back(part.file_name(kMeshFile));
  }
  return meshes.load_parts(names, scale);
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
  static const std::vector<Choice> choices = shape_choices();
  if (!node.value().is_object()) node.fail_expected("an object with a \"type\"");
  const auto type_it = node.value().find("type");
  if (type_it == node.value().end()) {
    std::vector<std::string_view> words;
    for (const Choice& choice : choices) words.push_back(choice.word);
    fail_at(node.context(), node.pointer() + "/type", "missing; expected " + one_of(words));
  }
  const Node type(*type_it, node, "type");
  const ShapeKind& kind = *shape_kinds()[static_cast<std::size_t>(type.choice(choices))];
  const ObjectReader in(node, kind.keys);
  in.record("type", kind.name);
  if (kind.make) return read_sizes(in, kind);
  if (kind.name == "plane") return read_plane(in);
  return read_mesh(in, meshes, even);
}

// The second moment that belongs to "inertia": Ixx, Iyy, Izz, Ixy, Ixz, Iyz.
std::optional<Mat3> read_inertia(const ObjectReader& in) {
  const auto node = in.find("inertia");
  if (!node) return std::nullopt;
  if (!in.has("mass")) node->fail("needs \"mass\" beside it; expected both");
  double I[6];
  node->numbers(I, {-1e18, 1e18, "kg m²"});
  for (const double x : I) in.record("inertia", x);
  Mat3 tensor;
  tensor << I[0], I[3], I[4], I[3], I[1], I[5], I[4], I[5], I[2];
  const Mat3 J = second_moment_of(tensor);
  constexpr double kThin = 1e-6;  // of tr J: laminas and rods get so much across, and files are rounded
  const Eigen::SelfAdjointEigenSolver<Mat3> spread(J);
  const double thin = kThin * J.trace();
  if (!(thin > 0) || !(spread.eigenvalues()[0] >= -thin))
    node->fail(
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

}  // namespace

BodySpec read_body(const Node& node, std::size_t index, MeshLibrary& meshes) {
  const ObjectReader in(node, keys::body);
  BodySpec body;
  body.name = in.name("name");
  if (body.name.empty()) body.name = fmt::format("body {}", index);
  body.shape = read_shape(in.require("shape", "an object such as { \"type\": \"box\", \"size\": [1, 1, 1] }"),
                          meshes, !in.has("inertia"));
  const bool plane = is_plane(body.shape);
  if (plane) refuse_on_plane(in);

  body.fixed = in.boolean("fixed", plane);
  body.mass = read_mass(in);
  body.J = read_inertia(in);
  body.c = in.vec3("position", kPositionRange, Vec3::Zero());
  if (const auto orientation = in.find("orientation")) {
    body.R = read_rotation(*orientation, in, "orientation");
  }
  if (in.find("center_of_mass")) {
    const Vec3 com = in.vec3("center_of_mass", kPositionRange);
    body.shape = with_centre_of_mass(body.shape, com);
    body.c += body.R * com;
  }
  body.v = in.vec3("velocity", kVelocityRange, Vec3::Zero());
  body.omega = in.vec3("angular_velocity", kSpinRange, Vec3::Zero()) * (kPi / 180);
  if (body.fixed) {
    if (!body.v.isZero(0)) in.fail_key("velocity", "a fixed body does not move; expected [0, 0, 0]");
    if (!body.omega.isZero(0))
      in.fail_key("angular_velocity", "a fixed body does not turn; expected [0, 0, 0]");
  }
  if (in.has("surface_velocity")) body.surface_velocity = in.vec3("surface_velocity", kVelocityRange);
  body.external = read_external(in, body.fixed);
  body.look = read_look(in);
  body.touch = read_touch(in);
  return body;
}

}  // namespace pabd
