// SPDX-License-Identifier: MIT
// The numbers of a body, a joint or a contact, as rows of text to show and to copy.
#pragma once

#include <string>
#include <vector>

#include "app/gui/ui_state.h"
#include "app/workbench/snapshot.h"

namespace pabd {

struct InspectorRow {
  std::string name, value;  // a heading has no value
  std::string help = {};
  bool warn = false;
};
using InspectorRows = std::vector<InspectorRow>;

// Preconditions: the number is one of the model's, of a contact one of the step's reports. Reports of bodies
// and contacts that the step does not hold are left out.
InspectorRows body_rows(const RunView& run, Index body);
InspectorRows joint_rows(const RunView& run, Index joint);
InspectorRows contact_rows(const RunView& run, Index contact);

// "box 3", "the world".
std::string body_title(const Model& model, Index body);
// Its name, or type and bodies.
std::string joint_title(const Model& model, Index joint);

// "2.45 kN".
std::string force_text(double newton);

// "name: value", one a line.
std::string as_text(const std::string& title, const InspectorRows& rows);

}  // namespace pabd
