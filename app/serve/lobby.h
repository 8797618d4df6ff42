// SPDX-License-Identifier: MIT
// Visitors, their roles and their desks. Lives in the network's thread and passes messages between it and the desks'
// threads. Without sockets.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/serve/gate.h"
#include "app/serve/served_desk.h"

namespace pabd {

// Reasons to close a connection; numbers of the subprotocol.
enum class CloseCode : int {
  going_away = 1001,
  malformed = 4400,
  refused = 4401,
  version = 4406,
  gone = 4410,
  too_many = 4429
};

// A visitor's connection.
class VisitorLink {
 public:
  virtual ~VisitorLink() = default;
  virtual void send_text(std::shared_ptr<const std::string> json) = 0;
  virtual void send_frame(EncodedFrame frame) = 0;  // replaces one that still waits
  virtual void close(CloseCode code, const std::string& why) = 0;
};

// A program that reads events.
class EventLink {
 public:
  virtual ~EventLink() = default;
  virtual void send_line(const std::string& json) = 0;
  virtual void finish() = 0;  // sends what waits, then closes
  virtual bool open() const = 0;
};

struct LobbyOptions {
  DeskOptions desk;
  int sessions = 1;         // 1: all visitors share one desk
  double idle_limit = 600;  // s; a session without visitors ends after it
  bool keep_files = false;  // of sessions that have ended
  std::string version;
  std::string watch_token;  // sent to who may control; empty: there is none
};

class Lobby {
 public:
  // `post` runs a function in the network's thread. Throws Error when the shared desk cannot be made.
  Lobby(const LobbyOptions& options, std::function<void(std::function<void()>)> post);
  ~Lobby();
  Lobby(const Lobby&) = delete;
  Lobby& operator=(const Lobby&) = delete;

  struct Seat {
    std::string session;
    VisitorId visitor = 0;
  };
  // Sends the welcome, or closes the link and returns nothing.
  std::optional<Seat> enter(const message::Hello& hello, Access access,
                            const std::shared_ptr<VisitorLink>& link);
  // Input counts only from the controller. False: the desk's queue is full.
  bool receive(const Seat& seat, ClientMessage message, VisitorLink& link);
  void leave(const Seat& seat,
             bool closed = false);  // `closed`: the page was closed, not only the connection lost

  // For programs; an empty name means the only session. False: there is no such session, or its queue is full.
  bool ask(const std::string& session, DeskInput question);
  bool may_listen(const std::string& session) const;  // false: no such session, or too many listen
  void listen(const std::string& session,
              const std::shared_ptr<EventLink>& link);  // precondition: may_listen()
  // The files of a session; null when there is none of that name.
  std::shared_ptr<FileRoot> files(const std::string& session) const;

  // Why the only session ended; empty: it runs.
  const std::string& failure() const { return failure_; }

  void tick(double now);  // a few times a second
  void close_all(CloseCode code, const std::string& why);

 private:
  struct Room;
  std::shared_ptr<Room> open_room(const std::string& name);
  std::shared_ptr<Room> room(const std::string& session) const;
  void handle_news(Room& room, DeskNews news);
  void send_roles(Room& room);
  void end(Room& room, const std::string& why);

  LobbyOptions options_;
  std::function<void(std::function<void()>)> post_;
  std::map<std::string, std::shared_ptr<Room>> rooms_;
  std::string failure_;
};

}  // namespace pabd
