// SPDX-License-Identifier: MIT
// Access checks: tokens, names of the server, origins of pages, rates.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pabd {

// The secret in the link: 128 random bits of the system.
class AccessToken {
 public:
  static constexpr std::size_t kDigits = 32;

  static AccessToken make();  // throws Error(file) without a source of random numbers

  const std::string& hex() const { return hex_; }
  // In constant time.
  bool matches(std::string_view given) const;

 private:
  explicit AccessToken(std::string hex) : hex_(std::move(hex)) {}
  std::string hex_;
};

// What the holder of a token may do.
enum class Access { none, watch, control };

struct AccessTokens {
  AccessToken control = AccessToken::make(), watch = AccessToken::make();
  bool watchers = true;  // whether the watch token is valid

  Access access(std::string_view given) const;
};

// Checks the headers Host (against DNS rebinding) and Origin (against scripts of other sites), regardless of case.
class Gate {
 public:
  // "127.0.0.1:8472"; `secure`: https. A name with the scheme's default port is also known without it.
  Gate(std::vector<std::string> hosts, bool secure);

  bool knows_host(std::string_view host) const;
  // Whether the origin is that of the requested host.
  bool knows_origin(std::string_view origin, std::string_view host) const;

  const char* scheme() const { return secure_ ? "https" : "http"; }

 private:
  std::vector<std::string> hosts_;  // in lower case
  bool secure_;
};

// "name", "name:8472", "[::1]:8472": what a browser can send as Host.
bool is_host(std::string_view host);

// Token bucket: `rate` a second, at most `most` at once.
class RateBucket {
 public:
  RateBucket(double rate, double most) : rate_(rate), most_(most), left_(most) {}
  bool take(double now);  // s; false: too many

 private:
  double rate_, most_, left_;
  std::optional<double> last_;
};

// Limits simultaneous connections, in all and per address.
class ConnectionCount {
 public:
  enum class Verdict { welcome, busy_peer, full };
  ConnectionCount(std::size_t all, std::size_t each) : most_(all), most_each_(each) {}

  Verdict enter(const std::string& peer);  // counted only when welcome
  void leave(const std::string& peer);
  std::size_t count() const { return count_; }

 private:
  std::size_t most_, most_each_, count_ = 0;
  std::map<std::string, std::size_t> peers_;
};

// The token of "Authorization: Bearer TOKEN"; empty: there is none.
std::string_view bearer_token(std::string_view authorization);

}  // namespace pabd
