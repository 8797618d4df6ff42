// SPDX-License-Identifier: MIT
// B with another law of its joints: it runs as the scene does that is loaded with that law, from where it was given it.
#include <catch2/catch.hpp>

#include "sim/trace/trace.h"
#include "tests/support/places.h"
#include "tests/support/temp_folder.h"
#include "tests/workbench/workbench_helpers.h"

namespace pabd::test_joint_laws {

using test::open;
using test::refusal;

namespace {

const std::string kScene = places::scenes() + "/four_bar.json";
const std::vector<std::string> kHard = {"joints_default.potential=hard", "joints_default.kappa=2000",
                                        "joints_default.d_hat=0.02"};

Workbench loaded(const std::vector<std::string>& sets) { return {{}, command::Load{kScene, sets, false}}; }
std::string hash(const Workbench& bench, Side side) { return state_hash(bench.run(side).state()); }
const BondLaw& law(const Workbench& bench, Side side) { return bench.run(side).model().joints.front().law; }

}  // namespace

TEST_CASE("B with another law of its joints is the scene that was loaded with it, and A stays as it is") {
  Workbench bench = open(kScene), hard = loaded(kHard), plain = open(kScene);
  bench.apply(command::Compare{kHard});
  for (Workbench* one : {&bench, &hard, &plain}) one->apply(command::Step{60});
  CHECK(hash(bench, Side::b) == hash(hard, Side::a));
  CHECK(hash(bench, Side::a) == hash(plain, Side::a));
  CHECK(hash(bench, Side::b) != hash(bench, Side::a));
  const Snapshot s = bench.snapshot();
  REQUIRE(s.b);
  CHECK(s.b->changed.size() == 4);  // with the N that hard has
  CHECK(s.a.changed.empty());
  CHECK(s.unsaved);

  // Back before it and on, with another parameter of B on the way: the law stays.
  bench.apply(command::Seek{0});
  bench.apply(command::Set{"solver.iterations", "40", Side::b});
  CHECK(law(bench, Side::b).potential == BondPotential::hard);
  bench.apply(command::Restart{});
  CHECK(law(bench, Side::b).potential == BondPotential::hard);
  CHECK(law(bench, Side::a).potential == BondPotential::soft);
}

TEST_CASE("a law that B is given later holds from then on, and is undone") {
  Workbench bench = open(kScene);
  bench.apply(command::Step{30});
  bench.apply(command::Compare{});
  const std::string here = hash(bench, Side::b);
  bench.apply(command::Set{"joints_default.kappa", "1e4", Side::b});
  CHECK(hash(bench, Side::b) == here);
  CHECK(law(bench, Side::b).kappa == 1e4);
  bench.apply(command::Step{20});
  CHECK(bench.run(Side::b).state().step == 50);
  const std::string soft = hash(bench, Side::b);
  CHECK(soft != hash(bench, Side::a));

  // The past is that of A; the same steps again give the same bits.
  bench.apply(command::Seek{0});
  CHECK(hash(bench, Side::b) == hash(bench, Side::a));
  bench.apply(command::Step{50});
  CHECK(hash(bench, Side::b) == soft);

  bench.apply(command::Set{"joints_default.potential", "hard", Side::b});
  CHECK(law(bench, Side::b).potential == BondPotential::hard);
  CHECK(law(bench, Side::b).kappa != 1e4);  // of another unit: found anew
  bench.apply(command::Undo{});
  CHECK(law(bench, Side::b).potential == BondPotential::soft);
  CHECK(law(bench, Side::b).kappa == 1e4);
  bench.apply(command::Redo{});
  CHECK(law(bench, Side::b).potential == BondPotential::hard);
  bench.apply(command::ResetParams{"joints_default", Side::b});
  CHECK(law(bench, Side::b).kappa == law(bench, Side::a).kappa);
  CHECK(bench.snapshot().b->changed.empty());
}

TEST_CASE("the law of B's joints is saved as a patch that gives it again") {
  const TempFolder folder;
  const std::string path = (folder.path() / "p.json").string();
  Workbench bench = open(kScene);
  std::vector<std::string> values = kHard;
  values.emplace_back("contact.N=6");
  bench.apply(command::Compare{values});
  bench.apply(command::SavePatch{path, false, Side::b});
  CHECK_FALSE(bench.snapshot().unsaved);
  Workbench other = open(kScene);
  CHECK_THAT(refusal(other, command::ApplyPatch{path, Side::a}), Catch::Contains("joints_default"));
  other.apply(command::Compare{});
  other.apply(command::ApplyPatch{path, Side::b});
  CHECK(other.run(Side::b).params() == bench.run(Side::b).params());
  for (Workbench* one : {&bench, &other}) one->apply(command::Step{30});
  CHECK(hash(other, Side::b) == hash(bench, Side::b));

  bench.apply(command::Reload{true});
  CHECK(law(bench, Side::b).kappa == 2000);
  CHECK(law(bench, Side::a).potential == BondPotential::soft);
  bench.apply(command::SaveScene{(folder.path() / "b.json").string(), false, false, Side::b});
  Workbench saved = open((folder.path() / "b.json").string());
  CHECK(law(saved, Side::a).kappa == 2000);
  CHECK(law(saved, Side::a).d_hat == 0.02);
}

TEST_CASE("a law of joints is refused where there is none to give, and nothing has changed then") {
  Workbench bench = open(kScene);
  CHECK_THAT(refusal(bench, command::Set{"joints_default.kappa", "5"}), Catch::Contains("A's joints"));
  CHECK_THAT(refusal(bench, command::Set{"joints_default.kappa", "5", Side::b}), Catch::Contains("compare"));
  CHECK_THAT(refusal(bench, command::Compare{{"joints_default.kappa=-1"}}), Catch::Contains("kappa"));
  CHECK_THAT(refusal(bench, command::Compare{{"joints_default.stiffness=1"}}), Catch::Contains("stiffness"));
  CHECK_FALSE(bench.comparing());
  bench.apply(command::Edit{R"({"do": "remove_joint", "joint": 0})"});
  CHECK_THAT(refusal(bench, command::Compare{kHard}), Catch::Contains("removed before"));
  CHECK_FALSE(bench.comparing());
  Workbench boxes = open();
  CHECK_THAT(refusal(boxes, command::Compare{kHard}), Catch::Contains("no joints"));
}

}  // namespace pabd::test_joint_laws
