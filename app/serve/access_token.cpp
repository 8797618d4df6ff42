// SPDX-License-Identifier: MIT
// See access_token.h.
#include "app/serve/access_token.h"

#include <fmt/format.h>
#include <sys/random.h>

#include <array>
#include <cstdint>

#include "sim/base/error.h"

namespace pabd {

AccessToken AccessToken::make() {
  std::array<std::uint8_t, kDigits / 2> bytes{};
  if (::getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    throw Error(ErrorKind::file,
                "the system gives no random numbers (getrandom); without them no token is safe");
  std::string hex;
  for (const std::uint8_t byte : bytes) hex += fmt::format("{:02x}", byte);
  return AccessToken(std::move(hex));
}

bool AccessToken::matches(std::string_view given) const {
  unsigned differs = given.size() == kDigits ? 0 : 1;
  for (std::size_t i = 0; i < kDigits; ++i) {
    const char c = i < given.size() ? given[i] : '\0';
    differs |= static_cast<unsigned>(static_cast<unsigned char>(c) ^ static_cast<unsigned char>(hex_[i]));
  }
  return differs == 0;
}

Access AccessTokens::access(std::string_view given) const {
  const bool controls = control.matches(given), watches = watch.matches(given);
  return controls ? Access::control : watches && watchers ? Access::watch : Access::none;
}

}  // namespace pabd
