// SPDX-License-Identifier: MIT
// Changed parameters: a merge patch, or a "key=value" of --set in the first line of an input. What is taken
// can be written as a patch that leads there.
#include "sim/scene/tuning.h"
#include "tests/fuzz/fuzz.h"

using namespace pabd;

namespace {

void check(const Params& params) {
  const Params again = patched(Params{}, patch_json(Params{}, params), "patch.json");
  fuzz::require(differences(params, again).empty(), "parameters that are written are read back");
}

}  // namespace

PABD_FUZZ_TARGET(patch, bytes) {
  const std::string text(bytes);
  fuzz::accepts([&] { check(patched(Params{}, text, "patch.json")); });
  fuzz::accepts([&] { check(tuned(Params{}, {text.substr(0, text.find('\n'))})); });
}
