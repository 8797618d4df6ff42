// SPDX-License-Identifier: MIT
// Reads the sweep that is open and the pictures of visible cells in threads of its own. Of pictures that are not
// visible any more only the latest are kept.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <future>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "app/gui/opened_sweep.h"
#include "render/gl/renderer.h"
#include "sim/base/error.h"

namespace pabd {

struct SweepPicture {
  enum class Status : std::uint8_t { waiting, there, none };
  Status status = Status::waiting;
  void* texture = nullptr;  // of a picture that is there
  int width = 0, height = 0;
};

class SweepReader {
 public:
  static constexpr std::size_t kMostTasks = 20000;  // of a sweep in the window
  static constexpr std::size_t kMostPictures = 400;

  // `renderer` outlives it. `steady`: everything is read at once, so that frames do not depend on timing. `links`:
  // files that are links are read.
  SweepReader(Renderer& renderer, bool steady, bool links);
  ~SweepReader();
  SweepReader(const SweepReader&) = delete;
  SweepReader& operator=(const SweepReader&) = delete;

  struct Answer {
    std::string text;  // what was read, or why nothing was
    bool failed = false;
    ErrorKind kind = ErrorKind::bad_input;
  };
  // Before a frame: begins to read what is asked for and takes what was read. Returns a result when reading ended.
  std::optional<Answer> update(OpenedSweep& sweep);

  // Within a frame: the picture of a task's end, at most `large` 320 or else 160 pixels wide.
  SweepPicture picture(const SweptTask& task, bool large);

  bool busy() const;  // a later frame will show more

 private:
  using Key = std::pair<std::string, bool>;  // file, large
  struct Kept {
    SweepPicture picture;
    std::uint64_t seen = 0;  // frame
  };
  struct Read {
    std::shared_ptr<const CollectedSweep> sweep;
    Answer answer;
  };

  Read read_folder(const std::string& folder) const;
  static std::optional<Image> read_picture(const Key& key);
  void take(const Key& key, const std::optional<Image>& image);
  void work();
  void forget(bool all);

  Renderer& renderer_;
  bool steady_, links_;
  std::uint64_t asked_ = 0, frame_ = 0;
  std::future<Read> reading_;
  std::map<Key, Kept> kept_;

  mutable std::mutex mutex_;
  std::condition_variable wake_;
  std::deque<Key> wanted_;
  std::deque<std::pair<Key, std::optional<Image>>> found_;
  bool under_way_ = false, stop_ = false;
  std::thread thread_;
};

}  // namespace pabd
