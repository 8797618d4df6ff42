// SPDX-License-Identifier: MIT
// Visitors, their roles and the desks they are at; between the network, in whose thread it lives, and the
// desks' threads. Knows no sockets.
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

// Reasons to close a connection, as the subprotocol numbers them.
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
  virtual void send_frame(EncodedFrame frame) = 0;  // takes the place of one that still waits
  virtual void close(CloseCode code, const std::string& why) = 0;
};

// A program that reads events.
class EventLink {
 public:
  virtual ~EventLink() = default;
  virtual void send_line(const std::string& json) = 0;
  virtual void finish() = 0;  // nothing more comes: said to it, then closed
  virtual bool open() const = 0;
};

struct LobbyOptions {
  DeskOptions desk;
  int sessions = 1;         // 1: all visitors are at one desk
  double idle_limit = 600;  // s; with sessions, a desk without visitors is ended
  bool keep_files = false;  // of sessions that have ended
  std::string version;
  std::string watch_token;  // for whoever may hand the link on; empty: there is none
};

class Lobby {
 public:
  // `post` carries a function out in the network's thread. Throws Error when the one desk cannot be made.
  Lobby(const LobbyOptions& options, std::function<void(std::function<void()>)> post);
  ~Lobby();
  Lobby(const Lobby&) = delete;
  Lobby& operator=(const Lobby&) = delete;

  struct Seat {
    std::string session;
    VisitorId visitor = 0;
  };
  // Says welcome, or closes the link: then there is no seat.
  std::optional<Seat> enter(const message::Hello& hello, Access access,
                            const std::shared_ptr<VisitorLink>& link);
  // Only the controller's input is obeyed. False: too much of it waits.
  bool hear(const Seat& seat, ClientMessage message, VisitorLink& link);
  void leave(const Seat& seat, bool closed = false);  // its page, and not only the connection

  // For programs; an empty name means the one session. False when there is none of that name, or too much
  // waits for it.
  bool ask(const std::string& session, DeskInput question);
  bool listen(const std::string& session, const std::shared_ptr<EventLink>& link);
  // The files of a session; null when there is none of that name.
  std::shared_ptr<FileRoot> files(const std::string& session) const;

  // Why the one session ended; empty: it goes on.
  const std::string& failure() const { return failure_; }

  void tick(double now);  // a few times a second
  void close_all(CloseCode code, const std::string& why);

 private:
  struct Room;
  std::shared_ptr<Room> open_room(const std::string& name);
  std::shared_ptr<Room> room(const std::string& session) const;
  void heard(Room& room, DeskNews news);
  void tell_roles(Room& room);
  void end(Room& room, const std::string& why);

  LobbyOptions options_;
  std::function<void(std::function<void()>)> post_;
  std::map<std::string, std::shared_ptr<Room>> rooms_;
  std::string failure_;
};

}  // namespace pabd
