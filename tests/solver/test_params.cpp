// SPDX-License-Identifier: MIT
// Every parameter has limits, and a message that names the place.

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

#include "sim/solver/parameter_table.h"
#include "tests/support/scenario.h"

namespace pabd::test_params {

namespace {

// Is only asked what it converts to.
struct Anything {
  template <class Type>
  operator Type() const {
    throw this;
  }
};

// How many members an aggregate has: as many as it can be made of.
template <class Struct, class... Made>
constexpr std::size_t members() {
  if constexpr (requires { Struct{Made{}..., Anything{}}; }) {
    return members<Struct, Made..., Anything>();
  } else {
    return sizeof...(Made);
  }
}

}  // namespace

TEST_CASE("every member of the parameters has a row in their table") {
  struct Three {
    std::optional<double> a;
    int b;
    Vec3 c;
  };
  CHECK(members<Three>() == 3);
  constexpr std::size_t kSections = 2;
  CHECK(parameter_table().size() ==
        members<Params>() - kSections + members<SolverParams>() + members<ContactParams>());
}

TEST_CASE("parameters out of range are refused with their JSON pointer") {
  struct Case {
    const char* pointer;
    std::function<void(Params&)> spoil;
  };
  const double nan = std::nan("");
  const std::vector<Case> cases = {
      {"/gravity/1", [&](Params& p) { p.gravity.y() = nan; }},
      {"/time_step", [](Params& p) { p.h = 0; }},
      {"/time_step", [](Params& p) { p.h = -0.01; }},
      {"/time_step", [&](Params& p) { p.h = nan; }},
      {"/solver/iterations", [](Params& p) { p.solver.iterations = 0; }},
      {"/solver/tolerance", [](Params& p) { p.solver.tolerance = -1; }},
      {"/solver/relaxation", [](Params& p) { p.solver.relaxation = 0; }},
      {"/solver/projection",
       [](Params& p) {
         p.solver.method = SolverMethod::sissm;
         p.solver.projection = Projection::tangent;
       }},
      {"/contact/N", [](Params& p) { p.contact.N = 0; }},
      {"/contact/N", [](Params& p) { p.contact.N = kMaxOrder + 1; }},
      {"/contact/N",
       [](Params& p) {
         p.contact.barrier = BarrierKind::even;
         p.contact.N = 1;
       }},
      {"/contact/d_hat", [](Params& p) { p.contact.d_hat = 0; }},
      {"/contact/d_hat", [](Params& p) { p.contact.d_hat = -1; }},
      {"/contact/kappa", [](Params& p) { p.contact.kappa = 0; }},
      {"/contact/kappa", [](Params& p) { p.contact.kappa = INFINITY; }},
      {"/contact/onset", [](Params& p) { p.contact.onset = 1; }},
      {"/contact/friction/static", [](Params& p) { p.contact.mu_static = -0.1; }},
      {"/contact/friction/dynamic", [](Params& p) { p.contact.mu_dynamic = 0.9; }},
  };
  CHECK_FALSE(check_params(Params{}).has_value());
  for (const Case& c : cases) {
    Params params;
    c.spoil(params);
    const auto error = check_params(params);
    INFO(c.pointer);
    REQUIRE(error.has_value());
    CHECK(error->pointer == c.pointer);
    CHECK(error->message.size() > 10);
  }
}

TEST_CASE("κ auto: ten times the heaviest weight rests on four contacts at 0.9 d̂") {
  for (const BarrierKind kind : {BarrierKind::polynomial, BarrierKind::even, BarrierKind::log}) {
    testing::World world;
    world.params.contact.barrier = kind;
    world.params.contact.N = 4;
    world.add_ground();
    world.add_cube(1, 70, {0, 1, 0});
    world.add_cube(1, 700, {0, 3, 0});
    const ContactParams& c = world.params.contact;
    const Barrier barrier{c.barrier, c.N, c.d_hat, resolve_kappa(world.model, world.params), c.onset};
    CHECK(-4 * evaluate(barrier, 0.9 * c.d_hat).first == Approx(10 * 700 * 9.81).epsilon(1e-12));
    world.params.gravity.setZero();
    CHECK(resolve_kappa(world.model, world.params) == Approx(barrier.kappa).epsilon(1e-12));
    world.params.contact.kappa = 3.5;
    CHECK(resolve_kappa(world.model, world.params) == 3.5);
  }
}

TEST_CASE("κ auto carries all bodies, but no more than a hundred of the heaviest") {
  const auto carried = [](testing::World& world) {  // by four contacts at 0.9 d̂, in kg
    const ContactParams& c = world.params.contact;
    const Barrier barrier{c.barrier, c.N, c.d_hat, resolve_kappa(world.model, world.params), c.onset};
    return -4 * evaluate(barrier, 0.9 * c.d_hat).first / world.params.gravity.norm();
  };
  testing::World world;
  world.add_ground();
  for (int k = 0; k < 60; ++k) world.add_cube(0.3, k % 2 == 0 ? 2 : 40, {0, 0.4 * k, 0});
  CHECK(carried(world) == Approx(30 * 42).epsilon(1e-12));
  for (int k = 0; k < 300; ++k) world.add_cube(0.3, 40, {2, 0.4 * k, 0});
  CHECK(carried(world) == Approx(100 * 40).epsilon(1e-12));
  world.add_cube(3, 5000, {1e5, 2, 0});  // as stiff as this one by itself needs
  CHECK(carried(world) == Approx(10 * 5000).epsilon(1e-12));
  // Dust: the load of many would be too stiff for it, that of a heavy one is not.
  testing::World dusty;
  dusty.add_ground();
  for (int k = 0; k < 80; ++k) dusty.add_cube(1, 1e6, {0, 1.1 * k, 0});
  dusty.add_cube(0.01, 1e-4, {5, 1, 0});
  CHECK(carried(dusty) < 40 * 1e6);
  CHECK(carried(dusty) >= Approx(10 * 1e6));
}

}  // namespace pabd::test_params
