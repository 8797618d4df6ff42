// SPDX-License-Identifier: MIT
// See flv_units.h.
#include "render/output/flv_units.h"

#include <cstddef>
#include <cstdint>

#include "sim/base/error.h"

namespace pabd {
namespace {

constexpr std::size_t kFileHead = 13, kTagHead = 11, kTagTail = 4;
constexpr std::size_t kVideoHead = 5;  // kind and codec, what it is, offset of its time
constexpr std::size_t kRecordHead = 5;
constexpr int kVideoTag = 9;
constexpr std::uint32_t kKeyAvc = 0x17, kDeltaAvc = 0x27;
constexpr std::uint32_t kParameters = 0, kUnit = 1;
constexpr std::uint32_t kDelimiter = 9;  // the unit's first NAL
constexpr std::string_view kStartCode{"\0\0\0\1", 4};

[[noreturn]] void refuse(const char* what) {
  throw Error(ErrorKind::encoder, std::string("ffmpeg's H.264: ") + what);
}

// Takes from the front; refuses to go beyond the end.
class FlvReader {
 public:
  explicit FlvReader(std::string_view bytes) : rest_(bytes) {}
  std::string_view bytes(std::size_t count) {
    if (count > rest_.size()) refuse("it ends in the middle of something");
    const std::string_view out = rest_.substr(0, count);
    rest_.remove_prefix(count);
    return out;
  }
  std::uint32_t number(std::size_t count) {  // big endian
    std::uint32_t out = 0;
    for (const char c : bytes(count)) out = out << 8 | static_cast<unsigned char>(c);
    return out;
  }
  bool empty() const { return rest_.empty(); }

 private:
  std::string_view rest_;
};

}  // namespace

std::optional<VideoUnit> FlvUnits::next() {
  if (!begun_) {
    if (bytes_.size() < kFileHead) return std::nullopt;
    if (!bytes_.starts_with("FLV\1")) refuse("it does not begin as FLV");
    bytes_.erase(0, kFileHead);
    begun_ = true;
  }
  while (bytes_.size() >= kTagHead) {
    FlvReader head(bytes_);
    const std::uint32_t kind = head.number(1);
    const std::size_t size = head.number(3);
    if (bytes_.size() < kTagHead + size + kTagTail) break;
    const std::string tag = bytes_.substr(kTagHead, size);
    bytes_.erase(0, kTagHead + size + kTagTail);
    if (kind != kVideoTag) continue;  // names and numbers of the file
    FlvReader in(tag);
    const std::uint32_t codec = in.number(1), packet = in.number(1);
    in.bytes(kVideoHead - 2);
    if (codec != kKeyAvc && codec != kDeltaAvc) refuse("it is another codec");
    const std::string_view rest = std::string_view(tag).substr(kVideoHead);
    if (packet == kParameters) read_parameters(rest);
    if (packet == kUnit) return read_unit(rest, codec == kKeyAvc);
  }
  return std::nullopt;
}

void FlvUnits::read_parameters(std::string_view record) {
  FlvReader in(record);
  const std::string_view head = in.bytes(kRecordHead);
  if (head[0] != 1 || (head[4] & 3) != 3) refuse("lengths of NAL units are not four bytes");
  parameters_.clear();
  const auto sets = [&](std::uint32_t count) {
    for (; count > 0; --count) {
      parameters_ += kStartCode;
      parameters_ += in.bytes(in.number(2));
    }
  };
  sets(in.number(1) & 31);
  sets(in.number(1));
}

VideoUnit FlvUnits::read_unit(std::string_view data, bool key) const {
  // What says where the unit begins comes first of all; libx264's first unit has a message before it.
  std::string delimiter, rest;
  for (FlvReader in(data); !in.empty();) {
    const std::string_view nal = in.bytes(in.number(4));
    if (nal.empty()) refuse("a NAL unit is empty");
    std::string& part = (static_cast<unsigned char>(nal[0]) & 31u) == kDelimiter ? delimiter : rest;
    part += kStartCode;
    part += nal;
  }
  if (rest.empty() || (key && parameters_.empty())) refuse("a picture without its parameters");
  VideoUnit out;
  out.key = key;
  out.bytes = delimiter + (key ? parameters_ : "") + rest;
  return out;
}

}  // namespace pabd
