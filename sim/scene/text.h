// SPDX-License-Identifier: MIT
// Words in messages: quoting text that came from a file, and guessing what a misspelt word was meant to be.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace pabd {

// `text` for a one-line message: control characters escaped, cut to about 60 bytes; without quotes.
std::string printable(std::string_view text);
// The same in double quotes.
std::string in_quotes(std::string_view text);

// The candidate nearest to `word` by edit distance without regard to case; empty when none is near.
std::string_view nearest(std::string_view word, std::span<const std::string_view> candidates);

// `; did you mean "density"?`, or empty when nothing is near.
std::string did_you_mean(std::string_view word, std::span<const std::string_view> candidates);

// `"a", "b" or "c"`.
std::string one_of(std::span<const std::string_view> words);

}  // namespace pabd
