// SPDX-License-Identifier: MIT
// The inputs that wait for the desk's thread.
#pragma once

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <utility>

#include "app/serve/served_desk.h"

namespace pabd {

class DeskQueue {
 public:
  bool push(DeskInput input) {
    {
      const std::scoped_lock lock(mutex_);
      if (merged(input)) return true;
      // Inputs about visitors are rare, or one per visitor: they are never refused.
      const bool never_refused =
          is<desk::Arrive, desk::Scheme, desk::Depart, desk::HandOver, desk::Shown, desk::Refresh>(input);
      if (!never_refused && waiting_.size() >= ServedDesk::kMostInputs) return false;
      waiting_.push_back(std::move(input));
    }
    wake_.notify_one();
    return true;
  }

  std::deque<DeskInput> take(std::chrono::duration<double> wait) {
    std::unique_lock lock(mutex_);
    wake_.wait_for(lock, wait, [&] { return stopped_ || !waiting_.empty(); });
    return std::exchange(waiting_, {});
  }

  // Only arrivals, departures and acknowledgements, in their order: the rest waits while a script runs.
  std::deque<DeskInput> take_acknowledgements() {
    const std::scoped_lock lock(mutex_);
    std::deque<DeskInput> out, rest;
    for (DeskInput& input : waiting_) {
      const bool urgent = is<desk::Arrive, desk::Depart, desk::Shown>(input);
      (urgent ? out : rest).push_back(std::move(input));
    }
    waiting_ = std::move(rest);
    return out;
  }

  void stop() {
    {
      const std::scoped_lock lock(mutex_);
      stopped_ = true;
    }
    wake_.notify_one();
  }
  bool stopped() const {
    const std::scoped_lock lock(mutex_);
    return stopped_;
  }

 private:
  template <class... Kinds>
  static bool is(const DeskInput& input) {
    return (std::holds_alternative<Kinds>(input) || ...);
  }

  // A move replaces a move before it. Of Shown and Refresh, only the newest of each visitor waits.
  bool merged(const DeskInput& input) {
    if (const auto* shown = std::get_if<desk::Shown>(&input)) return renewed(*shown);
    if (const auto* refresh = std::get_if<desk::Refresh>(&input)) return renewed(*refresh);
    const auto is_move = [](const DeskInput& i) {
      const auto* hand = std::get_if<desk::Input>(&i);
      return hand && hand->events.size() == 1 && std::holds_alternative<MouseMoved>(hand->events[0]);
    };
    if (waiting_.empty() || !is_move(input) || !is_move(waiting_.back())) return false;
    waiting_.back() = input;
    return true;
  }

  template <class Kind>
  bool renewed(const Kind& input) {
    const auto older = std::find_if(waiting_.begin(), waiting_.end(), [&](const DeskInput& i) {
      const auto* one = std::get_if<Kind>(&i);
      return one && one->visitor == input.visitor;
    });
    if (older == waiting_.end()) return false;
    *older = input;
    return true;
  }

  mutable std::mutex mutex_;
  std::condition_variable wake_;
  std::deque<DeskInput> waiting_;
  bool stopped_ = false;
};

}  // namespace pabd
