// SPDX-License-Identifier: MIT
// Chains, ropes over drums and nets.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "sim/body/shape_kind.h"
#include "tests/world/world.h"

namespace pabd::test_ropes {

using namespace world;

namespace {

struct Rope {
  double mu, left, right;  // masses of the weights; kg
  int links;               // on half a turn
  double radius;           // of the drum; m
  double h, link;          // s; mass of a link, kg
};

constexpr double kThin = 0.008, kReach = 0.001;  // radius of a rope, d̂; m
constexpr double kHanging = 0.35;                // of it on each side; m

double link_length(const Rope& rope) {
  return 2 * (rope.radius + kThin + kReach) * std::tan(kPi / rope.links / 2);
}

// A rope over a fixed drum with a weight on each side.
Setting over_drum(const Rope& rope) {
  Setting setting(rope.h, rope.mu, kReach);
  setting.add(spec::Body{.name = "drum",
                         .shape = make_shape("cylinder", {rope.radius, 0.3}),
                         .fixed = true,
                         .position = Vec3(0, 0, 0),
                         .orientation = along_z()});
  // Links touch the drum at their middles: corners of a polygon about a circle.
  const double turn = kPi / rope.links, middle = rope.radius + kThin + kReach, length = link_length(rope);
  std::vector<Vec3> joints;
  const int hanging = static_cast<int>(kHanging / length);
  const double corner = middle / std::cos(turn / 2);
  const auto at = [&](double angle) { return Vec3(-corner * std::cos(angle), corner * std::sin(angle), 0); };
  for (int k = hanging; k > 0; --k) joints.push_back(at(-turn / 2) - Vec3(0, k * length, 0));
  for (int k = 0; k <= rope.links + 1; ++k) joints.push_back(at((k - 0.5) * turn));
  for (int k = 1; k <= hanging; ++k) joints.push_back(at(kPi + turn / 2) - Vec3(0, k * length, 0));
  std::string before;
  const auto add_weight = [&](const char* name, double mass, const Vec3& end) {
    setting.add(spec::Body{.name = name,
                           .shape = Sphere{0.03},
                           .mass = mass,
                           .position = end - Vec3(0, 0.05, 0),
                           .groups = {"rope"}});
  };
  add_weight("left", rope.left, joints.front());
  before = "left";
  for (std::size_t k = 0; k + 1 < joints.size(); ++k) {
    const Vec3 along = joints[k + 1] - joints[k];
    const std::string link =
        setting.add(spec::Body{.shape = Capsule{kThin, along.norm() * 0.9},
                               .mass = rope.link,
                               .position = (joints[k] + joints[k + 1]) / 2,
                               .orientation = about_z(std::atan2(-along.x(), along.y()) / kDegree),
                               .groups = {"rope"}});
    setting.join(JointType::spherical, before, link, joints[k]);
    before = link;
  }
  add_weight("right", rope.right, joints.back());
  setting.join(JointType::spherical, before, "right", joints.back());
  setting.builder.add(spec::NoCollide{.i = spec::Group{"rope"}, .j = spec::Group{"rope"}});
  return setting;
}

}  // namespace

namespace {

// Mean acceleration of the right weight on its way down from 2 cm to 17 cm, in m/s²: half the slope of v² over the way, by
// least squares, since the rope swings lengthwise. Over shorter ways the links that come on and off the drum are felt. Runs
// for three seconds at most.
double acceleration(Run& run) {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (double way = 0; run.state.time < 3 && way < 0.17;) {
    run.go(std::max(0.005, run.scene.params.h));
    way = -run.way("right").y();
    if (way < 0.02) continue;
    const double square = run.v("right").squaredNorm();
    n += 1;
    x += way;
    y += square;
    xx += way * way;
    xy += way * square;
  }
  return 0.5 * (n * xy - x * y) / (n * xx - x * x);
}

// A rope that is thicker than nothing rubs at the drum's radius and pulls at its own: μ R/(R + r) for μ. Of links that
// touch at one point each: 2 tan(δ/2) for δ.
double capstan(const Rope& rope) {
  const double pull = rope.radius + kThin + kReach;
  return std::exp(rope.mu * rope.radius / pull * rope.links * 2 * std::tan(kPi / rope.links / 2));
}

// Of the right weight, with what hangs of the rope on each side half way.
double slip(const Rope& rope) {
  const double per_length = rope.link / link_length(rope), ratio = capstan(rope);
  const double right = rope.right + per_length * (kHanging + 0.095);
  const double left = rope.left + per_length * (kHanging - 0.095);
  const double drum = rope.link * rope.links;
  return kG * (right - left * ratio) / (right + left * ratio + drum);
}

}  // namespace

// Euler and Eytelwein's equation of the capstan: MuJoCo issue 454, newton issue 2976.
TEST_CASE(
    "a rope over a drum holds up to the ratio exp(μ π) of its weights, and slips beyond it as it says") {
  Rope rope = GENERATE(Rope{0.1, 1, 0, 30, 0.2, 0, 0.001}, Rope{0.3, 1, 0, 24, 0.25, 0, 0.001},
                       Rope{0.2, 1, 0, 36, 0.15, 0, 0.001});
  rope.h = 1.0 / 1000;
  CAPTURE(rope.mu, rope.links, rope.radius, rope.h);
  const double most = capstan(rope);
  rope.right = 0.85 * most;
  Setting holds = over_drum(rope);
  Run held(holds);
  held.go(0.1);
  const Vec3 c = held.c("right");
  held.go(1);
  CHECK((held.c("right") - c).norm() < 0.01 * rope.radius);
  CHECK(held.v("right").norm() < 1e-3);
  rope.right = 1.6 * most;
  Setting slips = over_drum(rope);
  Run run(slips);
  CHECK(acceleration(run) == Approx(slip(rope)).epsilon(0.05));
  CHECK(run.joint_error < 1e-4);
}

// The capstan again at steps that people take: links of a gram and of five under weights of 4 and 32 kg. Such ropes hung still.
TEST_CASE("a rope of light links slips over a drum under a heavy weight at usual steps") {
  const double link = GENERATE(1e-3, 5e-3), right = GENERATE(4.0, 32.0), h = GENERATE(1.0 / 60, 1.0 / 240);
  CAPTURE(link, right, h);
  const Rope rope{0.3, 1, right, 36, 0.25, h, link};
  Setting setting = over_drum(rope);
  Run run(setting);
  CHECK(acceleration(run) == Approx(slip(rope)).epsilon(0.15));  // the links that come on and off are felt
  CHECK(run.held <= run.steps / 2);
  CHECK(run.rise == 0);
  CHECK(run.joint_error < 1e-5);
}

// Atwood's machine, 1784, with a smooth drum in place of the pulley.
TEST_CASE("two weights on a rope over a smooth drum accelerate with g (M - m)/(M + m)") {
  const double ratio = GENERATE(1.5, 4.0), radius = GENERATE(0.1, 0.25), h = 1.0 / 1000;
  CAPTURE(ratio, radius, h);
  const Rope rope{0, 1, ratio, 40, radius, h, 0.001};
  Setting setting = over_drum(rope);
  Run run(setting);
  CHECK(acceleration(run) == Approx(slip(rope)).epsilon(0.03));
  CHECK(run.joint_error < 1e-4);
}

namespace {

// A chain between two fixed points in the shape that statics gives: link k of n stands at atan((k − (n − 1)/2) m g/H).
struct Catenary {
  std::vector<Vec3> joints;
  double span, sag;
};
Catenary catenary(int links, double length, double ratio) {  // ratio: m g/H
  Catenary out{{Vec3::Zero()}, 0, 0};
  for (int k = 0; k < links; ++k) {
    const double angle = std::atan((k - (links - 1) / 2.0) * ratio);
    out.joints.push_back(out.joints.back() + length * Vec3(std::cos(angle), std::sin(angle), 0));
    out.sag = std::max(out.sag, -out.joints.back().y());
  }
  out.span = out.joints.back().x();
  return out;
}

std::vector<std::string> add_chain(Setting& setting, const std::vector<Vec3>& joints, double mass) {
  std::vector<std::string> names;
  std::string before;
  for (std::size_t k = 0; k + 1 < joints.size(); ++k) {
    const Vec3 along = joints[k + 1] - joints[k];
    names.push_back(setting.add(Box{Vec3(0.9 * along.norm(), 0.02, 0.02) / 2}, mass,
                                (joints[k] + joints[k + 1]) / 2,
                                about_z(std::atan2(along.y(), along.x()) / kDegree)));
    setting.join(JointType::spherical, before, names.back(), joints[k]);
    before = names.back();
  }
  setting.join(JointType::spherical, before, "", joints.back());
  return names;
}

}  // namespace

// The catenary: Jakob and Johann Bernoulli, Huygens and Leibniz 1691.
TEST_CASE("a chain between two points rests in its catenary, and pulls as it says") {
  const int links = GENERATE(9, 30, 100);
  const double ratio = GENERATE(0.05, 0.4), h = GENERATE(1.0 / 60, 1.0 / 240);
  CAPTURE(links, ratio, h);
  const double length = 0.1, mass = 0.3;
  const Catenary shape = catenary(links, length, ratio);
  Setting setting(h);
  const auto names = add_chain(setting, shape.joints, mass);
  Run run(setting);
  run.go(2);
  for (const std::string& name : names) CHECK(run.way(name).norm() < 1e-4 * length);
  CHECK(std::abs(run.report.joint_reports[0].force.x()) == Approx(mass * kG / ratio).epsilon(1e-3));
  CHECK(run.report.joint_reports[0].force.y() == Approx(links * mass * kG / 2).epsilon(1e-3));
}

TEST_CASE("a chain that hangs otherwise swings into its catenary") {
  const int links = GENERATE(10, 24);
  const double ratio = GENERATE(0.15, 0.5);
  CAPTURE(links, ratio);
  const Catenary shape = catenary(links, 0.1, ratio);
  // Of the same span: up on one half, down on the other, like a wave; then let go.
  std::vector<Vec3> start{Vec3::Zero()};
  const double tilt = std::acos(shape.span / (links * 0.1));
  for (int k = 0; k < links; ++k)
    start.push_back(start.back() + 0.1 * Vec3(std::cos(tilt), (k < links / 2 ? 1 : -1) * std::sin(tilt), 0));
  Setting setting(1.0 / 30);
  setting.builder.params.solver.integrator = Integrator::euler;  // nothing else takes its motion
  const auto names = add_chain(setting, start, 0.3);
  Run run(setting);
  run.go(60);
  const std::size_t lowest = names.size() / 2;
  CHECK(run.c(names[lowest]).y() ==
        Approx((shape.joints[lowest] + shape.joints[lowest + 1]).y() / 2).epsilon(0.01));
  CHECK(run.rise < 1e-6 * run.weight() * shape.sag);
  CHECK(run.joint_error < 1e-4);
}

// A ball that tears a chain: T1 of the findings. Here it strikes a slack chain between two points from the side.
TEST_CASE("a ball that strikes a slack chain opens no joint and makes no energy") {
  const double speed = GENERATE(5.0, 25.0, 70.0), mass = GENERATE(0.5, 50.0),
               h = GENERATE(1.0 / 30, 1.0 / 60, 1.0 / 240);
  CAPTURE(speed, mass, h);
  const Catenary shape = catenary(21, 0.2, 0.15);
  Setting setting(h);
  add_chain(setting, shape.joints, 0.8);
  setting.add(spec::Body{.shape = Sphere{0.15},
                         .mass = mass,
                         .position = Vec3(shape.span / 2 + 0.03, -shape.sag, -1.5),
                         .velocity = Vec3(0, 0, speed)});
  Run run(setting);
  run.go(1);
  CHECK(run.joint_error < 1e-3);
  CHECK(run.rise < 1e-6 * std::abs(run.begin));
}

namespace {

// 3 m up, of tiles that hang on each other.
Run level_net(int edge, double size, double h, double d_hat, const char* fixed) {
  Setting setting(h, 0.5, d_hat);
  setting.builder.add(spec::Net{.rows = edge,
                                .columns = edge,
                                .size = Vec3(size, 0.1 * size, size),
                                .position = Vec3(0, 3, 0),
                                .gap = 0.02 * size,
                                .joint = JointType::spherical,
                                .fixed = fixed});
  return Run(setting);
}

}  // namespace

// A curtain that is let go level: nets that froze in the air are T2 of the findings.
TEST_CASE("a level net that hangs by one edge swings down and stays in one piece") {
  const int edge = GENERATE(4, 9);
  const double size = GENERATE(0.1, 0.4), h = GENERATE(1.0 / 60, 1.0 / 240);
  CAPTURE(edge, size, h);
  Run run = level_net(edge, size, h, 0.01 * size, "top");
  const double length = (edge - 1) * size * 1.02;
  double lowest = 3;
  run.go(2.5 * std::sqrt(length / kG), [&] {
    for (const Vec3& c : run.state.c) lowest = std::min(lowest, c.y());
  });
  CHECK(lowest < 3 - 0.8 * length);
  CHECK(run.fastest > std::sqrt(kG * length));
  CHECK(run.joint_error < 1e-3 * size);
  CHECK(run.rise < 1e-6 * run.weight() * length);
}

// T2 of the findings: between its corners a net of rigid tiles is taut, and rests where it is.
TEST_CASE("a level net between its corners makes no energy") {
  const int edge = GENERATE(4, 7);
  const double size = GENERATE(0.1, 0.4), h = GENERATE(1.0 / 60, 1.0 / 240);
  CAPTURE(edge, size, h);
  Run run = level_net(edge, size, h, 0.005 * size, "corners");
  run.go(1.5);
  CHECK(run.unsolved == 0);
  CHECK(run.rise < 1e-6 * run.weight() * size);
  CHECK(run.joint_error < 1e-3 * size);
  CHECK(run.kinetic() < 1e-6 * run.weight() * size);
}

// Two wheels and a belt: MuJoCo issue 757. A tight chain of capsules, held tight by the second wheel's carriage.
TEST_CASE("a belt drives a second wheel with the rate of the radii") {
  const double ratio = GENERATE(1.0, 2.0), h = 1.0 / 240;
  CAPTURE(ratio);
  const double r1 = 0.1, r2 = ratio * r1, apart = 0.6, thin = 0.008, d_hat = 0.001;
  Setting setting(h, 0.8, d_hat);
  setting.add(spec::Body{.name = "one",
                         .shape = make_shape("cylinder", {r1, 0.1}),
                         .mass = 1.0,
                         .position = Vec3(0, 0, 0),
                         .orientation = along_z()});
  setting.add(spec::Body{.name = "two",
                         .shape = make_shape("cylinder", {r2, 0.1}),
                         .mass = 1.0,
                         .position = Vec3(apart, 0, 0),
                         .orientation = along_z()});
  const std::string carriage = setting.add(Box{{0.02, 0.02, 0.02}}, 1, {apart, 0, 0.3});
  setting.builder.add(spec::Joint{.type = JointType::hinge,
                                  .j = "one",
                                  .anchor = Vec3(0, 0, 0),
                                  .axis = Vec3::UnitZ(),
                                  .drive = Profile{{{0, 0}, {0.5, 0}, {1.0, 90}, {3, 810}}}});
  setting.join(JointType::hinge, carriage, "two", {apart, 0, 0});
  setting.builder.add(spec::Joint{.type = JointType::slider,
                                  .j = carriage,
                                  .anchor = Vec3(apart, 0, 0.3),
                                  .axis = Vec3::UnitX(),
                                  .motor = spec::Motor{.force = Profile{{{0, 60}}}}});
  // Points along the belt, open: arc, straight, arc, straight.
  const double R1 = r1 + thin + d_hat, R2 = r2 + thin + d_hat, beta = std::asin((R2 - R1) / apart);
  std::vector<Vec3> points;
  const int arc = 20, straight = 24;
  const auto around = [&](const Vec3& centre, double R, double from, double to) {
    for (int k = 0; k <= arc; ++k) {
      const double a = from + (to - from) * k / arc;
      points.push_back(centre + 1.003 * R * Vec3(std::cos(a), std::sin(a), 0));
    }
  };
  const auto line = [&](const Vec3& to) {
    const Vec3 from = points.back();
    for (int k = 1; k < straight; ++k) points.push_back(from + (to - from) * k / straight);
  };
  const Vec3 second(apart, 0, 0);
  around(Vec3::Zero(), R1, kPi / 2 + beta, 1.5 * kPi - beta);
  line(second + 1.003 * R2 * Vec3(std::cos(-kPi / 2 - beta), std::sin(-kPi / 2 - beta), 0));
  around(second, R2, -kPi / 2 - beta, kPi / 2 + beta);
  line(points.front());
  std::vector<std::string> links;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Vec3 a = points[k], b = points[(k + 1) % points.size()], along = b - a;
    links.push_back(
        setting.add(spec::Body{.shape = Capsule{thin, 0.9 * along.norm()},
                               .mass = 0.002,
                               .position = (a + b) / 2,
                               .orientation = about_z(std::atan2(-along.x(), along.y()) / kDegree),
                               .groups = {"belt"}}));
  }
  for (std::size_t k = 0; k < links.size(); ++k)
    setting.join(JointType::spherical, links[k], links[(k + 1) % links.size()],
                 points[(k + 1) % points.size()]);
  setting.builder.add(spec::NoCollide{.i = spec::Group{"belt"}, .j = spec::Group{"belt"}});
  Run run(setting);
  run.go(1.2);
  double turned = 0;
  run.go(1, [&] { turned += run.omega("two").z() * h; });
  CHECK(turned == Approx(2 * kPi * R1 / R2).epsilon(0.02));
  CHECK(run.joint_error < 1e-4);
}

// A ball on a safety net: trampolines in every engine's demonstrations.
TEST_CASE("a ball that falls on an elastic net is caught and thrown no higher than it came from") {
  const double mass = GENERATE(1.0, 6.0), h = GENERATE(1.0 / 60, 1.0 / 240);
  const int edge = GENERATE(7, 11);
  CAPTURE(mass, h, edge);
  Setting setting(h);
  setting.builder.joint_law.kappa = 3000;
  setting.builder.add(spec::Net{.rows = edge,
                                .columns = edge,
                                .size = Vec3(0.2, 0.03, 0.2),
                                .position = Vec3(0, 2, 0),
                                .joint = JointType::spherical,
                                .fixed = "edges",
                                .mass = 0.1});
  const std::string ball = setting.add(Sphere{0.25}, mass, {0.03, 3.2, 0.05});
  Run run(setting);
  double highest = -10;
  run.go(2, [&] {
    if (run.state.time > 0.9) highest = std::max(highest, run.c(ball).y());
  });
  CHECK(run.c(ball).y() > 0.5);
  CHECK(highest < 3.2);
  CHECK(run.rise < 1e-6 * run.begin);
}

}  // namespace pabd::test_ropes
