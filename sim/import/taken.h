// SPDX-License-Identifier: MIT
// What of a robot's file is taken: one table a format. Whatever stands in a file and is neither taken nor without
// effect is noted with its line, by its row here. A new mapping is its code and a word in this table.
#pragma once

#include <span>
#include <string_view>

#include "sim/import/xml.h"

namespace pabd {

struct ImportRow {
  std::string_view element;
  std::string_view taken;      // attributes, parted by blanks
  std::string_view no_effect;  // attributes that change nothing of how bodies move
  std::string_view why;        // not empty: the element is not taken, and this is what that means
};

std::span<const ImportRow> mjcf_rows();
std::span<const ImportRow> urdf_rows();

// Notes the attributes of an element that its row does not have; those that are all zero say nothing.
void note_attributes(const XmlElement& element, std::span<const ImportRow> rows, ImportNotes& notes);
// Notes an element that is not taken, as its row says, or as unknown.
void note_element(const XmlElement& element, std::span<const ImportRow> rows, ImportNotes& notes);

}  // namespace pabd
