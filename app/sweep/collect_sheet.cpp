// SPDX-License-Identifier: MIT
// See collect_sheet.h.
#include "app/sweep/collect_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/plots/cairo_canvas.h"
#include "app/plots/theme.h"
#include "render/output/png.h"
#include "sim/base/error.h"
#include "sim/base/input_file.h"
#include "sim/base/utf8.h"

namespace pabd {
namespace {

constexpr double kSheetWidth = 3200;  // what all columns share
constexpr double kWidest = 320, kNarrowest = 96;
constexpr double kMargin = 24, kGap = 6;
constexpr int kMostSide = 2048;                     // of a task's picture
constexpr std::size_t kMostPictureBytes = 8 << 20;  // of its file
constexpr Color kEmpty{236, 239, 242, 255};

double widest(const std::vector<std::string>& names, const FontMetrics& font, double size) {
  double width = 0;
  for (const std::string& name : names) width = std::max(width, text_width(font, name, size));
  return width;
}

// As much of a text as fits, with "…" for the rest.
std::string fitting(const FontMetrics& font, const std::string& text, double size, double width) {
  if (text_width(font, text, size) <= width) return text;
  std::string cut = text;
  while (!cut.empty() && text_width(font, cut + "…", size) > width) cut = without_last(cut);
  return cut + "…";
}

class SheetPainter {
 public:
  SheetPainter(const CollectedSweep& sweep, const TaskGrid& grid, std::size_t slice)
      : sweep_(sweep),
        grid_(grid),
        slice_(grid.slices[slice]),
        layout_(layout_sheet(grid, font_)),
        canvas_(font_, layout_.width, layout_.height) {}

  Image paint() {
    title();
    for (std::size_t row = 0; row < grid_.rows(); ++row) {
      for (std::size_t column = 0; column < grid_.columns(); ++column)
        cell(layout_.picture(column, row, grid_.rows()), slice_.tasks[row * grid_.columns() + column]);
    }
    axes();
    return canvas_.finish();
  }

 private:
  void text(double x, double y, const std::string& words, double size, Color color, AlignX ax, AlignY ay,
            double room) {
    canvas_.text({x, y}, fitting(font_, words, size, room), {size, color, ax, ay});
  }

  void title() {
    const double size = 1.25 * layout_.letters, room = layout_.width - 2 * kMargin;
    std::string words = sweep_.title;
    if (!slice_.name.empty()) words += ": " + slice_.name;
    text(kMargin, kMargin, words, size, ink::text, AlignX::left, AlignY::top, room);
    text(kMargin, kMargin + 1.6 * size, counts_words(sweep_), layout_.letters, ink::muted, AlignX::left,
         AlignY::top, room);
  }

  void cell(const Rect& rect, std::optional<std::size_t> index) {
    const Point middle{rect.x + 0.5 * rect.w, rect.y + 0.5 * rect.h};
    canvas_.fill_rect(rect, kEmpty, 0);
    if (!index) {
      if (!grid_.scattered)
        text(middle.x, middle.y, "no task", layout_.letters, ink::muted, AlignX::center, AlignY::middle,
             rect.w);
      return;
    }
    const SweptTask& task = sweep_.tasks[*index];
    std::string missing = "no picture";
    if (!task.picture.empty()) {
      try {
        const Image image = read_end_picture(task);
        // Whole, whatever its shape.
        const double scale = std::min(rect.w / image.width, rect.h / image.height);
        const double w = scale * image.width, h = scale * image.height;
        canvas_.image({middle.x - 0.5 * w, middle.y - 0.5 * h, w, h}, image.width, image.height, image.rgb);
        missing.clear();
      } catch (const Error&) {
        missing = "picture damaged";
      }
    }
    if (!missing.empty())
      text(middle.x, middle.y, missing, layout_.letters, ink::muted, AlignX::center, AlignY::middle, rect.w);
    number(rect, task);
    if (task.status != SweptStatus::done) status(rect, task.status);
    if (grid_.scattered) words_below(rect, task);
  }

  // A chip in a corner with a few words.
  void chip(double x, double y, const std::string& words, Color paper, Color letters, AlignX side) {
    const double size = 0.92 * layout_.letters, pad = 0.4 * size;
    const double w = text_width(font_, words, size) + 2 * pad, h = 1.5 * size;
    const double left = side == AlignX::right ? x - w : x;
    canvas_.fill_rect({left, y, w, h}, paper, 3);
    canvas_.text({left + pad, y + 0.5 * h}, words, {size, letters, AlignX::left, AlignY::middle});
  }

  void number(const Rect& rect, const SweptTask& task) {
    if (task.index >= 0)
      chip(rect.x + 3, rect.y + 3, std::to_string(task.index), {255, 255, 255, 200}, ink::text, AlignX::left);
  }

  // A frame and a word: not by colour alone.
  void status(const Rect& rect, SweptStatus status) {
    const Color color = status_color(status);
    canvas_.stroke_rect(rect, color, 3);
    const double h = 1.38 * layout_.letters;
    chip(rect.right() - 5, rect.bottom() - h - 5, std::string(status_word(status)), color,
         {255, 255, 255, 255}, AlignX::right);
  }

  void words_below(const Rect& rect, const SweptTask& task) {
    const std::string words = in_words(sweep_, task, varied_parameters(sweep_));
    const double size = 0.85 * layout_.letters;
    double y = rect.bottom() + 0.3 * size;
    int lines = 0;
    for (const std::string& line : wrap_text(font_, words, size, rect.w)) {
      if (++lines > 3) break;
      text(rect.x, y, line, size, ink::text, AlignX::left, AlignY::top, rect.w);
      y += FontMetrics::line * size;
    }
  }

  void axes() {
    if (grid_.scattered) return;
    const Rect& g = layout_.grid;
    const double size = layout_.letters;
    for (std::size_t i = 0; i < grid_.columns(); ++i) {
      const double x = g.x + (static_cast<double>(i) + 0.5) * layout_.cell_w - 0.5 * kGap;
      TextStyle style{size, ink::text};
      style.vertical = layout_.vertical;
      style.x = layout_.vertical ? AlignX::right : AlignX::center;
      style.y = layout_.vertical ? AlignY::middle : AlignY::top;
      canvas_.text({x, g.bottom() + 0.5 * size}, grid_.x.names[i], style);
    }
    for (std::size_t i = 0; i < grid_.rows(); ++i) {
      const Rect rect = layout_.picture(0, i, grid_.rows());
      canvas_.text({g.x - 0.6 * size, rect.y + 0.5 * rect.h}, grid_.y.names[i],
                   {size, ink::text, AlignX::right, AlignY::middle});
    }
    const double label = 1.1 * size;
    canvas_.text({g.x + 0.5 * g.w, g.bottom() + layout_.names + 1.2 * size}, grid_.x.label,
                 {label, ink::text, AlignX::center, AlignY::top});
    canvas_.text(
        {kMargin, g.y + 0.5 * g.h}, grid_.y.label,
        {.size = label, .color = ink::text, .x = AlignX::center, .y = AlignY::top, .vertical = true});
  }

  const CollectedSweep& sweep_;
  const TaskGrid& grid_;
  const GridSlice& slice_;
  FontMetrics font_;
  SheetLayout layout_;
  RasterCanvas canvas_;
};

std::uint32_t big_endian(std::string_view bytes, std::size_t at) {
  std::uint32_t word = 0;
  for (std::size_t i = 0; i < 4; ++i) word = word << 8 | static_cast<unsigned char>(bytes[at + i]);
  return word;
}

}  // namespace

Rect SheetLayout::picture(std::size_t column, std::size_t row, std::size_t rows) const {
  return {std::round(grid.x + static_cast<double>(column) * cell_w),
          std::round(grid.y + static_cast<double>(rows - 1 - row) * cell_h), picture_w, picture_h};
}

bool SheetLayout::fits() const { return width <= png_largest_side && height <= png_largest_side; }

SheetLayout layout_sheet(const TaskGrid& grid, const FontMetrics& font) {
  SheetLayout layout;
  const double columns = static_cast<double>(grid.columns()), rows = static_cast<double>(grid.rows());
  layout.picture_w = std::clamp(std::floor(kSheetWidth / columns) - kGap, kNarrowest, kWidest);
  layout.picture_h = std::round(layout.picture_w * 9 / 16);
  layout.letters = std::clamp(layout.picture_w / 15, 11.0, 17.0);
  const double size = layout.letters;
  layout.cell_w = layout.picture_w + kGap;
  layout.cell_h = layout.picture_h + kGap + (grid.scattered ? 3.2 * FontMetrics::line * 0.85 * size : 0);
  layout.vertical = !grid.scattered && widest(grid.x.names, font, size) > layout.picture_w;
  layout.names = layout.vertical ? widest(grid.x.names, font, size) : size;
  const double left =
      grid.y.label.empty() ? kMargin : kMargin + 2 * size + widest(grid.y.names, font, size) + 0.6 * size;
  const double top = kMargin + 4.6 * size;
  layout.grid = {left, top, columns * layout.cell_w - kGap, rows * layout.cell_h - kGap};
  const double below = grid.scattered || grid.x.label.empty() ? kMargin : layout.names + 3.4 * size + kMargin;
  // A title has room to be read beside few pictures.
  layout.width = static_cast<int>(std::ceil(std::max(layout.grid.right() + kMargin, 480.0)));
  layout.height = static_cast<int>(std::ceil(layout.grid.bottom() + below));
  return layout;
}

Image contact_sheet(const CollectedSweep& sweep, const TaskGrid& grid, std::size_t slice) {
  return SheetPainter(sweep, grid, slice).paint();
}

Image read_end_picture(const SweptTask& task) {
  // The size comes first: a small file can hold a picture that is larger than the memory.
  const std::string bytes = read_file(task.picture, kMostPictureBytes, "a picture of a task");
  const std::string source = task.picture.string();
  if (bytes.size() < 24 || !bytes.starts_with("\x89PNG"))
    throw Error(ErrorKind::bad_input, source, "is no PNG file");
  const std::uint32_t width = big_endian(bytes, 16), height = big_endian(bytes, 20);
  if (width > kMostSide || height > kMostSide)
    throw Error(ErrorKind::bad_input, source,
                fmt::format("has {} × {} pixels; expected at most {} a side", width, height, kMostSide));
  return read_png(task.picture);
}

Color status_color(SweptStatus status) {
  switch (status) {
    case SweptStatus::done:
      return palette_color(2);
    case SweptStatus::diverged:
      return palette_color(1);
    case SweptStatus::refused:
      return {0x8A, 0x5E, 0x00, 255};  // ochre that white words can be read on
    case SweptStatus::unfinished:
      return palette_color(6);
    case SweptStatus::damaged:
      return palette_color(4);
  }
  return palette_color(6);
}

}  // namespace pabd
