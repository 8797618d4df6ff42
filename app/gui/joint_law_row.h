// SPDX-License-Identifier: MIT
// The law of B's joints, beside what else of B differs: another potential, κ, d̂ and N for all joints that say nothing
// of their own.
#pragma once

#include <string>

#include "app/gui/panel.h"

namespace pabd {

class JointLawRow {
 public:
  // At the cursor, on as many lines as it needs. Nothing where the scene has no joints. Precondition: there is a B.
  void draw(GuiFrame& frame);

 private:
  void field(GuiFrame& f, const char* name, const std::string& key, const std::string& shown, double width,
             const std::string& help);

  std::string typing_, typed_;  // key of the field that is being typed in, and its text
};

}  // namespace pabd
