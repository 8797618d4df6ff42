// SPDX-License-Identifier: MIT
// A visitor's WebSocket: a hello, then messages, with limits; at most one frame waits, the newest.
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/websocket.hpp>
#include <deque>

#include "app/serve/clock.h"
#include "app/serve/net.h"
#include "sim/base/error.h"
#include "sim/base/utf8.h"

namespace pabd::net {
namespace {

namespace websocket = beast::websocket;
using namespace std::chrono_literals;

constexpr const char* kProtocol = "pabd.1";
constexpr std::size_t kMostTextWaiting = 256 * 1024;  // bytes
constexpr double kMessageRate = 500, kMessageBurst = 1000;
constexpr std::size_t kLongestReason = 110;  // bytes, of a close frame, before the end of a character

bool offers_protocol(const UpgradeRequest& request) {
  for (const auto token : http::token_list(request[http::field::sec_websocket_protocol])) {
    if (token == kProtocol) return true;
  }
  return false;
}

class WebSocketClient : public VisitorLink, public std::enable_shared_from_this<WebSocketClient> {
 public:
  WebSocketClient(Shared& shared, NetStream stream, Place place)
      : shared_(shared), socket_(std::move(stream)), place_(std::move(place)), hello_timer_(shared.io) {}
  ~WebSocketClient() override {
    if (seat_ && shared_.lobby) shared_.lobby->leave(*seat_);
  }

  void begin(UpgradeRequest request) {
    request_ = std::make_shared<UpgradeRequest>(std::move(request));
    fits_ = offers_protocol(*request_);
    socket_.set_option(websocket::stream_base::timeout{10s, 20s, true});
    socket_.set_option(websocket::stream_base::decorator([fits = fits_](websocket::response_type& answer) {
      if (fits) answer.set(http::field::sec_websocket_protocol, kProtocol);
    }));
    websocket::permessage_deflate no;
    no.server_enable = false;
    socket_.set_option(no);
    socket_.auto_fragment(false);
    socket_.read_message_max(kMostHelloBytes);
    socket_.async_accept(*request_,
                         [self = shared_from_this()](Failure failure) { self->accepted(failure); });
  }

  // ---- VisitorLink ----

  void send_text(std::shared_ptr<const std::string> json) override {
    if (closing_) return;
    text_bytes_ += json->size();
    if (text_bytes_ > kMostTextWaiting) return close(CloseCode::too_many, "messages are not read");
    texts_.push_back(std::move(json));
    write();
  }

  void send_frame(EncodedFrame frame) override {
    if (closing_) return;
    waiting_ = std::move(frame);
    write();
  }

  void close(CloseCode code, const std::string& why) override {
    if (std::exchange(closing_, true)) return;
    texts_.clear();
    waiting_.reset();
    frame_.clear();
    websocket::close_reason reason;
    reason.code = static_cast<std::uint16_t>(code);
    const std::string_view shown = first_bytes(why, kLongestReason);
    reason.reason.assign(shown.data(), shown.size());
    socket_.async_close(reason, [self = shared_from_this()](Failure) {});
  }

 private:
  void accepted(Failure failure) {
    if (failure) return;
    read();  // receives the answer to a close, too
    if (!fits_) return close(CloseCode::version, "expected the subprotocol pabd.1");
    if (shared_.leaving) return close(CloseCode::going_away, "the server is going down");
    hello_timer_.expires_after(5s);
    hello_timer_.async_wait([weak = weak_from_this()](Failure cancelled) {
      const auto self = weak.lock();
      if (self && !cancelled && !self->seat_)
        self->close(CloseCode::malformed, "expected a hello within 5 s");
    });
  }

  void read() {
    socket_.async_read(buffer_, [self = shared_from_this()](Failure failure, std::size_t) {
      if (failure) return self->lost(failure == websocket::error::closed);
      self->take();
      self->read();
    });
  }

  // The connection ended, with or without a close frame.
  void lost(bool closed) {
    closing_ = true;
    hello_timer_.cancel();
    if (seat_) shared_.lobby->leave(*seat_, closed);
    seat_.reset();
  }

  void take() {
    const std::string text = beast::buffers_to_string(buffer_.data());
    buffer_.consume(buffer_.size());
    if (closing_) return;
    if (!bucket_.take(seconds_now())) return close(CloseCode::too_many, "more than 500 messages a second");
    if (!socket_.got_text()) return close(CloseCode::malformed, "expected text messages");
    try {
      ClientMessage message = read_client_message(text);
      const auto* hello = std::get_if<message::Hello>(&message);
      if (!seat_ || hello) return enter(hello);
      if (!shared_.lobby->receive(*seat_, std::move(message), *this))
        close(CloseCode::too_many, "too much input waits");
    } catch (const Error& error) {
      close(CloseCode::malformed, error.what());
    }
  }

  void enter(const message::Hello* hello) {
    if (!hello || seat_) return close(CloseCode::malformed, "expected one hello, before all else");
    const Access access = shared_.options.tokens.access(hello->token);
    if (access == Access::none) return close(CloseCode::refused, "the link's token is not the server's");
    hello_timer_.cancel();
    socket_.read_message_max(kMostMessageBytes);
    seat_ = shared_.lobby->enter(*hello, access, shared_from_this());
  }

  // Texts first, except within a frame; then the rest of the current frame, then the waiting one.
  void write() {
    if (busy_ || closing_) return;
    if (!texts_.empty() && frame_.empty()) {
      SharedBytes text = std::move(texts_.front());
      texts_.pop_front();
      text_bytes_ -= text->size();
      return write(std::move(text), false);
    }
    if (frame_.empty() && waiting_) {
      frame_.assign(waiting_->parts.begin(), waiting_->parts.end());
      waiting_.reset();
    }
    if (frame_.empty()) return;
    SharedBytes part = std::move(frame_.front());
    frame_.pop_front();
    write(std::move(part), true);
  }

  void write(const SharedBytes& bytes, bool binary) {
    busy_ = true;
    socket_.binary(binary);
    socket_.async_write(asio::buffer(*bytes),
                        [self = shared_from_this(), bytes](Failure failure, std::size_t) {
                          self->busy_ = false;
                          if (!failure) self->write();
                        });
  }

  Shared& shared_;
  websocket::stream<NetStream> socket_;
  Place place_;
  asio::steady_timer hello_timer_;
  std::shared_ptr<UpgradeRequest> request_;
  beast::flat_buffer buffer_;
  RateBucket bucket_{kMessageRate, kMessageBurst};
  std::optional<Lobby::Seat> seat_;
  std::deque<SharedBytes> texts_, frame_;
  std::size_t text_bytes_ = 0;
  std::optional<EncodedFrame> waiting_;
  bool fits_ = false, busy_ = false, closing_ = false;
};

}  // namespace

void serve_socket(Shared& shared, NetStream stream, UpgradeRequest request, Place place) {
  std::make_shared<WebSocketClient>(shared, std::move(stream), std::move(place))->begin(std::move(request));
}

}  // namespace pabd::net
