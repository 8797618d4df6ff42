// SPDX-License-Identifier: MIT
// See document.h. The parser calls back for each value (it does not recurse), and the document is built here.
#include "sim/scene/document.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "sim/base/error.h"
#include "sim/base/utf8.h"
#include "sim/scene/text.h"

namespace pabd {

namespace {

class DocumentBuilder : public nlohmann::json_sax<Json> {
 public:
  DocumentBuilder(const std::string& text, const std::string& source, const DocumentLimits& limits)
      : text_(text), source_(source), limits_(limits) {}

  Json take() { return std::move(root_); }

  bool null() override { return add(Json(nullptr)); }
  bool boolean(bool value) override { return add(Json(value)); }
  bool number_integer(number_integer_t value) override { return add(Json(value)); }
  bool number_unsigned(number_unsigned_t value) override { return add(Json(value)); }
  bool number_float(number_float_t value, const string_t&) override { return add(Json(value)); }
  bool string(string_t& value) override { return add(Json(std::move(value))); }
  bool binary(binary_t&) override { return false; }  // not in JSON text

  bool start_object(std::size_t) override { return open(Json::object()); }
  bool start_array(std::size_t) override { return open(Json::array()); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(string_t& value) override {
    if (stack_.back()->contains(value)) {
      refuse(fmt::format("{}/{}: the key appears twice in this object; keep one of them", pointer(),
                         printable(value)));
    }
    keys_.back() = value;
    return true;
  }

  bool parse_error(std::size_t position, const std::string& last_token,
                   const Json::exception& error) override {
    if (error.id == 406) {
      refuse(fmt::format("{}: the number {} is out of range; expected a finite number", place(position),
                         printable(last_token)));
    }
    // Keep what the library says about the token, drop its error numbers and its own idea of the place.
    std::string reason = error.what();
    const std::string lead = ": syntax error ";
    if (const auto at = reason.find(lead); at != std::string::npos) reason = reason.substr(at + lead.size());
    if (reason.size() > 160) reason = std::string(first_bytes(reason, 160)) + "...";
    refuse(fmt::format("{}: not valid JSON: {}", place(position), reason));
  }

 private:
  [[noreturn]] void refuse(const std::string& why) const { throw Error(ErrorKind::bad_input, source_, why); }

  bool add(Json value) {
    if (++values_ > limits_.values) {
      refuse(fmt::format("more than {} values; expected a smaller file, use \"generate\"", limits_.values));
    }
    last_ = put(std::move(value));
    return true;
  }

  Json* put(Json value) {
    if (stack_.empty()) {
      root_ = std::move(value);
      return &root_;
    }
    Json& parent = *stack_.back();
    if (parent.is_array()) {
      parent.push_back(std::move(value));
      return &parent.back();
    }
    return &(parent[keys_.back()] = std::move(value));
  }

  bool open(Json container) {
    if (static_cast<int>(stack_.size()) >= limits_.depth) {
      refuse(
          fmt::format("{}: nested deeper than {} levels; expected a flatter file", pointer(), limits_.depth));
    }
    add(std::move(container));
    stack_.push_back(last_);
    keys_.emplace_back();
    return true;
  }

  bool close() {
    stack_.pop_back();
    keys_.pop_back();
    return true;
  }

  // JSON pointer of the innermost open array or object.
  std::string pointer() const {
    std::string out;
    for (std::size_t i = 0; i + 1 < stack_.size(); ++i) {
      out += '/';
      out += stack_[i]->is_array() ? std::to_string(stack_[i]->size() - 1) : printable(keys_[i]);
    }
    return out;
  }

  std::string place(std::size_t position) const {  // position counts from 1; 0 when nothing was read
    const auto end =
        text_.begin() + static_cast<std::ptrdiff_t>(std::min(position > 0 ? position - 1 : 0, text_.size()));
    const auto line = 1 + std::count(text_.begin(), end, '\n');
    auto start = end;
    while (start != text_.begin() && *(start - 1) != '\n') --start;
    return fmt::format("line {}, column {}", line, 1 + (end - start));
  }

  const std::string& text_;
  const std::string& source_;
  const DocumentLimits limits_;
  std::size_t values_ = 0;
  Json root_;
  Json* last_ = nullptr;
  std::vector<Json*> stack_;       // open containers; one of them grows only after its children are closed
  std::vector<std::string> keys_;  // the current key of each
};

}  // namespace

Json parse_document(const std::string& text, const std::string& source, const DocumentLimits& limits) {
  if (text.size() > limits.bytes) {
    throw Error(ErrorKind::bad_input, source,
                fmt::format("longer than {} bytes; expected a smaller file, use \"generate\"", limits.bytes));
  }
  DocumentBuilder builder(text, source, limits);
  Json::sax_parse(text, &builder);
  return builder.take();
}

}  // namespace pabd
