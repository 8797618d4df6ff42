// SPDX-License-Identifier: MIT
// Default classes of MJCF. Internal to sim/import.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "sim/import/xml.h"

namespace pabd {

// An element and the defaults behind it, nearest first.
class MjcfElement {
 public:
  MjcfElement(const XmlElement& own, std::vector<XmlElement> defaults) : all_{own} {
    all_.insert(all_.end(), defaults.begin(), defaults.end());
  }
  const XmlElement& own() const { return all_.front(); }
  const std::vector<XmlElement>& all() const { return all_; }
  // Whoever says the attribute first; the element itself where none does.
  const XmlElement& with(std::string_view attribute) const;
  bool has(std::string_view attribute) const { return with(attribute).has(attribute); }

 private:
  std::vector<XmlElement> all_;
};

class MjcfDefaults {
  struct Class {
    std::string parent;
    std::map<std::string, std::vector<XmlElement>> elements;  // by name
  };

 public:
  // A <default>; the outermost is the class "main". `contents`: what stands in one, files that it includes as well.
  using Contents = std::function<std::vector<XmlElement>(const XmlElement&)>;
  void add(const XmlElement& element, const std::string& name, const std::string& parent,
           const Contents& contents, ImportNotes& notes);
  Class& add_class(const std::string& name, const std::string& parent);
  // `element` with the defaults of its own class, or `childclass`, or main. An unknown class is refused.
  MjcfElement of(const XmlElement& element, const std::string& childclass) const;
  void require(const XmlElement& element, std::string_view attribute) const;  // names a class that there is

 private:
  std::map<std::string, Class> classes_;
};

}  // namespace pabd
