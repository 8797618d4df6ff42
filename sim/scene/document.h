// SPDX-License-Identifier: MIT
// Text → JSON document, with everything refused that a JSON library lets through: duplicate keys, deep
// nesting, numbers that overflow, huge files. Internal to sim/scene and sim/trace.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace pabd {

using Json = nlohmann::json;

struct DocumentLimits {
  std::size_t bytes = std::size_t{64} << 20;   // length of the text
  std::size_t values = std::size_t{16} << 20;  // numbers, strings, arrays, … : bounds the memory
  int depth = 32;                              // arrays and objects inside each other
};

// Throws Error(bad_input) with line and column of a syntax error, or the JSON pointer of a duplicate key.
// `source` names the text in messages. Every number of the result is finite.
Json parse_document(const std::string& text, const std::string& source, const DocumentLimits& limits = {});

}  // namespace pabd
