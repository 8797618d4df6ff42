// SPDX-License-Identifier: MIT
// XML of strangers, read with limits: size, depth and number of elements, no entities from outside, every number finite
// and in range. An element knows its file and line, for messages and notes. Internal to sim/import.
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/import/notes.h"
#include "sim/math/types.h"
#include "sim/scene/guarded_scene.h"

namespace tinyxml2 {
class XMLDocument;
class XMLElement;
}  // namespace tinyxml2

namespace pabd {

inline constexpr std::size_t kMostXmlBytes = std::size_t{16} << 20;  // of a file
inline constexpr std::size_t kMostXmlElements = 200'000;             // of all files of a robot
inline constexpr std::size_t kMostXmlAttributes = 1000;              // of an element
inline constexpr std::size_t kLongestXmlName = 1000;                 // bytes
inline constexpr std::size_t kMostXmlFiles = 64;

struct XmlFile {
  XmlFile();
  ~XmlFile();
  std::string name;              // for messages
  std::filesystem::path folder;  // what names in it are relative to
  std::unique_ptr<tinyxml2::XMLDocument> document;
};

// Elements live as long as the XmlFiles they come from.
class XmlElement {
 public:
  XmlElement(const tinyxml2::XMLElement& element, const XmlFile& file) : element_(&element), file_(&file) {}

  std::string name() const;
  int line() const;
  const XmlFile& file() const { return *file_; }
  [[noreturn]] void fail(std::string_view message) const;  // "robot.urdf:12: <joint>: …"
  [[noreturn]] void fail_at(std::string_view attribute, std::string_view message) const;
  void note(ImportNotes& notes, const std::string& text) const { notes.add(text, file_->name, line()); }

  std::vector<XmlElement> children() const;
  // The first of that name.
  std::optional<XmlElement> child(std::string_view name) const;
  std::vector<std::string> attribute_names() const;

  bool has(std::string_view attribute) const { return find(attribute).has_value(); }
  std::optional<std::string> find(std::string_view attribute) const;
  std::string text(std::string_view attribute) const;  // required, not empty

  // Finite numbers of at most 1e12 in absolute value, between `least` and `most` of them.
  std::optional<std::vector<double>> numbers(std::string_view attribute, std::size_t least,
                                             std::size_t most) const;
  std::optional<double> number(std::string_view attribute) const;
  double bound(
      std::string_view attribute) const;  // 0 where it is missing; beyond what numbers may be: infinite
  double resistance(std::string_view attribute) const;  // at least 0, which it is where it is missing
  std::optional<Vec3> vec3(std::string_view attribute) const;
  std::optional<bool> boolean(std::string_view attribute) const;  // true, false, 1, 0

 private:
  const tinyxml2::XMLElement* element_;
  const XmlFile* file_;
};

// The numbers of a text that are parted by blanks. Empty when a word is no finite number.
std::optional<std::vector<double>> numbers_of(std::string_view text, std::size_t most);

// Files of one robot, and what they may be.
class XmlFiles {
 public:
  explicit XmlFiles(MayRead may_read = {}) : may_read_(std::move(may_read)) {}

  // Root element. Throws Error(bad_input) naming file and line, Error(file) when it cannot be read.
  XmlElement parse(const std::string& text, const std::string& name, const std::filesystem::path& folder);
  XmlElement read(const std::filesystem::path& path);

  std::vector<std::filesystem::path> names() const;  // of all files that were read after the first

 private:
  MayRead may_read_;
  std::vector<std::unique_ptr<XmlFile>> files_;
  std::size_t elements_ = 0;
};

}  // namespace pabd
