// SPDX-License-Identifier: MIT
// No shipped scene makes the program warn of it.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>

#include "app/session/contact_advice.h"
#include "app/session/session.h"
#include "tests/support/places.h"
#include "tests/support/sanitized.h"

namespace pabd::test_shipped_advice {

namespace {

// All of a scene's duration where that is quick: the pile and the cradle would take a minute.
std::int64_t steps_of(const Scene& scene) {
#ifdef PABD_SANITIZED
  constexpr double kMostSteps = 100,
                   kMostWork = 2e4;  // bodies × steps: it is the memory that is looked at then
#else
  constexpr double kMostSteps = 6000, kMostWork = 1.2e6;
#endif
  const double all = *scene.duration / scene.params.h;
  return static_cast<std::int64_t>(
      std::min({all, kMostSteps, kMostWork / static_cast<double>(scene.model.size())}));
}

}  // namespace

TEST_CASE("no step of a shipped scene ends at the iteration limit, overlaps or breaks Coulomb's law") {
  int scenes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(places::scenes())) {
    if (entry.path().extension() != ".json") continue;
    const std::string name = entry.path().stem();
    INFO(name);
    ++scenes;
    Session session(load_scene(entry.path()));
    REQUIRE(session.scene().duration.has_value());
    session.record_iterations(true);
    session.report_contacts(true);
    const std::int64_t steps = steps_of(session.scene());
    int warned = 0;
    std::string first;
    std::vector<StepSummary> past;
    for (std::int64_t k = 0; k < steps; ++k) {
      session.step();
      past.push_back(session.report());
      for (const Advice& advice :
           contact_advice(session.model(), session.params(), session.state(), session.report(), past)) {
        // Within the first steps everything that touches may be pressed in; two boxes start in each other.
        if (advice.kind == AdviceKind::pressed_past_onset) continue;
        if (name == "two_boxes" && advice.kind == AdviceKind::overlap) continue;
        if (warned++ == 0) first = "step " + std::to_string(k + 1) + ": " + advice.what;
      }
    }
    INFO(first);
    CHECK(warned == 0);
  }
  CHECK(scenes > 25);
}

}  // namespace pabd::test_shipped_advice
