// SPDX-License-Identifier: MIT
// See builder.h. Entries are kept as the values that a scene file would have.
#include "sim/scene/builder.h"

#include "sim/scene/fields.h"
#include "sim/scene/mesh_library.h"
#include "sim/scene/read_scene.h"
#include "sim/scene/tuning.h"

namespace pabd {

struct SceneBuilder::Parts {
  Parts(std::string scene, std::filesystem::path where)
      : name(std::move(scene)), folder(std::move(where)), meshes(folder) {}

  // The value of "file" for a body that has its hulls with it.
  Json enter(const Hull& hull) {
    const std::string file = "hull " + std::to_string(hulls++);
    meshes.enter(file, hull);
    return file;
  }
  Json enter(const Compound& compound) {
    std::vector<std::string> files;
    for (const CompoundPart& part : compound.data->parts) files.push_back(enter(part.hull()));
    meshes.enter(files, compound);
    return files;
  }

  Json shape_of(const spec::Body& body) {
    if (const auto* mesh = std::get_if<spec::Mesh>(&body.shape)) {
      Json out = json_of_entry(*mesh);
      out["type"] = "mesh";
      return out;
    }
    const Shape& shape = std::get<Shape>(body.shape);
    if (const auto* hull = std::get_if<Hull>(&shape)) return {{"type", "mesh"}, {"file", enter(*hull)}};
    if (const CompoundPart* part = off_centre(shape)) return Json(json_of(part->shape));
    if (const auto* compound = std::get_if<Compound>(&shape))
      return {{"type", "mesh"}, {"file", enter(*compound)}};
    return Json(json_of(shape));
  }

  template <class Entry>
  void add(const char* list, const Entry& entry) {
    document[list].push_back(Json(json_of_entry(entry)));
  }

  std::string name;
  std::filesystem::path folder;
  MeshLibrary meshes;
  int hulls = 0;                   // that were entered
  Json document = Json::object();  // its lists grow; build() sets the rest
};

SceneBuilder::SceneBuilder(std::string name, std::filesystem::path folder)
    : parts_(std::make_unique<Parts>(std::move(name), std::move(folder))) {}
SceneBuilder::~SceneBuilder() = default;
SceneBuilder::SceneBuilder(SceneBuilder&&) noexcept = default;
SceneBuilder& SceneBuilder::operator=(SceneBuilder&&) noexcept = default;

void SceneBuilder::add(const spec::Body& body) {
  Json entry = json_of_entry(body);
  entry["shape"] = parts_->shape_of(body);
  const auto* shape = std::get_if<Shape>(&body.shape);
  if (const CompoundPart* part = shape ? off_centre(*shape) : nullptr)
    entry["center_of_mass"] = {-part->offset.x(), -part->offset.y(), -part->offset.z()};
  parts_->document["bodies"].push_back(std::move(entry));
}

void SceneBuilder::add(const spec::Joint& joint) { parts_->add("joints", joint); }
void SceneBuilder::add(const spec::NoCollide& pair) {
  parts_->document["no_collide"].push_back(Json::array({json_of(pair.i), json_of(pair.j)}));
}
void SceneBuilder::add(const spec::Include& include) { parts_->add("includes", include); }
void SceneBuilder::add(const spec::Stack& stack) { parts_->add("generate", stack); }
void SceneBuilder::add(const spec::Wall& wall) { parts_->add("generate", wall); }
void SceneBuilder::add(const spec::Pyramid& pyramid) { parts_->add("generate", pyramid); }
void SceneBuilder::add(const spec::Pile& pile) { parts_->add("generate", pile); }
void SceneBuilder::add(const spec::Chain& chain) { parts_->add("generate", chain); }
void SceneBuilder::add(const spec::Net& net) { parts_->add("generate", net); }

Scene SceneBuilder::build() {
  Json& document = parts_->document;
  document.update(Json::parse(params_json(params)));
  document["format"] = "pabd-scene";
  document["version"] = 1;
  document["name"] = parts_->name;
  document["description"] = description;
  document["joints_default"] = json_of_entry(joint_law);
  document.erase("camera");
  if (camera) document["camera"] = json_of_entry(*camera);
  document.erase("duration");
  if (duration) document["duration"] = *duration;
  ReadContext context{parts_->name, {}, {}};
  IncludeLibrary includes({}, parts_->folder);
  return read_scene(document, context, parts_->meshes, includes);
}

}  // namespace pabd
