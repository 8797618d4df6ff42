// SPDX-License-Identifier: MIT
// Emptying a visual scene without giving its memory back.
#include "render/visual/visual_scene.h"

namespace pabd {

void VisualScene::clear() {
  for (auto& list : instances) list.clear();
  for (auto& mesh : meshes) mesh.instances.clear();
  lines.clear();
  labels.clear();
  grounds.clear();
}

}  // namespace pabd
