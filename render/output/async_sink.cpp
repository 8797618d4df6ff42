// SPDX-License-Identifier: MIT
// A FrameSink that writes in the background.
#include "render/output/async_sink.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "sim/base/error.h"

namespace pabd {
namespace {

using clock = std::chrono::steady_clock;

double ms_since(clock::time_point start) {
  return std::chrono::duration<double, std::milli>(clock::now() - start).count();
}

}  // namespace

AsyncSink::AsyncSink(std::unique_ptr<FrameSink> inner, int capacity)
    : inner_(std::move(inner)), ring_(static_cast<std::size_t>(std::max(1, capacity))) {
  worker_ = std::thread([this] { work(); });
}

AsyncSink::~AsyncSink() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
    dropping_ = true;
  }
  changed_.notify_all();
  if (worker_.joinable()) worker_.join();
}

template <class Fill>
void AsyncSink::add(const Fill& fill) {
  std::unique_lock lock(mutex_);
  if (ending_) throw Error(ErrorKind::defect, "a frame was written after the end of the output");
  changed_.wait(lock, [this] { return count_ < ring_.size() || failure_; });
  if (failure_) std::rethrow_exception(failure_);
  Image& slot = ring_[(first_ + count_) % ring_.size()];
  // Only this thread adds frames, and the worker does not look at a slot before it is counted.
  lock.unlock();
  fill(slot);
  lock.lock();
  ++count_;
  lock.unlock();
  changed_.notify_all();
}

void AsyncSink::write(const Image& frame) {
  add([&](Image& slot) { slot = frame; });
}

void AsyncSink::take(Image& frame) {
  add([&](Image& slot) { std::swap(slot, frame); });
}

bool AsyncSink::has_room() const {
  const std::lock_guard lock(mutex_);
  return count_ < ring_.size() || failure_ || ending_;
}

void AsyncSink::finish() {
  {
    const std::lock_guard lock(mutex_);
    if (ending_) throw Error(ErrorKind::defect, "the output was ended twice");
    ending_ = true;
  }
  changed_.notify_all();
  worker_.join();
  const auto joined = clock::now();
  if (failure_) std::rethrow_exception(failure_);
  inner_->finish();
  busy_ms_ += ms_since(joined);
}

void AsyncSink::work() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return count_ > 0 || ending_; });
    if (count_ == 0 || dropping_) return;
    const Image& frame = ring_[first_];
    lock.unlock();
    const auto start = clock::now();
    std::exception_ptr failure;
    try {
      inner_->write(frame);
    } catch (...) {
      failure = std::current_exception();
    }
    const double took = ms_since(start);
    lock.lock();
    busy_ms_ += took;
    first_ = (first_ + 1) % ring_.size();
    --count_;
    failure_ = failure;
    changed_.notify_all();
    if (failure) return;
  }
}

double AsyncSink::busy_ms() const {
  const std::lock_guard lock(mutex_);
  return busy_ms_;
}

}  // namespace pabd
