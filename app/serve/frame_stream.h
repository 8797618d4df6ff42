// SPDX-License-Identifier: MIT
// From frames that were drawn to messages for each visitor: one frame on its way at a time, the newest wins,
// only what changed, lossless when it stands still. Knows no GL, no network and no clock.
#pragma once

#include <functional>
#include <map>
#include <optional>

#include "app/serve/adaptation.h"
#include "app/serve/frame_encoder.h"
#include "app/serve/roles.h"

namespace pabd {

struct StreamStats {
  double fps = 0, kbps = 0, encode_ms = 0, draw_ms = 0, link_ms = 0;
  FrameLook look;
};

class FrameStream {
 public:
  using Send = std::function<void(VisitorId, const EncodedFrame&)>;
  static constexpr double kStill = 0.2;  // s without change, then lossless
  static constexpr std::size_t kLosslessTiles =
      160;  // at a time, so that nobody waits long for the next frame

  explicit FrameStream(Send send) : send_(std::move(send)) {}

  void arrive(VisitorId visitor) { visitors_[visitor] = {}; }
  void depart(VisitorId visitor) { visitors_.erase(visitor); }
  void refresh(VisitorId visitor);  // it has nothing any more
  // Whose link decides how good moving frames are; none: the first one's.
  void follow(std::optional<VisitorId> visitor) { leader_ = visitor; }
  void choose(Adaptation::Mode mode) { adaptation_.choose(mode); }
  void acknowledge(VisitorId visitor, std::uint32_t frame, double shown_ms, double now);

  // The window as it was drawn. False: the same pixels as before.
  bool show(Image image, std::uint32_t stamp, double draw_ms, double now);
  // Somebody can take a frame, or the newest is on its way: it is worth to draw another one.
  bool wants_frame() const;
  bool empty() const { return visitors_.empty(); }

  void deliver(double now);
  // When deliver() will have something to do without anything else happening.
  std::optional<double> due() const;

  // Since the last call; none when nothing was sent.
  std::optional<StreamStats> stats(double now);

 private:
  struct Visitor {
    bool ready = true;
    bool stale = false;       // what it has is not to be built upon
    std::uint32_t frame = 0;  // that it has or gets; 0: none
    double sent = 0;          // when
    std::size_t bytes = 0;    // of it
    Tiles lossy;              // not as they are
  };
  void send_moving(VisitorId id, Visitor& visitor, double now);
  void send_lossless(VisitorId id, Visitor& visitor, double now);
  void begin_moving();
  void send(VisitorId id, Visitor& visitor, const EncodedFrame& frame, double now);
  FrameHead head() const;
  VisitorId leader() const;

  Send send_;
  FrameEncoder encoder_;
  Adaptation adaptation_;
  std::map<VisitorId, Visitor> visitors_;
  std::optional<VisitorId> leader_;

  Image image_;
  std::uint32_t number_ = 0, stamp_ = 0;
  double draw_ms_ = 0, changed_ = -1e9;

  // The newest moving frame: what was encoded, and after which other one its rectangles are enough.
  Image sent_;
  FrameLook sent_look_;
  std::uint32_t sent_number_ = 0, base_ = 0;
  std::vector<PixelRect> rects_;
  std::optional<EncodedFrame> part_, whole_;

  double counted_from_ = 0;
  std::size_t frames_ = 0, bytes_ = 0;
};

}  // namespace pabd
