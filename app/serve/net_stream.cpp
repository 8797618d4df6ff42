// SPDX-License-Identifier: MIT
// See net_stream.h. The only file that compiles reads and writes of sockets and of TLS.
#include "app/serve/net_stream.h"

#include <algorithm>
#include <boost/asio/ssl/stream.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/websocket/teardown.hpp>
#include <optional>

namespace pabd::net {

constexpr std::size_t kRecord = 16 * 1024;  // largest record of TLS, bytes

struct NetStream::Impl {
  beast::tcp_stream tcp;
  std::optional<asio::ssl::stream<beast::tcp_stream&>> tls;
  std::vector<char> record;  // being written

  explicit Impl(tcp::socket socket) : tcp(std::move(socket)) {}
};

NetStream::NetStream(asio::io_context& io, tcp::socket socket, asio::ssl::context* tls)
    : io_(&io), impl_(std::make_unique<Impl>(std::move(socket))) {
  if (tls) impl_->tls.emplace(impl_->tcp, *tls);
}
NetStream::~NetStream() = default;
NetStream::NetStream(NetStream&&) noexcept = default;
NetStream& NetStream::operator=(NetStream&&) noexcept = default;

bool NetStream::secure() const { return impl_->tls.has_value(); }
void NetStream::expires_after(std::chrono::steady_clock::duration after) { impl_->tcp.expires_after(after); }
void NetStream::expires_never() { impl_->tcp.expires_never(); }
void NetStream::close() { impl_->tcp.close(); }

void NetStream::handshake(Done done) {
  if (!impl_->tls) return done({});
  impl_->tls->async_handshake(asio::ssl::stream_base::server, std::move(done));
}

void NetStream::shutdown(Done done) {
  if (impl_->tls) return impl_->tls->async_shutdown(std::move(done));
  Failure failure;
  impl_->tcp.socket().shutdown(tcp::socket::shutdown_send, failure);
  done(failure);
}

void NetStream::tear_down(Done done) {
  const auto tcp_too = [impl = impl_.get(), done = std::move(done)](Failure) {
    beast::websocket::async_teardown(beast::role_type::server, impl->tcp.socket(), done);
  };
  if (!impl_->tls) return tcp_too({});
  impl_->tls->async_shutdown(tcp_too);
}

void NetStream::read_some(asio::mutable_buffer to, Moved done) {
  if (impl_->tls) return impl_->tls->async_read_some(to, std::move(done));
  impl_->tcp.async_read_some(to, std::move(done));
}

void NetStream::write_some(const std::vector<asio::const_buffer>& from, Moved done) {
  if (!impl_->tls) return impl_->tcp.async_write_some(from, std::move(done));
  // One record for all buffers: a record each would be a packet each.
  impl_->record.resize(std::min(kRecord, asio::buffer_size(from)));
  asio::buffer_copy(asio::buffer(impl_->record), from);
  impl_->tls->async_write_some(asio::buffer(impl_->record), std::move(done));
}

}  // namespace pabd::net
