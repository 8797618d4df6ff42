// SPDX-License-Identifier: MIT
// Drawn frames as messages for each visitor: one unacknowledged frame at a time, then the newest; only the changed
// rectangles; lossless when the picture rests. Without GL, network and clock: times are parameters, in s.
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
  static constexpr double kStill = 0.2;  // s without change before lossless parts are sent
  static constexpr std::size_t kLosslessTiles =
      160;                                 // at a time, so that the next moving frame does not wait long
  static constexpr double kBeside = 0.15;  // s between what is beside the picture on a slow link

  explicit FrameStream(Send send) : send_(std::move(send)) {}

  void arrive(VisitorId visitor) { visitors_[visitor] = {}; }
  void depart(VisitorId visitor) { visitors_.erase(visitor); }
  void refresh(VisitorId visitor);  // its page lost the picture
  // Whose link controls the adaptation; none: the first visitor.
  void follow(std::optional<VisitorId> visitor) { leader_ = visitor; }
  void choose(Adaptation::Mode mode) { adaptation_.choose(mode); }
  void acknowledge(VisitorId visitor, std::uint32_t frame, double shown_ms, double now);

  // The window as drawn; only in `picture` (empty: everywhere) is it made coarser for a slow link. False: the same pixels
  // as before.
  bool show(Image image, std::uint32_t stamp, double draw_ms, double now, const PixelRect& picture = {});
  // Whether drawing another frame is useful: a visitor can take one, or has been sent the newest.
  bool wants_frame() const;
  bool empty() const { return visitors_.empty(); }

  void deliver(double now);
  // When deliver() has something to send if nothing else happens.
  std::optional<double> due() const;

  // Of the time since the last call; none: nothing was sent.
  std::optional<StreamStats> stats(double now);

 private:
  struct Visitor {
    bool ready = true;
    bool stale = false;       // it needs a whole frame
    std::uint32_t frame = 0;  // newest that it was sent; 0: none
    double sent = 0;          // time
    std::size_t bytes = 0;    // of that frame
    Tiles lossy;              // places that it has in JPEG only
  };
  void send_moving(VisitorId id, Visitor& visitor, double now);
  void send_lossless(VisitorId id, Visitor& visitor, double now);
  void begin_moving(double now);
  std::vector<JpegPart> parts_of(const std::vector<PixelRect>& rects) const;
  void send(VisitorId id, Visitor& visitor, const EncodedFrame& frame, double now);
  FrameHead head() const;
  VisitorId leader() const;

  Send send_;
  FrameEncoder encoder_;
  Adaptation adaptation_;
  std::map<VisitorId, Visitor> visitors_;
  std::optional<VisitorId> leader_;

  Image image_;
  PixelRect picture_;
  std::uint32_t number_ = 0, stamp_ = 0;
  double draw_ms_ = 0, changed_ = -1e9;

  // The newest moving frame as encoded, and the frame on which its rectangles (part_) build. What waits of it is in
  // `sent_` as it was.
  Image sent_;
  FrameLook sent_look_;
  std::uint32_t sent_number_ = 0, base_ = 0;
  std::vector<PixelRect> rects_;  // that changed, of which
  std::vector<JpegPart> parts_;   // these are sent
  double beside_sent_ = -1e9;
  std::optional<EncodedFrame> part_, whole_;

  double counted_from_ = 0;
  std::size_t frames_ = 0, bytes_ = 0;
};

}  // namespace pabd
