// SPDX-License-Identifier: MIT
// See sweep_reader.h.
#include "app/gui/sweep_reader.h"

#include <algorithm>
#include <chrono>
#include <vector>

#include "app/frames/linear_light.h"
#include "app/sweep/collect_sheet.h"

namespace pabd {
namespace {

constexpr std::size_t kMostUploads = 8;              // in a frame
constexpr std::size_t kMostTaskBytes = 1 << 16;      // of a file of a task
constexpr int kLargeWidth = 320, kSmallWidth = 160;  // pixels

}  // namespace

SweepReader::SweepReader(Renderer& renderer, bool steady, bool links)
    : renderer_(renderer), steady_(steady), links_(links) {
  if (!steady_) thread_ = std::thread([this] { work(); });
}

SweepReader::~SweepReader() {
  {
    const std::scoped_lock lock(mutex_);
    stop_ = true;
  }
  wake_.notify_all();
  if (thread_.joinable()) thread_.join();
}

SweepReader::Read SweepReader::read_folder(const std::string& folder) const {
  Read out;
  try {
    CollectLimits limits;
    limits.tasks = kMostTasks;
    limits.bytes = kMostTaskBytes;
    limits.links = links_;
    auto sweep = std::make_shared<const CollectedSweep>(collect_sweep(folder, limits));
    out.answer.text = sweep->title + ": " + counts_words(*sweep);
    out.sweep = std::move(sweep);
  } catch (const Error& error) {
    out.answer = {error.what(), true, error.kind()};
  } catch (const std::exception& error) {
    out.answer = {error.what(), true, ErrorKind::file};
  }
  return out;
}

std::optional<SweepReader::Answer> SweepReader::update(OpenedSweep& sweep) {
  ++frame_;
  if (asked_ != sweep.asked && !reading_.valid()) {
    asked_ = sweep.asked;
    forget(true);
    if (!sweep.folder.empty())
      reading_ = std::async(steady_ ? std::launch::deferred : std::launch::async,
                            [this, folder = sweep.folder] { return read_folder(folder); });
  }
  std::deque<std::pair<Key, std::optional<Image>>> found;
  {
    const std::scoped_lock lock(mutex_);
    const std::size_t n = std::min(found_.size(), kMostUploads);
    found.assign(std::make_move_iterator(found_.begin()),
                 std::make_move_iterator(found_.begin() + static_cast<std::ptrdiff_t>(n)));
    found_.erase(found_.begin(), found_.begin() + static_cast<std::ptrdiff_t>(n));
    wanted_.clear();  // what is still seen is asked for again
  }
  for (const auto& [key, image] : found) take(key, image);
  forget(false);
  if (!reading_.valid()) {
    sweep.reading = false;
    return std::nullopt;
  }
  sweep.reading = true;
  if (!steady_ && reading_.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
    return std::nullopt;
  Read read = reading_.get();
  sweep.reading = asked_ != sweep.asked;
  if (sweep.reading) return std::nullopt;  // another one was asked for meanwhile
  sweep.problem = read.answer.failed ? read.answer.text : "";
  take_read(sweep, std::move(read.sweep));
  return std::move(read.answer);
}

std::optional<Image> SweepReader::read_picture(const Key& key) {
  SweptTask task;
  task.picture = key.first;
  try {
    Image image = read_end_picture(task);
    const int most = key.second ? kLargeWidth : kSmallWidth;
    while (std::max(image.width, image.height) > most && std::min(image.width, image.height) >= 2)
      image = halved(image);
    return image;
  } catch (const std::exception&) {  // damaged: its cell says so
    return std::nullopt;
  }
}

void SweepReader::take(const Key& key, const std::optional<Image>& image) {
  const auto kept = kept_.find(key);
  if (kept == kept_.end() || kept->second.picture.status != SweepPicture::Status::waiting) return;
  SweepPicture& picture = kept->second.picture;
  picture.status = image ? SweepPicture::Status::there : SweepPicture::Status::none;
  if (!image) return;
  picture.texture = renderer_.upload_texture(*image);
  picture.width = image->width;
  picture.height = image->height;
}

SweepPicture SweepReader::picture(const SweptTask& task, bool large) {
  if (task.picture.empty()) return {SweepPicture::Status::none, nullptr, 0, 0};
  const Key key{task.picture.string(), large};
  Kept& kept = kept_[key];
  kept.seen = frame_;
  if (kept.picture.status != SweepPicture::Status::waiting) return kept.picture;
  if (steady_) {
    take(key, read_picture(key));
    return kept.picture;
  }
  {
    const std::scoped_lock lock(mutex_);
    // The one under the pointer comes first.
    large ? wanted_.push_front(key) : wanted_.push_back(key);
  }
  wake_.notify_all();
  return kept.picture;
}

// What was not seen in the last frame, the oldest first, beyond kMostPictures.
void SweepReader::forget(bool all) {
  if (!all && kept_.size() <= kMostPictures) return;
  std::vector<std::pair<std::uint64_t, Key>> old;
  for (const auto& [key, kept] : kept_) {
    if (all || kept.seen + 1 < frame_) old.emplace_back(kept.seen, key);
  }
  std::sort(old.begin(), old.end());
  const std::size_t most = all ? old.size() : std::min(old.size(), kept_.size() - kMostPictures);
  for (std::size_t i = 0; i < most; ++i) {
    const auto kept = kept_.find(old[i].second);
    if (kept->second.picture.texture) renderer_.free_texture(kept->second.picture.texture);
    kept_.erase(kept);
  }
}

bool SweepReader::busy() const {
  if (reading_.valid()) return true;
  const std::scoped_lock lock(mutex_);
  return !wanted_.empty() || under_way_ || !found_.empty();
}

void SweepReader::work() {
  std::unique_lock lock(mutex_);
  while (true) {
    wake_.wait(lock, [&] { return stop_ || (!wanted_.empty() && found_.size() < kMostPictures); });
    if (stop_) return;
    const Key key = std::move(wanted_.front());
    wanted_.pop_front();
    const bool known =
        std::any_of(found_.begin(), found_.end(), [&](const auto& one) { return one.first == key; });
    if (known) continue;
    under_way_ = true;
    lock.unlock();
    auto image = read_picture(key);
    lock.lock();
    under_way_ = false;
    found_.emplace_back(key, std::move(image));
  }
}

}  // namespace pabd
