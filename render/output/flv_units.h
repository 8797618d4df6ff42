// SPDX-License-Identifier: MIT
// Access units of H.264 out of what ffmpeg writes as FLV. There the length of each stands before it, so that it
// is known to be complete at once; in a plain stream only the next one's beginning would tell.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace pabd {

// In Annex B: four-byte start codes; parameter sets before the slices of a key frame.
struct VideoUnit {
  std::string bytes;
  bool key = false;
};

// Source: Adobe Flash Video File Format Specification 10.1, annex E; ISO/IEC 14496-15, 5.3.3 (avcC).
class FlvUnits {
 public:
  void append(std::string_view bytes) { bytes_ += bytes; }
  // The next unit that is complete. Throws Error(encoder) for what is no such stream; then it is over.
  std::optional<VideoUnit> next();

 private:
  void read_parameters(std::string_view record);
  VideoUnit read_unit(std::string_view data, bool key) const;

  std::string bytes_, parameters_;
  bool begun_ = false;
};

}  // namespace pabd
