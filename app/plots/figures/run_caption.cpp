// SPDX-License-Identifier: MIT
// See run_caption.h.
#include "app/plots/figures/run_caption.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "app/plots/axis_ticks.h"
#include "sim/potential/barrier.h"

namespace pabd {

std::string run_caption(const std::string& scene, std::int64_t step, const Params& params, double kappa,
                        bool d_hat) {
  const ContactParams& contact = params.contact;
  const BarrierTraits& traits = traits_of(contact.barrier);
  std::vector<std::string> parts;
  if (!scene.empty()) parts.push_back(scene);
  parts.push_back(fmt::format("step {}", step));
  parts.push_back("h = " + format_value(params.h) + " s");
  if (contact.barrier != BarrierKind::polynomial)
    parts.push_back(std::string(to_string(contact.barrier)) + " barrier");
  if (traits.least_N > 0) parts.push_back(fmt::format("N = {}", contact.N));
  if (d_hat) parts.push_back("d̂ = " + format_value(contact.d_hat) + " m");
  parts.push_back("κ = " + format_value(kappa) + " " + kappa_unit(contact.barrier));
  if (d_hat && traits.has_onset) parts.push_back("ε = " + format_value(contact.onset));
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string onset_words(const std::vector<BarrierKind>& kinds, double onset) {
  if (std::none_of(kinds.begin(), kinds.end(), [](BarrierKind kind) { return traits_of(kind).has_onset; }))
    return "";
  return onset > 0 ? ", ε = " + format_value(onset) : ", printed formula (ε = 0)";
}

std::string parameter_text(const ParameterMember& member, double value) {
  const ParameterRow& row = parameter_of(member);
  return fmt::format("{} = {}{}{}", row.symbol, format_value(value), *row.unit ? " " : "", row.unit);
}

}  // namespace pabd
