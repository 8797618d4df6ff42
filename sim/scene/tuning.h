// Tunable parameters as text: one key changed, a patch applied, two sets compared. Keys, values and messages
// are those of scene files and of --set, so that what was tuned by hand can be written down and repeated.
//
// A patch is a JSON merge patch (RFC 7386) of a scene's tunable keys: {"contact": {"kappa": 50}}.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim/solver/params.h"

namespace pabd {

// Every key that may change while a simulation runs: "gravity", "time_step", "solver.method", … in the order
// of the schema.
const std::vector<std::string>& tunable_keys();

// `params` with "key=value" strings applied in order. Throws Error(bad_input) that names key and expectation;
// a key outside tunable_keys() (or "contact.friction" for both) is refused.
Params tuned(const Params& params, const std::vector<std::string>& sets);

// `params` with a merge patch. `source` names the text in messages. Throws like `tuned`.
Params patched(const Params& params, const std::string& patch, const std::string& source);

// The value of one key, as --set takes it: shortest text that reads back exactly. Throws Error(bad_input) for
// a key that cannot be tuned.
std::string tuned_value(const Params& params, std::string_view key);

// Keys on which the two differ, with the value in `to`.
std::vector<std::pair<std::string, std::string>> differences(const Params& from, const Params& to);

// The patch that leads from one to the other, ending in a line break; "{}" when they are equal.
std::string patch_json(const Params& from, const Params& to);

// All tunable keys as an object of a scene file, on one line; κ "auto" where it is not given.
std::string params_json(const Params& params);

// The text of a scene file with overrides as load_scene takes them, and the tunable keys of `params` where
// they differ from what it says then; indented JSON. The order of keys is kept when there are no overrides.
// Throws Error(bad_input).
std::string tuned_scene_text(const std::string& scene, const std::string& source,
                             const std::vector<std::string>& overrides, const Params& params);

}  // namespace pabd
