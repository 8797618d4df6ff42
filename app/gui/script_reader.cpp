// SPDX-License-Identifier: MIT
// See script_reader.h.
#include "app/gui/script_reader.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/gui/script_actions.h"
#include "sim/scene/document.h"

namespace pabd {
std::vector<nlohmann::ordered_json> read_script(const std::string& json, const std::string& source) {
  (void)parse_document(json, source);  // refuses what is not JSON, too deep or too large, with its place
  nlohmann::ordered_json document = nlohmann::ordered_json::parse(json);  // keeps the order
  if (document.is_object() && document.contains("actions"))
    document = nlohmann::ordered_json(document["actions"]);
  if (!document.is_array())
    refuse_action(source, "expected a list of actions, or an object with \"actions\"");
  for (std::size_t i = 0; i < document.size(); ++i) {
    const nlohmann::ordered_json& a = document[i];
    const std::string what = fmt::format("{}: action {}", source, i);
    if (!a.is_object() || !a.contains("do") || !a["do"].is_string())
      refuse_action(what, "expected an object with \"do\"");
    if (a.contains(kMayFail) && !a[kMayFail].is_boolean())
      refuse_action(what, "\"may_fail\": expected true or false");
    (void)parse_action(a, what);
  }
  return {document.begin(), document.end()};
}

}  // namespace pabd
