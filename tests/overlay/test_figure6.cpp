// SPDX-License-Identifier: MIT
// Figure 6 marks the deepest pair.
#include <catch2/catch.hpp>

#include "app/overlay/figure6.h"
#include "sim/body/mass_properties.h"

using namespace pabd;

namespace {

// Two unit cubes, the upper one standing on a corner, its lowest point 0.1 inside the lower cube.
struct TwoBoxes {
  Model model;
  State state;
  Params params;

  TwoBoxes() {
    for (const char* name : {"lower", "upper"}) {
      const Shape box = Box{{0.5, 0.5, 0.5}};
      const MassProperties mass = mass_properties(box, 1000);
      model.name.emplace_back(name);
      model.shape.push_back(box);
      model.mass.push_back(mass.mass);
      model.J.push_back(mass.J);
      model.fixed.push_back(0);
    }
    const Mat3 R = Quat::FromTwoVectors(Vec3(-1, -1, -1), Vec3(0, -1, 0)).toRotationMatrix();
    state.c = {Vec3(0, 0.5, 0), Vec3(0, 1 - 0.1 + 0.5 * std::sqrt(3.0), 0)};
    state.R = {Mat3::Identity(), R};
    state.v.assign(2, Vec3::Zero());
    state.omega.assign(2, Vec3::Zero());
    params.contact.d_hat = 0.05;
  }
};

}  // namespace

TEST_CASE("the chosen pair is the deepest contact and is labelled") {
  const TwoBoxes boxes;
  const auto pair = deepest_contact(boxes.model, boxes.params, boxes.state);
  REQUIRE(pair);
  CHECK(pair->d == Approx(-0.1).margin(1e-9));
  CHECK(std::abs(pair->n.y()) == Approx(1).margin(1e-9));
  const Figure6 figure = figure6(boxes.model, boxes.params, boxes.state, 1.5);
  CHECK(figure.scene.labels.size() == 3);
  CHECK_FALSE(figure.scene.lines.empty());
  CHECK(figure.caption.find("−0.1 m") != std::string::npos);
}

TEST_CASE("bodies that are far apart have no pair") {
  TwoBoxes boxes;
  boxes.state.c[1].y() += 3;
  CHECK_FALSE(deepest_contact(boxes.model, boxes.params, boxes.state));
  CHECK(figure6(boxes.model, boxes.params, boxes.state, 1.5).scene.labels.empty());
}
