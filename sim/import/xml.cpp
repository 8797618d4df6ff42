// SPDX-License-Identifier: MIT
// See xml.h. TinyXML-2 parses: it resolves no entities but the five of XML, ignores document types, and refuses
// elements deeper than 100. Numbers are read here: its own depend on the locale and take "nan".
#include "sim/import/xml.h"

#include <fmt/format.h>
#include <tinyxml2.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "sim/base/error.h"
#include "sim/base/input_file.h"
#include "sim/scene/text.h"

namespace pabd {
namespace {

constexpr double kLargest = 1e12;

[[noreturn]] void refuse(const std::string& name, int line, std::string_view message) {
  throw Error(ErrorKind::bad_input, line > 0 ? fmt::format("{}:{}", name, line) : name, message);
}

bool blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

// TinyXML-2 compares each attribute of an element with all before it.
void check_attributes(std::string_view text, const std::string& name) {
  std::size_t at = 0;
  const auto skip_past = [&](std::string_view end) {
    const std::size_t found = text.find(end, at);
    at = found == std::string_view::npos ? text.size() : found + end.size();
  };
  while ((at = text.find('<', at)) < text.size()) {
    const std::string_view rest = text.substr(at);
    if (rest.starts_with("<!--")) {
      skip_past("-->");
    } else if (rest.starts_with("<![CDATA[")) {
      skip_past("]]>");
    } else {
      const std::size_t begin = at;
      for (std::size_t count = 0; at < text.size() && text[at] != '>'; ++at) {
        if (text[at] != '"' && text[at] != '\'') continue;
        at = std::min(text.find(text[at], at + 1), text.size() - 1);
        if (++count <= kMostXmlAttributes) continue;
        const std::string_view before = text.substr(0, begin);
        refuse(name, static_cast<int>(1 + std::count(before.begin(), before.end(), '\n')),
               fmt::format("an element has more than {} attributes; expected fewer", kMostXmlAttributes));
      }
    }
  }
}

// Without recursion: the depth is the file's.
std::size_t count_elements(const tinyxml2::XMLElement& root) {
  std::size_t count = 0;
  const tinyxml2::XMLElement* at = &root;
  while (at != nullptr) {
    ++count;
    if (const auto* down = at->FirstChildElement()) {
      at = down;
      continue;
    }
    while (at != nullptr && at != &root && at->NextSiblingElement() == nullptr)
      at = at->Parent() == nullptr ? nullptr : at->Parent()->ToElement();
    at = at == &root || at == nullptr ? nullptr : at->NextSiblingElement();
  }
  return count;
}

}  // namespace

std::optional<std::vector<double>> numbers_of(std::string_view text, std::size_t most) {
  std::vector<double> out;
  for (std::size_t at = 0; at < text.size();) {
    if (blank(text[at])) {
      ++at;
      continue;
    }
    std::size_t end = at;
    while (end < text.size() && !blank(text[end])) ++end;
    if (text[at] == '+') ++at;
    double value = 0;
    const auto [stop, error] = std::from_chars(text.data() + at, text.data() + end, value);
    if (error != std::errc{} || stop != text.data() + end || !(std::abs(value) <= kLargest)) return {};
    if (out.size() == most) return {};
    out.push_back(value);
    at = end;
  }
  return out;
}

XmlFile::XmlFile() = default;
XmlFile::~XmlFile() = default;

std::string XmlElement::name() const { return element_->Name(); }
int XmlElement::line() const { return element_->GetLineNum(); }

void XmlElement::fail(std::string_view message) const {
  refuse(file_->name, line(), fmt::format("<{}>: {}", printable(name()), message));
}

void XmlElement::fail_at(std::string_view attribute, std::string_view message) const {
  refuse(file_->name, line(), fmt::format("<{}> {}: {}", printable(name()), attribute, message));
}

std::vector<XmlElement> XmlElement::children() const {
  std::vector<XmlElement> out;
  for (const auto* e = element_->FirstChildElement(); e != nullptr; e = e->NextSiblingElement())
    out.emplace_back(*e, *file_);
  return out;
}

std::optional<XmlElement> XmlElement::child(std::string_view wanted) const {
  const auto* e = element_->FirstChildElement(std::string(wanted).c_str());
  if (e == nullptr) return {};
  return XmlElement(*e, *file_);
}

std::vector<std::string> XmlElement::attribute_names() const {
  std::vector<std::string> out;
  for (const auto* a = element_->FirstAttribute(); a != nullptr; a = a->Next()) out.emplace_back(a->Name());
  return out;
}

std::optional<std::string> XmlElement::find(std::string_view attribute) const {
  const char* value = element_->Attribute(std::string(attribute).c_str());
  if (value == nullptr) return {};
  return value;
}

std::string XmlElement::text(std::string_view attribute) const {
  const auto value = find(attribute);
  if (!value || value->empty()) fail_at(attribute, "missing; expected a name");
  if (value->size() > kLongestXmlName)
    fail_at(attribute,
            fmt::format("{} bytes long; expected a name of at most {}", value->size(), kLongestXmlName));
  return *value;
}

std::optional<std::vector<double>> XmlElement::numbers(std::string_view attribute, std::size_t least,
                                                       std::size_t most) const {
  const auto value = find(attribute);
  if (!value) return {};
  auto out = numbers_of(*value, most);
  if (!out || out->size() < least) {
    const std::string count = least == most ? fmt::format("{}", least) : fmt::format("{} to {}", least, most);
    fail_at(attribute, fmt::format("expected {} finite number{} of at most {}, got {}", count,
                                   most == 1 ? "" : "s", kLargest, in_quotes(*value)));
  }
  return out;
}

std::optional<double> XmlElement::number(std::string_view attribute) const {
  const auto list = numbers(attribute, 1, 1);
  if (!list) return {};
  return list->front();
}

double XmlElement::bound(std::string_view attribute) const {
  const std::string value = find(attribute).value_or("0");
  double read = 0;
  const char* end = value.data() + value.size();
  if (std::from_chars(value.data(), end, read).ptr == end && std::abs(read) > kLargest)
    return std::copysign(std::numeric_limits<double>::infinity(), read);
  return number(attribute).value_or(0);
}

double XmlElement::resistance(std::string_view attribute) const {
  const double value = number(attribute).value_or(0);
  if (value < 0) fail_at(attribute, "is negative");
  return value;
}

std::optional<Vec3> XmlElement::vec3(std::string_view attribute) const {
  const auto list = numbers(attribute, 3, 3);
  if (!list) return {};
  return Vec3((*list)[0], (*list)[1], (*list)[2]);
}

std::optional<bool> XmlElement::boolean(std::string_view attribute) const {
  const auto value = find(attribute);
  if (!value) return {};
  if (*value == "true" || *value == "1") return true;
  if (*value == "false" || *value == "0") return false;
  fail_at(attribute, "expected true or false, got " + in_quotes(*value));
}

XmlElement XmlFiles::parse(const std::string& text, const std::string& name,
                           const std::filesystem::path& folder) {
  if (files_.size() == kMostXmlFiles)
    refuse(name, 0, fmt::format("more than {} files; expected fewer includes", kMostXmlFiles));
  if (text.size() > kMostXmlBytes)
    refuse(name, 0, fmt::format("{} bytes; expected at most {}", text.size(), kMostXmlBytes));
  check_attributes(text, name);
  auto file = std::make_unique<XmlFile>();
  file->name = name;
  file->folder = folder;
  file->document = std::make_unique<tinyxml2::XMLDocument>();
  tinyxml2::XMLDocument& document = *file->document;
  switch (document.Parse(text.data(), text.size())) {
    case tinyxml2::XML_SUCCESS:
      break;
    case tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED:
      refuse(name, document.ErrorLineNum(), "elements are nested too deeply; expected at most 100 levels");
    case tinyxml2::XML_ERROR_EMPTY_DOCUMENT:
      refuse(name, 0, "no XML in it; expected <robot> or <mujoco>");
    default:
      refuse(name, document.ErrorLineNum(), "not well-formed XML");
  }
  const tinyxml2::XMLElement* root = document.RootElement();
  if (root == nullptr) refuse(name, 0, "no element in it; expected <robot> or <mujoco>");
  elements_ += count_elements(*root);
  if (elements_ > kMostXmlElements)
    refuse(name, 0, fmt::format("more than {} elements; expected a smaller file", kMostXmlElements));
  files_.push_back(std::move(file));
  return XmlElement(*root, *files_.back());
}

std::vector<std::filesystem::path> XmlFiles::names() const {
  std::vector<std::filesystem::path> out;
  for (std::size_t k = 1; k < files_.size(); ++k) out.emplace_back(files_[k]->name);
  return out;
}

XmlElement XmlFiles::read(const std::filesystem::path& path) {
  if (may_read_) may_read_(path);
  return parse(read_file(path, kMostXmlBytes, "a robot in URDF or MJCF"), path.string(), path.parent_path());
}

}  // namespace pabd
