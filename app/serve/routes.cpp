// SPDX-License-Identifier: MIT
// See routes.h.
#include "app/serve/routes.h"

#include <charconv>

#include "app/workbench/file_root.h"
#include "sim/base/utf8.h"

namespace pabd {
namespace {

constexpr int kLeastPicture = 16, kLargestPicture = 4096;  // pixels a side

Route refuse(int status, std::string why) {
  Route out;
  out.status = status;
  out.error = std::move(why);
  return out;
}

Route at(Endpoint endpoint, std::string name = {}) {
  Route out;
  out.endpoint = endpoint;
  out.name = std::move(name);
  return out;
}

std::optional<int> number(std::string_view text) {
  int value = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failure != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

Route picture(std::string_view query) {
  Route out = at(Endpoint::picture);
  while (!query.empty()) {
    const std::size_t end = std::min(query.find('&'), query.size());
    const std::string_view one = query.substr(0, end);
    query.remove_prefix(std::min(end + 1, query.size()));
    const std::size_t equals = std::min(one.find('='), one.size());
    const std::string_view key = one.substr(0, equals);
    const auto value = number(equals < one.size() ? one.substr(equals + 1) : std::string_view{});
    const bool side = value && *value >= kLeastPicture && *value <= kLargestPicture;
    if (key == "width" && side) {
      out.width = *value;
    } else if (key == "height" && side) {
      out.height = *value;
    } else if (key == "panels" && value && (*value == 0 || *value == 1)) {
      out.panels = *value == 1;
    } else {
      return refuse(400, "expected width=, height= (16 to 4096) and panels=0 or 1 in the query");
    }
  }
  return out;
}

// The endpoint, before access is checked.
Route find(const HttpRequest& request, std::string_view path, std::string_view query) {
  const bool get = request.method == "GET";
  const auto only_get = [&](Route route) { return get ? route : refuse(405, "expected GET"); };
  if (path == "/socket") {
    if (!get) return refuse(405, "expected GET");
    return request.upgrade ? at(Endpoint::socket) : refuse(426, "expected an upgrade to a WebSocket");
  }
  if (path == "/actions")
    return request.method == "POST" ? at(Endpoint::actions) : refuse(405, "expected POST");
  if (path == "/state") return only_get(at(Endpoint::state));
  if (path == "/events") return only_get(at(Endpoint::events));
  if (path == "/frame.png") return only_get(picture(query));
  if (path == "/files" || path == "/files/") return only_get(at(Endpoint::file_list));
  constexpr std::string_view kUnderFiles = "/files/";
  if (path.starts_with(kUnderFiles)) {
    if (!get && request.method != "PUT") return refuse(405, "expected GET or PUT");
    const auto name = percent_decoded(path.substr(kUnderFiles.size()));
    if (!name) return refuse(400, "the name is not well encoded");
    if (const std::string why = refusal_of_name(*name); !why.empty()) return refuse(400, why);
    return at(get ? Endpoint::read_file : Endpoint::write_file, *name);
  }
  const std::string_view file = path == "/" ? "index.html" : path.substr(1);
  if (!page_file(file).data()) return refuse(404, "there is no such page");
  return only_get(at(Endpoint::page, std::string(file)));
}

}  // namespace

std::optional<std::string> percent_decoded(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      out += text[i];
      continue;
    }
    unsigned value = 0;
    if (i + 2 >= text.size()) return std::nullopt;
    const char* const begin = text.data() + i + 1;
    const auto [end, failure] = std::from_chars(begin, begin + 2, value, 16);
    if (failure != std::errc{} || end != begin + 2) return std::nullopt;
    out += static_cast<char>(value);
    i += 2;
  }
  return out;
}

Route find_route(const HttpRequest& request, const Gate& gate, const AccessTokens& tokens) {
  if (!request.coding.empty() && lower_case(request.coding) != "chunked")
    return refuse(501, "expected no Transfer-Encoding but chunked");
  if (request.hosts != 1) return refuse(400, "expected one Host");
  if (!gate.knows_host(request.host))
    return refuse(421,
                  "this server is not called so; forward the port under its own number, or start it with "
                  "--host NAME:PORT");
  if (!request.origin.empty() && !gate.knows_origin(request.origin, request.host))
    return refuse(403, "another page's script may not ask this server");
  if (request.target.empty() || request.target.front() != '/') return refuse(400, "expected a path");
  const std::size_t mark = std::min(request.target.find('?'), request.target.size());
  const std::string_view query =
      mark < request.target.size() ? request.target.substr(mark + 1) : std::string_view{};
  Route route = find(request, request.target.substr(0, mark), query);
  if (route.status != 200) return route;
  if (route.endpoint == Endpoint::socket && request.origin.empty())
    return refuse(403, "a WebSocket needs the Origin of the page");
  const bool open = route.endpoint == Endpoint::page || route.endpoint == Endpoint::socket;
  if (!open) {
    const Access access = tokens.access(bearer_token(request.authorization));
    if (access == Access::none)
      return refuse(401, "expected 'Authorization: Bearer TOKEN' with the 32 digits behind #k= of the link");
    const bool writes = route.endpoint == Endpoint::actions || route.endpoint == Endpoint::write_file;
    if (writes && access != Access::control) return refuse(403, "this link is for watching only");
  }
  if (route.endpoint == Endpoint::actions) route.most_body = kMostBody;
  if (route.endpoint == Endpoint::write_file) route.most_body = kMostUpload;
  if (route.most_body == 0 && request.has_body) return refuse(400, "expected no body");
  return route;
}

}  // namespace pabd
