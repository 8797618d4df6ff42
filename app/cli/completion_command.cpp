// SPDX-License-Identifier: MIT
// pabd completion: what a shell reads to complete commands, options, scenes and parameters.
#include <memory>

#include "app/cli/completion.h"
#include "app/cli/streams.h"

namespace pabd::cli {

void add_completion_command(CLI::App& app, Action& action) {
  auto options = std::make_shared<CommonOptions>();
  auto shell = std::make_shared<std::string>();
  auto out = std::make_shared<std::string>("-");
  CLI::App* command = add_command(app, "completion", "tab completion for a shell, to standard output",
                                  {"source <(pabd completion bash)", "pabd completion zsh > ~/.zfunc/_pabd",
                                   "pabd completion fish > ~/.config/fish/completions/pabd.fish"},
                                  *options);
  command->add_option("SHELL", *shell, "bash, zsh or fish")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}));
  // For whoever builds and installs the program.
  command->add_option("-o,--out", *out, "a file in place of standard output; replaced if it exists")
      ->type_name("OUT")
      ->group("");
  command->callback([shell, out, options, &app, &action] {
    action = [shell, out, &app] {
      TextOutput file("--out", *out, true);
      file.write(completion_script(app, *shell));
      file.finish();
      return 0;
    };
  });
}

}  // namespace pabd::cli
