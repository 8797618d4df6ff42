// SPDX-License-Identifier: MIT
// Which visitor of a session controls it: the first who may, then whoever is given control; when the controller is
// absent for too long, whoever has waited longest. Without network and clock.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pabd {

using VisitorId = std::uint32_t;

class Roles {
 public:
  static constexpr double kKept = 60;           // s that an absent visitor's role is kept
  static constexpr double kGone = 10;           // s after which an absent controller loses control
  static constexpr double kReload = 2;          // the same after its page was closed: it may be reloading
  static constexpr std::size_t kMost = 16;      // visitors at a time
  static constexpr std::size_t kMostKept = 64;  // roles of absent visitors

  struct Arrival {
    VisitorId id = 0;
    std::optional<VisitorId> replaced;  // the same page's older connection
    bool came_back = false;
  };

  // `key`: identity of the page. None: there are too many visitors.
  std::optional<Arrival> arrive(const std::string& key, bool may_control, double now);
  // `closed`: the page was closed, not only its connection lost.
  void leave(VisitorId id, double now, bool closed = false);
  void ask(VisitorId id);
  // Gives control to who asked first, else to who has waited longest. False: `id` does not control, or nobody can.
  bool give(VisitorId id);
  void tick(double now);

  std::optional<VisitorId> controller() const;  // if present
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
  std::size_t count(auto&& is) const {
    return static_cast<std::size_t>(std::count_if(visitors_.begin(), visitors_.end(), is));
  }
  std::size_t present_controllers() const;
  void settle();

  std::vector<Visitor> visitors_;  // in the order of their first arrival
  std::optional<VisitorId> holder_;
  VisitorId next_ = 1;
};

}  // namespace pabd
