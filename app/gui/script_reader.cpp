// SPDX-License-Identifier: MIT
// See script_reader.h.
#include "app/gui/script_reader.h"

#include <fmt/format.h>

#include "app/gui/script_actions.h"
#include "sim/base/error.h"
#include "sim/scene/document.h"

namespace pabd {
namespace {

using ActionJson = nlohmann::ordered_json;

[[noreturn]] void refuse(const std::string& what, const std::string& why) {
  throw Error(ErrorKind::bad_input, what, why);
}

}  // namespace

std::vector<ActionJson> read_script(const std::string& json, const std::string& source) {
  (void)parse_document(json, source);  // refuses what is not JSON, too deep or too large, with its place
  ActionJson document = ActionJson::parse(json);  // keeps the order
  if (document.is_object() && document.contains("actions")) document = ActionJson(document["actions"]);
  if (!document.is_array()) refuse(source, "expected a list of actions, or an object with \"actions\"");
  for (std::size_t i = 0; i < document.size(); ++i) {
    const ActionJson& a = document[i];
    const std::string what = fmt::format("{}: action {}", source, i);
    if (!a.is_object() || !a.contains("do") || !a["do"].is_string())
      refuse(what, "expected an object with \"do\"");
    if (a.contains(kMayFail) && !a[kMayFail].is_boolean())
      refuse(what, "\"may_fail\": expected true or false");
    (void)parse_action(a, what);
  }
  return {document.begin(), document.end()};
}

}  // namespace pabd
