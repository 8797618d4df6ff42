// SPDX-License-Identifier: MIT
// Figure 6 marks the deepest pair.
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "app/overlay/figure6.h"
#include "sim/body/mass_properties.h"
#include "sim/math/so3.h"

namespace pabd::test_figure6 {

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
    const Mat3 R = rotation_between(Vec3(-1, -1, -1), Vec3(0, -1, 0));
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
  std::vector<std::string> labels;
  for (const Label& label : figure.scene.labels) labels.push_back(label.text);
  CHECK(labels == std::vector<std::string>{"*{y}_{i}", "*{y}_{j}", "*{n}_{i}", "*{i}", "*{j}", "0.1 m"});
  // The overlap is shaded, and the scale is as long as it says: here it reaches from one point to the other.
  REQUIRE(figure.scene.meshes.size() == 1);
  CHECK(figure.scene.meshes[0].mesh->corners.size() == 12);
  const Line& scale = figure.scene.lines[figure.scene.lines.size() - 3];
  CHECK((scale.a - scale.b).norm() == Approx(0.1).epsilon(1e-5));
  const Vec3 along = (scale.b - scale.a).cast<double>().normalized();
  CHECK(std::abs(along.dot(pair->n)) == Approx(1).epsilon(1e-5));
  CHECK(std::abs((scale.a.cast<double>() - pair->y_b).dot(pair->n)) < 1e-5);
  CHECK(figure.caption.find("−0.1 m") != std::string::npos);
}

TEST_CASE("bodies that are far apart have no pair") {
  TwoBoxes boxes;
  boxes.state.c[1].y() += 3;
  CHECK_FALSE(deepest_contact(boxes.model, boxes.params, boxes.state));
  CHECK(figure6(boxes.model, boxes.params, boxes.state, 1.5).scene.labels.empty());
}

}  // namespace pabd::test_figure6
