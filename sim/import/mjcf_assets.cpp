// SPDX-License-Identifier: MIT
// Meshes and colours of MJCF. See mjcf_elements.h.
#include "sim/import/mjcf_elements.h"
#include "sim/import/taken.h"
#include "sim/scene/text.h"

namespace pabd {
namespace {

constexpr std::size_t kMostVertices = 100'000;

MjcfAssets::Mesh read_mesh(const MjcfElement& element, const MjcfCompiler& compiler, std::string& name) {
  const XmlElement& own = element.own();
  MjcfAssets::Mesh mesh;
  mesh.element = own;
  mesh.scale = element.with("scale").vec3("scale").value_or(Vec3::Ones());
  mesh.reference.t = element.with("refpos").vec3("refpos").value_or(Vec3::Zero());
  if (const auto q = element.with("refquat").numbers("refquat", 4, 4)) {
    const Quat quat((*q)[0], (*q)[1], (*q)[2], (*q)[3]);
    if (!(quat.norm() > 1e-9)) own.fail_at("refquat", "its length is 0; expected a quaternion");
    mesh.reference.R = quat.normalized().toRotationMatrix();
  }
  if (const auto file = own.find("file")) {
    std::filesystem::path path(*file);
    if (compiler.strippath) path = path.filename();
    mesh.file = path.string();
    if (name.empty()) name = path.stem().string();
  } else if (const auto numbers = own.numbers("vertex", 12, 3 * kMostVertices)) {
    for (std::size_t k = 0; k + 2 < numbers->size(); k += 3) {
      const Vec3 point((*numbers)[k], (*numbers)[k + 1], (*numbers)[k + 2]);
      mesh.vertices.push_back(mesh.scale.cwiseProduct(point));
    }
  }
  return mesh;
}

}  // namespace

void MjcfAssets::read(const MjcfElement& element, const MjcfCompiler& compiler, ImportNotes& notes) {
  const XmlElement& own = element.own();
  note_attributes(own, mjcf_rows(), notes);
  std::string name = own.find("name").value_or("");
  if (own.name() == "mesh") {
    Mesh mesh = read_mesh(element, compiler, name);
    if (name.empty()) own.fail_at("name", "missing");
    meshes.insert_or_assign(name, std::move(mesh));
  } else if (const auto rgba = element.with("rgba").numbers("rgba", 4, 4)) {
    colors.insert_or_assign(name, Vec3((*rgba)[0], (*rgba)[1], (*rgba)[2]).cwiseMax(0).cwiseMin(1));
  }
}

}  // namespace pabd
