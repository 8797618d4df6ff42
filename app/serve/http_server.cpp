// SPDX-License-Identifier: MIT
// See http_server.h: listening, and the clock of the network's thread.
#include "app/serve/http_server.h"

#include <fmt/format.h>
#include <netinet/tcp.h>

#include <boost/asio/ip/v6_only.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>

#include "app/serve/clock.h"
#include "app/serve/net.h"
#include "sim/base/error.h"

namespace pabd {
namespace {

using namespace net;
using namespace std::chrono_literals;

constexpr auto kTick = 100ms;
constexpr auto kFarewell = 1000ms;
constexpr auto kShortOfFiles = 200ms;
// A peer that acknowledges nothing for so long is gone; the system's own limit is a quarter of an hour.
constexpr std::chrono::milliseconds kVanished = 15s;
using GivesUpAfter = asio::detail::socket_option::integer<IPPROTO_TCP, TCP_USER_TIMEOUT>;
constexpr int kMostRefused = 64;  // connections beyond the limit that are answered at a time

std::string in_url(const std::string& address) {
  return address.find(':') == address.npos ? address : "[" + address + "]";
}

}  // namespace

struct HttpServer::Impl {
  Shared shared;
  std::optional<asio::ssl::context> tls;
  std::vector<std::unique_ptr<tcp::acceptor>> acceptors;
  asio::steady_timer timer;
  int port = 0;
  std::string host;

  explicit Impl(const ServerOptions& options) : shared(options), timer(shared.io) {
    if (!options.certificate.empty()) load_certificate();
    listen();
    std::vector<std::string> hosts;
    for (const std::string& name : options.hosts) {
      hosts.push_back(name);
      if (name.find(':') == name.npos) hosts.push_back(fmt::format("{}:{}", name, port));
    }
    for (const auto& acceptor : acceptors)
      hosts.push_back(fmt::format("{}:{}", in_url(acceptor->local_endpoint().address().to_string()), port));
    hosts.push_back(fmt::format("localhost:{}", port));
    host =
        options.hosts.empty() ? hosts.front() : hosts[hosts.front().find(':') == std::string::npos ? 1 : 0];
    shared.gate.emplace(hosts, tls.has_value());
  }

  void load_certificate() {
    tls.emplace(asio::ssl::context::tls_server);
    tls->set_options(asio::ssl::context::default_workarounds | asio::ssl::context::no_sslv2 |
                     asio::ssl::context::no_sslv3 | asio::ssl::context::no_tlsv1 |
                     asio::ssl::context::no_tlsv1_1);
    Failure failure;
    tls->use_certificate_chain_file(shared.options.certificate, failure);
    if (failure)
      throw Error(ErrorKind::file, shared.options.certificate, "no certificate: " + failure.message());
    tls->use_private_key_file(shared.options.key, asio::ssl::context::pem, failure);
    if (failure)
      throw Error(ErrorKind::file, shared.options.key, "no key to the certificate: " + failure.message());
  }

  // All addresses on one port.
  void listen() {
    const bool loopback = shared.options.addresses.empty();
    std::vector<std::string> addresses = shared.options.addresses;
    if (loopback) addresses = {"127.0.0.1", "::1"};
    std::string problem;
    for (int k = 0; k < shared.options.tries; ++k) {
      port = shared.options.port + (shared.options.port == 0 ? 0 : k);
      acceptors.clear();
      problem.clear();
      for (const std::string& address : addresses) {
        const std::string why = listen(address);
        // A machine without IPv6 has no ::1.
        if (!why.empty() && !(loopback && address == "::1")) problem = why;
      }
      if (problem.empty()) return;
    }
    throw Error(ErrorKind::file, problem);
  }

  std::string listen(const std::string& text) {
    Failure failure;
    const auto address = asio::ip::make_address(text, failure);
    if (failure)
      throw Error(ErrorKind::bad_input,
                  fmt::format("--listen {}: expected an address such as 127.0.0.1 or ::1", text));
    auto acceptor = std::make_unique<tcp::acceptor>(shared.io);
    const tcp::endpoint endpoint(address, static_cast<std::uint16_t>(port));
    acceptor->open(endpoint.protocol(), failure);
    if (!failure) acceptor->set_option(asio::socket_base::reuse_address(true), failure);
    if (!failure && address.is_v6()) acceptor->set_option(asio::ip::v6_only(true), failure);
    if (!failure) acceptor->bind(endpoint, failure);
    if (!failure) acceptor->listen(asio::socket_base::max_listen_connections, failure);
    if (failure)
      return fmt::format("{} port {}: {}; --port gives another one", text, port, failure.message());
    if (port == 0) port = acceptor->local_endpoint().port();
    acceptors.push_back(std::move(acceptor));
    return "";
  }

  void accept(tcp::acceptor& acceptor) {
    acceptor.async_accept([this, &acceptor](Failure failure, tcp::socket socket) {
      if (!acceptor.is_open()) return;
      if (failure) return accept_later(acceptor);  // no descriptors left, perhaps
      take(std::move(socket));
      accept(acceptor);
    });
  }

  void accept_later(tcp::acceptor& acceptor) {
    auto wait = std::make_shared<asio::steady_timer>(shared.io, kShortOfFiles);
    wait->async_wait([this, wait, &acceptor](Failure) {
      if (acceptor.is_open()) accept(acceptor);
    });
  }

  void take(tcp::socket socket) {
    Failure failure;
    const auto peer = socket.remote_endpoint(failure);
    if (failure) return;
    socket.set_option(tcp::no_delay(true), failure);
    socket.set_option(GivesUpAfter(kVanished.count()), failure);
    Place place(shared, peer.address().to_string());
    if (shared.refused > kMostRefused) return;
    serve(shared, NetStream(shared.io, std::move(socket), tls ? &*tls : nullptr), std::move(place));
  }

  void tick(const std::function<bool()>& leave) {
    timer.expires_after(kTick);
    timer.async_wait([this, &leave](Failure) {
      shared.lobby->tick(seconds_now());
      if (leave() || !shared.lobby->failure().empty()) return farewell();
      tick(leave);
    });
  }

  void farewell() {
    shared.leaving = true;
    for (const auto& acceptor : acceptors) acceptor->close();
    shared.lobby->close_all(CloseCode::going_away, "the server is going down");
    wait_for_visitors(kFarewell / kTick);
  }

  void wait_for_visitors(std::int64_t ticks) {
    if (ticks <= 0 || shared.connections.count() == 0) return shared.io.stop();
    timer.expires_after(kTick);
    timer.async_wait([this, ticks](Failure) { wait_for_visitors(ticks - 1); });
  }
};

HttpServer::HttpServer(const ServerOptions& options, const LobbyOptions& lobby)
    : impl_(std::make_unique<Impl>(options)) {
  asio::io_context& io = impl_->shared.io;
  impl_->shared.lobby =
      std::make_unique<Lobby>(lobby, [&io](std::function<void()> work) { asio::post(io, std::move(work)); });
}

HttpServer::~HttpServer() {
  impl_->shared.io.stop();
  impl_->shared.lobby.reset();  // desks post until they have ended
}

int HttpServer::port() const { return impl_->port; }

std::string HttpServer::url() const {
  return fmt::format("{}://{}/", impl_->shared.gate->scheme(), impl_->host);
}

void HttpServer::run(const std::function<bool()>& leave) {
  for (const auto& acceptor : impl_->acceptors) impl_->accept(*acceptor);
  impl_->tick(leave);
  impl_->shared.io.run();
  if (const std::string why = impl_->shared.lobby->failure(); !why.empty())
    throw Error(ErrorKind::defect, "the session ended: " + why);
}

}  // namespace pabd
