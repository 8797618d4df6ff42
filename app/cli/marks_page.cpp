// SPDX-License-Identifier: MIT
// See marks_page.h. Names, colours and places are read off the tables of panels and palettes; the words are here.
#include "app/cli/marks_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <string_view>

#include "app/overlay/overlay_panel_table.h"
#include "app/overlay/overlay_panels.h"
#include "app/overlay/overlay_style.h"
#include "render/visual/body_marks.h"
#include "render/visual/palette.h"
#include "render/visual/picture_marks.h"
#include "render/visual/value_map.h"
#include "sim/body/joint.h"

namespace pabd::cli {
namespace {

struct Words {
  std::string_view name, text;
};

constexpr Words kPanelWords[] = {
    {"params",
     "The parameters of the run, each with its unit: d̂ in m, κ in the unit of the barrier (`auto`: the value "
     "that it "
     "came to), ε and μ without one, h in s; iterations of the last step of those allowed; with joints their "
     "law "
     "and largest error in m; contacts, step, time in s."},
    {"barrier",
     "The barrier B_N and its derivative over the gap d (m), with the contacts of the last step under the "
     "curve, in "
     "the colour of their d/d̂: those that would touch are one, larger marker with its count, and a strip "
     "below says "
     "how many there are where. Left of 0 bodies overlap."},
    {"convergence",
     "The iterations of the last step: incremental energy above the end in J, residual without unit, largest "
     "overlap "
     "and joint error in m."},
    {"series",
     "Smallest gap, overlap and joint error in m, energies in J, over the simulated time in s. With `--ab` A "
     "is solid "
     "and B dashed."},
    {"legend", "The colours of contacts: d/d̂, without unit."},
    {"difference",
     "With `--ab`: the largest distance between a body of A and the same one of B, in m, over time in s."},
    {"", "The dots of bonds, and the colour of each type of joint that the scene has."},
};

constexpr Words kJointWords[] = {
    {"spherical", "leaves every rotation free"},
    {"hinge", "leaves a rotation about its axis free; pointer: the angle, arc: its limits"},
    {"slider", "leaves a motion along its axis free; bar: the offset, stops: its limits"},
    {"cylindrical", "leaves a motion along its axis and a rotation about it free"},
    {"universal", "leaves rotations about two axes free that stay square"},
    {"fixed", "leaves nothing free; drawn as its three axes"},
    {"distance", "holds the length between two points: a coil if soft, else a rod"},
};

constexpr Words kColourings[] = {
    {"body", "tells bodies apart; fixed ones are grey"},
    {"projection", "‖A − R‖, without unit: how far the solver's affine map is from a rotation"},
    {"speed", "of the centre, m/s"},
    {"energy", "kinetic energy, J"},
    {"component", "which bodies are solved together: one colour each, grey: alone or fixed"},
};

std::string words_for(std::span<const Words> list, std::string_view name, const char* what) {
  const auto found = std::find_if(list.begin(), list.end(), [&](const Words& w) { return w.name == name; });
  if (found == list.end())
    throw std::logic_error(
        fmt::format("marks: {} '{}' has no words; add them in marks_page.cpp", what, name));
  return std::string(found->text);
}

// As people call it, from hue, saturation and lightness.
std::string colour_name(const Color& c) {
  const double r = c.r / 255.0, g = c.g / 255.0, b = c.b / 255.0;
  const double most = std::max({r, g, b}), least = std::min({r, g, b}), range = most - least;
  const double light = 0.5 * (most + least);
  const std::string shade = light < 0.3 ? "dark " : light > 0.7 ? "light " : "";
  if (light > 0.85 && range < 0.2) return range < 0.05 ? "white" : "off-white";
  if (range < 0.12) return light < 0.12 ? "black" : shade + "grey";
  double hue = most == r   ? std::fmod((g - b) / range + 6, 6)
               : most == g ? (b - r) / range + 2
                           : (r - g) / range + 4;
  hue *= 60;  // degrees
  struct Hue {
    double to;
    const char* name;
  };
  constexpr Hue kHues[] = {{16, "red"},   {42, "orange"},  {70, "yellow"}, {160, "green"}, {190, "teal"},
                           {250, "blue"}, {290, "violet"}, {340, "pink"},  {361, "red"}};
  for (const Hue& each : kHues) {
    if (hue < each.to) return shade + each.name;
  }
  return shade + "red";
}

std::string ink(const Color& c) {
  return fmt::format("{} `#{:02x}{:02x}{:02x}`", colour_name(c), c.r, c.g, c.b);
}
std::string ink(const Vec4f& linear) { return ink(overlay_style::screen_ink(linear)); }

std::string place_words(PanelPlace place) {
  switch (place) {
    case PanelPlace::top_left:
      return "top left";
    case PanelPlace::column:
      return "right";
    case PanelPlace::bottom_left:
      return "bottom left";
  }
  return "";
}

std::string panel_rows() {
  std::string out = "| `--overlay` | place | shows |\n|---|---|---|\n";
  for (const OverlayPanel* panel : overlay_panels()) {
    std::string name = panel->name.empty() ? "" : fmt::format("`{}`", panel->name);
    if (panel->layer != PictureLayer::none)
      name += fmt::format("{}with `{}`", name.empty() ? "" : ", ",
                          panel->layer == PictureLayer::contacts ? "contacts" : "bonds");
    out += fmt::format("| {} | {} | {} |\n", name, place_words(panel->place),
                       words_for(kPanelWords, panel->name, "panel"));
  }
  return out;
}

std::string contact_rows() {
  std::string out = "| d/d̂ | colour | meaning |\n|--:|---|---|\n";
  struct Row {
    double x;
    const char* shown;
    const char* meaning;
  };
  constexpr Row kRows[] = {{-1, "−1", "bodies overlap by d̂ or more"},
                           {-1e-6, "below 0", "bodies overlap"},
                           {0, "0", "touching: the barrier is steepest"},
                           {0.2, "0.2", ""},
                           {0.4, "0.4", ""},
                           {0.6, "0.6", ""},
                           {0.8, "0.8", ""},
                           {1, "1", "d = d̂: the barrier begins, no force"}};
  for (const Row& row : kRows)
    out += fmt::format("| {} | {} | {} |\n", row.shown, ink(contact_ink(row.x)), row.meaning);
  return out;
}

std::string joint_rows() {
  std::string out = "| type | colour | meaning |\n|---|---|---|\n";
  for (const JointType type : kJointTypes)
    out += fmt::format("| `{}` | {} | {} |\n", to_string(type), ink(joint_color(type)),
                       words_for(kJointWords, to_string(type), "joint"));
  return out;
}

std::string body_mark_rows() {
  std::string out = "| `--overlay` | shows |\n|---|---|\n";
  for (const PictureMark& mark : picture_marks()) out += fmt::format("| `{}` | {} |\n", mark.name, mark.help);
  out += "\nThe first five trails of `--trail` are";
  for (std::size_t k = 0; k < kTrailInks; ++k)
    out += fmt::format("{} {}", k == 0 ? "" : ",", ink(trail_color(k)));
  return out + "; they fade with their age.\n";
}

std::string colouring_rows() {
  std::string out = "| `color_by` | says |\n|---|---|\n";
  for (const Words& each : kColourings) out += fmt::format("| `{}` | {} |\n", each.name, each.text);
  return out + fmt::format("\nNumbers go from {} over {} to {}; grey: no number.\n", ink(value_color(0)),
                           ink(value_color(0.5)), ink(value_color(1)));
}

}  // namespace

std::string marks_page() {
  return "# Marks in pictures\n\n"
         "What `pabd render --overlay` and the window draw in the picture and over it. Written by `pabd "
         "marks`; do not "
         "edit it by hand.\n\n"
         "## Panels\n\n" +
         panel_rows() +
         "\n`plots` stands for the panels at the right that need no `--ab`, `all` for every panel that needs "
         "none, with "
         "`contacts` and `bonds`.\n\n"
         "## Contacts\n\n"
         "With `contacts`, for every contact of the last step: a disc at the point of contact, in the colour "
         "of the "
         "gap, with a dark rim, and an arrow along the normal, the force on the movable body, of two the "
         "upper one. Its "
         "length grows with the logarithm of the normal force f_n (N); no force, no arrow. Of more than 300 "
         "contacts "
         "those of one pair with the same normal are one mark. Overlap is darker than all else.\n\n" +
         contact_rows() +
         fmt::format(
             "\n## Bonds and joints\n\n"
             "With `bonds`, for every bond its two points: y_i on the one body, a {} dot, and y_j on the "
             "other, a "
             "{} disc with a rim in the colour of the joint's type. Where they meet they make a bullseye; "
             "where "
             "they do not, a {} line as long as the error (m) joins them. Of contacts the two points and the "
             "line "
             "between them are shown alike.\n\n",
             ink(bond_point_i_color()), ink(bond_point_j_color()), ink(bond_line_color())) +
         joint_rows() +
         "\n## Motion, size and place\n\n"
         "Not part of `all`; in the window in the menu View.\n\n" +
         body_mark_rows() +
         "\n## Bodies\n\n"
         "In the window *colour* chooses what the colours of bodies say; `pabd render` shows `body`.\n\n" +
         colouring_rows();
}

}  // namespace pabd::cli
