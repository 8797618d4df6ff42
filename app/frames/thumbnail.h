// SPDX-License-Identifier: MIT
// Small pictures of scenes for a list to choose from, and where they are kept between runs.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "render/gl/renderer.h"
#include "sim/scene/scene.h"

namespace pabd {

inline constexpr int kThumbnailWidth = 256, kThumbnailHeight = 144;  // pixels

// A state of a scene, drawn twice as large as asked for (pixels) and averaged in linear light. Takes the renderer's view
// `view` (what was in it is lost) and leaves the frame alone. The renderer's context must be current. Throws
// Error(no_context).
Image draw_small(Renderer& renderer, const Scene& scene, const State& state, const Camera& camera, int width,
                 int height, int view = Renderer::kViews - 1);

// The scene at its start, seen by its own camera or the one that frames it. Otherwise as draw_small.
Image draw_thumbnail(Renderer& renderer, const Scene& scene, int view = Renderer::kViews - 1);

// Thumbnails in files FOLDER/HASH.png. A cache: what cannot be read or written is as if it were not there,
// and nothing throws for it. Files are written whole or not at all, so that several programs may share the
// folder.
class ThumbnailCache {
 public:
  // Without a folder nothing is found or kept.
  explicit ThumbnailCache(std::optional<std::filesystem::path> folder = default_folder());

  // $XDG_CACHE_HOME/pabd/thumbnails, or $HOME/.cache/pabd/thumbnails; none when neither is an absolute path.
  static std::optional<std::filesystem::path> default_folder();

  // The picture stored for Scene::hash; empty when there is none, or when the file is damaged, of another
  // size, of another scene, or was drawn by another version.
  std::optional<Image> find(const std::string& scene_hash) const;

  // False when it could not be kept: no folder, no room, or something that is not a scene's hash. Beyond
  // kMostFiles the oldest go.
  bool store(const std::string& scene_hash, const Image& thumbnail) const;

  static constexpr std::size_t kMostFiles = 500;

 private:
  std::optional<std::filesystem::path> path_of(const std::string& scene_hash) const;
  void drop_oldest() const;

  std::optional<std::filesystem::path> folder_;
};

}  // namespace pabd
