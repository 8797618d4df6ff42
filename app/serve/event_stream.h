// SPDX-License-Identifier: MIT
// GET /events: a line of JSON for every change, until the client or the server closes.
#pragma once

#include <boost/asio/steady_timer.hpp>
#include <boost/asio/write.hpp>

#include "app/serve/net.h"

namespace pabd::net {

class EventStream : public EventLink, public std::enable_shared_from_this<EventStream> {
 public:
  static constexpr std::size_t kMostWaiting =
      256 * 1024;  // bytes; a client that reads more slowly is disconnected

  EventStream(Shared& shared, NetStream stream, Place place)
      : shared_(shared), stream_(std::move(stream)), place_(std::move(place)), farewell_(shared.io) {}

  void begin() {
    auto head = std::make_shared<http::response<http::empty_body>>(http::status::ok, 11);
    set_headers(shared_, *head);
    head->set(http::field::content_type, "application/x-ndjson");
    head->chunked(true);
    head->keep_alive(false);
    auto writer = std::make_shared<http::response_serializer<http::empty_body>>(*head);
    stream_.expires_never();
    http::async_write_header(stream_, *writer,
                             [self = shared_from_this(), head, writer](Failure failure, std::size_t) {
                               self->started_ = true;
                               failure ? self->end() : self->write();
                             });
    watch();
  }

  void send_line(const std::string& json) override {
    if (!open_ || finished_) return;
    waiting_ += json + "\n";
    if (waiting_.size() > kMostWaiting) return end();
    write();
  }
  void finish() override {
    if (!open_ || std::exchange(finished_, true)) return;
    write();
    wait_for_reader(10);
  }
  bool open() const override { return open_; }

 private:
  void write() {
    if (!started_ || busy_ || !open_) return;
    if (waiting_.empty()) {
      if (finished_) write_last();
      return;
    }
    busy_ = true;
    auto lines = std::make_shared<std::string>(std::exchange(waiting_, {}));
    asio::async_write(stream_, http::make_chunk(asio::buffer(*lines)),
                      [self = shared_from_this(), lines](Failure failure, std::size_t) {
                        self->busy_ = false;
                        failure ? self->end() : self->write();
                      });
  }

  // Waits a second in tenths, so that a pause of this thread does not count as the client's.
  void wait_for_reader(int tenths) {
    farewell_.expires_after(std::chrono::milliseconds(100));
    farewell_.async_wait([weak = weak_from_this(), tenths](Failure cancelled) {
      const auto self = weak.lock();
      if (!self || cancelled || !self->open_) return;
      tenths > 1 ? self->wait_for_reader(tenths - 1) : self->end();
    });
  }

  void write_last() {
    busy_ = true;
    asio::async_write(stream_, http::make_chunk_last(),
                      [self = shared_from_this()](Failure, std::size_t) { self->end(); });
  }

  // Reading shows when the client closes.
  void watch() {
    stream_.async_read_some(asio::buffer(rest_), [self = shared_from_this()](Failure failure, std::size_t) {
      failure ? self->end() : self->watch();
    });
  }

  void end() {
    open_ = false;
    waiting_.clear();
    stream_.close();
  }

  Shared& shared_;
  NetStream stream_;
  Place place_;
  asio::steady_timer farewell_;
  std::string waiting_;
  std::array<char, 512> rest_{};
  bool started_ = false, busy_ = false, open_ = true, finished_ = false;
};

}  // namespace pabd::net
