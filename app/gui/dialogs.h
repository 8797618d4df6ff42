// The dialogs that ask for a file name, or whether to leave. What is typed is only sent when it is confirmed;
// an error stays in the dialog.
#pragma once

#include <string>

#include "app/gui/panel.h"

namespace pabd {

class Dialogs {
 public:
  void draw(GuiFrame& frame, int width, int height);

 private:
  void start(const GuiFrame& frame);
  void confirm(GuiFrame& frame, bool force);

  std::string open_;         // which one is shown
  std::string text_;         // what is typed
  std::uint64_t asked_ = 0;  // newest message when it was confirmed
  bool waiting_ = false;     // for the answer to what was confirmed
  bool with_ui_ = true;      // screenshot
  command::Record record_;
  bool along_keys_ = false;
};

}  // namespace pabd
