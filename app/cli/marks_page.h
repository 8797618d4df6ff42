// SPDX-License-Identifier: MIT
// The reference of marks: what stands in pictures and over them, what its colours mean, in which units. Made from
// the tables that draw them.
#pragma once

#include <string>

namespace pabd::cli {

// Markdown; app/cli/marks.md holds it. Throws std::logic_error when a panel or a type of joint has no words here.
std::string marks_page();

}  // namespace pabd::cli
