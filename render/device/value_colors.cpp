// SPDX-License-Identifier: MIT
// See value_colors.h.
#include "render/device/value_colors.h"

#include <cmath>
#include <vector>

#include "render/visual/value_map.h"

namespace pabd::device {

void set_value_colors(unsigned values, const ValueRange& range, DrawView& view, DrawBuffers& buffers) {
  buffers.lend(DrawSlot::values, values);
  view.counts[1] = values != 0 ? 1 : 0;
  if (values == 0) return;
  const bool is_range = range.lo < range.hi && (!range.logarithmic || range.lo > 0);
  const double length = range.logarithmic ? std::log2(range.hi / range.lo) : range.hi - range.lo;
  view.values[0] = static_cast<float>(range.lo);
  view.values[1] = static_cast<float>(range.hi);
  view.values[2] = is_range ? static_cast<float>(1 / length) : 0.0f;
  view.values[3] = is_range && range.logarithmic ? 1.0f : 0.0f;
  if (buffers.id(DrawSlot::value_colors) != 0) return;
  std::vector<Vec4f> map;
  for (int k = 0; k < kValueColors; ++k)
    map.push_back(value_color(static_cast<double>(k) / (kValueColors - 1)));
  map.push_back(no_value_color());
  buffers.make(DrawSlot::value_colors, map.size() * sizeof(Vec4f), map.data());
}

}  // namespace pabd::device
