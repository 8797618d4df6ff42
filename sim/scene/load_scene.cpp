// Scene file → Scene, in the order: document, overrides, parameters, bodies, generators, joints. See scene.h.
#include <fmt/format.h>

#include "sim/base/input_file.h"
#include "sim/error.h"
#include "sim/scene/builder.h"
#include "sim/scene/document.h"
#include "sim/scene/generators.h"
#include "sim/scene/keys.h"
#include "sim/scene/overrides.h"
#include "sim/scene/read_body.h"
#include "sim/scene/read_joint.h"
#include "sim/scene/read_memory.h"
#include "sim/scene/read_params.h"
#include "sim/scene/scene.h"
#include "sim/scene/text.h"

namespace pabd {

namespace {

constexpr int kVersion = 1;

// Before anything else: a newer file would only produce a confusing list of unknown keys.
void check_format(const Node& root) {
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

void read_bodies(const ObjectReader& scene, MeshLibrary& meshes, SceneBuilder& out) {
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
void read_friction_anchors(const ObjectReader& scene, SceneBuilder& out) {
  const auto list = scene.find("friction_anchors");
  if (!list) return;
  read_anchors(*list, out.model.size(), out.state.anchors);
  for (const FrictionAnchor& anchor : out.state.anchors) {
    scene.record("friction_anchors", static_cast<double>(anchor.pair >> 32));
    scene.record("friction_anchors", static_cast<double>(anchor.pair & 0xffffffffu));
    scene.record("friction_anchors", static_cast<double>(anchor.feature));
    scene.record("friction_anchors", anchor.stretch);
    scene.record("friction_anchors", static_cast<double>(flags_of(anchor)));
  }
}

// The same.
void read_forces_of_joints(const ObjectReader& scene, SceneBuilder& out) {
  const auto list = scene.find("joint_forces");
  if (!list) return;
  read_joint_forces(*list, out.model.joints.size(), out.state.joint_force);
  for (const Vec3& force : out.state.joint_force) scene.record("joint_forces", force);
}

std::optional<CameraDesc> read_camera(const ObjectReader& scene) {
  const auto node = scene.find("camera");
  if (!node) return std::nullopt;
  const ObjectReader in(*node, keys::camera);
  CameraDesc camera;
  camera.eye = in.vec3("eye", kPositionRange);
  camera.target = in.vec3("target", kPositionRange);
  camera.fov = in.number("fov", {1, 170, "degrees", true}, camera.fov);
  if (!((camera.eye - camera.target).norm() > 1e-6)) {
    in.fail_key("eye", "the camera sits on its target; expected two different points");
  }
  return camera;
}

}  // namespace

std::string read_scene_text(const std::filesystem::path& file) {
  std::string text, problem;
  switch (read_file(file, DocumentLimits{}.bytes, text, problem)) {
    case ReadOutcome::done:
      break;
    case ReadOutcome::unreadable:
      throw Error(ExitCode::file,
                  fmt::format("{}: cannot be read: {}; expected a scene file", file.string(), problem));
    case ReadOutcome::too_long:
      throw Error(ExitCode::bad_input,
                  fmt::format("{}: {}; expected a smaller file, use \"generate\"", file.string(), problem));
  }
  return text;
}

Scene load_scene(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  Scene scene = parse_scene(read_scene_text(file), file.string(), file.parent_path(), overrides);
  scene.files.push_back(file);
  return scene;
}

Scene parse_scene(const std::string& text, const std::string& source, const std::filesystem::path& folder,
                  const std::vector<std::string>& overrides) {
  Json document = parse_document(text, source);
  ReadContext context{source, {}, {}};
  const Node root(document, context);
  if (!document.is_object()) check_format(root);  // refuses
  context.overrides = apply_overrides(document, overrides, source);
  check_format(root);

  const ObjectReader in(root, keys::scene);
  Scene scene;
  scene.name = in.name("name");
  scene.description = in.text("description", 1000);
  if (const auto schema = in.find("$schema"))
    schema->text(1000);  // for editors; says nothing about the scene
  scene.params = read_params(in);

  SceneBuilder builder(read_joint_defaults(in));
  MeshLibrary meshes(folder);
  read_bodies(in, meshes, builder);
  const std::size_t listed = builder.model.name.size();
  run_generators(in, scene.params.contact.d_hat, builder);
  const BodyNames names = builder.names(context, listed);
  const std::size_t generated = builder.model.joints.size();
  read_joints(in, names, builder);
  builder.finish_joints(scene.params.gravity, generated);
  if (builder.model.size() == 0) in.fail("the scene has no bodies; expected \"bodies\" or \"generate\"");
  read_friction_anchors(in, builder);
  read_forces_of_joints(in, builder);
  scene.camera = read_camera(in);
  scene.files = meshes.files();

  if (scene.name.empty()) scene.name = std::filesystem::path(source).stem().string();
  scene.model = std::move(builder.model);
  scene.joint_law = builder.joint_law;
  scene.initial = std::move(builder.state);
  scene.hash = context.hash.hex();
  return scene;
}

}  // namespace pabd
