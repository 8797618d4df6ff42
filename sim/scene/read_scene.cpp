// SPDX-License-Identifier: MIT
// Document → Scene, in the order: format, parameters, bodies, generators, joints. See read_scene.h.
#include "sim/scene/read_scene.h"

#include <fmt/format.h>

#include <optional>

#include "sim/base/error.h"
#include "sim/scene/fields.h"
#include "sim/scene/generators.h"
#include "sim/scene/model_builder.h"
#include "sim/scene/no_collide.h"
#include "sim/scene/read_body.h"
#include "sim/scene/read_joint.h"
#include "sim/scene/read_memory.h"
#include "sim/scene/read_params.h"
#include "sim/scene/rotation.h"
#include "sim/scene/text.h"
#include "sim/scene/thickness.h"

namespace pabd {

namespace {

constexpr int kVersion = 1;

void read_bodies(const ObjectReader& scene, MeshLibrary& meshes, ModelBuilder& out) {
  const auto bodies = scene.find("bodies");
  const std::size_t count = bodies ? bodies->array_size() : 0;
  scene.record("bodies", static_cast<double>(count));
  if (count > 0) out.reserve(static_cast<std::int64_t>(count), *bodies);
  for (std::size_t i = 0; i < count; ++i) {
    const Node node = bodies->element(i);
    out.add(read_body(node, i, meshes), node);
  }
}

// Only a scene that was saved in mid-run has them.
void read_contact_memory(const ObjectReader& scene, ModelBuilder& out) {
  const auto list = scene.find("friction_anchors");
  if (!list) return;
  read_memory_of_contacts(*list, out.model.size(), out.state.contacts);
  for (const ContactMemory& contact : out.state.contacts) {
    scene.record("friction_anchors", static_cast<double>(contact.pair >> 32));
    scene.record("friction_anchors", static_cast<double>(contact.pair & 0xffffffffu));
    scene.record("friction_anchors", static_cast<double>(contact.feature));
    scene.record("friction_anchors", contact.stretch);
    scene.record("friction_anchors", static_cast<double>(flags_of(contact)));
  }
}

// The same.
void read_forces_of_joints(const ObjectReader& scene, ModelBuilder& out) {
  const auto list = scene.find("joint_forces");
  if (!list) return;
  read_joint_forces(*list, out.model.joints.size(), out.state.joint_force);
  for (const Vec3& force : out.state.joint_force) scene.record("joint_forces", force);
}

// Name, description and parameters.
void read_settings(const ObjectReader& in, ParameterTable table, const Params& defaults, Scene& out) {
  out.name = in.name("name");
  out.description = in.text("description", 1000);
  if (const auto schema = in.find("$schema"))
    schema->text(1000);  // for editors; says nothing about the scene
  out.params = read_params(in, table, defaults);
}

std::optional<CameraDesc> read_camera(const ObjectReader& scene) {
  const auto node = scene.find("camera");
  if (!node) return std::nullopt;
  static const auto kKeys = keys_of_entry(CameraDesc{});
  const ObjectReader in(*node, kKeys);
  CameraDesc camera;
  camera.fields(FieldReader(in));
  if (!((camera.eye - camera.target).norm() > 1e-6)) {
    in.fail_key("eye", "the camera sits on its target; expected two different points");
  }
  return camera;
}

void read_view(const ObjectReader& in, Scene& out) {
  out.camera = read_camera(in);
  const FieldReader fields(in);
  fields(kDuration, out.duration);
}

ObjectReader read_root(const Json& document, ReadContext& context, ParameterTable table) {
  check_format(document, context);
  return ObjectReader(Node(document, context), scene_object_keys(table));
}

// What an included scene has of the one that includes it.
struct IncludeContext {
  double d_hat;  // m
  bool assumed;  // it is not stated, and may turn out to be another
  IncludeLibrary& includes;
  ParameterTable table;
};

void read_includes(const ObjectReader& scene, const IncludeContext& around, ModelBuilder& out);

// What an included scene gives as well: bodies, generators, scenes that it includes, joints, pairs that never touch.
ModelBuilder read_content(const ObjectReader& in, MeshLibrary& meshes, const IncludeContext& around) {
  ModelBuilder builder(read_joint_defaults(in));
  read_bodies(in, meshes, builder);
  const std::size_t listed = builder.model.name.size();
  run_generators(in, around.d_hat, around.assumed, builder);
  const std::size_t made = builder.model.name.size();
  read_includes(in, around, builder);
  const BodyNames names = builder.names(in.context(), listed, made);
  const std::size_t before = builder.model.joints.size();
  read_joints(in, names, builder);
  builder.move_behind(before);
  read_no_collide(in, names, builder);
  return builder;
}

// The whole of it is checked; what is not taken leaves no trace, in the hash neither.
ModelBuilder read_included(const IncludeLibrary::Opened& opened, const std::string& name,
                           const IncludeContext& around, std::string& hash) {
  const Json document = parse_document(opened.text(), printable(name));
  ReadContext context{printable(name), {}, {}};
  const ObjectReader in = read_root(document, context, around.table);
  Scene unused;
  read_settings(in, around.table, {}, unused);
  read_view(in, unused);
  context.hash = Hash64();
  ModelBuilder out = read_content(in, opened.meshes(), around);
  hash = context.hash.hex();
  read_contact_memory(in, out);
  read_forces_of_joints(in, out);
  out.state.contacts.clear();
  out.state.joint_force.clear();
  return out;
}

void read_include(const Node& node, const IncludeContext& around, ModelBuilder& out) {
  static const auto kKeys = keys_of_entry(spec::Include{});
  const ObjectReader in(node, kKeys);
  spec::Include entry;
  entry.fields(FieldReader(in));
  Placement placement{entry.prefix, *entry.position};
  if (entry.orientation) placement.R = rotation_of(*entry.orientation);
  std::optional<ModelBuilder> part;
  try {
    const IncludeLibrary::Opened opened(around.includes, entry.scene);
    std::string hash;
    part = read_included(opened, entry.scene, around, hash);
    in.record("scene", hash);
  } catch (const Error& error) {
    in.fail_key("scene", error.what());
  }
  out.append(std::move(*part), placement, *in.find("scene"));
}

void read_includes(const ObjectReader& scene, const IncludeContext& around, ModelBuilder& out) {
  const auto list = scene.find("includes");
  if (!list) return;
  const std::size_t count = list->array_size();
  scene.record("includes", static_cast<double>(count));
  for (std::size_t k = 0; k < count; ++k) read_include(list->element(k), around, out);
}

}  // namespace

// Before anything else: a newer file would only produce a confusing list of unknown keys.
void check_format(const Json& document, ReadContext& context) {
  const Node root(document, context);
  if (!root.value().is_object()) root.fail_expected("an object with \"format\": \"pabd-scene\"");
  const auto format = root.value().find("format");
  if (format == root.value().end()) fail_at(root.context(), "/format", "missing; expected \"pabd-scene\"");
  const Node format_node(*format, root, "format");
  if (!format_node.is_word("pabd-scene")) format_node.fail_expected("\"pabd-scene\"");
  const auto version = root.value().find("version");
  if (version == root.value().end())
    fail_at(root.context(), "/version", fmt::format("missing; expected {}", kVersion));
  const Node node(*version, root, "version");
  if (!version->is_number()) node.fail_expected(std::to_string(kVersion));
  const double v = version->get<double>();
  if (v > kVersion) {
    node.fail(
        fmt::format("the file has version {}, this program reads version {}; use a newer pabd", v, kVersion));
  }
  if (v != kVersion) node.fail_expected(std::to_string(kVersion));
}

namespace {

// The scene with that d̂, unless it states one.
Scene read_with(double d_hat, bool assumed, const ObjectReader& in, MeshLibrary& meshes,
                IncludeLibrary& includes, ParameterTable table) {
  in.context().hash = Hash64();
  includes.start_again();
  Scene scene;
  Params defaults;
  defaults.contact.d_hat = d_hat;
  read_settings(in, table, defaults, scene);
  const IncludeContext around{scene.params.contact.d_hat, assumed, includes, table};
  ModelBuilder builder = read_content(in, meshes, around);
  builder.finish(scene.params.gravity);
  if (builder.model.size() == 0)
    in.fail("the scene has no bodies; expected \"bodies\", \"generate\" or \"includes\"");
  read_contact_memory(in, builder);
  read_forces_of_joints(in, builder);
  read_view(in, scene);

  if (scene.name.empty()) scene.name = std::filesystem::path(in.context().source).stem().string();
  scene.model = std::move(builder.model);
  scene.joint_law = builder.joint_law;
  scene.looks = std::move(builder.looks);
  scene.initial = std::move(builder.state);
  scene.hash = in.context().hash.hex();
  return scene;
}

bool states_d_hat(const Json& document) {
  const auto contact = document.find("contact");
  return contact != document.end() && contact->is_object() && contact->contains("d_hat");
}

// Of the bodies as they are without gaps: generators leave d̂ between theirs, for which half a brick is that much less.
std::optional<ThinBody> thinnest_without_gaps(const ObjectReader& in, MeshLibrary& meshes,
                                              IncludeLibrary& includes, ParameterTable table) {
  includes.start_again();
  ModelBuilder builder = read_content(in, meshes, {0, false, includes, table});
  builder.finish(Vec3::Zero());
  return thinnest_body(builder.model);
}

}  // namespace

Scene read_scene(const Json& document, ReadContext& context, MeshLibrary& meshes, IncludeLibrary& includes,
                 ParameterTable table) {
  const ObjectReader in = read_root(document, context, table);
  const double usual = ContactParams{}.d_hat;
  if (states_d_hat(document)) return read_with(usual, false, in, meshes, includes, table);
  try {
    Scene scene = read_with(usual, true, in, meshes, includes, table);
    if (default_d_hat(thinnest_body(scene.model)) == usual) return scene;
  } catch (const GapsInDoubt&) {  // what is wrong all the same is told below
  }
  const std::optional<ThinBody> thinnest = thinnest_without_gaps(in, meshes, includes, table);
  const double d_hat = default_d_hat(thinnest);
  Scene scene = read_with(d_hat, false, in, meshes, includes, table);
  if (d_hat != usual) scene.d_hat_of = thinnest;
  return scene;
}

}  // namespace pabd
