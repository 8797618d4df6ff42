// SPDX-License-Identifier: MIT
// See collect_table.h.
#include "app/sweep/collect_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>

#include "sim/base/utf8.h"

namespace pabd {
namespace {

std::string field(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? "\"\"" : std::string(1, c);
  return out + '"';
}

// Code points.
std::u32string characters_of(const std::string& text) {
  std::u32string out;
  for (std::size_t i = 0; i < text.size();) out += next_character(text, i);
  return out;
}

template <class Number>
std::string field(const std::optional<Number>& number) {
  return number ? fmt::format("{}", *number) : std::string();
}

// A column of a structured array: its name, its type as NumPy writes it, and the bytes of a row.
struct Column {
  std::string name, type;
  std::function<void(const SweptTask& task, std::string& out)> put;
};

void put_word(std::uint64_t word, int bytes, std::string& out) {
  for (int i = 0; i < bytes; ++i) out += static_cast<char>(static_cast<unsigned char>(word >> (8 * i)));
}

Column whole(const char* name, std::function<std::int64_t(const SweptTask&)> value) {
  return {name, "<i8", [value](const SweptTask& task, std::string& out) {
            put_word(static_cast<std::uint64_t>(value(task)), 8, out);
          }};
}

Column real(const std::string& name, std::function<std::optional<double>(const SweptTask&)> value) {
  return {name, "<f8", [value](const SweptTask& task, std::string& out) {
            put_word(
                std::bit_cast<std::uint64_t>(value(task).value_or(std::numeric_limits<double>::quiet_NaN())),
                8, out);
          }};
}

// Width: the longest text.
Column text(const CollectedSweep& sweep, const std::string& name,
            std::function<std::string(const SweptTask&)> value) {
  std::size_t longest = 1;
  for (const SweptTask& task : sweep.tasks) longest = std::max(longest, characters_of(value(task)).size());
  return {name, fmt::format("<U{}", longest), [value, longest](const SweptTask& task, std::string& out) {
            std::u32string characters = characters_of(value(task));
            characters.resize(longest);
            for (const char32_t c : characters) put_word(c, 4, out);
          }};
}

std::vector<Column> table_columns_of(const CollectedSweep& sweep) {
  std::vector<Column> columns;
  columns.push_back(whole("index", [](const SweptTask& t) { return t.index; }));
  columns.push_back(text(sweep, "hash", [](const SweptTask& t) { return t.hash; }));
  for (std::size_t p = 0; p < sweep.parameters.size(); ++p) {
    const bool words = std::any_of(sweep.tasks.begin(), sweep.tasks.end(), [&](const SweptTask& t) {
      return !t.parameters[p].absent() && !t.parameters[p].number;
    });
    const std::string& key = sweep.parameters[p].key;
    columns.push_back(words ? text(sweep, key, [p](const SweptTask& t) { return t.parameters[p].text; })
                            : real(key, [p](const SweptTask& t) { return t.parameters[p].number; }));
  }
  columns.push_back(
      text(sweep, "status", [](const SweptTask& t) { return std::string(status_word(t.status)); }));
  for (std::size_t m = 0; m < sweep.metrics.size(); ++m)
    columns.push_back(real(sweep.metrics[m].key, [m](const SweptTask& t) { return t.metrics[m]; }));
  columns.push_back(whole("step", [](const SweptTask& t) { return t.step.value_or(-1); }));
  columns.push_back(real("time", [](const SweptTask& t) { return t.time; }));
  return columns;
}

// A text in Python's quotes, ASCII only.
std::string python_text(const std::string& text) {
  std::string out = "'";
  for (const char32_t c : characters_of(text)) {
    if (c == U'\'' || c == U'\\') out += '\\';
    if (c >= 0x20 && c < 0x7F) {
      out += static_cast<char>(c);
    } else {
      out += fmt::format("\\U{:08x}", static_cast<std::uint32_t>(c));
    }
  }
  return out + "'";
}

// Names of columns differ: a parameter may be called "status".
void make_unique(std::vector<Column>& columns) {
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const auto taken = [&](const std::string& name) {
      return std::any_of(columns.begin(), columns.end(),
                         [&](const Column& c) { return &c != &columns[i] && c.name == name; });
    };
    while (taken(columns[i].name)) columns[i].name += "_";
  }
}

}  // namespace

std::string table_csv(const CollectedSweep& sweep) {
  std::string out = "index,hash";
  for (const SweptQuantity& p : sweep.parameters) out += ',' + field(p.key);
  out += ",status";
  for (const SweptQuantity& m : sweep.metrics) out += ',' + field(m.key);
  out += ",step,time\n";
  for (const SweptTask& task : sweep.tasks) {
    out += (task.index < 0 ? "" : std::to_string(task.index)) + ',' + task.hash;
    for (const SweptValue& value : task.parameters) out += ',' + field(value.text);
    out += ',' + std::string(status_word(task.status));
    for (const auto& metric : task.metrics) out += ',' + field(metric);
    out += ',' + field(task.step) + ',' + field(task.time) + '\n';
  }
  return out;
}

std::string table_jsonl(const CollectedSweep& sweep) {
  std::string out;
  for (const SweptTask& task : sweep.tasks) {
    nlohmann::ordered_json row = nlohmann::ordered_json::object();
    if (task.index >= 0) row["index"] = task.index;
    row["hash"] = task.hash;
    auto& parameters = row["parameters"] = nlohmann::ordered_json::object();
    for (std::size_t p = 0; p < sweep.parameters.size(); ++p) {
      const SweptValue& value = task.parameters[p];
      if (value.absent()) continue;
      auto& place = parameters[sweep.parameters[p].key];
      const auto json = nlohmann::ordered_json::parse(value.text, nullptr, false);
      if (value.number) {
        place = *value.number;
      } else if (json.is_discarded()) {
        place = value.text;
      } else {
        place = json;
      }
    }
    row["status"] = status_word(task.status);
    if (!task.why.empty()) row["why"] = task.why;
    if (!task.faults.empty()) row["faults"] = task.faults;
    auto& metrics = row["metrics"] = nlohmann::ordered_json::object();
    for (std::size_t m = 0; m < sweep.metrics.size(); ++m) {
      if (task.metrics[m]) metrics[sweep.metrics[m].key] = *task.metrics[m];
    }
    if (task.step) row["step"] = *task.step;
    if (task.time) row["time"] = *task.time;
    out += row.dump() + '\n';
  }
  return out;
}

std::string table_npy(const CollectedSweep& sweep) {
  std::vector<Column> columns = table_columns_of(sweep);
  make_unique(columns);
  std::string header = "{'descr': [";
  for (const Column& column : columns)
    header += fmt::format("({}, '{}'), ", python_text(column.name), column.type);
  header += fmt::format("], 'fortran_order': False, 'shape': ({},), }}", sweep.tasks.size());
  // The data begins at a multiple of 64 bytes.
  const std::size_t before = 10;
  header.append(63 - (before + header.size()) % 64, ' ');
  header += '\n';
  std::string out = "\x93NUMPY";
  out += '\x01';
  out += '\0';
  put_word(header.size(), 2, out);
  out += header;
  for (const SweptTask& task : sweep.tasks) {
    for (const Column& column : columns) column.put(task, out);
  }
  return out;
}

std::string timing_csv(const CollectedSweep& sweep) {
  std::string out = "index,hash,seconds,threads,step_time\n";
  for (const SweptTask& task : sweep.tasks) {
    if (!task.timing) continue;
    out += fmt::format("{},{},{},{},{}\n", task.index < 0 ? "" : std::to_string(task.index), task.hash,
                       task.timing->seconds, task.timing->threads, field(task.timing->step_time));
  }
  return out;
}

}  // namespace pabd
