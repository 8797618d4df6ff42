// SPDX-License-Identifier: MIT
// See gate.h.
#include "app/serve/gate.h"

#include <fmt/format.h>
#include <sys/random.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>

#include "sim/base/error.h"
#include "sim/base/utf8.h"

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

Gate::Gate(std::vector<std::string> hosts, bool secure) : secure_(secure) {
  const std::string_view usual = secure ? ":443" : ":80";  // a port that browsers leave out
  for (const std::string& host : hosts) {
    hosts_.push_back(lower_case(host));
    if (host.ends_with(usual)) hosts_.push_back(lower_case(host.substr(0, host.size() - usual.size())));
  }
}

bool is_host(std::string_view host) {
  constexpr std::size_t kLongest = 255 + 6;
  const bool named = !host.empty() && host.front() != ':' && host.size() <= kLongest;
  return named && std::all_of(host.begin(), host.end(), [](unsigned char c) {
           return std::isalnum(c) != 0 ||
                  std::string_view("-._:[]").find(static_cast<char>(c)) != std::string_view::npos;
         });
}

bool Gate::knows_host(std::string_view host) const {
  return std::find(hosts_.begin(), hosts_.end(), lower_case(host)) != hosts_.end();
}

bool Gate::knows_origin(std::string_view origin, std::string_view host) const {
  return knows_host(host) && lower_case(origin) == std::string(scheme()) + "://" + lower_case(host);
}

bool RateBucket::take(double now) {
  if (last_) left_ = std::min(most_, left_ + rate_ * std::max(0.0, now - *last_));
  last_ = now;
  if (left_ < 1) return false;
  left_ -= 1;
  return true;
}

ConnectionCount::Verdict ConnectionCount::enter(const std::string& peer) {
  if (count_ >= most_) return Verdict::full;
  const auto known = peers_.find(peer);
  if (known != peers_.end() && known->second >= most_each_) return Verdict::busy_peer;
  ++peers_[peer];
  ++count_;
  return Verdict::welcome;
}

void ConnectionCount::leave(const std::string& peer) {
  const auto known = peers_.find(peer);
  if (known == peers_.end()) return;
  --count_;
  if (--known->second == 0) peers_.erase(known);
}

std::string_view bearer_token(std::string_view authorization) {
  constexpr std::string_view kScheme = "bearer ";
  if (authorization.size() <= kScheme.size() ||
      lower_case(authorization.substr(0, kScheme.size())) != kScheme)
    return {};
  return authorization.substr(kScheme.size());
}

}  // namespace pabd
