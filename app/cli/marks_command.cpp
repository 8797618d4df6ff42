// SPDX-License-Identifier: MIT
// pabd marks: the reference of what stands in pictures.
#include <memory>

#include "app/cli/common.h"
#include "app/cli/marks_page.h"
#include "app/cli/streams.h"

namespace pabd::cli {

void add_marks_command(CLI::App& app, Action& action) {
  auto options = std::make_shared<CommonOptions>();
  CLI::App* command = add_command(app, "marks", "explain the marks and colours of pictures, with their units",
                                  {"pabd marks", "pabd marks > marks.md"}, *options);
  command->callback([options, &action] {
    action = [options] {
      write_stdout(marks_page());
      return 0;
    };
  });
}

}  // namespace pabd::cli
