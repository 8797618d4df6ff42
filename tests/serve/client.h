// SPDX-License-Identifier: MIT
// A client of plain sockets, without anybody's library: HTTP requests, a WebSocket, and worse.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <thread>

#include "app/serve/frame_encoder.h"
#include "app/serve/http_server.h"
#include "sim/base/descriptor.h"
#include "tests/support/temp_folder.h"

namespace pabd {

// Whether it comes to hold within a minute: what has no message of its own is asked again and again.
bool comes(const std::function<bool()>& holds);

// A TCP connection to 127.0.0.1; nothing waits for longer than ten seconds.
class Socket {
 public:
  explicit Socket(int port, int receive_buffer = 0);
  void send(const std::string& bytes) const;         // as far as the other side takes it
  std::string read(std::size_t most = 65536) const;  // what there is; empty: closed, or nothing came
  std::string read_exactly(std::size_t size);        // shorter: closed
  std::string read_to_end();
  std::string read_until(const std::string& mark);  // with it

 private:
  Descriptor fd_;
  std::string buffer_;
};

struct HttpAnswer {
  int status = 0;
  std::string head, body;
};
// One request on a connection of its own. `more`: header lines, each with \r\n.
HttpAnswer http(int port, const std::string& method, const std::string& target, const std::string& more = "",
                const std::string& body = "");
inline std::string bearer(const std::string& token) { return "Authorization: Bearer " + token + "\r\n"; }

class WebSocketPage {
 public:
  struct Message {
    int opcode = 0;  // 1 text, 2 binary, 8 close; 0: the connection broke
    std::string bytes;
    int close_code() const;
    FrameHead head() const { return read_frame_head(bytes); }
  };

  explicit WebSocketPage(int port, const std::string& protocol = "pabd.1", int receive_buffer = 0);
  int status() const { return status_; }  // of the upgrade: 101

  void say(const nlohmann::json& json) const { send(1, json.dump()); }
  void send(int opcode, const std::string& payload) const;
  void send_raw(const std::string& bytes) const { socket_.send(bytes); }
  // Answers pings. Frames are acknowledged unless not.
  Message next();
  // Reads on until `wanted`; fails the test when it does not come.
  Message until(const std::function<bool(const Message&)>& wanted);
  nlohmann::json until_text(const std::string& t);
  int until_close();  // the code

  bool acknowledges = true;

  // {"t":"hello"…}
  static nlohmann::json hello(const std::string& token, const std::string& id = "0123456789abcdef",
                              int width = 640, int height = 400);

 private:
  mutable Socket socket_;
  int status_ = 0;
};

// A server with a desk of its own, in a thread.
class RunningServer {
 public:
  explicit RunningServer(const std::function<void(ServerOptions&, LobbyOptions&)>& change = {});
  ~RunningServer();

  int port() const { return server_->port(); }
  const std::string& control() const { return options_.tokens.control.hex(); }
  const std::string& watch() const { return options_.tokens.watch.hex(); }
  const TempFolder& root() const { return root_; }
  HttpAnswer get(const std::string& target) const { return http(port(), "GET", target, bearer(control())); }
  nlohmann::json state() const { return nlohmann::json::parse(get("/state").body); }
  // The first state that is as wanted; after a minute, the one there is.
  nlohmann::json state_when(const std::function<bool(const nlohmann::json&)>& wanted) const;
  HttpAnswer act(const nlohmann::json& actions) const {
    return http(port(), "POST", "/actions", bearer(control()), actions.dump());
  }
  void stop();

 private:
  TempFolder root_;
  ServerOptions options_;
  std::unique_ptr<HttpServer> server_;
  std::atomic<bool> leave_{false};
  std::thread thread_;
};

}  // namespace pabd
