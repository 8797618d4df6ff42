// SPDX-License-Identifier: MIT
// Scene file → Scene, in the order: text, document, overrides, reader. See scene.h.
#include <fmt/format.h>

#include "sim/base/error.h"
#include "sim/base/input_file.h"
#include "sim/scene/guarded_scene.h"
#include "sim/scene/mesh_library.h"
#include "sim/scene/overrides.h"
#include "sim/scene/read_scene.h"
#include "sim/scene/scene.h"

namespace pabd {
namespace {

Scene parse(const std::string& text, const std::string& source, const std::vector<std::string>& overrides,
            ParameterTable table, MeshLibrary meshes, IncludeLibrary includes) {
  Json document = parse_document(text, source);
  ReadContext context{source, {}, {}};
  if (!document.is_object()) check_format(document, context);  // refuses
  context.overrides = apply_overrides(document, overrides, source, table);
  Scene scene = read_scene(document, context, meshes, includes, table);
  scene.files = meshes.files();
  const auto included = includes.files();
  scene.files.insert(scene.files.end(), included.begin(), included.end());
  return scene;
}

}  // namespace

std::string read_scene_text(const std::filesystem::path& file) {
  return read_file(file, DocumentLimits{}.bytes, "a scene file", "a smaller file, use \"generate\"");
}

Scene load_scene(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  Scene scene = parse_scene(read_scene_text(file), file.string(), file.parent_path(), overrides);
  scene.files.push_back(file);
  return scene;
}

Scene parse_scene(const std::string& text, const std::string& source, const std::filesystem::path& folder,
                  const std::vector<std::string>& overrides, ParameterTable table) {
  return parse(text, source, overrides, table, MeshLibrary(folder), IncludeLibrary(source, folder));
}

Scene parse_guarded_scene(const std::string& text, const std::string& source,
                          const std::filesystem::path& folder, const std::vector<std::string>& overrides,
                          const MayRead& may_read, const ReadSceneText& read_text) {
  return parse(text, source, overrides, parameter_table(), MeshLibrary(folder, may_read),
               IncludeLibrary(source, folder, may_read, read_text));
}

}  // namespace pabd
