// SPDX-License-Identifier: MIT
// The network: HTTP, WebSocket and TLS in one thread. See README.md for the protocol.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/serve/gate.h"
#include "app/serve/lobby.h"

namespace pabd {

struct ServerOptions {
  std::vector<std::string> addresses;  // to listen on; empty: 127.0.0.1 and, where there is one, ::1
  int port = 0;                        // 0: any that is free
  int tries = 1;                       // ports from `port` on, until one is free
  std::vector<std::string> hosts;      // other names of this server: "name:port"
  std::string certificate, key;        // PEM files; both or none
  std::string embed;                   // origin of a page that may show this one in a frame
  AccessTokens tokens;
};

class HttpServer {
 public:
  // Listens; requests are answered in run(). Throws Error(bad_input) for an address, Error(file) for a port in use and
  // for TLS files, and what the lobby throws.
  HttpServer(const ServerOptions& options, const LobbyOptions& lobby);
  ~HttpServer();
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;

  int port() const;
  std::string url() const;  // without a token: "http://127.0.0.1:8472/"

  // Serves until `leave`, called ten times a second, returns true; then closes all connections. Throws Error(defect)
  // when the only session ended by itself.
  void run(const std::function<bool()>& leave);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pabd
