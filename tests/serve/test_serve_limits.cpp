// SPDX-License-Identifier: MIT
// What wrong, greedy and slow clients can do: nothing to others.
#include <malloc.h>

#include <catch2/catch.hpp>
#include <random>

#include "tests/serve/client.h"

namespace pabd::test_serve_limits {

using Json = nlohmann::json;
using Message = WebSocketPage::Message;

// Of the sanitizers' allocator, where the program has it; not every compiler ships its header.
extern "C" __attribute__((weak)) std::size_t __sanitizer_get_current_allocated_bytes();

namespace {

// What is allocated and not given back. Not what is resident: sanitizers keep what was freed for a while.
std::size_t held_bytes() {
  if (__sanitizer_get_current_allocated_bytes) return __sanitizer_get_current_allocated_bytes();
  const struct mallinfo2 heap = mallinfo2();
  return heap.uordblks + heap.hblkhd;
}

bool answers(const RunningServer& server) { return http(server.port(), "GET", "/").status == 200; }

}  // namespace

TEST_CASE("who does not begin as pages do is closed, with the reason as a number") {
  const RunningServer server;
  const auto closed_after = [&](const std::function<void(WebSocketPage&)>& act,
                                const std::string& protocol = "pabd.1") {
    WebSocketPage page(server.port(), protocol);
    REQUIRE(page.status() == 101);
    act(page);
    return page.until_close();
  };
  const Json good = WebSocketPage::hello(server.control());
  CHECK(closed_after([&](auto& page) { page.say(WebSocketPage::hello(std::string(32, '0'))); }) == 4401);
  CHECK(closed_after([&](auto& page) { page.say(WebSocketPage::hello("")); }) == 4401);
  CHECK(closed_after([&](auto&) {}, "pabd.0") == 4406);
  CHECK(closed_after([&](auto& page) { page.say({{"t", "leave"}}); }) == 4400);
  CHECK(closed_after([&](auto& page) { page.send(1, "no JSON"); }) == 4400);
  CHECK(closed_after([&](auto& page) { page.send(2, "binary"); }) == 4400);
  CHECK(closed_after([&](auto& page) { page.send(1, "\xff\xfe"); }) == 1007);
  CHECK(closed_after([&](auto& page) { page.send(1, std::string(5000, ' ')); }) == 1009);
  CHECK(closed_after([&](auto&) {}) == 4400);  // no hello within 5 s
  CHECK(closed_after([&](auto& page) {
          page.say(good);
          page.say(good);
        }) == 4400);
  CHECK(closed_after([&](auto& page) {
          page.say(good);
          page.send(1, std::string(65537, ' '));
        }) == 1009);
  CHECK(closed_after([&](auto& page) {
          page.say(good);
          page.say({{"t", "move"}, {"x", "left"}, {"y", 0}, {"s", 1}});
        }) == 4400);
  CHECK(closed_after([&](auto& page) {
          page.say(good);
          for (int i = 0; i < 3000; ++i) page.say({{"t", "leave"}});
        }) == 4429);
  CHECK(answers(server));
}

TEST_CASE("HTTP that is wrong, long or slow is refused and the others are served") {
  const RunningServer server;
  const std::string host = "Host: 127.0.0.1:" + std::to_string(server.port()) + "\r\n";
  const auto status_of = [&](const std::string& bytes) {
    Socket socket(server.port());
    socket.send(bytes);
    const std::string answer = socket.read_until("\r\n");
    return answer.starts_with("HTTP/1.1 ") ? std::stoi(answer.substr(9, 3)) : 0;
  };
  CHECK(status_of("GET / HTTP/1.1\r\n\r\n") == 400);
  CHECK(status_of("GET / HTTP/1.1\r\n" + host + host + "\r\n") == 400);
  CHECK(status_of("nonsense\r\n\r\n") == 400);
  CHECK(status_of("GET / HTTP/1.1\r\n" + host + "X: " + std::string(20000, 'x') + "\r\n\r\n") == 431);
  CHECK(status_of("GET / HTTP/1.1\r\n" + host + "Content-Length: 5\r\n\r\nhello") == 400);
  CHECK(status_of("POST /actions HTTP/1.1\r\n" + host + bearer(server.control()) +
                  "Content-Length: 2000000\r\n\r\n") == 413);
  CHECK(status_of("PUT /files/a HTTP/1.1\r\n" + host + bearer(server.control()) +
                  "Content-Length: 99999999999\r\n\r\n") == 413);
  CHECK(status_of("PUT /files/a HTTP/1.1\r\n" + host + "Content-Length: 10\r\n\r\n") ==
        401);  // before the body
  CHECK(status_of("POST /actions HTTP/1.1\r\n" + host + bearer(server.control()) +
                  "Transfer-Encoding: chunked\r\n\r\n" + "200000\r\n" + std::string(0x200000, 'x') +
                  "\r\n0\r\n\r\n") == 413);
  CHECK(status_of("GET /socket HTTP/1.1\r\n" + host + "\r\n") == 426);
  CHECK(server.root().names().empty());
  const Socket half(server.port());
  half.send("GET / HT");
  CHECK(answers(server));
}

TEST_CASE("uploads that come too slowly make room for others; who listens hears that the server lives") {
  const RunningServer server;
  const std::string head =
      " HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(server.port()) + "\r\n" + bearer(server.control());
  Socket listener(server.port());
  listener.send("GET /events" + head + "\r\n");
  CHECK_THAT(listener.read_until("\r\n\r\n"), Catch::Contains("200 OK"));
  const Socket a(server.port()), b(server.port());
  for (const Socket* slow : {&a, &b})
    slow->send("PUT /files/slow.json" + head + "Content-Length: 1000000\r\n\r\n");
  const auto upload = [&] {
    for (const Socket* slow : {&a, &b}) slow->send("x");  // it never stops to send
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    return http(server.port(), "PUT", "/files/mine.json", bearer(server.control()), "{}").status;
  };
  CHECK(upload() == 503);
  CHECK(comes([&] { return upload() == 201; }));  // after 10 s
  // Nothing has happened in the meantime; the line that says so is blank, in a chunk of its own.
  CHECK_THAT(listener.read_until("1\r\n\n\r\n"), Catch::EndsWith("1\r\n\n\r\n"));
}

TEST_CASE("fifty connections at once: so many are served as may be, the rest is told") {
  const RunningServer server;
  std::vector<std::unique_ptr<WebSocketPage>> pages;
  int served = 0, refused = 0;
  for (int i = 0; i < 50; ++i) {
    pages.push_back(std::make_unique<WebSocketPage>(server.port()));
    if (pages.back()->status() == 101) ++served;
    if (pages.back()->status() == 429) ++refused;
  }
  CHECK(served == 16);
  CHECK(served + refused == 50);
  pages.clear();
  CHECK(comes([&] { return answers(server); }));
}

TEST_CASE("a client that never reads holds one frame, and nobody up") {
  const RunningServer server([](ServerOptions&, LobbyOptions& lobby) { lobby.desk.play = true; });
  WebSocketPage page(server.port());
  page.say(WebSocketPage::hello(server.control(), "000000000000000a"));
  for (int i = 0; i < 20; ++i) page.until([](const Message& m) { return m.opcode == 2; });
  std::vector<std::unique_ptr<WebSocketPage>> deaf;
  for (int i = 0; i < 8; ++i) {
    deaf.push_back(std::make_unique<WebSocketPage>(server.port(), "pabd.1", 4096));
    deaf.back()->say(WebSocketPage::hello(server.watch(), "00000000000000b" + std::to_string(i)));
  }
  for (int i = 0; i < 20; ++i) page.until([](const Message& m) { return m.opcode == 2; });
  const std::size_t before = held_bytes();
  // They go on to talk, and even say that they have seen frames that they never read.
  std::uint32_t frame = 0;
  for (int round = 0; round < 600; ++round) {
    for (const auto& one : deaf) {
      one->say({{"t", "ping"}, {"at", round}});
      for (std::uint32_t k = 0; k < 3; ++k) one->say({{"t", "ack"}, {"frame", frame + k}, {"shown_ms", 1}});
    }
    frame = page.until([](const Message& m) { return m.opcode == 2; }).head().frame;
  }
  const std::size_t after = held_bytes();
  CAPTURE(before >> 20, after >> 20);
  CHECK(after < before + (std::size_t{48} << 20));
}

TEST_CASE("thousands of spoilt messages over sockets end their own connection and nothing else") {
  const RunningServer server;
  WebSocketPage good(server.port());
  good.say(WebSocketPage::hello(server.control(), "000000000000000a"));
  good.until_text("welcome");
  std::mt19937 random(5);
  const std::string seed = R"({"t":"button","b":"left","down":true,"x":1,"y":2,"mods":0,"s":1})";
  int sent = 0;
  for (int connection = 0; connection < 400; ++connection) {
    WebSocketPage page(server.port());
    REQUIRE(page.status() == 101);
    if (connection % 2 == 0) page.say(WebSocketPage::hello(server.control(), "000000000000000b"));
    for (int i = 0; i < 10; ++i, ++sent) {
      std::string text = seed;
      for (int k = 0; k < 3; ++k) text[random() % text.size()] = static_cast<char>(random() % 256);
      if (i % 3 == 0) {
        // Frames of the protocol below that are no frames.
        std::string raw;
        for (int k = 0; k < 24; ++k) raw += static_cast<char>(random() % 256);
        page.send_raw(raw);
      } else {
        page.send(i % 3 == 1 ? 1 : static_cast<int>(random() % 16), text);
      }
    }
  }
  CHECK(sent == 4000);
  good.say({{"t", "ping"}, {"at", 1}});
  CHECK(good.until_text("pong")["at"] == 1);
  CHECK(server.act(Json::parse(R"([{"do":"step"}])")).status == 200);
}

TEST_CASE("a server that goes down tells its visitors, and ends what it was doing") {
  RunningServer server;
  std::vector<std::unique_ptr<WebSocketPage>> pages;
  for (int i = 0; i < 5; ++i) {
    pages.push_back(std::make_unique<WebSocketPage>(server.port()));
    pages.back()->say(WebSocketPage::hello(server.control(), "000000000000000" + std::to_string(i)));
    pages.back()->until_text("welcome");
  }
  Socket script(server.port());  // one that would go on for hours
  const std::string actions = R"([{"do":"step","steps":1000000}])";
  script.send("POST /actions HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(server.port()) + "\r\n" +
              bearer(server.control()) + "Content-Length: " + std::to_string(actions.size()) + "\r\n\r\n" +
              actions);
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  server.stop();
  for (auto& page : pages) CHECK(page->until_close() == 1001);
}

}  // namespace pabd::test_serve_limits
