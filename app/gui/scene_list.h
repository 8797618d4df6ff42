// SPDX-License-Identifier: MIT
// The scenes to choose from: shipped ones, those in the folder of the open one, recent ones; each with a small picture
// of its start. A thread reads the files, the window's thread draws at most one picture a frame.
#pragma once

#include <condition_variable>
#include <deque>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "app/frames/thumbnail.h"
#include "app/workbench/file_root.h"
#include "sim/scene/scene.h"

namespace pabd {

struct SceneCard {
  enum class Group : std::uint8_t { folder, recent, shipped };
  Group group = Group::shipped;
  std::string path;                         // absolute
  std::string name;                         // of the file, without .json
  std::string description;                  // one line; may be empty
  std::string error;                        // why it cannot be opened; empty: it can
  std::filesystem::file_time_type written;  // when the file was last changed
  std::size_t bodies = 0, joints = 0;
  bool read = false;             // the above is known
  void* picture = nullptr;       // texture; null: none yet, or none at all
  bool without_picture = false;  // there will be none: broken, or too large
};

class SceneList {
 public:
  static constexpr std::size_t kMostBodies = 20000;         // of a scene with a picture
  static constexpr std::uintmax_t kMostBytes = 64'000'000;  // of a file that is read
  static constexpr std::size_t kMostFiles = 300;            // of a folder

  using Files = std::function<std::vector<std::filesystem::path>()>;
  // `steady`: everything is read and drawn at once, without the cache, so that frames do not depend on timing.
  // `files`: only those of that folder are listed beside the shipped ones; null: those beside the open scene.
  SceneList(Files shipped, bool steady, std::shared_ptr<const FileRoot> files = nullptr);
  ~SceneList();
  SceneList(const SceneList&) = delete;
  SceneList& operator=(const SceneList&) = delete;

  // Reads the folders again; cards of unchanged files are kept.
  void look(const std::string& open_path, const std::vector<std::string>& recent, Renderer& renderer);
  // Takes what was read, draws a picture.
  void update(Renderer& renderer);

  const std::vector<SceneCard>& cards() const { return cards_; }
  const std::string& open_path() const { return open_; }  // absolute
  bool busy() const;                                      // something is still being read or drawn

 private:
  struct Found {  // what the thread knows of a file
    std::string path;
    SceneCard card;
    bool is_scene = true;  // else: another JSON file
    std::shared_ptr<const Scene> scene;
    std::optional<Image> picture;
  };
  Found read(const std::string& path) const;
  void work();
  void add(SceneCard::Group group, const std::filesystem::path& file, std::vector<SceneCard>& out) const;
  void take(Found found, Renderer& renderer);
  bool draw(Found& found, Renderer& renderer);

  Files shipped_;
  bool steady_;
  std::shared_ptr<const FileRoot> files_;
  ThumbnailCache cache_;
  std::string open_;
  std::vector<SceneCard> cards_;
  std::deque<Found> undrawn_;

  mutable std::mutex mutex_;
  std::condition_variable wake_;
  std::deque<std::string> wanted_;
  std::deque<Found> found_;
  std::size_t reading_ = 0;
  bool stop_ = false;
  std::thread thread_;
};

}  // namespace pabd
