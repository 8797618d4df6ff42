// SPDX-License-Identifier: MIT
// See lobby.h.
#include "app/serve/lobby.h"

#include <algorithm>
#include <filesystem>

#include "app/serve/clock.h"
#include "sim/base/error.h"

namespace pabd {
namespace {

constexpr std::size_t kMostListeners = 8;  // of a session's events
constexpr double kKeepAlive = 10;          // s between blank lines, which reveal connections that broke

std::shared_ptr<const std::string> shared(const OrderedJson& json) {
  return std::make_shared<const std::string>(json_line(json));
}

}  // namespace

struct Lobby::Room {
  struct Guest {
    std::weak_ptr<VisitorLink> link;
    desk::Resize size;  // of its page
    std::string said;   // the last role message
  };
  std::string name;
  std::shared_ptr<FileRoot> files;
  std::unique_ptr<ServedDesk> desk;
  Roles roles;
  std::map<VisitorId, Guest> guests;
  std::vector<std::shared_ptr<EventLink>> listeners;
  std::optional<VisitorId> controller;
  double alone_since = 0;
  double kept_alive = 0;  // when listeners got their last blank line
  bool ended = false;
  bool dressed = false;  // light or dark was set by the first controller

  // All connections.
  void close(CloseCode code, const std::string& why) {
    for (const auto& [id, guest] : guests) {
      if (const auto link = guest.link.lock()) link->close(code, why);
    }
    for (const auto& listener : listeners) listener->finish();
    listeners.clear();  // each is freed after its last line
  }
};

Lobby::Lobby(const LobbyOptions& options, std::function<void(std::function<void()>)> post)
    : options_(options), post_(std::move(post)) {
  if (options_.sessions > 1) return;
  const auto one = open_room("");
  one->desk->wait_until_ready();
}

Lobby::~Lobby() = default;

std::shared_ptr<Lobby::Room> Lobby::open_room(const std::string& name) {
  auto room = std::make_shared<Room>();
  room->name = name;
  room->alone_since = seconds_now();
  DeskOptions desk = options_.desk;
  if (!name.empty()) {
    // Sessions do not see each other's files.
    const std::filesystem::path own = desk.files->folder() / ("session-" + name);
    std::error_code failure;
    std::filesystem::create_directory(own, failure);
    desk.files = std::make_shared<FileRoot>(own);
  }
  room->files = desk.files;
  const std::weak_ptr<Room> weak = room;
  room->desk = std::make_unique<ServedDesk>(desk, [this, weak, post = post_](DeskNews news) {
    post([this, weak, news = std::move(news)]() mutable {
      if (const auto here = weak.lock()) handle_news(*here, std::move(news));
    });
  });
  rooms_[name] = room;
  return room;
}

std::shared_ptr<Lobby::Room> Lobby::room(const std::string& session) const {
  // The only session needs no name.
  const auto found = session.empty() && rooms_.size() == 1 ? rooms_.begin() : rooms_.find(session);
  return found == rooms_.end() || found->second->ended ? nullptr : found->second;
}

std::optional<Lobby::Seat> Lobby::enter(const message::Hello& hello, Access access,
                                        const std::shared_ptr<VisitorLink>& link) {
  const bool shared_desk = options_.sessions <= 1;
  const std::string name = shared_desk ? "" : hello.id;
  auto here = room(name);
  if (!here && shared_desk) {
    link->close(CloseCode::gone, "the session has ended");
    return std::nullopt;
  }
  if (!here && rooms_.size() >= static_cast<std::size_t>(options_.sessions)) {
    link->close(CloseCode::too_many, "all sessions are taken; try again later");
    return std::nullopt;
  }
  try {
    if (!here) here = open_room(name);
  } catch (const std::exception& error) {  // no thread, no memory, no folder: no session, but a server
    link->close(CloseCode::gone, error.what());
    return std::nullopt;
  }
  const auto arrival = here->roles.arrive(hello.id, access == Access::control, seconds_now());
  if (!arrival) {
    link->close(CloseCode::too_many, "there are too many visitors; try again later");
    return std::nullopt;
  }
  if (arrival->replaced) {
    const auto older = here->guests.find(*arrival->replaced);
    if (older != here->guests.end()) {
      if (const auto old = older->second.link.lock()) old->close(CloseCode::gone, "opened in another tab");
      here->guests.erase(older);
      here->desk->send(desk::Depart{*arrival->replaced});
    }
  }
  here->guests[arrival->id] = {link, hello.size, ""};
  const bool controls = here->roles.controls(arrival->id);
  const std::string role = controls ? "control" : "watch";
  OrderedJson welcome = {{"t", "welcome"},
                         {"role", role},
                         {"may_control", access == Access::control},
                         {"version", options_.version},
                         {"scene", std::filesystem::path(options_.desk.scene).stem().string()},
                         {"visitors", here->roles.present()},
                         {"id", hello.id},
                         {"session", name}};  // what the page's requests name
  if (access == Access::control && !options_.watch_token.empty()) welcome["watch"] = options_.watch_token;
  link->send_text(shared(welcome));
  if (controls && hello.dark && !std::exchange(here->dressed, true))
    here->desk->send(desk::Scheme{*hello.dark});
  here->desk->send(desk::Arrive{arrival->id});
  send_roles(*here);
  return Seat{name, arrival->id};
}

// Sends each visitor its role if that changed.
void Lobby::send_roles(Room& room) {
  const auto controller = room.roles.controller();
  if (controller != room.controller) {
    room.controller = controller;
    room.desk->send(desk::HandOver{controller});
    const auto guest = room.guests.find(controller.value_or(0));
    if (guest != room.guests.end()) room.desk->send(guest->second.size);
  }
  for (auto& [id, guest] : room.guests) {
    const bool controls = controller == id;
    const OrderedJson json = {{"t", "role"},
                              {"role", controls ? "control" : "watch"},
                              {"visitors", room.roles.present()},
                              {"asks", controls && room.roles.somebody_asks()}};
    auto text = shared(json);
    if (*text == guest.said) continue;
    guest.said = *text;
    if (const auto link = guest.link.lock()) link->send_text(std::move(text));
  }
}

bool Lobby::receive(const Seat& seat, ClientMessage said, VisitorLink& link) {
  const auto here = room(seat.session);
  if (!here) return true;
  ServedDesk& desk = *here->desk;
  const bool controls = here->roles.controls(seat.visitor);
  // From any visitor:
  if (auto* shown = std::get_if<desk::Shown>(&said)) {
    shown->visitor = seat.visitor;
    return desk.send(*shown);
  }
  if (const auto* ping = std::get_if<message::Ping>(&said)) {
    link.send_text(shared({{"t", "pong"}, {"at", ping->at}}));
    return true;
  }
  if (std::holds_alternative<message::AskControl>(said)) {
    here->roles.ask(seat.visitor);
    send_roles(*here);
    return true;
  }
  if (const auto* size = std::get_if<desk::Resize>(&said)) {
    here->guests[seat.visitor].size = *size;
    if (!desk.send(desk::Refresh{seat.visitor})) return false;
  }
  // From the controller only:
  if (!controls) return true;
  if (std::holds_alternative<message::GiveControl>(said)) {
    here->roles.give(seat.visitor);
    send_roles(*here);
    return true;
  }
  return std::visit(
      [&](auto& message) {
        if constexpr (std::is_constructible_v<DeskInput, decltype(message)>)
          return desk.send(std::move(message));
        else
          return true;
      },
      said);
}

void Lobby::leave(const Seat& seat, bool closed) {
  const auto here = room(seat.session);
  if (!here || here->guests.erase(seat.visitor) == 0) return;
  here->roles.leave(seat.visitor, seconds_now(), closed);
  here->desk->send(desk::Depart{seat.visitor});
  if (here->guests.empty()) here->alone_since = seconds_now();
  send_roles(*here);
}

void Lobby::handle_news(Room& room, DeskNews news) {
  if (auto* frame = std::get_if<desk::Frame>(&news)) {
    const auto guest = room.guests.find(frame->visitor);
    if (guest == room.guests.end()) return;
    if (const auto link = guest->second.link.lock()) link->send_frame(std::move(frame->frame));
  } else if (const auto* text = std::get_if<desk::Text>(&news)) {
    const auto json = std::make_shared<const std::string>(text->json);
    for (const auto& [id, guest] : room.guests) {
      if (text->control_only && room.controller != id) continue;
      if (const auto link = guest.link.lock()) link->send_text(json);
    }
  } else if (const auto* event = std::get_if<desk::Event>(&news)) {
    for (const auto& listener : room.listeners) listener->send_line(event->json);
  } else if (const auto* ended = std::get_if<desk::Ended>(&news)) {
    end(room, ended->why);
  }
}

void Lobby::end(Room& room, const std::string& why) {
  room.ended = true;
  if (options_.sessions <= 1) failure_ = why;
  room.close(CloseCode::gone, why);
  room.guests.clear();
  room.desk.reset();  // answers open questions and stops writing files
}

bool Lobby::ask(const std::string& session, DeskInput question) {
  const auto here = room(session);
  return here && here->desk->send(std::move(question));
}

bool Lobby::may_listen(const std::string& session) const {
  const auto here = room(session);
  return here && here->listeners.size() < kMostListeners;
}

void Lobby::listen(const std::string& session, const std::shared_ptr<EventLink>& link) {
  const auto here = room(session);
  here->listeners.push_back(link);
  here->desk->enable_events(true);
}

std::shared_ptr<FileRoot> Lobby::files(const std::string& session) const {
  const auto here = room(session);
  return here ? here->files : nullptr;
}

void Lobby::tick(double now) {
  for (auto& [name, here] : rooms_) {
    if (here->ended) continue;
    here->roles.tick(now);
    if (now - here->kept_alive >= kKeepAlive) {
      here->kept_alive = now;
      for (const auto& listener : here->listeners) listener->send_line("");
    }
    if (std::erase_if(here->listeners, [](const auto& l) { return !l->open(); }) > 0 &&
        here->listeners.empty())
      here->desk->enable_events(false);
    send_roles(*here);
    if (options_.sessions > 1 && here->guests.empty() && now - here->alone_since > options_.idle_limit)
      end(*here, "nobody was there for too long");
  }
  if (options_.sessions <= 1) return;
  std::erase_if(rooms_, [&](const auto& entry) {
    if (!entry.second->ended) return false;
    std::error_code ignored;
    if (!options_.keep_files) std::filesystem::remove_all(entry.second->files->folder(), ignored);
    return true;
  });
}

void Lobby::close_all(CloseCode code, const std::string& why) {
  for (auto& [name, here] : rooms_) here->close(code, why);
}

}  // namespace pabd
