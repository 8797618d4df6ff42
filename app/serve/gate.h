// SPDX-License-Identifier: MIT
// Who may come in: with which secret, under which names of the server, from which pages, how often.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pabd {

// The secret in the link: 128 bits of the system's randomness.
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

// Host and Origin, compared as they are, without case. A page of another site that got a name of its own to
// point here (DNS rebinding) is stopped by the first, its scripts by the second.
class Gate {
 public:
  // "127.0.0.1:8472"; `secure`: https. Those with its usual port are known without it too.
  Gate(std::vector<std::string> hosts, bool secure);

  bool knows_host(std::string_view host) const;
  // An origin is right when it is that of the host that was asked.
  bool knows_origin(std::string_view origin, std::string_view host) const;

  const char* scheme() const { return secure_ ? "https" : "http"; }

 private:
  std::vector<std::string> hosts_;  // in small letters
  bool secure_;
};

// "name", "name:8472", "[::1]:8472": what a browser can send as Host.
bool is_host(std::string_view host);

// `rate` tokens a second, at most `most` at a time.
class RateBucket {
 public:
  RateBucket(double rate, double most) : rate_(rate), most_(most), left_(most) {}
  bool take(double now);  // seconds, since whenever; false: too many

 private:
  double rate_, most_, left_;
  std::optional<double> last_;
};

// Connections at a time.
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
