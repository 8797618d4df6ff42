// SPDX-License-Identifier: MIT
// The server as pages see it: frames, input, roles, coming back.
#include <catch2/catch.hpp>
#include <filesystem>
#include <set>

#include "tests/serve/client.h"

namespace pabd::test_serve_visitors {

using Json = nlohmann::json;
using Message = WebSocketPage::Message;

namespace {

bool is_frame(const Message& message) { return message.opcode == 2; }

}  // namespace

TEST_CASE("a page gets a frame, its input changes the simulation, and its stamp comes back") {
  const RunningServer server;
  WebSocketPage page(server.port());
  REQUIRE(page.status() == 101);
  page.say(WebSocketPage::hello(server.control()));
  const Json welcome = page.until_text("welcome");
  CHECK(welcome["role"] == "control");
  CHECK(welcome["scene"] == "two_boxes");
  const Message first = page.until(is_frame);
  CHECK(first.head().kind == FrameHead::jpeg);
  CHECK(first.head().width == 640);
  // At rest it becomes exact, and then nothing comes any more.
  page.until([](const Message& m) { return is_frame(m) && (m.head().flags & FrameHead::kLossless); });
  page.say({{"t", "move"}, {"x", 300}, {"y", 200}, {"s", 1}});
  page.say({{"t", "key"}, {"key", "space"}, {"down", true}, {"mods", 0}, {"repeat", false}, {"s", 2}});
  page.say({{"t", "key"}, {"key", "space"}, {"down", false}, {"mods", 0}, {"repeat", false}, {"s", 3}});
  page.until([](const Message& m) { return is_frame(m) && m.head().stamp == 3; });
  for (int i = 0; i < 10; ++i) page.until(is_frame);
  const Json state = server.state_when([](const Json& now) { return now["a"]["step"] > 0; });
  CHECK(state["playing"] == true);
  CHECK(state["a"]["step"] > 0);
  page.say({{"t", "size"}, {"size", {800, 500}}, {"scale", 1}});
  page.until([](const Message& m) { return is_frame(m) && m.head().width == 800; });
}

TEST_CASE("one controls, others watch; control is asked for, handed over, and lost with the connection") {
  const RunningServer server;
  WebSocketPage first(server.port()), second(server.port()), watcher(server.port());
  first.say(WebSocketPage::hello(server.control(), "000000000000000a"));
  CHECK(first.until_text("welcome")["role"] == "control");
  second.say(WebSocketPage::hello(server.control(), "000000000000000b", 700, 450));
  CHECK(second.until_text("welcome")["role"] == "watch");
  watcher.say(WebSocketPage::hello(server.watch(), "000000000000000c"));
  CHECK(watcher.until_text("welcome")["visitors"] == 3);
  CHECK(watcher.until(is_frame).head().width == 640);

  // What watchers do changes nothing.
  for (WebSocketPage* page : {&second, &watcher}) {
    page->say({{"t", "script"}, {"actions", Json::parse(R"([{"do":"step","steps":7}])")}});
    page->say({{"t", "ask_control"}});
    page->say({{"t", "give_control"}});
    page->say({{"t", "ping"}, {"at", 5}});
    CHECK(page->until_text("pong")["at"] == 5);
  }
  CHECK(server.state()["a"]["step"] == 0);
  Json role;
  do role = first.until_text("role");
  while (role["asks"] != true);
  first.say({{"t", "give_control"}});
  do role = second.until_text("role");
  while (role["role"] != "control");
  second.say({{"t", "script"}, {"actions", Json::parse(R"([{"do":"step","steps":7}])")}});
  second.until([](const Message& m) { return is_frame(m) && m.head().width == 700; });
  CHECK(server.state_when([](const Json& now) { return now["a"]["step"] == 7; })["a"]["step"] == 7);
}

TEST_CASE("a page that comes back finds its role and the same state; the same page twice is one") {
  const RunningServer server;
  {
    WebSocketPage page(server.port());
    page.say(WebSocketPage::hello(server.control()));
    CHECK(page.until_text("welcome")["role"] == "control");
    CHECK(server.act(Json::parse(R"([{"do":"step","steps":4}])")).status == 200);
  }
  WebSocketPage page(server.port());
  page.say(WebSocketPage::hello(server.control()));
  CHECK(page.until_text("welcome")["role"] == "control");
  page.until(is_frame);
  CHECK(server.state()["a"]["step"] == 4);
  WebSocketPage again(server.port());
  again.say(WebSocketPage::hello(server.control()));
  CHECK(again.until_text("welcome")["role"] == "control");
  CHECK(page.until_close() == 4410);
}

TEST_CASE("without visitors the simulation goes on, or waits as it was asked to") {
  for (const bool pauses : {false, true}) {
    const RunningServer server([&](ServerOptions&, LobbyOptions& lobby) {
      lobby.desk.pause_when_alone = pauses;
      lobby.desk.play = true;
    });
    {
      WebSocketPage page(server.port());
      page.say(WebSocketPage::hello(server.control()));
      for (int i = 0; i < 5; ++i) page.until(is_frame);
    }
    CHECK(server.state_when([&](const Json& now) { return now["playing"] == !pauses; })["playing"] ==
          !pauses);
    const auto rest = std::chrono::milliseconds(pauses ? 200 : 0);  // a step may have been under way
    std::this_thread::sleep_for(rest);
    const int then = server.state()["a"]["step"];
    const auto went_on = [&](const Json& now) { return now["a"]["step"] > then; };
    std::this_thread::sleep_for(rest);
    CHECK(went_on(pauses ? server.state() : server.state_when(went_on)) == !pauses);
    WebSocketPage page(server.port());
    page.say(WebSocketPage::hello(server.control()));
    page.until_text("welcome");
    CHECK(server.state_when([](const Json& now) { return now["playing"] == true; })["playing"] == true);
  }
}

TEST_CASE("with sessions, each visitor has a simulation and files of its own; idle ones end") {
  RunningServer server([](ServerOptions&, LobbyOptions& lobby) {
    lobby.sessions = 2;
    lobby.idle_limit = 0.5;
  });
  const auto state = [&](const std::string& id) {
    const HttpAnswer answer =
        http(server.port(), "GET", "/state", bearer(server.control()) + "Pabd-Session: " + id + "\r\n");
    return answer.status == 200 ? Json::parse(answer.body) : Json();
  };
  {
    WebSocketPage a(server.port()), b(server.port()), c(server.port());
    a.say(WebSocketPage::hello(server.control(), "000000000000000a"));
    CHECK(a.until_text("welcome")["role"] == "control");
    b.say(WebSocketPage::hello(server.control(), "000000000000000b"));
    CHECK(b.until_text("welcome")["role"] == "control");
    c.say(WebSocketPage::hello(server.control(), "000000000000000c"));
    CHECK(c.until_close() == 4429);
    a.say({{"t", "script"},
           {"actions", Json::parse(R"([{"do":"step","steps":3},{"do":"save_scene","path":"a.json"}])")}});
    CHECK(a.until_text("file")["name"] == "a.json");
    b.until(is_frame);
    CHECK(state("000000000000000a")["a"]["step"] == 3);
    CHECK(state("000000000000000b")["a"]["step"] == 0);
    const HttpAnswer files =
        http(server.port(), "GET", "/files", bearer(server.control()) + "Pabd-Session: 000000000000000b\r\n");
    CHECK(Json::parse(files.body)["files"].empty());
    CHECK(server.get("/state").status == 404);
  }
  CHECK(comes([&] { return state("000000000000000a").is_null(); }));
  WebSocketPage later(server.port());
  later.say(WebSocketPage::hello(server.control(), "000000000000000d"));
  CHECK(later.until_text("welcome")["role"] == "control");
}

TEST_CASE(
    "a session that ends answers what it was asked, ends its events, and keeps its files where it should") {
  for (const bool keeps : {false, true}) {
    CAPTURE(keeps);
    const RunningServer server([&](ServerOptions&, LobbyOptions& lobby) {
      lobby.sessions = 2;
      lobby.idle_limit = 0.5;
      lobby.keep_files = keeps;
    });
    const std::string id = "000000000000000a";
    const auto ask = [&](const Socket& socket, const std::string& what, const std::string& body = "") {
      socket.send(what + " HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(server.port()) + "\r\n" +
                  bearer(server.control()) + "Pabd-Session: " + id + "\r\nContent-Length: " +
                  std::to_string(body.size()) + "\r\nConnection: close\r\n\r\n" + body);
    };
    Socket events(server.port()), script(server.port());
    std::vector<std::unique_ptr<Socket>> waiting;
    {
      WebSocketPage page(server.port());
      page.say(WebSocketPage::hello(server.control(), id));
      page.until_text("welcome");
      ask(events, "GET /events");
      CHECK(events.read_until("\r\n\r\n").starts_with("HTTP/1.1 200"));
      CHECK(http(server.port(), "PUT", "/files/a.json",
                 bearer(server.control()) + "Pabd-Session: " + id + "\r\n", "{}")
                .status == 201);
      ask(script, "POST /actions", R"([{"do":"step","steps":1000000}])");
      std::this_thread::sleep_for(std::chrono::milliseconds(300));  // it is carried out
      for (int i = 0; i < 10; ++i) {
        waiting.push_back(std::make_unique<Socket>(server.port()));
        ask(*waiting.back(), "GET /state");
      }
    }
    CHECK(script.read_until("\r\n").starts_with("HTTP/1.1 503"));
    for (const auto& one : waiting) CHECK(one->read_until("\r\n").starts_with("HTTP/1.1 503"));
    const std::string heard = events.read_to_end();
    CAPTURE(heard);
    CHECK(("\r\n" + heard).ends_with("\r\n0\r\n\r\n"));  // the last chunk
    const auto folder = server.root() / ("session-" + id);
    CHECK((keeps || comes([&] { return !std::filesystem::exists(folder); })));
    CHECK(std::filesystem::exists(folder / "a.json") == keeps);
  }
}

}  // namespace pabd::test_serve_visitors
