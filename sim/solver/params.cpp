#include "sim/solver/params.h"

#include <fmt/format.h>

#include <cmath>

namespace pabd {
namespace {

bool inside(double x, double lo, double hi) { return std::isfinite(x) && x >= lo && x <= hi; }

std::optional<ParamError> expect(bool ok, const char* pointer, double value, const char* expected) {
  if (ok) return std::nullopt;
  return ParamError{pointer, fmt::format("{} is out of range: expected {}", value, expected)};
}

std::optional<ParamError> check_solver(const SolverParams& s) {
  if (auto e = expect(s.iterations >= 1 && s.iterations <= 100000, "/solver/iterations", s.iterations,
                      "a whole number from 1 to 100000"))
    return e;
  if (auto e = expect(inside(s.tolerance, 0, 1), "/solver/tolerance", s.tolerance, "a number from 0 to 1"))
    return e;
  if (auto e = expect(inside(s.relaxation, 0, 1) && s.relaxation > 0, "/solver/relaxation", s.relaxation,
                      "a number above 0 and up to 1"))
    return e;
  if (s.method == SolverMethod::sissm && s.projection == Projection::tangent)
    return ParamError{"/solver/projection",
                      "\"tangent\" belongs to \"descent\": sissm takes \"polar\" or \"weighted\""};
  return std::nullopt;
}

std::optional<ParamError> check_contact(const ContactParams& c) {
  if (auto e = expect(c.N >= 1 && c.N <= kMaxOrder, "/contact/N", c.N, "a whole number from 1 to 32"))
    return e;
  if (c.N < traits_of(c.barrier).least_N)
    return ParamError{"/contact/N", std::string("1 leaves the ") + to_string(c.barrier) +
                                        " barrier without a term: expected 2 to 32"};
  if (auto e = expect(inside(c.d_hat, 1e-9, 1e3), "/contact/d_hat", c.d_hat,
                      "a thickness from 1e-9 to 1000 (metres)"))
    return e;
  if (c.kappa) {
    if (auto e = expect(inside(*c.kappa, 1e-12, 1e18), "/contact/kappa", *c.kappa,
                        "\"auto\" or a stiffness from 1e-12 to 1e18 (joules)"))
      return e;
  }
  if (auto e = expect(inside(c.onset, 0, 1) && c.onset < 1, "/contact/onset", c.onset,
                      "a width from 0 to below 1"))
    return e;
  if (auto e = expect(inside(c.recovery_speed, 0, 1e6), "/contact/recovery_speed", c.recovery_speed,
                      "a speed from 0 (no limit) to 1e6 (m/s)"))
    return e;
  if (auto e = expect(inside(c.mu_static, 0, 100), "/contact/friction/static", c.mu_static,
                      "a coefficient from 0 to 100"))
    return e;
  if (auto e = expect(inside(c.mu_dynamic, 0, 100), "/contact/friction/dynamic", c.mu_dynamic,
                      "a coefficient from 0 to 100"))
    return e;
  return expect(c.mu_dynamic <= c.mu_static, "/contact/friction/dynamic", c.mu_dynamic,
                "a coefficient not above the static one");
}

}  // namespace

std::optional<ParamError> check_params(const Params& params) {
  for (int k = 0; k < 3; ++k) {
    if (!inside(params.gravity[k], -1e6, 1e6))
      return ParamError{fmt::format("/gravity/{}", k),
                        fmt::format("{} is out of range: expected -1e6 to 1e6 (m/s²)", params.gravity[k])};
  }
  if (auto e = expect(inside(params.h, 1e-6, 1), "/time_step", params.h, "a step from 1e-6 to 1 (seconds)"))
    return e;
  if (auto e = check_solver(params.solver)) return e;
  return check_contact(params.contact);
}

const char* to_string(SolverMethod method) {
  switch (method) {
    case SolverMethod::sissm:
      return "sissm";
    case SolverMethod::descent:
      return "descent";
    case SolverMethod::newton:
      return "newton";
    case SolverMethod::automatic:
      return "auto";
  }
  return "?";
}

const char* to_string(Projection projection) {
  switch (projection) {
    case Projection::automatic:
      return "auto";
    case Projection::polar:
      return "polar";
    case Projection::weighted:
      return "weighted";
    case Projection::tangent:
      return "tangent";
  }
  return "?";
}

}  // namespace pabd
