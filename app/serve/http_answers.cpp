// SPDX-License-Identifier: MIT
// Answers of HTTP, with what each says to a browser: see net.h.
#include "app/serve/net.h"

namespace pabd::net {

void set_headers(const Shared& shared, http::fields& answer) {
  const std::string& embed = shared.options.embed;
  answer.set(
      "Content-Security-Policy",
      "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' blob: data:; connect-src "
      "'self'; frame-ancestors " +
          (embed.empty() ? std::string("'none'") : "'self' " + embed) +
          "; base-uri 'none'; form-action 'none'");
  answer.set("X-Content-Type-Options", "nosniff");
  answer.set("Referrer-Policy", "no-referrer");
  answer.set(http::field::cache_control, "no-store");
  if (embed.empty()) {
    answer.set("Cross-Origin-Opener-Policy", "same-origin");
    answer.set("Cross-Origin-Resource-Policy", "same-origin");
  }
}

TextAnswer text_answer(const Shared& shared, int status, const std::string& type, std::string body) {
  TextAnswer out(static_cast<http::status>(status), 11);
  set_headers(shared, out);
  out.set(http::field::content_type, type);
  if (status == 401) out.set(http::field::www_authenticate, "Bearer");
  if (status == 426) out.set(http::field::upgrade, "websocket");
  out.body() = std::move(body);
  return out;
}

TextAnswer json_answer(const Shared& shared, int status, const OrderedJson& json) {
  return text_answer(shared, status, "application/json", json_line(json) + "\n");
}

TextAnswer page_answer(const Shared& shared, const std::string& name) {
  const char* const type = name.ends_with(".html")  ? "text/html; charset=utf-8"
                           : name.ends_with(".css") ? "text/css; charset=utf-8"
                           : name.ends_with(".js")  ? "text/javascript; charset=utf-8"
                                                    : "image/svg+xml";
  return text_answer(shared, 200, type, std::string(page_file(name)));
}

}  // namespace pabd::net
