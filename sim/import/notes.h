// SPDX-License-Identifier: MIT
// What a robot's file says and the scene does not: told once a thing, with every line where it stands.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace pabd {

struct ImportNote {
  std::string text;                                // "damping of a joint: not taken"
  std::vector<std::pair<std::string, int>> where;  // file and line, in the order of the file; may be empty
  // "robot.urdf:12, 15 and 3 more: damping of a joint: not taken"
  std::string line() const;
};

// Equal texts are one note; notes keep the order of their first place.
class ImportNotes {
 public:
  void add(const std::string& text, const std::string& file, int line);
  const std::vector<ImportNote>& all() const { return notes_; }

 private:
  std::vector<ImportNote> notes_;
  std::map<std::string, std::size_t> places_;
};

}  // namespace pabd
