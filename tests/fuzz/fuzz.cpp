// SPDX-License-Identifier: MIT
#include "tests/fuzz/fuzz.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <map>

namespace pabd::fuzz {

void require(bool holds, const char* property) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %s\n", property);
  std::abort();
}

void check_error(const Error& error) {
  const std::string_view what = error.what();
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; };
  const bool fits = error.kind() == ErrorKind::bad_input && !what.empty() &&
                    std::none_of(what.begin(), what.end(), is_control);
  if (!fits) std::fprintf(stderr, "kind %d: %s\n", static_cast<int>(error.kind()), error.what());
  require(fits, "a refusal is one line without control characters, of the kind of a bad input");
}

}  // namespace pabd::fuzz

namespace {

using Run = void (*)(std::string_view);

std::map<std::string, Run>& targets() {
  static std::map<std::string, Run> all;
  return all;
}
Run chosen = nullptr;

}  // namespace

pabd::fuzz::Target::Target(const char* name, Run run) { targets()[name] = run; }

// libFuzzer passes over words that begin with two dashes.
extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
  for (int i = 1; i < *argc; ++i) {
    const std::string_view word = (*argv)[i];
    if (word.starts_with("--target=")) {
      const auto found = targets().find(std::string(word.substr(9)));
      if (found != targets().end()) chosen = found->second;
    }
  }
  if (chosen) return 0;
  for (const auto& [name, run] : targets()) std::printf("%s\n", name.c_str());
  std::exit(2);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  chosen({reinterpret_cast<const char*>(data), size});
  return 0;
}
