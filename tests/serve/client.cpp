// SPDX-License-Identifier: MIT
// See client.h.
#include "tests/serve/client.h"
#include "tests/support/places.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <catch2/catch.hpp>
#include <filesystem>

#include "sim/base/error.h"

namespace pabd {
namespace {

constexpr int kPatience = 10;  // s

std::string shipped(const std::string& name) { return std::string(places::scenes()) + "/" + name + ".json"; }

}  // namespace

bool comes(const std::function<bool()>& holds) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  while (!holds()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return true;
}

Socket::Socket(int port, int receive_buffer) : fd_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
  const timeval limit{kPatience, 0};
  ::setsockopt(fd_.get(), SOL_SOCKET, SO_RCVTIMEO, &limit, sizeof limit);
  ::setsockopt(fd_.get(), SOL_SOCKET, SO_SNDTIMEO, &limit, sizeof limit);
  if (receive_buffer > 0)
    ::setsockopt(fd_.get(), SOL_SOCKET, SO_RCVBUF, &receive_buffer, sizeof receive_buffer);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  REQUIRE(::connect(fd_.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0);
}

void Socket::send(const std::string& bytes) const {
  for (std::size_t at = 0; at < bytes.size();) {
    const ssize_t n = ::send(fd_.get(), bytes.data() + at, bytes.size() - at, MSG_NOSIGNAL);
    if (n <= 0) return;
    at += static_cast<std::size_t>(n);
  }
}

std::string Socket::read(std::size_t most) const {
  std::string out(most, '\0');
  const ssize_t n = ::recv(fd_.get(), out.data(), most, 0);
  out.resize(n > 0 ? static_cast<std::size_t>(n) : 0);
  return out;
}

std::string Socket::read_exactly(std::size_t size) {
  while (buffer_.size() < size) {
    const std::string more = read();
    if (more.empty()) break;
    buffer_ += more;
  }
  std::string out = buffer_.substr(0, size);
  buffer_.erase(0, out.size());
  return out;
}

std::string Socket::read_to_end() {
  std::string out = std::exchange(buffer_, {});
  for (std::string more = read(); !more.empty(); more = read()) out += more;
  return out;
}

std::string Socket::read_until(const std::string& mark) {
  std::size_t at;
  while ((at = buffer_.find(mark)) == std::string::npos) {
    const std::string more = read();
    if (more.empty()) return std::exchange(buffer_, {});
    buffer_ += more;
  }
  std::string out = buffer_.substr(0, at + mark.size());
  buffer_.erase(0, out.size());
  return out;
}

HttpAnswer http(int port, const std::string& method, const std::string& target, const std::string& more,
                const std::string& body) {
  Socket socket(port);
  std::string request = method + " " + target + " HTTP/1.1\r\n";
  if (more.find("Host:") == more.npos) request += fmt::format("Host: 127.0.0.1:{}\r\n", port);
  if (!body.empty()) request += fmt::format("Content-Length: {}\r\n", body.size());
  socket.send(request + "Connection: close\r\n" + more + "\r\n" + body);
  const std::string all = socket.read_to_end();
  HttpAnswer out;
  if (all.starts_with("HTTP/1.1 ")) out.status = std::stoi(all.substr(9, 3));
  const std::size_t end = all.find("\r\n\r\n");
  out.head = all.substr(0, end);
  if (end != all.npos) out.body = all.substr(end + 4);
  return out;
}

int WebSocketPage::Message::close_code() const {
  if (opcode != 8 || bytes.size() < 2) return opcode == 8 ? 1005 : 1006;
  return static_cast<unsigned char>(bytes[0]) * 256 + static_cast<unsigned char>(bytes[1]);
}

WebSocketPage::WebSocketPage(int port, const std::string& protocol, int receive_buffer)
    : socket_(port, receive_buffer) {
  socket_.send(
      fmt::format("GET /socket HTTP/1.1\r\nHost: 127.0.0.1:{0}\r\nOrigin: http://127.0.0.1:{0}\r\n"
                  "Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
                  "Sec-WebSocket-Key: MDEyMzQ1Njc4OWFiY2RlZg==\r\nSec-WebSocket-Protocol: {1}\r\n\r\n",
                  port, protocol));
  const std::string head = socket_.read_until("\r\n\r\n");
  if (head.starts_with("HTTP/1.1 ")) status_ = std::stoi(head.substr(9, 3));
}

void WebSocketPage::send(int opcode, const std::string& payload) const {
  std::string frame(1, static_cast<char>(0x80 | opcode));
  const std::size_t n = payload.size();
  if (n < 126) {
    frame += static_cast<char>(0x80 | n);
  } else if (n < 65536) {
    frame += static_cast<char>(0x80 | 126);
    frame += static_cast<char>(n >> 8);
    frame += static_cast<char>(n & 0xff);
  } else {
    frame += static_cast<char>(0x80 | 127);
    for (int i = 7; i >= 0; --i) frame += static_cast<char>((n >> (8 * i)) & 0xff);
  }
  const std::string mask = "mask";
  frame += mask;
  for (std::size_t i = 0; i < n; ++i) frame += static_cast<char>(payload[i] ^ mask[i % 4]);
  socket_.send(frame);
}

WebSocketPage::Message WebSocketPage::next() {
  Message out;
  const std::string head = socket_.read_exactly(2);
  if (head.size() < 2) return out;
  const int opcode = head[0] & 0x0f;
  std::size_t size = static_cast<unsigned char>(head[1]) & 0x7f;
  if (size >= 126) {
    const std::string more = socket_.read_exactly(size == 126 ? 2 : 8);
    size = 0;
    for (const char c : more) size = size * 256 + static_cast<unsigned char>(c);
  }
  const std::string bytes = socket_.read_exactly(size);
  if (bytes.size() < size) return out;
  if (opcode == 9) {
    send(10, bytes);
    return next();
  }
  out.opcode = opcode;
  out.bytes = bytes;
  if (opcode == 2 && acknowledges && (out.head().flags & FrameHead::kLast))
    say({{"t", "ack"}, {"frame", out.head().frame}, {"shown_ms", 0.5}});
  return out;
}

WebSocketPage::Message WebSocketPage::until(const std::function<bool(const Message&)>& wanted) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(30);
  while (std::chrono::steady_clock::now() < end) {
    Message message = next();
    if (wanted(message)) return message;
    CAPTURE(message.opcode, message.bytes.substr(0, 200));
    REQUIRE((message.opcode == 1 || message.opcode == 2));
  }
  FAIL("it did not come in time");
  return {};
}

nlohmann::json WebSocketPage::until_text(const std::string& t) {
  nlohmann::json out;
  until([&](const Message& message) {
    if (message.opcode != 1) return false;
    out = nlohmann::json::parse(message.bytes);
    return out["t"] == t;
  });
  return out;
}

int WebSocketPage::until_close() {
  return until([](const Message& message) { return message.opcode == 8 || message.opcode == 0; })
      .close_code();
}

nlohmann::json WebSocketPage::hello(const std::string& token, const std::string& id, int width, int height) {
  return {{"t", "hello"}, {"token", token}, {"size", {width, height}}, {"scale", 1}, {"id", id}};
}

RunningServer::RunningServer(const std::function<void(ServerOptions&, LobbyOptions&)>& change) {
  LobbyOptions lobby;
  lobby.version = "test";
  lobby.desk.scene = shipped("two_boxes");
  lobby.desk.files = std::make_shared<FileRoot>(root_.path());
  lobby.desk.turn = std::make_shared<std::mutex>();
  lobby.desk.find_scene = [](const std::string& name) -> std::string {
    if (name == "stack" || name == "two_boxes") return shipped(name);
    throw Error(ErrorKind::file, name, "there is no such scene here");
  };
  lobby.desk.width = 640;
  lobby.desk.height = 400;
  if (change) change(options_, lobby);
  server_ = std::make_unique<HttpServer>(options_, lobby);
  thread_ = std::thread([this] { server_->run([this] { return leave_.load(); }); });
}

RunningServer::~RunningServer() { stop(); }

nlohmann::json RunningServer::state_when(const std::function<bool(const nlohmann::json&)>& wanted) const {
  nlohmann::json now;
  comes([&] { return wanted(now = state()); });
  return now;
}

void RunningServer::stop() {
  leave_ = true;
  if (thread_.joinable()) thread_.join();
}

}  // namespace pabd
