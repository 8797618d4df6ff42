// SPDX-License-Identifier: MIT
// See scene_list.h.
#include "app/gui/scene_list.h"

#include <algorithm>

#include "app/gui/file_list.h"
#include "sim/base/error.h"
#include "sim/import/import.h"
#include "sim/scene/guarded_scene.h"

namespace pabd {
namespace {

namespace fs = std::filesystem;

// The canonical path, where there is one.
std::string clean(const fs::path& path) {
  std::error_code failure;
  const fs::path full = fs::weakly_canonical(path, failure);
  return (failure ? path : full).string();
}

fs::file_time_type time_of(const std::string& path) {
  std::error_code failure;
  const auto time = fs::last_write_time(path, failure);
  return failure ? fs::file_time_type::min() : time;
}

MayRead mesh_rule(const FileRoot* files) {
  if (!files) return {};
  return [files](const fs::path& mesh) { files->check_mesh(mesh); };
}

}  // namespace

SceneList::SceneList(Files shipped, bool steady, std::shared_ptr<const FileRoot> files)
    : shipped_(std::move(shipped)),
      steady_(steady),
      files_(std::move(files)),
      cache_(steady ? std::nullopt : ThumbnailCache::default_folder()) {
  if (!steady_) thread_ = std::thread([this] { work(); });
}

SceneList::~SceneList() {
  {
    const std::scoped_lock lock(mutex_);
    stop_ = true;
  }
  wake_.notify_all();
  if (thread_.joinable()) thread_.join();
}

bool SceneList::busy() const {
  const std::scoped_lock lock(mutex_);
  return !wanted_.empty() || reading_ > 0 || !found_.empty() || !undrawn_.empty();
}

SceneList::Found SceneList::read(const std::string& path) const {
  Found found;
  found.path = path;
  found.card.read = true;
  found.card.without_picture = true;
  std::string text;
  try {
    std::error_code failure;
    const std::uintmax_t size = fs::file_size(path, failure);
    if (!failure && size > kMostBytes) {
      found.card.description = "a large file: it is read when it is opened";
      return found;
    }
    text = read_any_scene_text(path, mesh_rule(files_.get()));
    auto scene = std::make_shared<const Scene>(
        parse_any_scene(text, path, fs::path(path).parent_path(), {}, mesh_rule(files_.get())));
    found.card.description = scene->description;
    found.card.bodies = scene->model.shape.size();
    found.card.joints = scene->model.joints.size();
    if (found.card.bodies > kMostBodies) return found;
    found.card.without_picture = false;
    found.picture = cache_.find(scene->hash);
    found.scene = std::move(scene);
  } catch (const Error& error) {
    // The list says which file it is.
    found.card.error = error.source() == path ? error.message() : error.what();
  } catch (const std::exception& error) {
    found.card.error = error.what();
  }
  // Patches, scripts and the like lie beside scenes.
  if (!found.card.error.empty())
    found.is_scene = text.empty() || text.find("\"pabd-scene\"") != std::string::npos;
  return found;
}

void SceneList::work() {
  std::unique_lock lock(mutex_);
  while (true) {
    wake_.wait(lock, [&] { return stop_ || !wanted_.empty(); });
    if (stop_) return;
    const std::string path = std::move(wanted_.front());
    wanted_.pop_front();
    reading_ = 1;
    lock.unlock();
    Found found = read(path);
    lock.lock();
    reading_ = 0;
    found_.push_back(std::move(found));
  }
}

void SceneList::add(SceneCard::Group group, const fs::path& file, std::vector<SceneCard>& out) const {
  const std::string path = clean(file);
  if (std::any_of(out.begin(), out.end(), [&](const SceneCard& c) { return c.path == path; })) return;
  SceneCard card;
  card.group = group;
  card.path = path;
  card.name = file.stem().string();
  card.written = time_of(path);
  out.push_back(std::move(card));
}

void SceneList::look(const std::string& open_path, const std::vector<std::string>& recent,
                     Renderer& renderer) {
  std::vector<fs::path> shipped;
  try {
    if (shipped_) shipped = shipped_();
  } catch (const std::exception&) {  // a folder that went away
  }
  open_ = open_path.empty() ? "" : clean(open_path);
  const fs::path folder = files_ ? files_->folder() : fs::path(open_).parent_path();
  const bool among_shipped = !shipped.empty() && fs::path(clean(shipped.front())).parent_path() == folder;
  std::vector<SceneCard> cards;
  if (!folder.empty() && !among_shipped) {
    if (!open_.empty()) add(SceneCard::Group::folder, open_, cards);
    std::size_t count = 0;
    for (const FileEntry& file : list_files(folder, ".json"))
      if (!file.folder && ++count <= kMostFiles) add(SceneCard::Group::folder, folder / file.name, cards);
  }
  std::vector<std::string> known;
  for (const fs::path& file : shipped) known.push_back(clean(file));
  for (const std::string& path : recent) {
    std::error_code failure;
    const bool listed = std::find(known.begin(), known.end(), clean(path)) != known.end();
    if (!listed && fs::is_regular_file(path, failure)) add(SceneCard::Group::recent, path, cards);
  }
  for (const fs::path& file : shipped) add(SceneCard::Group::shipped, file, cards);

  // Cards of unchanged files are kept; the rest is read.
  std::deque<std::string> wanted;
  for (SceneCard& card : cards) {
    const auto old = std::find_if(cards_.begin(), cards_.end(), [&](const SceneCard& c) {
      return c.path == card.path && c.read && c.written == card.written;
    });
    if (old == cards_.end()) {
      wanted.push_back(card.path);
      continue;
    }
    const SceneCard::Group group = card.group;
    card = *old;
    card.group = group;
    old->picture = nullptr;
  }
  for (const SceneCard& old : cards_) {
    if (old.picture) renderer.free_texture(old.picture);
  }
  cards_ = std::move(cards);
  {
    const std::scoped_lock lock(mutex_);
    wanted_ = std::move(wanted);
  }
  wake_.notify_all();
}

void SceneList::take(Found found, Renderer& renderer) {
  const auto card =
      std::find_if(cards_.begin(), cards_.end(), [&](const SceneCard& c) { return c.path == found.path; });
  if (card == cards_.end()) return;
  if (!found.is_scene) {
    cards_.erase(card);
    return;
  }
  if (card->picture) renderer.free_texture(card->picture);
  found.card.group = card->group;
  found.card.path = card->path;
  found.card.name = card->name;
  found.card.written = card->written;
  *card = found.card;
  if (!found.card.without_picture) undrawn_.push_back(std::move(found));
}

// False when the picture was in the cache.
bool SceneList::draw(Found& found, Renderer& renderer) {
  const auto card =
      std::find_if(cards_.begin(), cards_.end(), [&](const SceneCard& c) { return c.path == found.path; });
  if (card == cards_.end()) return false;
  const bool kept = found.picture.has_value();
  if (!kept) {
    found.picture = draw_thumbnail(renderer, *found.scene);
    cache_.store(found.scene->hash, *found.picture);
  }
  card->picture = renderer.upload_texture(*found.picture);
  return !kept;
}

void SceneList::update(Renderer& renderer) {
  if (steady_) {
    while (!wanted_.empty()) {
      take(read(wanted_.front()), renderer);
      wanted_.pop_front();
    }
  }
  std::deque<Found> found;
  {
    const std::scoped_lock lock(mutex_);
    found.swap(found_);
  }
  for (Found& f : found) take(std::move(f), renderer);
  bool drawn = false;
  while (!undrawn_.empty() && (steady_ || !drawn)) {
    drawn = draw(undrawn_.front(), renderer) || drawn;
    undrawn_.pop_front();
  }
}

}  // namespace pabd
