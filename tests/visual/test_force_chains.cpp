// SPDX-License-Identifier: MIT
// Bars that show where loads go, and colours of contacts by force and friction.
#include "render/visual/force_chains.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "render/visual/contact_glyphs.h"
#include "render/visual/value_map.h"
#include "tests/support/tiny_model.h"

namespace pabd::test_force_chains {

namespace {

constexpr double kWeight = 9810;  // of a box, N

// Two boxes of 1 m³ on a floor, on four points each: the lower pair carries both.
struct Stack {
  TinyModel tiny;
  StepReport report;

  Stack() {
    tiny.add_fixed(Plane{{0, 1, 0}, 0}, Vec3::Zero());
    tiny.add(Box{{0.5, 0.5, 0.5}}, {0, 0.5, 0});
    tiny.add(Box{{0.5, 0.5, 0.5}}, {0.2, 1.5, 0});
    for (Index upper : {1, 2}) {
      for (const double x : {-0.5, 0.5}) {
        for (const double z : {-0.5, 0.5}) {
          const Vec3 at(x, upper - 1, z);
          // More on the right.
          const double force = (x > 0 ? 0.3 : 0.2) * (3 - upper) * kWeight;
          const Vec3 friction(0.1 * force, 0, 0);
          report.contact_reports.push_back(
              {upper - 1, upper, at, at, {0, 1, 0}, 0.005, force, friction, true, 0.4});
        }
      }
    }
  }
  VisualScene drawn(ContactQuantity by) const {
    VisualOptions options;
    options.contacts = true;
    options.contacts_by = by;
    options.glyph_scale = 0.13;
    options.force_range = force_range(largest_force(tiny.model, report));
    VisualScene out;
    build_visual(tiny.model, tiny.state, report, options, out);
    return out;
  }
};

bool anywhere(const Vec3&, const Vec3&) { return true; }

}  // namespace

TEST_CASE(
    "what two bodies press each other with is a bar from centre to centre through the middle of the load") {
  const Stack stack;
  CHECK(largest_force(stack.tiny.model, stack.report) == Approx(2 * kWeight));
  const ValueRange range = force_range(2 * kWeight);
  CHECK(range.hi == 20000);
  CHECK(range.lo == Approx(20));
  CHECK(range.logarithmic);

  const VisualScene scene = stack.drawn(ContactQuantity::force);
  CHECK(scene.instances[static_cast<int>(Primitive::disc)].empty());  // in place of discs and arrows
  CHECK(scene.instances[static_cast<int>(Primitive::cone)].empty());
  // Of each pair two halves over their rims; the weak one first, the strong one with its foot on the floor.
  REQUIRE(scene.lines.size() == 8);
  const Line &weak = scene.lines[2], &weak_above = scene.lines[3], &foot = scene.lines[6],
             &strong = scene.lines[7];
  CHECK(weak.color == value_color(range.place(kWeight)));
  CHECK(weak_above.color == weak.color);
  CHECK(strong.color == value_color(range.place(2 * kWeight)));
  CHECK(foot.color == strong.color);
  CHECK(strong.width > 1.1f * weak.width);
  CHECK(scene.lines[5].width > strong.width + 2);  // its rim
  for (const Line& line : scene.lines) CHECK(line.on_top);
  // 60 % of the load at x = 0.5, the rest at −0.5: its middle at 0.1 (ends reach half a width beyond).
  const auto near = [](const Vec3f& p, const Vec3f& q) { return (p - q).norm() < 0.1f; };
  CHECK(near(strong.a, {0.1f, 0, 0}));
  CHECK(near(strong.b, {0, 0.5f, 0}));
  CHECK(near(weak.a, {0.1f, 1, 0}));
  CHECK(near(weak.b, {0, 0.5f, 0}));
  CHECK(near(weak_above.b, {0.2f, 1.5f, 0}));
  CHECK(near(0.5f * (foot.a + foot.b), {0.1f, 0, 0}));
}

TEST_CASE("far less than the largest force makes no bar, and no force none at all") {
  Stack stack;
  for (ContactReport& contact : stack.report.contact_reports) {
    if (contact.b == 2) contact.normal_force *= 1e-3;
  }
  CHECK(stack.drawn(ContactQuantity::force).lines.size() == 4);
  for (ContactReport& contact : stack.report.contact_reports) contact.normal_force = 0;
  CHECK(stack.drawn(ContactQuantity::force).lines.empty());
  stack.report.contact_reports.clear();
  CHECK(largest_force(stack.tiny.model, stack.report) == 0);
  CHECK(stack.drawn(ContactQuantity::force).lines.empty());
}

TEST_CASE("friction colours marks by the used part of what Coulomb's law allows; without any they are grey") {
  Stack stack;
  stack.report.contact_reports.front().mu = 0;
  stack.report.contact_reports.front().friction.setZero();
  const VisualScene scene = stack.drawn(ContactQuantity::friction);
  const auto& discs = scene.instances[static_cast<int>(Primitive::disc)];
  REQUIRE(discs.size() == 16);  // each over its rim
  CHECK(discs[1].color == no_value_color());
  CHECK((discs[3].color - value_color(0.25)).norm() < 1e-5f);  // 0.1 of 0.4
  CHECK_FALSE(scene.instances[static_cast<int>(Primitive::cone)].empty());
}

TEST_CASE("the friction of several contacts in one mark is the part of what they may have together") {
  Stack stack;
  auto& contacts = stack.report.contact_reports;
  contacts.front().friction *= 3;  // f = 0.4 W: 0.12 W instead of 0.04 W, of 0.4 · 2 W in all
  const auto merged = merged_contacts(stack.tiny.model, stack.report, anywhere);
  REQUIRE(merged.size() == 2);
  CHECK(merged[0].slip == Approx((0.2 + 0.08) / (0.4 * 2)));
  CHECK(merged[1].slip == Approx(0.25));
}

}  // namespace pabd::test_force_chains
