// SPDX-License-Identifier: MIT
#include "sim/solver/params.h"

#include <fmt/format.h>

#include <cmath>

#include "sim/solver/parameter_table.h"

namespace pabd {
namespace {

std::optional<ParamError> check_row(const ParameterRow& row, const Params& params) {
  const auto check = [&](double x, const std::string& pointer) -> std::optional<ParamError> {
    if (std::isfinite(x) && row.range.contains(x)) return std::nullopt;
    return ParamError{pointer, fmt::format("{} is out of range: expected {}", x, expected_of(row))};
  };
  const ParameterValue value = value_of(row, params);
  if (const auto* v = std::get_if<Vec3>(&value)) {
    for (int k = 0; k < 3; ++k) {
      if (auto e = check((*v)[k], fmt::format("{}/{}", pointer_of(row.key), k))) return e;
    }
  }
  if (const auto x = as_number(value)) return check(*x, pointer_of(row.key));
  return std::nullopt;
}

// What one parameter asks of another.
std::optional<ParamError> check_together(const Params& params) {
  const SolverParams& s = params.solver;
  const ContactParams& c = params.contact;
  if (s.method == SolverMethod::sissm && s.projection == Projection::tangent)
    return ParamError{"/solver/projection",
                      "\"tangent\" belongs to \"descent\": sissm takes \"polar\" or \"weighted\""};
  if (c.N < traits_of(c.barrier).least_N)
    return ParamError{"/contact/N", std::string("1 leaves the ") + to_string(c.barrier) +
                                        " barrier without a term: expected 2 to 32"};
  if (!(c.mu_dynamic <= c.mu_static))
    return ParamError{
        "/contact/friction/dynamic",
        fmt::format("{} is out of range: expected a coefficient from 0 to {}, not above the static one",
                    c.mu_dynamic, c.mu_static)};
  return std::nullopt;
}

}  // namespace

std::optional<ParamError> check_params(const Params& params, ParameterTable table) {
  for (const ParameterRow& row : table) {
    if (auto e = check_row(row, params)) return e;
  }
  return check_together(params);
}

std::optional<ParamError> check_params(const Params& params) {
  return check_params(params, parameter_table());
}

const char* to_string(SolverMethod method) {
  static constexpr const char* kWords[] = {"sissm", "descent", "newton", "auto"};
  return kWords[static_cast<std::size_t>(method)];
}

const char* to_string(Projection projection) {
  static constexpr const char* kWords[] = {"auto", "polar", "weighted", "tangent"};
  return kWords[static_cast<std::size_t>(projection)];
}

const char* to_string(Integrator integrator) {
  static constexpr const char* kWords[] = {"euler", "bdf2"};
  return kWords[static_cast<std::size_t>(integrator)];
}

const char* to_string(SolverDevice device) {
  static constexpr const char* kWords[] = {"cpu", "gpu", "auto"};
  return kWords[static_cast<std::size_t>(device)];
}

}  // namespace pabd
