// SPDX-License-Identifier: MIT
// State shared by all connections, and HTTP answers. Includes Boost.Beast: for files that use sockets only.
#pragma once

#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <memory>
#include <optional>
#include <string>

#include "app/serve/gate.h"
#include "app/serve/http_server.h"
#include "app/serve/net_stream.h"
#include "app/serve/routes.h"

namespace pabd::net {

namespace http = boost::beast::http;

struct Shared {
  ServerOptions options;
  std::optional<Gate> gate;
  std::unique_ptr<Lobby> lobby;
  ConnectionCount connections{64, 16};   // in all, and from one address
  std::size_t uploads = 0, waiting = 0;  // uploads under way; requests that wait for a desk
  int refused = 0;                       // connections beyond the limit that are being answered
  bool leaving = false;
  asio::io_context io{1};  // last member, so destroyed first: its handlers use the others

  explicit Shared(const ServerOptions& o) : options(o) {}
};

// Counts a connection as long as it lives.
class Place {
 public:
  Place(Shared& shared, std::string peer) : shared_(&shared), peer_(std::move(peer)) {
    verdict_ = shared.connections.enter(peer_);
    if (!welcome()) ++shared.refused;
  }
  ~Place() {
    if (!shared_) return;
    if (welcome()) {
      shared_->connections.leave(peer_);
    } else {
      --shared_->refused;
    }
  }
  Place(Place&& other) noexcept
      : shared_(std::exchange(other.shared_, nullptr)),
        peer_(std::move(other.peer_)),
        verdict_(other.verdict_) {}
  Place& operator=(Place&&) = delete;

  bool welcome() const { return verdict_ == ConnectionCount::Verdict::welcome; }
  ConnectionCount::Verdict verdict() const { return verdict_; }

 private:
  Shared* shared_;
  std::string peer_;
  ConnectionCount::Verdict verdict_;
};

// Answers requests of one connection, until it becomes a WebSocket or ends.
void serve(Shared& shared, NetStream stream, Place place);

// Precondition: the request passed all checks but the subprotocol.
using UpgradeRequest = http::request<http::empty_body>;
void serve_socket(Shared& shared, NetStream stream, UpgradeRequest request, Place place);

// Headers that restrict what a browser does with an answer.
void set_headers(const Shared& shared, http::fields& answer);

using TextAnswer = http::response<http::string_body>;
TextAnswer text_answer(const Shared& shared, int status, const std::string& type, std::string body);
TextAnswer json_answer(const Shared& shared, int status, const OrderedJson& json);
TextAnswer page_answer(const Shared& shared, const std::string& name);  // of a file of the page

}  // namespace pabd::net
