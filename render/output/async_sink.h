// SPDX-License-Identifier: MIT
// A FrameSink that writes in the background, so that encoding overlaps simulating and drawing.
#pragma once

#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "render/output/frame_sink.h"

namespace pabd {

// One worker thread takes frames from a ring of `capacity` reused images, in order: frame k is published
// before k + 1. An error of the inner sink is thrown again by the next write() or finish(); no later frame is
// written then.
class AsyncSink : public FrameSink {
 public:
  explicit AsyncSink(std::unique_ptr<FrameSink> inner, int capacity = 3);
  // Waits for the frame being written. Frames that still wait are dropped unless finish() was called.
  ~AsyncSink() override;

  void write(const Image& frame) override;  // copies; waits while the ring is full
  void take(Image& frame);                  // the same without a copy: `frame` gets an old one's memory
  bool has_room() const;                    // write() would not wait
  void finish() override;                   // writes what waits, then finishes the inner sink

  double busy_ms() const;  // time that the inner sink worked, so far

 private:
  void work();
  template <class Fill>
  void add(const Fill& fill);  // of a free slot of the ring

  std::unique_ptr<FrameSink> inner_;
  std::vector<Image> ring_;
  std::size_t first_ = 0;  // oldest waiting frame
  std::size_t count_ = 0;  // frames that wait or are being written
  bool ending_ = false;    // no more frames come
  bool dropping_ = false;  // what waits is not wanted any more
  std::exception_ptr failure_;
  double busy_ms_ = 0;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::thread worker_;
};

}  // namespace pabd
