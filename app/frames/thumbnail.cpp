// SPDX-License-Identifier: MIT
// Small pictures of scenes, and a folder of them.
#include "app/frames/thumbnail.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <system_error>
#include <utility>
#include <vector>

#include "app/frames/linear_light.h"
#include "app/frames/scene_framing.h"
#include "render/output/png.h"
#include "render/visual/build_visual.h"
#include "sim/base/error.h"
#include "sim/base/input_file.h"

namespace pabd {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kHashDigits = 16;
constexpr const char* kVersion = "pabd " PABD_VERSION " thumbnail 2";  // count up when the look changes

PngText text_of(const std::string& scene_hash) {
  return {{"Software", kVersion}, {"Scene hash", scene_hash}};
}

// The size in a PNG's header, before anything is unpacked.
bool has_size(const fs::path& path, unsigned width, unsigned height) {
  std::array<unsigned char, 24> head{};
  std::string problem;
  const Descriptor file = open_input(path, problem);
  if (!problem.empty() || read_some(file.get(), head.data(), head.size()) != ssize_t{head.size()})
    return false;
  const auto number = [&](std::size_t at) {
    return (unsigned{head[at]} << 24) | (unsigned{head[at + 1]} << 16) | (unsigned{head[at + 2]} << 8) |
           unsigned{head[at + 3]};
  };
  return number(16) == width && number(20) == height;
}

std::optional<fs::path> absolute_path_in(const char* variable) {
  const char* value = std::getenv(variable);
  if (value == nullptr || !fs::path(value).is_absolute()) return std::nullopt;
  return fs::path(value);
}

}  // namespace

Image draw_small(Renderer& renderer, const Scene& scene, const State& state, const Camera& camera, int width,
                 int height, int view) {
  VisualScene visual;
  visual.camera = camera;
  VisualOptions options;
  options.looks = looks_of(scene, scene.model);
  build_visual(scene.model, state, {}, options, visual);
  renderer.draw_view(view, visual, 2 * width, 2 * height);
  Image large;
  renderer.read_view(view, large);
  return halved(large);
}

Image draw_thumbnail(Renderer& renderer, const Scene& scene, int view) {
  constexpr double kAspect = static_cast<double>(kThumbnailWidth) / kThumbnailHeight;
  return draw_small(renderer, scene, scene.initial, scene_camera(scene, kAspect), kThumbnailWidth,
                    kThumbnailHeight, view);
}

ThumbnailCache::ThumbnailCache(std::optional<fs::path> folder) : folder_(std::move(folder)) {}

std::optional<fs::path> ThumbnailCache::default_folder() {
  if (const auto cache = absolute_path_in("XDG_CACHE_HOME")) return *cache / "pabd" / "thumbnails";
  if (const auto home = absolute_path_in("HOME")) return *home / ".cache" / "pabd" / "thumbnails";
  return std::nullopt;
}

std::optional<fs::path> ThumbnailCache::path_of(const std::string& scene_hash) const {
  const bool is_hash = scene_hash.size() == kHashDigits &&
                       scene_hash.find_first_not_of("0123456789abcdef") == std::string::npos;
  if (!folder_ || !is_hash) return std::nullopt;
  return *folder_ / (scene_hash + ".png");
}

std::optional<Image> ThumbnailCache::find(const std::string& scene_hash) const {
  const auto path = path_of(scene_hash);
  if (!path || !has_size(*path, kThumbnailWidth, kThumbnailHeight)) return std::nullopt;
  try {
    if (read_png_text(*path) != text_of(scene_hash)) return std::nullopt;
    Image image = read_png(*path);
    if (image.width != kThumbnailWidth || image.height != kThumbnailHeight) return std::nullopt;
    return image;
  } catch (const Error&) {
    return std::nullopt;
  }
}

bool ThumbnailCache::store(const std::string& scene_hash, const Image& thumbnail) const {
  const auto path = path_of(scene_hash);
  if (!path || thumbnail.width != kThumbnailWidth || thumbnail.height != kThumbnailHeight) return false;
  try {
    write_png(*path, thumbnail, text_of(scene_hash));
  } catch (const Error&) {
    return false;
  }
  drop_oldest();
  return true;
}

void ThumbnailCache::drop_oldest() const {
  std::error_code failure;
  std::vector<std::pair<fs::file_time_type, fs::path>> files;
  for (fs::directory_iterator entry(*folder_, failure), end; !failure && entry != end;
       entry.increment(failure)) {
    const fs::file_time_type time = entry->last_write_time(failure);
    if (!failure && entry->path().extension() == ".png") files.emplace_back(time, entry->path());
  }
  if (files.size() <= kMostFiles) return;
  std::sort(files.begin(), files.end());
  files.resize(files.size() - kMostFiles);
  for (const auto& [time, path] : files) fs::remove(path, failure);
}

}  // namespace pabd
