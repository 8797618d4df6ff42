// See read_body.h.
#include "sim/scene/read_body.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/error.h"
#include "sim/scene/keys.h"
#include "sim/scene/text.h"

namespace pabd {

namespace {

enum class ShapeType { box, sphere, capsule, plane, mesh };

constexpr Choice kShapes[] = {{"box", static_cast<int>(ShapeType::box)},
                              {"sphere", static_cast<int>(ShapeType::sphere)},
                              {"capsule", static_cast<int>(ShapeType::capsule)},
                              {"plane", static_cast<int>(ShapeType::plane)},
                              {"mesh", static_cast<int>(ShapeType::mesh)}};

Plane read_plane(const ObjectReader& in) {
  Plane plane{Vec3::UnitY(), 0};
  if (const auto normal = in.find("normal")) plane.normal = normal->unit_vector();
  in.record("normal", plane.normal);
  plane.offset = in.number("offset", kPositionRange, 0);
  return plane;
}

std::string read_mesh_name(const Node& file) {
  const std::string name = file.text(1000);
  if (name.empty() || std::any_of(name.begin(), name.end(), [](unsigned char c) { return c < 0x20; })) {
    file.fail_expected("the name of an OBJ, STL or PLY file");
  }
  return name;
}

// Convex hull of one file, read and entered into the hash. What is in the file counts, not its name.
Hull read_hull(const ObjectReader& in, const Node& file, double scale, MeshLibrary& meshes) {
  const std::string name = read_mesh_name(file);
  try {
    const MeshLibrary::Entry& entry = meshes.load(name, scale);
    in.record("file", entry.digest);
    return entry.hull;
  } catch (const Error& error) {
    file.fail(error.what());
  }
}

// The body's origin is the centre of mass, wherever the file has its own. Several files are the convex parts
// of one body, in common coordinates.
Shape read_mesh(const ObjectReader& in, MeshLibrary& meshes) {
  const Node file = in.require("file", "the name of an OBJ, STL or PLY file, or a list of them");
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
    names.push_back(read_mesh_name(part));
  }
  return meshes.load_parts(names, scale);
}

Shape read_shape(const Node& node, MeshLibrary& meshes) {
  if (!node.value().is_object()) node.fail_expected("an object with a \"type\"");
  const auto type_it = node.value().find("type");
  if (type_it == node.value().end())
    fail_at(node.context(), node.pointer() + "/type",
            "missing; expected \"box\", \"sphere\", \"capsule\", \"mesh\" or \"plane\"");
  const Node type(*type_it, node, "type");
  switch (static_cast<ShapeType>(type.choice(kShapes))) {
    case ShapeType::sphere: {
      const ObjectReader in(node, keys::sphere);
      in.record("type", "sphere");
      return Sphere{in.number("radius", kSizeRange)};
    }
    case ShapeType::capsule: {
      const ObjectReader in(node, keys::capsule);
      in.record("type", "capsule");
      return Capsule{in.number("radius", kSizeRange), in.number("length", kSizeRange)};
    }
    case ShapeType::plane: {
      const ObjectReader in(node, keys::plane);
      in.record("type", "plane");
      return read_plane(in);
    }
    case ShapeType::mesh: {
      const ObjectReader in(node, keys::mesh);
      in.record("type", "mesh");
      return read_mesh(in, meshes);
    }
    case ShapeType::box:
      break;
  }
  const ObjectReader in(node, keys::box);
  in.record("type", "box");
  return Box{0.5 * in.vec3("size", kSizeRange)};
}

// A plane is placed by its normal and offset and never moves, so the rest of a body's keys would say nothing.
void refuse_on_plane(const ObjectReader& in) {
  if (const auto fixed = in.find("fixed"); fixed && !fixed->boolean()) {
    fixed->fail("a plane is always fixed; expected true, or leave the key out");
  }
  for (const std::string_view key :
       {"density", "mass", "position", "orientation", "velocity", "angular_velocity"}) {
    if (in.has(key)) in.fail_key(key, "a plane has only a normal and an offset; remove this key");
  }
}

}  // namespace

BodySpec read_body(const Node& node, std::size_t index, MeshLibrary& meshes) {
  const ObjectReader in(node, keys::body);
  BodySpec body;
  body.name = in.name("name");
  if (body.name.empty()) body.name = fmt::format("body {}", index);
  body.shape =
      read_shape(in.require("shape", "an object such as { \"type\": \"box\", \"size\": [1, 1, 1] }"), meshes);
  const bool plane = std::holds_alternative<Plane>(body.shape);
  if (plane) refuse_on_plane(in);

  body.fixed = in.boolean("fixed", plane);
  body.mass = read_mass(in);
  body.c = in.vec3("position", kPositionRange, Vec3::Zero());
  if (const auto orientation = in.find("orientation")) {
    body.R = orientation->rotation();
    double q[4];  // the hash takes the file's numbers: those of R depend on how they were computed
    orientation->numbers(q, {});
    for (const double x : q) in.record("orientation", x);
  }
  body.v = in.vec3("velocity", kVelocityRange, Vec3::Zero());
  body.omega = in.vec3("angular_velocity", kSpinRange, Vec3::Zero()) * (kPi / 180);
  if (body.fixed) {
    if (!body.v.isZero(0)) in.fail_key("velocity", "a fixed body does not move; expected [0, 0, 0]");
    if (!body.omega.isZero(0))
      in.fail_key("angular_velocity", "a fixed body does not turn; expected [0, 0, 0]");
  }
  return body;
}

}  // namespace pabd
