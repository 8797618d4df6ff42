// SPDX-License-Identifier: MIT
// Text and bytes inside of XML and HTML.
#pragma once

#include <string>
#include <string_view>

namespace pabd {

// Text as it may stand between tags and in quoted attributes: & < > " ' as entities, control characters as
// blanks.
std::string escape_markup(std::string_view text);

// Base64 of RFC 4648 with padding, without line breaks.
std::string base64(std::string_view bytes);

}  // namespace pabd
