// SPDX-License-Identifier: MIT
// Colours by value, outlines of what is selected, ghosts and springs: numbers of the visual scene.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <map>

#include "render/visual/build_visual.h"
#include "render/visual/outline.h"
#include "render/visual/palette.h"
#include "sim/body/convex_hull.h"
#include "tests/support/tiny_model.h"

namespace pabd::test_selection {

namespace {

// CIE L* of linear RGB.
double lightness(const Vec3& rgb) {
  const double y = 0.2126 * rgb.x() + 0.7152 * rgb.y() + 0.0722 * rgb.z();
  return 116 * std::cbrt(std::max(y, 0.008856)) - 16;
}

// CIE L*a*b* of linear sRGB.
Vec3 lab(const Vec3& rgb) {
  Mat3 to_xyz;
  to_xyz << 0.4124, 0.3576, 0.1805, 0.2126, 0.7152, 0.0722, 0.0193, 0.1192, 0.9505;
  const Vec3 f = (to_xyz * rgb).cwiseQuotient(Vec3(0.9505, 1, 1.089)).array().max(1e-6).pow(1 / 3.0);
  return {116 * f.y() - 16, 500 * (f.x() - f.y()), 200 * (f.y() - f.z())};
}

Vec3 map_at(double t) { return value_color(t).head<3>().cast<double>(); }

// The pieces of a closed outline: each end is met by exactly one other piece. Returns how many there are.
int closed_pieces(const std::vector<Line>& lines) {
  std::map<std::tuple<long, long, long>, int> ends;
  const auto key = [](const Vec3f& p) {
    return std::tuple{std::lround(p.x() * 1e3f), std::lround(p.y() * 1e3f), std::lround(p.z() * 1e3f)};
  };
  for (const Line& line : lines) {
    ++ends[key(line.a)];
    ++ends[key(line.b)];
  }
  for (const auto& [place, count] : ends) CHECK(count == 2);
  return static_cast<int>(lines.size());
}

// The narrow half of the lines: every outline is drawn in a wide pen and again in a narrow one.
std::vector<Line> narrow(const VisualScene& scene) {
  const auto half = static_cast<std::ptrdiff_t>(scene.lines.size() / 2);
  return {scene.lines.begin() + half, scene.lines.end()};
}

std::vector<Line> outline(const Shape& shape, const Pose& pose, const Vec3f& eye) {
  VisualScene scene;
  scene.camera.eye = eye;
  scene.camera.target = {0, 0, 0};
  add_outline(shape, pose, scene);
  for (const Line& line : scene.lines) CHECK(line.on_top);
  return narrow(scene);
}

const Pose kTurned{{0.3, 0.2, -0.1}, Eigen::AngleAxisd(0.8, Vec3(1, 2, 0.5).normalized()).toRotationMatrix()};

TinyModel two_balls_on_a_floor() {
  TinyModel tiny;
  tiny.add_fixed(Plane{{0, 1, 0}, 0}, Vec3::Zero());
  tiny.add(Sphere{0.5}, {0, 0.5, 0});
  tiny.add(Box{{0.5, 0.4, 0.3}}, {2, 0.4, 0});
  return tiny;
}

}  // namespace

TEST_CASE("the map of values: lighter all the way, in steps that look equal, within what screens show") {
  double least = 1e9, most = 0;
  for (int k = 0; k < 20; ++k) {
    const Vec3 a = map_at(k / 20.0), b = map_at((k + 1) / 20.0);
    CHECK(lightness(b) > lightness(a) + 1);
    const double step = (lab(b) - lab(a)).norm();
    least = std::min(least, step);
    most = std::max(most, step);
    CHECK((a.array() > 0 && a.array() < 1).all());  // nothing was cut off
  }
  CHECK(most < 1.9 * least);  // CIELAB and OKLab do not agree better on blues
}

TEST_CASE("the map keeps its order for people who lack one kind of cone") {
  // Linear RGB as protanopes, deuteranopes and tritanopes see it (Viénot 1999; Brettel 1997, one half plane).
  Mat3 protan, deutan, tritan;
  protan << 0.112, 0.888, 0, 0.112, 0.888, 0, 0.004, -0.004, 1;
  deutan << 0.292, 0.708, 0, 0.292, 0.708, 0, -0.022, 0.022, 1;
  tritan << 1.013, 0.143, -0.156, -0.012, 0.869, 0.143, 0.078, 0.694, 0.228;
  for (const Mat3& sight : {protan, deutan, tritan}) {
    for (int k = 0; k < 10; ++k)
      CHECK(lightness(sight * map_at((k + 1) / 10.0)) > lightness(sight * map_at(k / 10.0)) + 1.5);
  }
}

TEST_CASE("values find their place in the range; nonsense finds one too") {
  CHECK(ValueRange{2, 4, false}.place(3) == Approx(0.5));
  CHECK(ValueRange{2, 4, false}.place(9) == 1);
  CHECK(ValueRange{2, 4, false}.place(-9) == 0);
  CHECK(ValueRange{1e-6, 1e-2, true}.place(1e-4) == Approx(0.5));
  CHECK(ValueRange{1e-6, 1e-2, true}.place(0) == 0);
  CHECK(ValueRange{3, 3, false}.place(3) == 0);
  CHECK(ValueRange{-1, 3, true}.place(2) == 0);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(std::isnan(ValueRange{}.place(nan)));
  CHECK(value_color(nan) == no_value_color());
  CHECK(value_color(-3) == value_color(0));
  CHECK(value_color(7) == value_color(1));
}

TEST_CASE("bodies take the colours of their values; fixed ones and those without a number are grey") {
  TinyModel tiny = two_balls_on_a_floor();
  tiny.add_fixed(Sphere{0.2}, {4, 1, 0});
  tiny.add(Sphere{0.2}, {5, 1, 0});
  tiny.add(Sphere{0.2}, {6, 1, 0});
  VisualOptions options;
  options.values = {0, 0.25, 5, 1, std::nan("")};  // none for the last body
  options.value_range = {0, 1, false};
  options.contacts = true;  // colours that mean something do not step back
  VisualScene scene;
  build_visual(tiny.model, tiny.state, {}, options, scene);
  const auto& balls = scene.instances[static_cast<int>(Primitive::sphere)];
  REQUIRE(balls.size() == 4);
  CHECK(balls[0].color == value_color(0.25));
  CHECK(scene.instances[static_cast<int>(Primitive::cube)][0].color == value_color(1));
  CHECK(balls[1].color == body_color(3, true));
  CHECK(balls[2].color == no_value_color());
  CHECK(balls[3].color == no_value_color());
}

TEST_CASE("the outline of a ball is where lines of sight touch it") {
  const Vec3 eye(3, 2, 5);
  const auto lines = outline(Sphere{0.7}, kTurned, eye.cast<float>());
  REQUIRE(lines.size() > 30);
  closed_pieces(lines);
  for (const Line& line : lines) {
    const Vec3 p = line.a.cast<double>();
    CHECK((p - kTurned.c).norm() == Approx(0.7).epsilon(1e-5));
    CHECK((p - kTurned.c).dot(p - eye) == Approx(0).margin(1e-5));
  }
}

TEST_CASE("the outline of a capsule touches it too, and closes") {
  const Capsule capsule{0.3, 0.9};
  const Vec3 u = kTurned.R.col(1);
  for (const Vec3& eye : {Vec3(3, 2, 5), Vec3(-4, 0.5, 1), Vec3(0.5, -6, 0.2)}) {
    const auto lines = outline(capsule, kTurned, eye.cast<float>());
    closed_pieces(lines);
    for (const Line& line : lines) {
      const Vec3 p = line.a.cast<double>(), q = p - kTurned.c;
      const Vec3 on_axis = std::clamp(q.dot(u), -0.45, 0.45) * u;
      CHECK((q - on_axis).norm() == Approx(0.3).epsilon(1e-4));
      CHECK((q - on_axis).dot(p - eye) == Approx(0).margin(1e-4));
    }
  }
  // Along the axis: the circle of the nearer end.
  const Vec3f eye = (kTurned.c + 5 * u).cast<float>();
  for (const Line& line : outline(capsule, kTurned, eye))
    CHECK((line.a.cast<double>() - kTurned.c - 0.45 * u).norm() == Approx(0.3).epsilon(1e-4));
}

TEST_CASE("boxes and hulls: the edges between what is seen and what is not") {
  const Box box{{0.5, 0.4, 0.3}};
  const Pose pose{Vec3::Zero(), Mat3::Identity()};
  CHECK(closed_pieces(outline(box, pose, {3, 2, 4})) == 6);  // three faces seen
  CHECK(closed_pieces(outline(box, pose, {0, 2, 4})) == 6);  // two
  CHECK(closed_pieces(outline(box, pose, {0, 0, 4})) == 4);
  CHECK(outline(box, pose, {0.1f, 0.1f, 0.1f}).empty());  // from within
  std::vector<Vec3> corners;
  for (int k = 0; k < 8; ++k)
    corners.push_back(Vec3(k & 1 ? 0.5 : -0.5, k & 2 ? 0.4 : -0.4, k & 4 ? 0.3 : -0.3));
  const Hull hull{make_hull(corners).hull};
  for (const Vec3f& eye : {Vec3f(3, 2, 4), Vec3f(0, 0, 4), Vec3f(-2, 0.1f, 0.2f)})
    CHECK(closed_pieces(outline(hull, kTurned, eye)) == closed_pieces(outline(box, kTurned, eye)));
}

TEST_CASE("what is selected is outlined, what is not there is not") {
  const TinyModel tiny = two_balls_on_a_floor();
  StepReport report;
  report.contact_reports.push_back(
      {0, 1, {0, 0, 0}, {0, 0.01, 0}, {0, 1, 0}, 0.01, 1e5, Vec3::Zero(), true, 0});
  VisualOptions options;
  VisualScene scene;
  build_visual(tiny.model, tiny.state, report, options, scene);
  CHECK(scene.lines.empty());
  options.selected_body = 2;
  build_visual(tiny.model, tiny.state, report, options, scene);
  CHECK(closed_pieces(narrow(scene)) >= 4);
  for (const Index none : {-1, 3, 1000, 0}) {  // 0: the floor
    options.selected_body = none;
    build_visual(tiny.model, tiny.state, report, options, scene);
    CHECK(scene.lines.empty());
  }
  options.selected_body.reset();
  options.selected_contact = 0;
  build_visual(tiny.model, tiny.state, report, options, scene);
  CHECK(closed_pieces(narrow(scene)) > 8);                                // a ring
  CHECK(scene.instances[static_cast<int>(Primitive::cone)].size() == 2);  // and its rim
  options.contacts = true;                                                // its arrow is there anyway
  build_visual(tiny.model, tiny.state, report, options, scene);
  CHECK(scene.instances[static_cast<int>(Primitive::cone)].size() == 2);  // and its rim
  options.contacts = false;
  options.selected_contact = 1;
  options.selected_joint = 0;
  build_visual(tiny.model, tiny.state, report, options, scene);
  CHECK(scene.lines.empty());
}

TEST_CASE("a ghost is the movable bodies of another state, translucent and without shadows") {
  const TinyModel tiny = two_balls_on_a_floor();
  State other = tiny.state;
  other.c[1] += Vec3(0.3, 0, 0);
  VisualScene scene;
  build_visual(tiny.model, tiny.state, {}, {}, scene);
  add_ghost(tiny.model, other, ghost_color(), scene);
  const auto& balls = scene.instances[static_cast<int>(Primitive::sphere)];
  REQUIRE(balls.size() == 2);
  CHECK(balls[1].transform(0, 3) - balls[0].transform(0, 3) == Approx(0.3));
  CHECK(balls[1].transform(0, 0) < balls[0].transform(0, 0));  // hidden where both agree
  CHECK(balls[1].transform(0, 0) == Approx(balls[0].transform(0, 0)).epsilon(0.005));
  CHECK(balls[1].color == ghost_color());
  CHECK(ghost_color().w() < 1);
  CHECK_FALSE(balls[1].shadow);
  CHECK(scene.instances[static_cast<int>(Primitive::cube)].size() == 2);
  CHECK(scene.grounds.size() == 1);
  // A state of a smaller model, or one that blew up, shows what it has.
  other.c.resize(2);
  other.c[1].x() = std::nan("");
  build_visual(tiny.model, tiny.state, {}, {}, scene);
  add_ghost(tiny.model, other, ghost_color(), scene);
  CHECK(balls.size() == 1);
}

TEST_CASE("a spring goes from the hand to the body; without numbers there is none") {
  VisualScene scene;
  scene.camera.eye = {0, 0, 5};
  scene.camera.target = {0, 0, 0};
  const Vec3 hand(1, 1, 0), body(-1, 0, 0);
  add_spring(hand, body, scene);
  const auto touches = [&](const Vec3& p) {
    return std::any_of(scene.lines.begin(), scene.lines.end(), [&](const Line& line) {
      return (line.a.cast<double>() - p).norm() < 1e-6 || (line.b.cast<double>() - p).norm() < 1e-6;
    });
  };
  CHECK(touches(hand));
  CHECK(touches(body));
  CHECK(scene.instances[static_cast<int>(Primitive::disc)].size() == 2);
  VisualScene none;
  add_spring(hand, {0, std::nan(""), 0}, none);
  CHECK(none.lines.empty());
  add_spring(hand, hand, none);  // not stretched at all: the ring and the dot
  CHECK_FALSE(none.lines.empty());
}

}  // namespace pabd::test_selection
