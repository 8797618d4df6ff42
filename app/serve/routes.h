// SPDX-License-Identifier: MIT
// What a request asks for and whether it is allowed: all checks of HTTP in one function, without sockets.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "app/serve/gate.h"

namespace pabd {

inline constexpr std::uint64_t kMostUpload = std::uint64_t{64} << 20;
inline constexpr std::uint64_t kMostBody = std::uint64_t{1} << 20;

struct HttpRequest {
  std::string_view method, target, host, origin, authorization;
  std::string_view coding;  // Transfer-Encoding
  std::size_t hosts = 1;    // headers of that name
  bool upgrade = false;     // to a WebSocket
  bool has_body = false;
};

enum class Endpoint { page, socket, actions, state, picture, events, file_list, read_file, write_file };

struct Route {
  int status = 200;  // else `error` is the answer
  std::string error;
  Endpoint endpoint = Endpoint::page;
  std::string name;           // of a file of the page or of a visitor
  int width = 0, height = 0;  // of a picture; 0: that of the window
  bool panels = true;
  std::uint64_t most_body = 0;  // bytes
};

Route find_route(const HttpRequest& request, const Gate& gate, const AccessTokens& tokens);

// The bytes of a file of the page, which is part of the program; without data: there is none of that name.
std::string_view page_file(std::string_view name);

// "%20" → " "; nothing for malformed text.
std::optional<std::string> percent_decoded(std::string_view text);

}  // namespace pabd
