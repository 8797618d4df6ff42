// SPDX-License-Identifier: MIT
// See collect_write.h.
#include "app/sweep/collect_write.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <utility>

#include "app/plots/figure.h"
#include "app/sweep/collect_plots.h"
#include "app/sweep/collect_report.h"
#include "app/sweep/collect_sheet.h"
#include "app/sweep/collect_table.h"
#include "render/output/png.h"
#include "sim/base/atomic_file.h"
#include "sim/base/counted.h"
#include "sim/base/output_path.h"

namespace pabd {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostSheets = 12;
constexpr int kShown = 1190;  // width of a picture in the report, px

// A name as part of a file's: letters, digits, _ and -.
std::string file_word(const std::string& name) {
  std::string out;
  for (const char c : name) {
    const bool good =
        (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
    out += good ? c : '_';
  }
  return out;
}

std::string png_bytes(const Image& image) {
  const std::vector<std::uint8_t> bytes = encode_png(image, {{"Software", "pabd"}});
  return {bytes.begin(), bytes.end()};
}

std::string png_bytes(const SizedPicture& picture) {
  return png_bytes(picture_to_image(picture.picture, picture.size.width, picture.size.height));
}

struct PlannedFile {
  std::string name;
  std::function<std::string()> make;
};

class Collection {
 public:
  Collection(const CollectedSweep& sweep, const CollectOptions& options)
      : sweep_(sweep), grid_(grid_of(sweep, options.x, options.y)), ranking_(rank(sweep)) {
    if (grid_.hidden > 0) {
      report_.notes.push_back(
          fmt::format("{} in no cell of sheets and maps: without its parameters, or with those of another",
                      counted(grid_.hidden, "task")));
    }
    plan_tables();
    plan_sheets();
    plan_pareto();
    plan_maps();
    add("report.html", [this] { return report_html(sweep_, ranking_, report_); });
  }

  void write(const fs::path& folder, const CollectOptions& options, const CollectProgress& progress) {
    for (const PlannedFile& file : files_) {
      const fs::path path = folder / file.name;
      check_overwrite(path.string(), path, {.force = options.force, .inputs = nullptr});
    }
    for (std::size_t i = 0; i < files_.size(); ++i) {
      if (progress) progress(files_[i].name, i + 1, files_.size());
      write_file(folder / files_[i].name, files_[i].make());
    }
  }

  CollectionWords words() const { return {sentences(), report_.notes}; }

 private:
  std::vector<std::string> sentences() const {
    std::vector<std::string> out;
    for (const std::string& sentence : ranking_.sentences) out.push_back(plain_text(sentence));
    return out;
  }

  void add(std::string name, std::function<std::string()> make) {
    // Different keys may give the same name.
    const auto taken = [&] {
      return std::any_of(files_.begin(), files_.end(), [&](const PlannedFile& f) { return f.name == name; });
    };
    const fs::path given = name;
    for (std::string more = "_"; taken(); more += '_')
      name = given.stem().string() + more + given.extension().string();
    files_.push_back({std::move(name), std::move(make)});
  }

  void plan_tables() {
    add("table.csv", [this] { return table_csv(sweep_); });
    add("table.jsonl", [this] { return table_jsonl(sweep_); });
    add("table.npy", [this] { return table_npy(sweep_); });
    add("timing.csv", [this] { return timing_csv(sweep_); });
    add("ranking.txt", [this] {
      std::string out;
      for (const std::string& sentence : sentences()) out += sentence + "\n";
      return out;
    });
  }

  void plan_sheets() {
    const SheetLayout layout = layout_sheet(grid_, FontMetrics());
    if (!layout.fits()) {
      report_.notes.push_back(fmt::format(
          "no contact sheet: {} × {} pictures would be {} × {} pixels; expected at most {} a side",
          grid_.columns(), grid_.rows(), layout.width, layout.height, png_largest_side));
      return;
    }
    for (std::size_t i = 0; i < std::min(grid_.slices.size(), kMostSheets); ++i) {
      add(i == 0 ? "sheet.png" : fmt::format("sheet_{}.png", i + 1), [this, i] {
        const Image sheet = contact_sheet(sweep_, grid_, i);
        std::string bytes = png_bytes(sheet);
        const std::string& slice = grid_.slices[i].name;
        std::string title = "contact sheet" + (slice.empty() ? std::string() : ": " + plain_text(slice));
        if (i + 1 == kMostSheets && grid_.slices.size() > kMostSheets)
          title += fmt::format(" (the first {} of {})", kMostSheets, grid_.slices.size());
        report_.sheets.push_back({std::move(title), "image/png", bytes, sheet.width});
        return bytes;
      });
    }
  }

  void plan_picture(const std::string& name, const std::string& title, const SizedPicture& picture,
                    std::vector<ReportPicture>& shown) {
    add(name + ".png", [picture] { return png_bytes(picture); });
    add(name + ".svg", [picture, title, &shown] {
      std::string svg = picture_to_svg(picture.picture, picture.size.width, picture.size.height);
      shown.push_back({title, "image/svg+xml", svg, std::min(picture.size.width, kShown)});
      return svg;
    });
  }

  void plan_pareto() {
    const Figure figure = pareto_figure(sweep_, ranking_.criteria);
    if (figure.plots.empty()) return;
    plan_picture("pareto", figure.title, {figure_picture(figure), default_size(figure)}, report_.plots);
  }

  void plan_maps() {
    if (varied_parameters(sweep_).empty()) return;
    for (const Criterion& criterion : ranking_.criteria) {
      SizedPicture picture = criterion_picture(sweep_, grid_, criterion);
      if (!picture.picture) continue;
      plan_picture("heat_" + file_word(criterion.quantity.key), plain_text(criterion.quantity.words), picture,
                   report_.maps);
    }
  }

  const CollectedSweep& sweep_;
  TaskGrid grid_;
  Ranking ranking_;
  Report report_;  // filled while files are made; written last
  std::vector<PlannedFile> files_;
};

}  // namespace

CollectionWords write_collection(const CollectedSweep& sweep, const fs::path& folder,
                                 const CollectOptions& options, const CollectProgress& progress) {
  Collection collection(sweep, options);
  collection.write(folder, options, progress);
  return collection.words();
}

}  // namespace pabd
