// Parameters in words.
#include "app/overlay/parameter_words.h"

#include <fmt/format.h>

#include <cstdlib>

#include "app/plots/axis_ticks.h"
#include "sim/scene/tuning.h"

namespace pabd {
namespace {

struct Word {
  const char* key;  // of the scene
  const char* symbol;
  const char* unit;  // with the space before it
};

constexpr Word kWords[] = {
    {"gravity", "*{g}", " m/s²"},
    {"time_step", "*{h}", " s"},
    {"solver.method", "solver", ""},
    {"contact.d_hat", "*{d̂}", " m"},
    {"contact.onset", "*{ε}", ""},
    {"contact.N", "*{N}", ""},
    {"contact.friction.static", "*{μ}_{static}", ""},
    {"contact.friction.dynamic", "*{μ}_{dynamic}", ""},
};

std::string kappa_words(const Params& params, double kappa) {
  return format_value(kappa) + " " + kappa_unit(params.contact.barrier) +
         (params.contact.kappa ? "" : " (auto)");
}

// A number for people; anything else as --set takes it.
std::string value_words(const Params& params, const std::string& key) {
  if (key == "gravity") {
    return fmt::format("({}, {}, {})", format_value(params.gravity.x()), format_value(params.gravity.y()),
                       format_value(params.gravity.z()));
  }
  const std::string text = tuned_value(params, key);
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  return !text.empty() && end && *end == '\0' ? format_value(number) : text;
}

}  // namespace

std::vector<std::string> difference_words(const Params& a, double kappa_a, const Params& b, double kappa_b) {
  std::vector<std::string> lines;
  for (const auto& [key, value] : differences(a, b)) {
    if (key == "contact.kappa") {
      // The unit once, unless the barrier changes it.
      std::string from = kappa_words(a, kappa_a);
      const bool same = traits_of(a.contact.barrier).per_area == traits_of(b.contact.barrier).per_area;
      if (same && a.contact.kappa) from = format_value(kappa_a);
      lines.push_back("*{κ} " + from + " → " + kappa_words(b, kappa_b));
      continue;
    }
    // "solver.iterations" is "iterations" where nothing shorter is known.
    std::string symbol = key.substr(key.rfind('.') + 1), unit;
    for (const Word& word : kWords) {
      if (key != word.key) continue;
      symbol = word.symbol;
      unit = word.unit;
    }
    lines.push_back(fmt::format("{} {} → {}{}", symbol, value_words(a, key), value_words(b, key), unit));
  }
  if (!a.contact.kappa && !b.contact.kappa && kappa_a != kappa_b) {  // it follows d̂, N, …
    lines.push_back("*{κ} " + format_value(kappa_a) + " → " + kappa_words(b, kappa_b));
  }
  return lines;
}

}  // namespace pabd
