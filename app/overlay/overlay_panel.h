// SPDX-License-Identifier: MIT
// A panel of the overlay: its name, its place, what it needs, how it is painted. Each has a file in
// panels/ and a line in overlay_panel_table.h; names, help and places are read from there.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "app/plots/canvas.h"

namespace pabd {

struct OverlayData;

enum class PanelPlace : std::uint8_t { top_left, column, bottom_left };  // the column is at the right

// What is drawn into the picture itself, and brings a legend along.
enum class PictureLayer : std::uint8_t { none, contacts, bonds, body_colors };

struct OverlayPanel {
  std::string_view name = {};  // as --overlay takes it; empty: it only comes with its layer
  PanelPlace place = PanelPlace::column;
  double width = 312,
         height = 218;  // px at 1280 × 720; in the column all are as wide and high as the largest
  // Draws into `rect`; `scale` is of texts and lines.
  void (*paint)(const Rect& rect, double scale, const OverlayData& data, Canvas& canvas) = nullptr;

  PictureLayer layer = PictureLayer::none;                   // it comes with
  bool iterations = false;                                   // it needs the records of a step's iterations,
  bool contacts = false;                                     // the reports of contacts,
  bool other_run = false;                                    // another run beside the first
  double (*more_height)(const OverlayData& data) = nullptr;  // added to `height`, px at 1280 × 720
  bool (*applies)(const OverlayData& data) = nullptr;        // has something to say; null: always
};

using PanelTable = std::span<const OverlayPanel* const>;

}  // namespace pabd
