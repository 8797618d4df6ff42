// SPDX-License-Identifier: MIT
// A device that gives way to the processor.
#include <catch2/catch.hpp>

#include "app/session/session.h"
#include "app/session/yielding_engine.h"
#include "tests/support/drift_device.h"
#include "tests/support/tiny_model.h"

namespace pabd::test_yielding_engine {

TEST_CASE("where a device cannot go on the processor does, from there on, and that is told once") {
  TinyModel tiny;
  tiny.add(Sphere{0.5}, Vec3(0, 10, 0));
  auto scene = std::make_shared<Scene>();
  scene->model = tiny.model;
  scene->initial = tiny.state;
  const auto drift = std::make_shared<test::DriftEngine>();
  drift->lost_after = 3;
  std::vector<std::string> told;
  Session session(std::shared_ptr<const Scene>{scene});
  session.solve_with(
      std::make_shared<YieldingEngine>(drift, [&](const std::string& why) { told.push_back(why); }));
  for (int k = 0; k < 3; ++k) session.step();
  CHECK(session.state().c[0].y() == 10);
  CHECK(told.empty());
  for (int k = 0; k < 3; ++k) session.step();
  CHECK(told == std::vector<std::string>{"drift: lost"});
  CHECK(drift->steps == 3);
  CHECK(session.state().step == 6);
  const double h = session.params().h;
  CHECK(session.state().c[0].y() == Approx(10 - 0.5 * 9.81 * 9 * h * h).epsilon(1e-12));  // three steps of it
}

}  // namespace pabd::test_yielding_engine
