// SPDX-License-Identifier: MIT
// pabd man: the manual pages, for whoever builds and installs the program. Not in the help.
#include <filesystem>

#include "app/cli/common.h"
#include "app/cli/man_page.h"
#include "app/cli/streams.h"

namespace pabd::cli {

void add_man_command(CLI::App& app, Action& action) {
  auto options = std::make_shared<CommonOptions>();
  auto folder = std::make_shared<std::string>();
  CLI::App* command =
      add_command(app, "man", "write the manual pages into a folder", {"pabd man man1"}, *options);
  command->group("");
  command->add_option("FOLDER", *folder, "where; files of the same names are replaced")->required();
  command->callback([folder, options, &app, &action] {
    action = [folder, &app] {
      for (const ManPage& page : man_pages(app)) {
        TextOutput file("FOLDER", (std::filesystem::path(*folder) / page.file).string(), true);
        file.write(page.text);
        file.finish();
      }
      return 0;
    };
  });
}

}  // namespace pabd::cli
