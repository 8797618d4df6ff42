// SPDX-License-Identifier: MIT
// Mechanisms of several bodies.
#include <cmath>

#include "app/validate/case.h"
#include "app/validate/crossings.h"

namespace pabd::validate {
namespace {

// A bar from one point to another, along its own axis x, y or z where these differ in one coordinate only.
void add_bar(Bench& bench, const std::string& name, const Vec3& from, const Vec3& to, double mass,
             double width) {
  const Vec3 way = to - from;
  const Vec3 size = way.cwiseAbs().cwiseMax(width);
  bench.builder().add(spec::Body{
      .name = name, .shape = Box{size / 2}, .mass = mass, .position = (from + to) / 2, .groups = {"links"}});
}
void nothing_touches(Bench& bench) {
  bench.builder().add(spec::NoCollide{spec::Group{"links"}, spec::Group{"links"}});
}

// N windows of four bars side by side, of rods of 1 m and 1 kg, upright; the top moves with 1 m/s. Once a turn all rods
// are level, where the mechanism has N + 1 degrees of freedom.
Outcome windows(Bench& bench, int count) {
  const auto post = [](int k) { return "post " + std::to_string(k); };
  for (int k = 0; k <= count; ++k) add_bar(bench, post(k), Vec3(k, 0, 0), Vec3(k, 1, 0), 1, 0.01);
  for (int k = 0; k < count; ++k)
    add_bar(bench, "beam " + std::to_string(k), Vec3(k, 1, 0), Vec3(k + 1, 1, 0), 1, 0.01);
  for (int k = 0; k <= count; ++k) {
    bench.join(JointType::hinge, "", post(k), Vec3(k, 0, 0));
    for (const int beam : {k - 1, k})
      if (beam >= 0 && beam < count)
        bench.join(JointType::hinge, post(k), "beam " + std::to_string(beam), Vec3(k, 1, 0));
  }
  nothing_touches(bench);
  bench.build();
  for (int k = 0; k <= count; ++k) {
    bench.omega(post(k)) = -Vec3::UnitZ();
    bench.v(post(k)) = Vec3(0.5, 0, 0);
    if (k < count) bench.v("beam " + std::to_string(k)) = Vec3(1, 0, 0);
  }
  Outcome out;
  const double start = bench.energy();
  bench.run(10, [&] { out.see(bench.time(), (bench.energy() - start) / (count + 1), 0); });
  out.value = out.ours.back();
  return out;
}

// Five rods with sections of 0.1 m and six hinges along the edges of a cube, that have one degree of freedom by their
// directions alone. P₃ joins the second and the third rod.
Outcome bricard(Bench& bench) {
  const Vec3 corner[] = {{0, 0, 0}, {1, 0, 0}, {1, -1, 0}, {1, -1, 1}, {0, -1, 1}, {0, 0, 1}};
  const Vec3 axis[] = {Vec3::UnitY(), Vec3::UnitZ(), Vec3::UnitX(),
                       Vec3::UnitY(), Vec3::UnitZ(), Vec3::UnitX()};
  const auto rod = [](int k) { return k < 0 || k > 4 ? std::string() : "rod " + std::to_string(k); };
  for (int k = 0; k < 5; ++k) add_bar(bench, rod(k), corner[k], corner[k + 1], 1, 0.1);
  for (int k = 0; k < 6; ++k) bench.join(JointType::hinge, rod(k - 1), rod(k), corner[k], axis[k]);
  nothing_touches(bench);
  Outcome out;
  Crossings crossings;
  bench.run(5, [&] {
    const double x = (bench.c(rod(1)) + bench.R(rod(1)) * Vec3(0, -0.5, 0)).x();
    crossings.see(bench.time(), x);
    out.see(bench.time(), x);
  });
  out.value = crossings.at().empty() ? 0 : crossings.at().front();
  return out;
}

// Hooke's joint between shafts at 35°, the first driven with a turn a second: how far the second is ahead at most.
constexpr double kBend = 35 * kDegree;
Outcome universal_joint(Bench& bench) {
  const Vec3 out_axis(std::cos(kBend), std::sin(kBend), 0);
  const auto shaft = [&](const std::string& name, const Vec3& axis, double side) {
    const double angle = std::atan2(axis.y(), axis.x()) / kDegree;
    bench.builder().add(spec::Body{.name = name,
                                   .shape = Box{{0.2, 0.02, 0.02}},
                                   .mass = 1.0,
                                   .position = 0.3 * side * axis,
                                   .orientation = spec::AxisAngle{Vec3::UnitZ(), angle},
                                   .groups = {"links"}});
  };
  shaft("in", Vec3::UnitX(), -1);
  shaft("out", out_axis, 1);
  add_bar(bench, "cross", Vec3(-0.05, 0, 0), Vec3(0.05, 0, 0), 0.2, 0.1);
  bench.builder().add(spec::Joint{.type = JointType::hinge,
                                  .j = "in",
                                  .anchor = Vec3(-0.3, 0, 0),
                                  .axis = Vec3::UnitX(),
                                  .drive = Profile{{{0, 0}, {10, 3600}}}});
  bench.join(JointType::hinge, "in", "cross", Vec3::Zero(), Vec3::UnitZ());
  bench.join(JointType::hinge, "cross", "out", Vec3::Zero(), Vec3(-std::sin(kBend), std::cos(kBend), 0));
  bench.join(JointType::hinge, "", "out", 0.3 * out_axis, out_axis);
  nothing_touches(bench);
  Outcome out;
  bench.build();
  const Mat3 start = bench.R("out");
  double turned = 0, before = 0;
  bench.run(1, [&] {
    const Mat3 turn = start.transpose() * bench.R("out");
    const double angle = std::atan2(turn(2, 1), turn(1, 1)), in = 2 * kPi * bench.time();
    turned += std::remainder(angle - before, 2 * kPi);
    before = angle;
    // The arm of the first shaft begins square to the plane of both: tan φ₂ = tan φ₁ cos β.
    const double right =
        std::remainder(std::atan2(std::sin(in) * std::cos(kBend), std::cos(in)) - in, 2 * kPi);
    out.see(bench.time(), (turned - in) / kDegree, right / kDegree);
    out.value = std::max(out.value, out.ours.back());
  });
  return out;
}

// Andrews' squeezing mechanism: seven plane bodies, a spring and a torque. Names of lengths are those of the book.
void build_andrews(Bench& bench) {
  constexpr double beta = -0.0617138900142764496, Theta = 0, gamma = 0.455279819163070380,
                   Phi = 0.222668390165885885, delta = 0.487364979543842550, Omega = -0.222668390165885885,
                   epsilon = 1.23054744454982119;
  constexpr double d = 0.028, da = 0.0115, e = 0.02, ea = 0.01421, rr = 0.007, ra = 0.00092, sa = 0.01874,
                   sb = 0.01043, sc = 0.018, sd = 0.02, ta = 0.02308, tb = 0.00916, u = 0.04, ua = 0.01228,
                   ub = 0.00449, zf = 0.02, zt = 0.04, fa = 0.01421;
  const Vec3 A(-0.06934, -0.00227, 0), B(-0.03635, 0.03273, 0), C(0.014, 0.072, 0);
  const auto along = [](double angle, double x, double y = 0) {
    return Vec3(x * std::cos(angle) - y * std::sin(angle), x * std::sin(angle) + y * std::cos(angle), 0);
  };
  const Vec3 P = along(beta, rr), E = P - along(beta + Theta, d);
  SceneBuilder& builder = bench.builder();
  builder.params.gravity.setZero();
  const auto body = [&](const char* name, double mass, double inertia, const Vec3& c) {
    const double half = std::sqrt(1.5 * inertia / mass);  // of a square with that moment
    builder.add(spec::Body{
        .name = name, .shape = Box{{half, half, 0.001}}, .mass = mass, .position = c, .groups = {"links"}});
  };
  body("K1", 0.04325, 2.194e-6, along(beta, ra));
  body("K2", 0.00365, 4.410e-7, P - along(beta + Theta, da));
  body("K3", 0.02373, 5.255e-6, B + along(gamma, sb, -sa));
  body("K4", 0.00706, 5.667e-7, A + along(delta, zt) + along(Phi + delta, 0, -(e - ea)));
  body("K5", 0.07050, 1.169e-5, A + along(delta, ta, tb));
  body("K6", 0.00706, 5.667e-7, A + along(epsilon, 0, -u) + along(Omega + epsilon, zf - fa));
  body("K7", 0.05498, 1.912e-5, A + along(epsilon, -ub, -ua));
  const auto pin = [&](const char* i, const char* j, const Vec3& at, double torque = 0) {
    spec::Joint joint{
        .type = JointType::hinge, .i = i, .j = j, .anchor = at, .axis = Vec3::UnitZ(), .arm = 0.01};
    if (torque > 0) joint.motor = spec::Motor{.force = Profile{{{0, torque}}}};
    builder.add(joint);
  };
  pin("", "K1", Vec3::Zero(), 0.033);
  pin("K1", "K2", P);
  pin("K2", "K3", E);
  pin("K2", "K4", E);
  pin("K2", "K6", E);
  pin("", "K3", B);
  pin("K4", "K5", A + along(delta, zt));
  pin("", "K5", A);
  pin("K6", "K7", A + along(epsilon, 0, -u));
  pin("", "K7", A);
  builder.add(spec::Joint{.type = JointType::distance,
                          .j = "K3",
                          .points = {C, B + along(gamma, sd, -sc)},
                          .length = 0.07785,
                          .law = {.potential = BondPotential::soft, .kappa = 4530}});
  nothing_touches(bench);
}

// The angle of the crank K1 at 0.03 s, whole turns and all.
Outcome andrews(Bench& bench) {
  build_andrews(bench);
  Outcome out;
  double beta = -0.0617138900142764496, from = 0;
  bench.run(0.03, [&] {
    const Mat3& R = bench.R("K1");
    const double turned = std::atan2(R(1, 0), R(0, 0));
    beta += std::remainder(turned - from, 2 * kPi);
    from = turned;
    out.see(1e3 * bench.time(), beta);
  });
  out.value = beta;
  return out;
}

}  // namespace

void add_linkages(std::vector<Case>& cases) {
  cases.push_back({"andrews", 15.81077, andrews});
  cases.push_back({"four-bars-2", 0, [](Bench& bench) { return windows(bench, 2); }});
  cases.push_back({"four-bars-40", 0, [](Bench& bench) { return windows(bench, 40); }});
  cases.push_back({"bricard", 3.743783635, bricard});
  cases.push_back({"universal-joint", std::asin((1 - std::cos(kBend)) / (1 + std::cos(kBend))) / kDegree,
                   universal_joint});
}

}  // namespace pabd::validate
