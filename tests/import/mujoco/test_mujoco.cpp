// SPDX-License-Identifier: MIT
// The same robots in MuJoCo: they stand, hang, slide and fall there as they do here. Both steps are of first order, so
// that motion that does not touch differs by the length of the step; what touches keeps a distance of up to d̂ here and
// sinks in there.
#include <mujoco/mujoco.h>

#include <Eigen/Geometry>
#include <cmath>
#include <memory>

#include "tests/import/import_helpers.h"
#include "tests/support/places.h"
#include "tests/support/temp_folder.h"

namespace pabd::test_mujoco {

using namespace test;

namespace {

const std::filesystem::path kModels = places::tests() + "/import/models", kAssets = places::assets();
constexpr double kStep = 0.0005;  // s

// A pose of a body, z up: its centre of mass, and how it has turned since the start.
struct Moved {
  Vec3 c;
  Mat3 R;
};

class MujocoRun {
 public:
  explicit MujocoRun(const std::filesystem::path& file) {
    char problem[1000] = "";
    model_.reset(mj_loadXML(file.c_str(), nullptr, problem, sizeof problem));
    INFO(problem);
    REQUIRE(model_);
    model_->opt.timestep = kStep;
    data_.reset(mj_makeData(model_.get()));
    mj_forward(model_.get(), data_.get());
    for (int body = 0; body < model_->nbody; ++body) start_.push_back(rotation(body));
  }
  void run(double until) {
    while (data_->time < until - kStep / 2) mj_step(model_.get(), data_.get());
    mj_kinematics(model_.get(), data_.get());
  }
  Moved body(const std::string& name) const {
    const int body = mj_name2id(model_.get(), mjOBJ_BODY, name.c_str());
    REQUIRE(body > 0);
    return {Vec3(data_->xipos + 3 * body),
            rotation(body) * start_[static_cast<std::size_t>(body)].transpose()};
  }
  double mass(const std::string& name) const {
    return model_->body_mass[mj_name2id(model_.get(), mjOBJ_BODY, name.c_str())];
  }

 private:
  Mat3 rotation(int body) const {
    return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(data_->xmat + 9 * body);
  }
  struct Free {
    void operator()(mjModel* model) const { mj_deleteModel(model); }
    void operator()(mjData* data) const { mj_deleteData(data); }
  };
  std::unique_ptr<mjModel, Free> model_;
  std::unique_ptr<mjData, Free> data_;
  std::vector<Mat3> start_;
};

// A robot in both, from one file.
class Both {
 public:
  Both(const std::string& file, const std::string& text, const std::vector<std::string>& bodies)
      : bodies_(bodies) {
    write_bytes(folder_ / file, text);
    std::filesystem::copy_file(kAssets / "meshes/wedge.obj", folder_ / "wedge.obj");
    ours_ = std::make_unique<ImportedRun>(
        import_robot_text(text, file, kAssets).text,
        std::vector<std::string>{"time_step=" + std::to_string(kStep), "solver.integrator=euler"});
    theirs_ = std::make_unique<MujocoRun>(folder_ / file);
    for (std::size_t i = 0; i < ours_->state.c.size(); ++i) start_.push_back(z_up() * ours_->state.R[i]);
    for (const std::string& name : bodies_)
      CHECK(ours_->scene.model.mass[ours_->body(name)] == Approx(theirs_->mass(name)).epsilon(1e-6));
  }
  void run(double until) {
    ours_->run(until);
    theirs_->run(until);
  }
  // Largest over all bodies: m, and degrees.
  double apart() const {
    double most = 0;
    for (const std::string& name : bodies_)
      most = std::max(most, (ours(name).c - theirs_->body(name).c).norm());
    return most;
  }
  double turned_apart() const {
    double most = 0;
    for (const std::string& name : bodies_) {
      const Eigen::AngleAxisd turn(Mat3(ours(name).R * theirs_->body(name).R.transpose()));
      most = std::max(most, std::abs(turn.angle()) * 180 / kPi);
    }
    return most;
  }
  // Of the common centre of mass; m.
  std::pair<double, double> heights() const {
    double here = 0, there = 0, mass = 0;
    for (const std::string& name : bodies_) {
      const double m = theirs_->mass(name);
      here += m * ours(name).c.z();
      there += m * theirs_->body(name).c.z();
      mass += m;
    }
    return {here / mass, there / mass};
  }

 private:
  static Mat3 z_up() {
    Mat3 W;
    W << 1, 0, 0, 0, 0, -1, 0, 1, 0;
    return W;
  }
  Moved ours(const std::string& name) const {
    const std::size_t body = ours_->body(name);
    return {z_up() * ours_->state.c[body], z_up() * ours_->state.R[body] * start_[body].transpose()};
  }

  TempFolder folder_;
  std::vector<std::string> bodies_;
  std::unique_ptr<ImportedRun> ours_;
  std::unique_ptr<MujocoRun> theirs_;
  std::vector<Mat3> start_;
};

std::string text_of(const std::string& file) { return read_scene_text(kModels / file); }

}  // namespace

TEST_CASE("a pendulum hangs and swings as in MuJoCo", "[import]") {
  Both robot("pendulum.urdf", text_of("pendulum.urdf"), {"rod"});
  for (const double t : {0.0, 0.1, 0.5, 1.0}) {
    robot.run(t);
    INFO(t);
    CHECK(robot.apart() < 5e-4);  // it goes 0.19 m
    CHECK(robot.turned_apart() < 0.05);
  }
}

TEST_CASE("springs pull as in MuJoCo", "[import]") {
  Both robot("springs.xml", R"(<mujoco><compiler angle="degree"/><worldbody>
      <body name="arm" pos="0 0 1"><joint axis="0 1 0" stiffness="3" springref="-20" ref="10"/>
        <geom type="box" size="0.2 0.02 0.02" pos="0.2 0 0" mass="1"/></body>
      <body name="block" pos="0 1 1"><joint type="slide" axis="0 0 1" stiffness="40" springref="0.1"/>
        <geom size="0.1" mass="2"/></body></worldbody></mujoco>)",
             {"arm", "block"});
  for (const double t : {0.1, 0.5, 1.0}) {
    robot.run(t);
    INFO(t);
    CHECK(robot.apart() < 2e-3);  // of 0.6 m
    CHECK(robot.turned_apart() < 0.3);
  }
}

TEST_CASE("a block slides as in MuJoCo, until its end", "[import]") {
  Both robot("slider.urdf", text_of("slider.urdf"), {"block"});
  robot.run(0.4);
  CHECK(robot.apart() < 1e-6);  // of 0.39 m
}

TEST_CASE("an arm falls as in MuJoCo", "[import]") {
  std::string text = text_of("arm.xml");
  const std::size_t from = text.find("<actuator>"), to = text.find("</actuator>");
  REQUIRE(to != std::string::npos);
  text.erase(from, to + 11 - from);
  Both robot("arm.xml", text, {"shoulder", "elbow", "wrist", "palm"});
  robot.run(0.1);
  CHECK(robot.apart() < 1e-4);  // of 0.055 m
  CHECK(robot.turned_apart() < 0.02);
  robot.run(0.3);
  CHECK(robot.apart() < 1.5e-3);  // of 0.44 m, 68 degrees; light bodies between joints weigh a thousandth
  CHECK(robot.turned_apart() < 0.4);
}

TEST_CASE("a cart stands as in MuJoCo, and its mast falls to its bound", "[import]") {
  Both robot("cart.xml", text_of("cart.xml"), {"deck", "left", "right", "mast"});
  for (const double t : {0.1, 0.5, 1.0}) {
    robot.run(t);
    INFO(t);
    CHECK(robot.apart() < 7e-3);  // d̂ is 5 mm
    CHECK(robot.turned_apart() < 1.5);
  }
}

TEST_CASE("a tree of bodies falls as in MuJoCo, and comes to lie", "[import]") {
  Both robot("tree.xml", text_of("tree.xml"), {"trunk", "left", "left shin", "right"});
  robot.run(0.2);
  CHECK(robot.apart() < 1e-9);
  CHECK(robot.turned_apart() < 1e-4);
  // Where limbs go from there is chance, but not that all lie: between the radii of the foot and of the head.
  robot.run(3);
  const auto [here, there] = robot.heights();
  for (const double height : {here, there}) {
    CHECK(height > 0.03);
    CHECK(height < 0.1);
  }
}

}  // namespace pabd::test_mujoco
