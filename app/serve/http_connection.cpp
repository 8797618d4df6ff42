// SPDX-License-Identifier: MIT
// An HTTP connection: every request is checked (routes.h) before its body is read.
#include <boost/asio/post.hpp>
#include <boost/beast/websocket/rfc6455.hpp>

#include "app/serve/clock.h"
#include "app/serve/event_stream.h"
#include "app/serve/net.h"
#include "app/workbench/file_root.h"
#include "sim/base/atomic_file.h"
#include "sim/base/error.h"

namespace pabd::net {
namespace {

using namespace std::chrono_literals;
constexpr std::uint32_t kMostHeader = 16 * 1024;
constexpr auto kIdle = 30s, kLongest = 600s;
constexpr std::size_t kMostUploads = 2, kMostWaiting = 16;
// Slower uploads are refused, since only two run at a time.
constexpr double kUploadGrace = 10;  // s
constexpr double kUploadRate = 1e4;  // bytes a second

class HttpConnection : public std::enable_shared_from_this<HttpConnection> {
 public:
  HttpConnection(Shared& shared, NetStream stream, Place place)
      : shared_(shared), stream_(std::move(stream)), place_(std::move(place)) {}
  ~HttpConnection() {
    if (uploading_) --shared_.uploads;
  }

  void begin() {
    expire(10s);
    stream_.handshake([self = shared_from_this()](Failure failure) {
      if (!failure) self->read();
    });
  }

 private:
  void expire(std::chrono::steady_clock::duration after) { stream_.expires_after(after); }

  void read() {
    parser_.emplace();
    parser_->header_limit(kMostHeader);
    parser_->body_limit(kMostUpload);  // limit of the announced length; read_body() has its own
    expire(kIdle);
    http::async_read_header(
        stream_, buffer_, *parser_,
        [self = shared_from_this()](Failure failure, std::size_t) { self->take(failure); });
  }

  void take(Failure failure) {
    if (failure == http::error::header_limit) return refuse(431, "the header is longer than 16 KiB");
    if (failure == http::error::body_limit) return refuse(413, "the body is longer than is taken");
    if (failure == beast::error::timeout || failure == http::error::end_of_stream) return close();
    if (failure && failure.category() == http::make_error_code(http::error::end_of_stream).category())
      return refuse(400, "no HTTP: " + failure.message());
    if (failure) return;
    if (place_.verdict() == ConnectionCount::Verdict::busy_peer)
      return refuse(429, "too many connections from there; close some");
    if (!place_.welcome()) return refuse(503, "too many connections; try again later");
    const auto& head = parser_->get();
    keep_alive_ = head.keep_alive();
    HttpRequest request;
    const auto text = [](auto view) { return std::string_view(view.data(), view.size()); };
    request.method = text(head.method_string());
    request.target = text(head.target());
    request.host = text(head[http::field::host]);
    request.hosts = head.count(http::field::host);
    request.origin = text(head[http::field::origin]);
    request.authorization = text(head[http::field::authorization]);
    request.coding = text(head[http::field::transfer_encoding]);
    request.upgrade = beast::websocket::is_upgrade(head);
    request.has_body = parser_->chunked() || parser_->content_length_remaining().value_or(0) > 0;
    session_ = std::string(text(head["Pabd-Session"]));
    const Route route = find_route(request, *shared_.gate, shared_.options.tokens);
    if (route.status != 200) return refuse(route.status, route.error);
    if (parser_->content_length_remaining().value_or(0) > route.most_body)
      return refuse(413, "the body is longer than is taken");
    act(route);
  }

  void act(const Route& route) {
    switch (route.endpoint) {
      case Endpoint::page:
        return send(page_answer(shared_, route.name));
      case Endpoint::socket:
        stream_.expires_never();
        return serve_socket(shared_, std::move(stream_), parser_->release(), std::move(place_));
      case Endpoint::actions:
      case Endpoint::write_file:
        return read_body(route);
      case Endpoint::state:
        return ask([](desk::Reply reply) { return desk::AskState{std::move(reply)}; });
      case Endpoint::picture:
        return ask([&](desk::Reply reply) {
          return desk::AskPicture{route.width, route.height, route.panels, std::move(reply)};
        });
      case Endpoint::events:
        return listen();
      case Endpoint::file_list:
        return list_files();
      case Endpoint::read_file:
        return send_file(route.name);
    }
  }

  // ---- bodies ----

  void read_body(const Route& route) {
    if (route.endpoint == Endpoint::write_file) {
      if (shared_.uploads >= kMostUploads) return refuse(503, "other uploads are under way; try again");
      ++shared_.uploads;
      uploading_ = true;
    }
    const bool waits = beast::iequals(parser_->get()[http::field::expect], "100-continue");
    body_.emplace(std::move(*parser_));
    body_->body_limit(route.most_body);
    body_began_ = seconds_now();
    body_bytes_ = 0;
    expire(kIdle);
    if (!waits) return read_more(route);
    auto go_on = std::make_shared<http::response<http::empty_body>>(http::status::continue_, 11);
    http::async_write(stream_, *go_on,
                      [self = shared_from_this(), go_on, route](Failure failure, std::size_t) {
                        if (!failure) self->read_more(route);
                      });
  }

  void read_more(const Route& route) {
    if (body_->is_done()) return take_body(route, {});
    const double since = seconds_now() - body_began_;
    if (since > kUploadGrace && static_cast<double>(body_bytes_) < kUploadRate * since) {
      if (std::exchange(uploading_, false)) --shared_.uploads;
      return refuse(408, "the body comes too slowly");
    }
    expire(kIdle);
    http::async_read_some(stream_, buffer_, *body_,
                          [self = shared_from_this(), route](Failure failure, std::size_t n) {
                            self->body_bytes_ += n;
                            failure ? self->take_body(route, failure) : self->read_more(route);
                          });
  }

  void take_body(const Route& route, Failure failure) {
    if (std::exchange(uploading_, false)) --shared_.uploads;
    if (failure == http::error::body_limit) return refuse(413, "the body is longer than is taken");
    if (failure) return;
    std::string body = std::move(body_->get().body());
    body_.reset();
    if (route.endpoint == Endpoint::write_file) return write_file_of(route.name, body);
    ask([&](desk::Reply reply) { return desk::Run{std::move(body), std::move(reply)}; });
  }

  void write_file_of(const std::string& name, const std::string& body) {
    const auto files = shared_.lobby->files(session_);
    if (!files) return no_session();
    try {
      files->check_room(name, body.size());
    } catch (const Error& error) {
      return refuse(413, error.what());
    }
    try {
      write_file(files->file_of(name), body);
    } catch (const Error& error) {
      return refuse(error.kind() == ErrorKind::bad_input ? 400 : 503, error.what());
    }
    shared_.lobby->ask(session_, desk::Uploaded{name});
    send(json_answer(shared_, 201, {{"name", name}, {"bytes", body.size()}}));
  }

  // ---- files ----

  void list_files() {
    const auto files = shared_.lobby->files(session_);
    if (!files) return no_session();
    OrderedJson list = OrderedJson::array();
    for (const FileRoot::Entry& entry : files->list())
      list.push_back({{"name", entry.name}, {"bytes", entry.bytes}});
    send(json_answer(shared_, 200, {{"files", list}}));
  }

  void send_file(const std::string& name) {
    const auto files = shared_.lobby->files(session_);
    if (!files) return no_session();
    auto answer = std::make_shared<http::response<http::file_body>>(http::status::ok, 11);
    try {
      Descriptor descriptor = files->open(name);
      beast::file_posix file;
      file.native_handle(descriptor.release());
      http::file_body::value_type body;
      Failure failure;
      body.reset(std::move(file), failure);
      if (failure) return refuse(503, failure.message());
      answer->body() = std::move(body);
    } catch (const Error& error) {
      return refuse(404, error.what());
    }
    set_headers(shared_, *answer);
    answer->set(http::field::content_type, "application/octet-stream");
    answer->set(http::field::content_disposition, "attachment");
    answer->keep_alive(keep_alive_);
    answer->prepare_payload();
    write(answer, kLongest);
  }

  // ---- what a desk answers ----

  // A request that waits for a desk. It is answered even if the desk ends; the connection is used and released in the
  // network's thread only.
  class Pending {
   public:
    explicit Pending(std::shared_ptr<HttpConnection> connection) : connection_(std::move(connection)) {
      ++connection_->shared_.waiting;
    }
    ~Pending() {
      try {
        refuse("the session has ended");
      } catch (const std::exception&) {  // no memory for an answer: the connection closes without one
      }
    }
    Pending(const Pending&) = delete;
    Pending& operator=(const Pending&) = delete;

    void answer(desk::Answer answer) {
      if (!connection_) return;
      asio::io_context& io = connection_->shared_.io;
      asio::post(io, [to = std::move(connection_), answer = std::move(answer)]() mutable {
        --to->shared_.waiting;
        to->send(text_answer(to->shared_, answer.status, answer.type, std::move(answer.body)));
      });
    }
    void refuse(const char* why) { answer({503, "application/json", json_line({{"error", why}}) + "\n"}); }

   private:
    std::shared_ptr<HttpConnection> connection_;
  };

  void ask(const auto& question) {
    if (shared_.waiting >= kMostWaiting)
      return refuse(503, "too many requests are being worked on; try again");
    if (!shared_.lobby->files(session_)) return no_session();
    expire(std::chrono::hours(24));
    const auto pending = std::make_shared<Pending>(shared_from_this());
    const auto reply = [pending](desk::Answer answer) { pending->answer(std::move(answer)); };
    if (!shared_.lobby->ask(session_, question(reply))) pending->refuse("the session is busy; try again");
  }

  void listen() {
    if (!shared_.lobby->files(session_)) return no_session();
    if (!shared_.lobby->may_listen(session_)) return refuse(503, "too many read the events");
    auto events = std::make_shared<EventStream>(shared_, std::move(stream_), std::move(place_));
    shared_.lobby->listen(session_, events);
    events->begin();
  }

  void no_session() {
    refuse(404, "there is no such session; with --sessions, name it in the header Pabd-Session");
  }

  // ---- answers ----

  // Closes the connection: parts of a refused request may be unread.
  void refuse(int status, const std::string& why) {
    keep_alive_ = false;
    send(json_answer(shared_, status, {{"error", why}}));
  }

  void send(http::response<http::string_body> answer) {
    answer.keep_alive(keep_alive_);
    answer.prepare_payload();
    write(std::make_shared<http::response<http::string_body>>(std::move(answer)), 120s);
  }

  template <class Answer>
  void write(std::shared_ptr<Answer> answer, std::chrono::seconds limit) {
    expire(limit);
    http::async_write(stream_, *answer, [self = shared_from_this(), answer](Failure failure, std::size_t) {
      if (failure || !self->keep_alive_ || self->shared_.leaving) return self->close();
      self->read();
    });
  }

  // Reads what the client still sends for a moment, so that it receives the answer instead of a reset.
  void close() {
    expire(stream_.secure() ? 2s : 1s);
    stream_.shutdown([self = shared_from_this()](Failure failure) {
      if (!failure && !self->stream_.secure()) self->drain();
    });
  }

  void drain() {
    stream_.async_read_some(asio::buffer(rest_), [self = shared_from_this()](Failure failure, std::size_t n) {
      self->drained_ += n;
      if (!failure && self->drained_ < (std::size_t{4} << 20)) self->drain();
    });
  }

  Shared& shared_;
  NetStream stream_;
  Place place_;
  beast::flat_buffer buffer_{128 * 1024};
  std::optional<http::request_parser<http::empty_body>> parser_;
  std::optional<http::request_parser<http::string_body>> body_;
  std::string session_;
  std::array<char, 16 * 1024> rest_{};
  std::size_t drained_ = 0, body_bytes_ = 0;
  double body_began_ = 0;
  bool keep_alive_ = false, uploading_ = false;
};

}  // namespace

void serve(Shared& shared, NetStream stream, Place place) {
  std::make_shared<HttpConnection>(shared, std::move(stream), std::move(place))->begin();
}

}  // namespace pabd::net
