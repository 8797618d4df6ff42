// SPDX-License-Identifier: MIT
// Tokens, names of the server, rates, counts of connections.
#include <catch2/catch.hpp>
#include <set>

#include "app/serve/gate.h"

namespace pabd::test_access {

TEST_CASE("a token is 128 bits as hex digits, another one every time") {
  std::set<std::string> seen;
  for (int i = 0; i < 200; ++i) {
    const AccessToken token = AccessToken::make();
    CHECK(token.hex().size() == 32);
    CHECK(token.hex().find_first_not_of("0123456789abcdef") == std::string::npos);
    CHECK(seen.insert(token.hex()).second);
  }
}

TEST_CASE("a token matches itself only, whatever is given") {
  const AccessToken token = AccessToken::make();
  CHECK(token.matches(token.hex()));
  CHECK_FALSE(token.matches(""));
  CHECK_FALSE(token.matches(token.hex().substr(0, 31)));
  CHECK_FALSE(token.matches(token.hex() + "0"));
  CHECK_FALSE(token.matches(token.hex() + std::string(1, '\0')));
  for (std::size_t i = 0; i < token.hex().size(); ++i) {
    std::string other = token.hex();
    other[i] = other[i] == '0' ? '1' : '0';
    CHECK_FALSE(token.matches(other));
  }
  std::string capital = token.hex();
  capital[0] = 'A';
  CHECK_FALSE(token.matches(capital));
}

TEST_CASE("the second token only watches, and only when there is one") {
  AccessTokens tokens;
  CHECK(tokens.access(tokens.control.hex()) == Access::control);
  CHECK(tokens.access(tokens.watch.hex()) == Access::watch);
  CHECK(tokens.access("") == Access::none);
  tokens.watchers = false;
  CHECK(tokens.access(tokens.watch.hex()) == Access::none);
}

TEST_CASE("Host and Origin are exact") {
  const Gate gate({"127.0.0.1:8472", "localhost:8472", "[::1]:8472"}, false);
  for (const char* host : {"127.0.0.1:8472", "LOCALHOST:8472", "[::1]:8472"}) CHECK(gate.knows_host(host));
  for (const char* host : {"", "127.0.0.1", "127.0.0.1:8473", "localhost:8472.evil.org", "evil.org:8472",
                           "127.0.0.1:8472 ", "127.0.0.2:8472", "[::1]"})
    CHECK_FALSE(gate.knows_host(host));
  CHECK(gate.knows_origin("http://127.0.0.1:8472", "127.0.0.1:8472"));
  CHECK(gate.knows_origin("http://localhost:8472", "localhost:8472"));
  for (const char* origin : {"", "null", "https://127.0.0.1:8472", "http://127.0.0.1:8472/",
                             "http://evil.org", "http://127.0.0.1:8472.evil.org", "http://localhost:8472"})
    CHECK_FALSE(gate.knows_origin(origin, "127.0.0.1:8472"));
  CHECK_FALSE(gate.knows_origin("http://evil.org", "evil.org"));
  CHECK(Gate({"a:1"}, true).knows_origin("https://a:1", "a:1"));
  CHECK_FALSE(Gate({"a:1"}, true).knows_origin("http://a:1", "a:1"));
}

TEST_CASE("a name of the server is one that a browser can send") {
  for (const char* host : {"a", "example.org:8472", "[::1]:1", "10.0.0.1", "my_host-2"}) CHECK(is_host(host));
  for (const char* host : {"", ":80", "a b", "a\r\nX: y", "a,b", "a/b", "http://a", "a@b", "\xc3\xa4.org"})
    CHECK_FALSE(is_host(host));
  CHECK_FALSE(is_host(std::string(300, 'a')));
}

TEST_CASE("a host on the port that is usual for its scheme is known without it, as browsers call it") {
  const Gate plain({"127.0.0.1:80", "[::1]:80", "a:443"}, false), secure({"127.0.0.1:443", "a:80"}, true);
  for (const char* host : {"127.0.0.1", "127.0.0.1:80", "[::1]", "a:443"}) CHECK(plain.knows_host(host));
  CHECK(plain.knows_origin("http://127.0.0.1", "127.0.0.1"));
  CHECK_FALSE(plain.knows_host("a"));
  CHECK(secure.knows_origin("https://127.0.0.1", "127.0.0.1"));
  CHECK_FALSE(secure.knows_host("a"));
}

TEST_CASE("a bucket lets a burst through, then its rate") {
  RateBucket bucket(500, 1000);
  int taken = 0;
  for (int i = 0; i < 3000; ++i) taken += bucket.take(0) ? 1 : 0;
  CHECK(taken == 1000);
  taken = 0;
  // Ten seconds at twice the rate.
  for (int i = 0; i < 10000; ++i) taken += bucket.take(1e-3 * (i + 1)) ? 1 : 0;
  CHECK(taken == 5000);
  CHECK_FALSE(bucket.take(5));  // a clock that goes back gives nothing
}

TEST_CASE("connections are counted, in all and for each peer") {
  using Verdict = ConnectionCount::Verdict;
  ConnectionCount count(5, 3);
  for (int i = 0; i < 3; ++i) CHECK(count.enter("a") == Verdict::welcome);
  CHECK(count.enter("a") == Verdict::busy_peer);
  CHECK(count.enter("b") == Verdict::welcome);
  CHECK(count.enter("c") == Verdict::welcome);
  CHECK(count.enter("d") == Verdict::full);
  count.leave("a");
  count.leave("nobody");
  CHECK(count.count() == 4);
  CHECK(count.enter("d") == Verdict::welcome);
}

TEST_CASE("the token of a request stands behind Bearer") {
  CHECK(bearer_token("Bearer abc") == "abc");
  CHECK(bearer_token("bearer abc") == "abc");
  for (const char* other : {"", "Bearer", "Bearer ", "Basic abc", "abc"}) CHECK(bearer_token(other).empty());
}

}  // namespace pabd::test_access
