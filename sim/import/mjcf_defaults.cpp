// SPDX-License-Identifier: MIT
// See mjcf_defaults.h.
#include "sim/import/mjcf_defaults.h"

#include <fmt/format.h>

#include "sim/import/taken.h"
#include "sim/scene/text.h"

namespace pabd {
namespace {

constexpr std::size_t kMostDefaults = 100;  // behind an element

[[noreturn]] void refuse(const XmlElement& element) {
  element.fail(fmt::format("more than {} defaults of a kind; expected fewer", kMostDefaults));
}

}  // namespace

const XmlElement& MjcfElement::with(std::string_view attribute) const {
  for (const XmlElement& each : all_)
    if (each.has(attribute)) return each;
  return all_.front();
}

MjcfDefaults::Class& MjcfDefaults::add_class(const std::string& name, const std::string& parent) {
  return classes_.try_emplace(name, Class{name == parent ? "" : parent, {}}).first->second;
}

void MjcfDefaults::add(const XmlElement& element, const std::string& name, const std::string& parent,
                       const Contents& contents, ImportNotes& notes) {
  Class& mine = add_class(name, parent);
  for (const XmlElement& child : contents(element)) {
    if (child.name() == "default") {
      note_attributes(child, mjcf_rows(), notes);
      add(child, child.text("class"), name, contents, notes);
      continue;
    }
    const std::string kind = child.name();
    if (kind == "geom" || kind == "joint" || kind == "position" || kind == "motor" || kind == "velocity" ||
        kind == "general" || kind == "mesh" || kind == "material") {
      note_attributes(child, mjcf_rows(), notes);
      auto& list = mine.elements[kind];
      if (list.size() == kMostDefaults) refuse(child);
      list.insert(list.begin(), child);
    }
    // Defaults of what is not taken say nothing: what uses them is noted.
  }
}

void MjcfDefaults::require(const XmlElement& element, std::string_view attribute) const {
  const auto name = element.find(attribute);
  if (name && *name != "main" && !classes_.contains(*name))
    element.fail_at(attribute, "there is no default class " + in_quotes(*name));
}

MjcfElement MjcfDefaults::of(const XmlElement& element, const std::string& childclass) const {
  require(element, "class");
  std::string name = element.find("class").value_or(childclass.empty() ? "main" : childclass);
  std::vector<XmlElement> chain;
  while (!name.empty()) {
    const auto found = classes_.find(name);
    if (found == classes_.end()) break;
    const auto elements = found->second.elements.find(element.name());
    if (elements != found->second.elements.end())
      chain.insert(chain.end(), elements->second.begin(), elements->second.end());
    if (chain.size() > kMostDefaults) refuse(element);
    name = found->second.parent;
  }
  return MjcfElement(element, std::move(chain));
}

}  // namespace pabd
