// SPDX-License-Identifier: MIT
// The dialogs (view_words.h). A command is sent when it is confirmed; an error stays in the dialog.
#pragma once

#include <string>
#include <vector>

#include "app/gui/file_list.h"
#include "app/gui/number_input.h"
#include "app/gui/panel.h"

namespace pabd {

class Dialogs {
 public:
  // Looks for the answer to what was confirmed; before messages are drawn.
  void look(const Snapshot& sim, const UiState& ui);
  void draw(GuiFrame& frame, int width, int height);

  // The newest message that was shown in a dialog.
  std::uint64_t answered() const { return answered_; }

 private:
  void start(const GuiFrame& frame);
  void fields(GuiFrame& frame, bool& go);
  void browser(GuiFrame& frame, bool& go);
  void confirm(GuiFrame& frame, bool force);

  std::string open_;  // which one is shown
  float height_ = 0;  // of the last frame; pixels
  const DialogKind* kind_ = nullptr;
  std::string text_;            // what is typed
  std::string awaited_;         // name of the command that was confirmed; empty: nothing was
  std::uint64_t asked_ = 0;     // newest message then
  std::uint64_t scene_ = 0;     // serial of the scene then
  std::uint64_t answered_ = 0;  // message
  std::string refusal_;         // why it was refused; empty: it was not
  bool exists_ = false;         // …: the file is there already
  bool done_ = false;           // it was carried out
  bool focus_ = false;          // the text gets the keyboard in the next frame
  bool with_ui_ = true;         // screenshot
  bool browse_ = false;         // the folder is shown
  std::string listed_;          // folder that files_ are of
  std::vector<FileEntry> files_;
  command::Record record_;
  TypedField field_;  // of its numbers
  bool along_keys_ = false;
};

}  // namespace pabd
