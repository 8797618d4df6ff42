// SPDX-License-Identifier: MIT
// Answers of HTTP, with what every one of them says to a browser.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/serve/net.h"

namespace pabd::net {

// What a browser may do with an answer: nothing that is not from here, no frame but that of --embed.
void set_headers(const Shared& shared, http::fields& answer);

using TextAnswer = http::response<http::string_body>;
TextAnswer text_answer(const Shared& shared, int status, const std::string& type, std::string body);
TextAnswer json_answer(const Shared& shared, int status, const nlohmann::ordered_json& json);
TextAnswer page_answer(const Shared& shared, const std::string& name);  // of a file of the page

}  // namespace pabd::net
