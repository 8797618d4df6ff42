// SPDX-License-Identifier: MIT
// What panels do with plots: long curves made short, what is under the pointer, lists of what is plotted, and the
// button that writes a plot to a file.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/gui/widgets.h"
#include "app/plots/plot_pick.h"

namespace pabd {

// Of lines over an ascending x what the plot's range leaves out goes. Lines of more than `most` points (at least 8) keep the first, lowest, highest and last one of every piece: the same
// picture, and cheap to draw.
void thin_lines(Plot& plot, std::size_t most);

// The plot of one of kPlottingPanels, at the cursor: the mouse chooses what part of it is seen (command::PlotView), except
// where it `grips` something.
PlotTouch panel_plot(GuiFrame& frame, const char* panel, const Plot& plot, ImVec2 size, bool grips = false);

// A ring around the point nearest to the pointer, and its numbers. `x_name`: "iteration".
std::optional<PlotPick> read_point(GuiFrame& frame, const Plot& plot, const PlotTouch& touch,
                                   const char* x_name);

// An upright line at the point whose x (in seconds) is nearest, and the values of all lines there, under
// `names` (one a series; fewer: the series' own).
std::optional<PlotPick> read_time(GuiFrame& frame, const Plot& plot, const PlotTouch& touch,
                                  const std::vector<std::string>& names = {});

// Wide enough for a list on which that word stands; pixels.
float combo_width(const char* word);
// A list of words: the index of the one that was just chosen. A word too long for the list loses its beginning; the
// tooltip has all of it.
std::optional<std::size_t> word_combo(const char* id, const char* const* words, std::size_t count,
                                      std::size_t now, float width, const char* help);
// The same for words of commands: the name of the one that was just chosen; null: none.
const char* choice_combo(const char* id, std::span<const Choice> choices, std::string_view now, float width,
                         const char* help);

// At the right end of the present line: a button, and below it a name to be changed; sends ExportPlot. `path`
// keeps the name that was used last; empty: one that fits is made.
void export_button(GuiFrame& frame, const char* panel, std::string& path);
// px that the button takes.
float export_width(const GuiFrame& frame);

}  // namespace pabd
