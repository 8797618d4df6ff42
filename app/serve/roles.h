// SPDX-License-Identifier: MIT
// Who of a session's visitors controls it: the first who may; then whom it is handed to, or the one who waits
// longest when the other is gone for too long. Knows no network and no clock.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pabd {

using VisitorId = std::uint32_t;

class Roles {
 public:
  static constexpr double kKept = 60;           // s that a lost visitor's role waits for it
  static constexpr double kGone = 10;           // s after which a lost controller's role goes to who waits
  static constexpr double kReload = 2;          // the same when its page was closed: it may be loaded again
  static constexpr std::size_t kMost = 16;      // visitors at a time
  static constexpr std::size_t kMostKept = 64;  // roles that wait

  struct Arrival {
    VisitorId id = 0;
    std::optional<VisitorId> replaced;  // the same page's older connection
    bool came_back = false;
  };

  // `key`: what the page keeps. None: there are too many.
  std::optional<Arrival> arrive(const std::string& key, bool may_control, double now);
  // `closed`: the page was closed or left, not only its connection lost.
  void leave(VisitorId id, double now, bool closed = false);
  void ask(VisitorId id);
  // To who asked first, else to who waits longest. False when `id` does not control or nobody can have it.
  bool give(VisitorId id);
  void tick(double now);

  std::optional<VisitorId> controller() const;  // one that is here
  bool controls(VisitorId id) const { return controller() == id; }
  bool somebody_asks() const;
  std::size_t present() const;

 private:
  struct Visitor {
    VisitorId id;
    std::string key;
    bool may_control, present, asks;
    bool closed;  // its page
    double left;  // when
  };
  Visitor* find(VisitorId id);
  std::size_t present_controllers() const;
  void settle();

  std::vector<Visitor> visitors_;  // in the order of their first arrival
  std::optional<VisitorId> holder_;
  VisitorId next_ = 1;
};

}  // namespace pabd
