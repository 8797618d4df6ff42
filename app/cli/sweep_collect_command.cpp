// SPDX-License-Identifier: MIT
// pabd sweep collect: tables, pictures, a ranking and a report of what a sweep left.
#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "app/cli/help_text.h"
#include "app/cli/streams.h"
#include "app/sweep/collect_write.h"

namespace pabd::cli {
namespace {

struct CollectCommandOptions {
  CommonOptions common;
  std::string folder, out;
  CollectOptions collect;
};

int collect(const CollectCommandOptions& options) {
  const std::filesystem::path folder = options.folder;
  const std::filesystem::path out =
      options.out.empty() ? folder / "collected" : std::filesystem::path(options.out);
  const CollectedSweep sweep = collect_sweep(folder);
  const bool quiet = options.common.quiet;
  CollectProgress progress;
  if (!quiet && stderr_is_terminal()) {
    progress = [](const std::string& name, std::size_t number, std::size_t of) {
      write_stderr(fmt::format("\r\x1b[K{} of {} files  {}", number, of, name));
      if (number == of) write_stderr("\r\x1b[K");
    };
  }
  const CollectionWords words = write_collection(sweep, out, options.collect, progress);
  for (const auto* notes : {&sweep.notes, &words.notes}) {
    for (const std::string& note : *notes) write_note("note: " + note);
  }
  if (quiet) return 0;
  std::string text = counts_words(sweep) + "\n";
  for (const std::string& sentence : words.ranking) text += wrap(sentence, help_columns(), 2) + "\n";
  text += (out / "report.html").string() + "\n";
  write_stdout(text);
  return 0;
}

}  // namespace

void add_sweep_collect_command(CLI::App& sweep, Action& action) {
  auto options = std::make_shared<CollectCommandOptions>();
  const Command command(
      sweep, "collect", "make tables, pictures, a ranking and a report of what a sweep left",
      {"pabd sweep collect out", "pabd sweep collect out -o report --x contact.d_hat --y contact.kappa",
       "pabd sweep collect out --force"},
      options->common);
  using group::kOutput;
  command.argument("DIR", options->folder, "the folder of the sweep")->type_name("FOLDER")->required();
  command.option(kOutput, "-o,--out", options->out,
                 "folder of table.csv, .jsonl and .npy, timing.csv, ranking.txt, sheet.png, heat_*.png and "
                 ".svg, pareto.png and .svg, report.html (default DIR/collected)",
                 "FOLDER");
  command.force(options->collect.force);
  command.option(kOutput, "--x", options->collect.x,
                 "parameter from left to right, by its key (default: one of the two with the most values)",
                 "KEY");
  command.option(kOutput, "--y", options->collect.y, "parameter from bottom to top", "KEY");
  command.carry_out(action, options, collect);
}

}  // namespace pabd::cli
