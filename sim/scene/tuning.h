// SPDX-License-Identifier: MIT
// Tunable parameters as text: one key changed, a patch applied, two sets compared. Keys, values and messages
// are those of scene files and of --set, so that what was tuned by hand can be written down and repeated.
//
// A patch is a JSON merge patch (RFC 7386) of a scene's tunable keys: {"contact": {"kappa": 50}}.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim/solver/parameter_table.h"

namespace pabd {

// `params` with "key=value" strings applied in order. Throws Error(bad_input) that names key and expectation;
// a key that is not in the table (or "contact.friction" for both, "gravity.1" for one of three) is refused.
Params tuned(const Params& params, const std::vector<std::string>& sets,
             ParameterTable table = parameter_table());

// `params` with a merge patch. `source` names the text in messages. Throws like `tuned`.
Params patched(const Params& params, const std::string& patch, const std::string& source,
               ParameterTable table = parameter_table());

// A value as --set takes it: shortest text that reads back exactly.
std::string value_text(const ParameterValue& value);

// The same of one key. Throws Error(bad_input) for a key that cannot be tuned.
std::string tuned_value(const Params& params, std::string_view key, ParameterTable table = parameter_table());

// Rows on which the two differ.
std::vector<const ParameterRow*> differing(const Params& from, const Params& to,
                                           ParameterTable table = parameter_table());

// Keys on which the two differ, with the value in `to`.
std::vector<std::pair<std::string, std::string>> differences(const Params& from, const Params& to,
                                                             ParameterTable table = parameter_table());

// The patch that leads from one to the other, ending in a line break; "{}" when they are equal.
std::string patch_json(const Params& from, const Params& to, ParameterTable table = parameter_table());

// All parameters as an object of a scene file, on one line; κ "auto" where it is not given.
std::string params_json(const Params& params, ParameterTable table = parameter_table());

// The text of a scene file with overrides as load_scene takes them, and the parameters where they differ from
// what it says then; indented JSON. What it leaves out is that of `defaults`: d̂ follows from bodies (thickness.h). The
// order of keys is kept when there are no overrides. Throws Error(bad_input).
std::string tuned_scene_text(const std::string& scene, const std::string& source,
                             const std::vector<std::string>& overrides, const Params& params,
                             ParameterTable table = parameter_table(), const Params& defaults = {});

}  // namespace pabd
