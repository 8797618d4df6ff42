// SPDX-License-Identifier: MIT
// Turns a simulation state into things to see.
#pragma once

#include <optional>
#include <vector>

#include "render/visual/value_map.h"
#include "render/visual/visual_scene.h"
#include "sim/body/body_look.h"
#include "sim/body/model.h"
#include "sim/body/state.h"
#include "sim/solver/report.h"

namespace pabd {

// What the colours of contacts say: d/d̂, the normal force (N), or friction as a share of what Coulomb's law allows,
// ‖f_t‖/(μ f_n).
enum class ContactQuantity : std::uint8_t { gap, force, friction };
inline constexpr const char* kContactQuantities[] = {"gap", "force", "friction"};  // in this order
ContactQuantity contact_quantity(const std::string& name);  // gap where there is none of that name

struct VisualOptions {
  bool bonds = false;     // points of contact pairs and of joints, axes of joints
  bool contacts = false;  // normal arrows and discs; by force bars from body to body (force_chains.h)
  ContactQuantity contacts_by = ContactQuantity::gap;
  ValueRange force_range;  // N
  double d_hat = 0.01;     // for the colours; m
  double glyph_scale = 0;  // size of glyphs in m; 0: from the size of the bodies

  // A number a body to colour it by (value_map.h), instead of the palette; empty: the palette. Fixed bodies,
  // non-finite values and bodies beyond the end of the list are grey.
  std::vector<double> values;
  ValueRange value_range;

  // How bodies are drawn, by number; may be shorter than the list of bodies. Values win over its colours.
  std::vector<BodyLook> looks;

  // Of bodies, in front of them (body_marks.h).
  bool velocities = false, boxes = false;

  // What is selected is outlined, in front of everything. Numbers that are none select nothing.
  std::optional<Index> selected_body;
  std::optional<std::size_t> selected_joint;    // of Model::joints; its glyphs are shown
  std::optional<std::size_t> selected_contact;  // of StepReport::contact_reports; its glyphs are shown
};

// Fills `out` (reusing its memory). Fixed planes become `grounds`. `report` may lack contact reports. The
// camera is left alone; glyphs of joints have sizes that suit it, so set it before.
void build_visual(const Model& model, const State& state, const StepReport& report,
                  const VisualOptions& options, VisualScene& out);

// Adds the movable bodies of a second state of the same model, all in one translucent colour: where they are
// hidden by the first one, both agree (the ghost is a touch smaller for that). Bodies without a finite pose,
// and those beyond the end of the state, are left out. After build_visual.
void add_ghost(const Model& model, const State& state, const Vec4f& color, VisualScene& out);
Vec4f ghost_color();

// A camera that frames the movable bodies from a pleasing angle.
Camera frame_camera(const Model& model, const State& state, double aspect);

// Linear colour of a contact at x = d/d̂: below 0 penetrating, 1 untouched. The legend uses the same function.
Vec4f contact_color(double x);

}  // namespace pabd
