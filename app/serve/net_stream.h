// SPDX-License-Identifier: MIT
// A connection with or without TLS as one type, so that code on top of it is compiled once.
//
// An AsyncStream of Boost.Beast. std::function hides the handlers, so that TLS is compiled once as well. Not
// thread-safe: handlers run in the thread of the io_context.
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ssl/context.hpp>
#include <boost/beast/core/error.hpp>
#include <boost/beast/core/role.hpp>
#include <chrono>
#include <functional>
#include <memory>
#include <vector>

namespace pabd::net {

namespace asio = boost::asio;
namespace beast = boost::beast;
using tcp = asio::ip::tcp;
using Failure = beast::error_code;

class NetStream {
 public:
  using executor_type = asio::io_context::executor_type;
  using Moved = std::function<void(Failure, std::size_t)>;
  using Done = std::function<void(Failure)>;

  // `tls`, if any, must outlive the connection.
  NetStream(asio::io_context& io, tcp::socket socket, asio::ssl::context* tls);
  ~NetStream();
  NetStream(NetStream&&) noexcept;
  NetStream& operator=(NetStream&&) noexcept;

  executor_type get_executor() noexcept { return io_->get_executor(); }

  // Without TLS calls `done` at once.
  void handshake(Done done);
  // Announces the end: closes the sending half of the socket, or exchanges close_notify of TLS.
  void shutdown(Done done);
  bool secure() const;
  // Closes both directions.
  void tear_down(Done done);

  // Pending operations then fail with beast::error::timeout.
  void expires_after(std::chrono::steady_clock::duration after);
  void expires_never();
  void close();

  template <class Buffers, class Token>
  auto async_read_some(const Buffers& buffers, Token&& token) {
    return asio::async_initiate<Token, void(Failure, std::size_t)>(
        [this](auto handler, const Buffers& to) { read_some(first_of(to), hidden(std::move(handler))); },
        token, buffers);
  }
  template <class Buffers, class Token>
  auto async_write_some(const Buffers& buffers, Token&& token) {
    return asio::async_initiate<Token, void(Failure, std::size_t)>(
        [this](auto handler, const Buffers& from) { write_some(all_of(from), hidden(std::move(handler))); },
        token, buffers);
  }

 private:
  struct Impl;

  // std::function copies what it holds; handlers only move.
  template <class Handler>
  static Moved hidden(Handler handler) {
    return [held = std::make_shared<Handler>(std::move(handler))](Failure failure, std::size_t n) {
      std::move (*held)(failure, n);
    };
  }
  template <class Buffers>
  static asio::mutable_buffer first_of(const Buffers& buffers) {
    for (auto it = asio::buffer_sequence_begin(buffers); it != asio::buffer_sequence_end(buffers); ++it)
      if (const asio::mutable_buffer buffer(*it); buffer.size() > 0) return buffer;
    return {};
  }
  template <class Buffers>
  static std::vector<asio::const_buffer> all_of(const Buffers& buffers) {
    return {asio::buffer_sequence_begin(buffers), asio::buffer_sequence_end(buffers)};
  }

  void read_some(asio::mutable_buffer to, Moved done);
  void write_some(const std::vector<asio::const_buffer>& from, Moved done);

  asio::io_context* io_;
  std::unique_ptr<Impl> impl_;
};

// Required by beast::websocket: an orderly and an immediate close.
template <class Handler>
void async_teardown(beast::role_type, NetStream& stream, Handler&& handler) {
  stream.tear_down([held = std::make_shared<std::decay_t<Handler>>(std::forward<Handler>(handler))](
                       Failure failure) { std::move (*held)(failure); });
}
inline void beast_close_socket(NetStream& stream) { stream.close(); }

}  // namespace pabd::net
