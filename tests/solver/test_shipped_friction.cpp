// SPDX-License-Identifier: MIT
// Coulomb's law ‖f_t‖ ≤ μ f_n in every step that says it converged: all shipped scenes, every solver. With the default
// parameters also where hits come thick, and more iterations than usual are needed.

#include <catch2/catch.hpp>
#include <filesystem>
#include <map>

#include "sim/body/mass_properties.h"
#include "sim/scene/scene.h"
#include "sim/solver/time_step.h"
#include "tests/support/places.h"
#include "tests/support/sanitized.h"

namespace pabd::test_shipped_friction {

namespace {

struct Seen {
  long contacts = 0;  // loaded, in converged steps
  double excess = 0;  // the largest
};

void watch(const Scene& scene, const StepReport& report, Seen& seen) {
  if (report.status != StepStatus::converged) return;
  const double least = 1e-3 * movable_mass(scene.model).heaviest * scene.params.gravity.norm();
  for (const ContactReport& c : report.contact_reports) {
    if (c.normal_force < least || c.mu == 0) continue;
    ++seen.contacts;
    seen.excess = std::max(seen.excess, c.friction.norm() / (c.mu * c.normal_force) - 1);
  }
}

#ifdef PABD_SANITIZED
constexpr int kSteps = 15, kStepsOfMany = 4;  // it is the memory that is looked at then
constexpr long kLeastContacts = 500;
#else
// The end of the first second and a half is where things have met; a step of many bodies is dear.
constexpr int kSteps = 90, kStepsOfMany = 12;
constexpr long kLeastContacts = 4000;
#endif

int steps_for(const Scene& scene) { return scene.model.size() > 60 ? kStepsOfMany : kSteps; }

}  // namespace

TEST_CASE("no converged step of a shipped scene breaks Coulomb's law by over 1 %, with any solver") {
  std::map<SolverMethod, Seen> all;
  for (const auto& entry : std::filesystem::directory_iterator(places::assets() + "/scenes")) {
    if (entry.path().extension() != ".json") continue;
    Scene scene = load_scene(entry.path());
    for (const SolverMethod method :
         {SolverMethod::automatic, SolverMethod::newton, SolverMethod::descent, SolverMethod::sissm}) {
      INFO(entry.path().stem() << " with " << to_string(method));
      scene.params.solver.method = method;
      if (method == SolverMethod::sissm) scene.params.solver.projection = Projection::weighted;
      State state = scene.initial;
      StepWorkspace workspace;
      StepReport report;
      StepOptions options;
      options.report_contacts = true;
      Seen seen;
      for (int k = 0; k < steps_for(scene); ++k) {
        step(scene.model, scene.params, options, state, workspace, report);
        if (report.status == StepStatus::non_finite) break;
        watch(scene, report, seen);
        if (report.status == StepStatus::converged) CHECK(report.friction_excess <= 0.01);
      }
      CHECK(seen.excess <= 0.01);
      all[method].contacts += seen.contacts;
    }
  }
  for (const auto& [method, seen] : all) {
    INFO(to_string(method));
    CHECK(seen.contacts > kLeastContacts);
  }
}

TEST_CASE("with the defaults hundreds of hits a second keep Coulomb's law, in halved steps too") {
  for (const char* name : {"card_house", "chairs", "dominoes", "meshes", "wall", "wrecking_ball"}) {
    Scene scene = load_scene(places::assets() + "/scenes/" + name + ".json");
    scene.params.h = Params{}.h;
    scene.params.solver = SolverParams{};
    State state = scene.initial;
    StepWorkspace workspace;
    StepReport report;
    int broken = 0;
    for (int k = 0; k < kSteps; ++k) {
      step(scene.model, scene.params, {}, state, workspace, report);
      broken += report.friction_excess > 0.01;
    }
    INFO(name);
    CHECK(broken == 0);
  }
}

}  // namespace pabd::test_shipped_friction
