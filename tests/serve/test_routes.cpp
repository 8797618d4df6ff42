// SPDX-License-Identifier: MIT
// What requests may do.
#include <catch2/catch.hpp>

#include "app/serve/routes.h"

namespace pabd::test_routes {

namespace {

struct Case {
  AccessTokens tokens;
  Gate gate{{"127.0.0.1:1"}, false};
  std::string control = "Bearer " + tokens.control.hex(), watch = "Bearer " + tokens.watch.hex();

  Route ask(const std::string& method, const std::string& target, const std::string& authorization = "",
            const std::string& origin = "", const std::string& host = "127.0.0.1:1") const {
    HttpRequest request;
    request.method = method;
    request.target = target;
    request.authorization = authorization;
    request.origin = origin;
    request.host = host;
    request.upgrade = target == "/socket";
    return find_route(request, gate, tokens);
  }
};

}  // namespace

TEST_CASE("the page is for everybody who names the server rightly; all else needs a token") {
  const Case c;
  CHECK(c.ask("GET", "/").status == 200);
  CHECK(c.ask("GET", "/").name == "index.html");
  CHECK(c.ask("GET", "/?x=1").status == 200);
  CHECK(c.ask("GET", "/", "", "", "evil.org:1").status == 421);
  CHECK(c.ask("GET", "/", "", "", "").status == 421);
  CHECK(c.ask("GET", "/", "", "http://evil.org").status == 403);
  CHECK(c.ask("GET", "/", "", "null").status == 403);
  CHECK(c.ask("GET", "/", "", "http://127.0.0.1:1").status == 200);
  CHECK(c.ask("POST", "/").status == 405);
  CHECK(c.ask("GET", "/nothing.js").status == 404);
  CHECK(c.ask("GET", "/../etc/passwd").status == 404);
  CHECK(c.ask("GET", "http://127.0.0.1:1/").status == 400);
  CHECK(c.ask("GET", "").status == 400);
  for (const char* target : {"/state", "/frame.png", "/events", "/files", "/files/a.json"}) {
    CAPTURE(target);
    CHECK(c.ask("GET", target).status == 401);
    CHECK(c.ask("GET", target, "Bearer 0").status == 401);
    CHECK(c.ask("GET", target, c.control).status == 200);
    CHECK(c.ask("GET", target, c.watch).status == 200);
    CHECK(c.ask("GET", target, c.control, "http://evil.org").status == 403);
    CHECK(c.ask("DELETE", target, c.control).status == 405);
  }
  // The token counts nowhere else.
  CHECK(c.ask("GET", "/state?token=" + c.tokens.control.hex()).status == 401);
}

TEST_CASE("who watches changes nothing") {
  const Case c;
  CHECK(c.ask("POST", "/actions", c.control).status == 200);
  CHECK(c.ask("POST", "/actions", c.watch).status == 403);
  CHECK(c.ask("PUT", "/files/a.json", c.control).status == 200);
  CHECK(c.ask("PUT", "/files/a.json", c.watch).status == 403);
  CHECK(c.ask("GET", "/actions", c.control).status == 405);
}

TEST_CASE("a WebSocket needs its page's origin") {
  const Case c;
  CHECK(c.ask("GET", "/socket", "", "http://127.0.0.1:1").status == 200);
  CHECK(c.ask("GET", "/socket").status == 403);
  CHECK(c.ask("GET", "/socket", c.control, "http://evil.org").status == 403);
  CHECK(c.ask("GET", "/socket", c.control, "https://127.0.0.1:1").status == 403);
  CHECK(c.ask("POST", "/socket", "", "http://127.0.0.1:1").status == 405);
  CHECK(c.ask("GET", "/socket?x", "", "http://127.0.0.1:1").status == 426);  // no upgrade in it
}

TEST_CASE("names of files are names") {
  const Case c;
  CHECK(c.ask("GET", "/files/my%20scene.json", c.control).name == "my scene.json");
  for (const char* name : {"..", ".", ".hidden", "a/b", "..%2fetc%2fpasswd", "%2e%2e", "a%00b", "a%0ab", "%",
                           "%zz", "%f", "a%5cb", "%ff", "{frame}.png"}) {
    CAPTURE(name);
    CHECK(c.ask("PUT", std::string("/files/") + name, c.control).status == 400);
  }
  CHECK(c.ask("GET", "/files/" + std::string(200, 'x'), c.control).status == 400);
}

TEST_CASE("pictures have a size") {
  const Case c;
  const Route route = c.ask("GET", "/frame.png?width=640&height=360&panels=0", c.watch);
  CHECK(route.width == 640);
  CHECK(route.height == 360);
  CHECK_FALSE(route.panels);
  for (const char* query :
       {"width=0", "width=1e3", "height=99999", "width", "x=1", "panels=2", "width=-64", "&"})
    CHECK(c.ask("GET", std::string("/frame.png?") + query, c.control).status == 400);
}

TEST_CASE("of codings of a transfer there is one") {
  const Case c;
  HttpRequest request;
  request.method = "GET";
  request.target = "/";
  request.host = "127.0.0.1:1";
  for (const char* coding : {"xchunked", "chunked, chunked", "gzip", "gzip, chunked", "identity", " "}) {
    CAPTURE(coding);
    request.coding = coding;
    CHECK(find_route(request, c.gate, c.tokens).status == 501);
  }
  for (const char* coding : {"chunked", "Chunked"}) {
    request.coding = coding;
    CHECK(find_route(request, c.gate, c.tokens).status == 200);
  }
}

TEST_CASE("bodies have limits, and two Hosts are none") {
  const Case c;
  CHECK(c.ask("POST", "/actions", c.control).most_body == kMostBody);
  CHECK(c.ask("PUT", "/files/a", c.control).most_body == kMostUpload);
  CHECK(c.ask("GET", "/state", c.control).most_body == 0);
  HttpRequest request;
  request.method = "GET";
  request.target = "/";
  request.host = "127.0.0.1:1";
  request.hosts = 2;
  CHECK(find_route(request, c.gate, c.tokens).status == 400);
  request.hosts = 1;
  request.has_body = true;
  CHECK(find_route(request, c.gate, c.tokens).status == 400);
}

}  // namespace pabd::test_routes
