// SPDX-License-Identifier: MIT
// The secret in the link: 128 bits of the system's randomness.
#pragma once

#include <string>
#include <string_view>

namespace pabd {

class AccessToken {
 public:
  static constexpr std::size_t kDigits = 32;

  static AccessToken make();  // throws Error(file) when the system has no randomness

  const std::string& hex() const { return hex_; }
  // In a time that does not depend on where they differ.
  bool matches(std::string_view given) const;

 private:
  explicit AccessToken(std::string hex) : hex_(std::move(hex)) {}
  std::string hex_;
};

// What a link with one of the two tokens may do.
enum class Access { none, watch, control };

struct AccessTokens {
  AccessToken control = AccessToken::make(), watch = AccessToken::make();
  bool watchers = true;  // the second one counts

  Access access(std::string_view given) const;
};

}  // namespace pabd
