// See read_params.h. Ranges live in check_params (sim/solver), which the panels use as well; here only types,
// whole numbers and words are checked.
#include "sim/scene/read_params.h"

#include <limits>

#include "sim/scene/keys.h"

namespace pabd {

namespace {

constexpr Range kAny{};
constexpr std::int64_t kIntLo = std::numeric_limits<int>::min(), kIntHi = std::numeric_limits<int>::max();

constexpr int value_of(auto enumerator) { return static_cast<int>(enumerator); }

constexpr Choice kMethods[] = {{"auto", value_of(SolverMethod::automatic)},
                               {"sissm", value_of(SolverMethod::sissm)},
                               {"descent", value_of(SolverMethod::descent)},
                               {"newton", value_of(SolverMethod::newton)}};
constexpr Choice kProjections[] = {{"auto", value_of(Projection::automatic)},
                                   {"polar", value_of(Projection::polar)},
                                   {"weighted", value_of(Projection::weighted)},
                                   {"tangent", value_of(Projection::tangent)}};
constexpr Choice kBarriers[] = {
#define PABD_KIND(name) {#name, value_of(BarrierKind::name)},
    PABD_BARRIERS(PABD_KIND)
#undef PABD_KIND
};

void read_solver(const ObjectReader& in, SolverParams& out) {
  out.method = static_cast<SolverMethod>(in.choice("method", kMethods, value_of(out.method)));
  out.iterations = static_cast<int>(in.integer("iterations", kIntLo, kIntHi, out.iterations));
  out.tolerance = in.number("tolerance", kAny, out.tolerance);
  out.relaxation = in.number("relaxation", kAny, out.relaxation);
  out.projection = static_cast<Projection>(in.choice("projection", kProjections, value_of(out.projection)));
}

// A number, or "auto" (empty).
std::optional<double> read_kappa(const ObjectReader& in) {
  const auto node = in.find("kappa");
  if (!node || node->is_word("auto")) {
    in.record("kappa", "auto");
    return std::nullopt;
  }
  if (!node->value().is_number()) node->fail_expected("a number above 0 or \"auto\"");
  return in.number("kappa", kAny);
}

void read_friction(const Node& node, ContactParams& out) {
  if (node.value().is_number()) {  // one number stands for both
    out.mu_static = out.mu_dynamic = node.number(kAny);
    return;
  }
  const ObjectReader in(node, keys::friction);
  if (const auto s = in.find("static")) out.mu_static = s->number(kAny);
  const auto dynamic = in.find("dynamic");
  out.mu_dynamic = dynamic ? dynamic->number(kAny) : out.mu_static;
}

void read_contact(const ObjectReader& in, ContactParams& out) {
  out.barrier = static_cast<BarrierKind>(in.choice("barrier", kBarriers, value_of(out.barrier)));
  out.N = static_cast<int>(in.integer("N", kIntLo, kIntHi, out.N));
  out.d_hat = in.number("d_hat", kAny, out.d_hat);
  out.kappa = read_kappa(in);
  out.onset = in.number("onset", kAny, out.onset);
  out.recovery_speed = in.number("recovery_speed", kAny, out.recovery_speed);
  if (const auto friction = in.find("friction")) read_friction(*friction, out);
  in.record("static", out.mu_static);
  in.record("dynamic", out.mu_dynamic);
}

}  // namespace

Params read_params(const ObjectReader& scene) {
  Params params;
  params.gravity = scene.vec3("gravity", {-1e6, 1e6, "m/s²"}, params.gravity);
  params.h = scene.number("time_step", kAny, params.h);
  with_section(scene, "solver", keys::solver,
               [&](const ObjectReader& in) { read_solver(in, params.solver); });
  with_section(scene, "contact", keys::contact,
               [&](const ObjectReader& in) { read_contact(in, params.contact); });
  if (const auto error = check_params(params)) fail_at(scene.context(), error->pointer, error->message);
  return params;
}

}  // namespace pabd
