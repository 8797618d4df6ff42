// SPDX-License-Identifier: MIT
// Scene file → Scene, in the order: text, document, overrides, reader. See scene.h.
#include <fmt/format.h>

#include "sim/base/error.h"
#include "sim/base/input_file.h"
#include "sim/scene/mesh_library.h"
#include "sim/scene/overrides.h"
#include "sim/scene/read_scene.h"
#include "sim/scene/scene.h"

namespace pabd {

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
  Json document = parse_document(text, source);
  ReadContext context{source, {}, {}};
  if (!document.is_object()) check_format(document, context);  // refuses
  context.overrides = apply_overrides(document, overrides, source, table);
  MeshLibrary meshes(folder);
  Scene scene = read_scene(document, context, meshes, table);
  scene.files = meshes.files();
  return scene;
}

}  // namespace pabd
