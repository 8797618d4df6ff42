// SPDX-License-Identifier: MIT
// The state of the program as JSON: what scripts print and expect (scripts.md). Of at most kMostBodies bodies.
#include "app/frames/frame_text.h"
#include "app/gui/pictures.h"
#include "app/gui/script.h"
#include "app/plots/figures/difference.h"
#include "app/workbench/command_json.h"
#include "sim/base/ordered_json.h"
#include "sim/scene/tuning.h"
#include "sim/solver/step_numbers.h"
#include "sim/trace/trace.h"

namespace pabd {
namespace {

constexpr std::size_t kMostBodies = 100;

OrderedJson vec(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

OrderedJson report_json(const StepReport& report) {
  OrderedJson out = {{"method", to_string(report.method)},
                     {"status", to_string(report.status)},
                     {"records", report.records.size()},
                     {"contact_reports", report.contact_reports.size()}};
  for (const StepNumber& number : step_numbers())
    std::visit([&](const auto of) { out[std::string(number.name)] = report.*of; }, number.member);
  return out;
}

OrderedJson run_json(const RunView& run) {
  OrderedJson params = OrderedJson::parse(params_json(run.params));
  OrderedJson changed = OrderedJson::object();
  for (const auto& [key, value] : run.changed) changed[key] = value;
  OrderedJson bodies = OrderedJson::array();
  for (std::size_t i = 0; i < std::min(kMostBodies, run.state->c.size()); ++i) {
    bodies.push_back({{"name", run.model->name[i]},
                      {"position", vec(run.state->c[i])},
                      {"velocity", vec(run.state->v[i])}});
  }
  OrderedJson parting;
  if (run.parting) {
    parting = {{"time", run.parting->time}, {"differs", nullptr}, {"parted", nullptr}};
    if (run.parting->differs) parting["differs"] = *run.parting->differs;
    if (run.parting->parted) parting["parted"] = *run.parting->parted;
  }
  return {{"step", run.state->step},
          {"time", run.state->time},
          {"hash", state_hash(*run.state)},
          {"cursor", run.cursor},
          {"moments", run.history.size()},
          {"left", run.left ? run.left->size() : 0},
          {"parting", parting},
          {"params", std::move(params)},
          {"device", {{"name", run.device.name}, {"why", run.device.why}}},
          {"gone", run.gone},
          {"kappa", run.kappa},
          {"changed", std::move(changed)},
          {"joints_default", OrderedJson::parse(parameters_json(run.params, run.kappa,
                                                                &run.scene->joint_law))["joints_default"]},
          {"report", report_json(run.report)},
          {"pulls", run.pulls.size()},
          {"bodies", std::move(bodies)},
          {"body_count", run.model->shape.size()},
          {"joint_count", run.model->joints.size()}};
}

// Keys of what is chosen, also where the view leaves that open.
OrderedJson sweep_json(const OpenedSweep& sweep) {
  if (sweep.folder.empty()) return nullptr;
  OrderedJson json = {{"folder", sweep.folder}, {"reading", sweep.reading}, {"problem", sweep.problem}};
  if (!sweep.read) return json;
  const CollectedSweep& read = *sweep.read;
  json["tasks"] = read.tasks.size();
  for (const SweptStatus status : kSweptStatuses) json[std::string(status_word(status))] = read.count(status);
  const ShownSweep shown = shown_of(read, sweep.view);
  const auto key = [&](const GridAxis& axis) {
    return axis.parameter ? read.parameters[*axis.parameter].key : "";
  };
  json["columns"] = shown.grid.columns();
  json["rows"] = shown.grid.rows();
  json["slices"] = shown.grid.slices.size();
  json["x"] = key(shown.grid.x);
  json["y"] = key(shown.grid.y);
  const bool measured = shown.criterion < shown.criteria.size();
  json["metric"] = measured ? shown.criteria[shown.criterion].quantity.key : "";
  json["slice"] = shown.slice;
  json["pictures"] = sweep.view.pictures;
  json["loaded"] = sweep.loaded ? OrderedJson(read.tasks[*sweep.loaded].index) : OrderedJson();
  return json;
}

// Places in pixels of the window, as left, top, width, height; null: not shown.
OrderedJson layout_json(const GuiLayout& layout, const UiState& ui) {
  const auto place = [](const Rect& r) {
    return r.w > 0 && r.h > 0 ? OrderedJson{r.x, r.y, r.w, r.h} : OrderedJson();
  };
  OrderedJson out = {{"toolbar", place(layout.toolbar)},
                     {"timeline", place(layout.timeline)},
                     {"picture", place(layout.view)}};
  OrderedJson tabs = OrderedJson::object(), borders = OrderedJson::object();
  for (const Slot slot : kSlots) {
    const std::string name(slot_name(slot));
    out[name] = place(layout.slots[slot]);
    if (out[name].is_null()) continue;
    for (const WindowPanel* panel : tabs_of(layout, ui, slot)) tabs[name].push_back(panel->name);
  }
  for (const LayoutBorder& border : layout.borders)
    borders[kBorders[static_cast<std::size_t>(border.what)].name] = place(border.rect);
  out["tabs"] = std::move(tabs);
  out["borders"] = std::move(borders);
  return out;
}

}  // namespace

OrderedJson state_document(const Snapshot& sim, const UiState& ui, const GuiLayout& layout) {
  OrderedJson panels = OrderedJson::array(), camera_keys = OrderedJson::array(),
              trails = OrderedJson::array();
  for (const TrailPoint& point : ui.trails) trails.push_back(trail_words(point));
  for (const Slot slot : kSlots) panels.push_back(ui.shown[slot]->name);
  for (const CameraKey& key : ui.camera_keys)
    camera_keys.push_back({{"time", key.time}, {"eye", vec(key.pose.eye)}});
  OrderedJson plots = OrderedJson::object();
  for (const Choice& panel : kPlottingPanels) {
    plots[panel.name] = command_to_json(ViewCommand(plot_view(panel.name, ui.zoom_of(panel.name))));
  }
  OrderedJson held = OrderedJson::array(), sizes = OrderedJson::object();
  for (std::size_t i = 0; i < kBorderCount; ++i) sizes[kBorders[i].name] = ui.sizes.of[i];
  for (const HeldCurve& h : sim.held) held.push_back(h.name);
  OrderedJson messages = OrderedJson::array();
  for (const Message& m : sim.messages) messages.push_back(m.text);
  return {{"scene", {{"name", sim.scene->name}, {"hash", sim.scene->hash}}},
          {"a", run_json(sim.a)},
          {"b", sim.b ? run_json(*sim.b) : OrderedJson()},
          {"distances", sim.distances.size()},
          {"distance", sim.b ? state_distance(*sim.a.state, *sim.b->state).position : 0},
          {"playing", sim.playing},
          {"speed", sim.speed},
          {"diverged", sim.diverged},
          {"unsaved", sim.unsaved},
          {"at_stake", sim.at_stake},
          {"reload_loses", sim.reload_loses},
          {"file_changed", sim.file_changed},
          {"can_undo", sim.can_undo},
          {"undo_text", sim.undo_text},
          {"can_redo", sim.can_redo},
          {"held", std::move(held)},
          {"message", sim.messages.empty() ? "" : sim.messages.back().text},
          {"messages", std::move(messages)},
          {"sweep", sweep_json(ui.sweep)},
          {"layout", layout_json(layout, ui)},
          {"ui",
           {{"dark", ui.dark},
            {"scale", ui.scale},
            {"help", ui.help},
            {"palette", ui.palette},
            {"hidden", ui.hidden},
            {"panels", std::move(panels)},
            {"open", ui.open.of},
            {"sizes", std::move(sizes)},
            {"eye", vec(ui.camera.eye)},
            {"target", vec(ui.camera.target)},
            {"fov", ui.camera.fov},
            {"ortho", ui.camera.orthographic},
            {"follow", ui.follow ? *ui.follow : -1},
            {"camera_keys", std::move(camera_keys)},
            {"keys_unsaved", ui.keys_unsaved},
            {"fly", ui.fly},
            {"along", ui.along},
            {"costs", ui.costs},
            {"contacts", ui.contacts},
            {"bonds", ui.bonds},
            {"shown", overlay_words(ui)},
            {"background", std::string(ui.theme->name)},
            {"trails", std::move(trails)},
            {"color", kColors[static_cast<std::size_t>(ui.color)].name},
            {"contacts_by", kContactQuantities[static_cast<std::size_t>(ui.contacts_by)]},
            {"selection",
             {{"kind", kSelectionKinds[static_cast<std::size_t>(ui.selection.kind)].name},
              {"index", ui.selection.index}}},
            {"joining", ui.joining ? ui.joining->type : ""},
            {"side_by_side", ui.side_by_side},
            {"convergence", ui.convergence},
            {"series", ui.series},
            {"series_x", ui.series_x},
            {"series_y", ui.series_y},
            {"difference", ui.difference},
            {"plots", std::move(plots)},
            {"barrier", command_to_json(ViewCommand(ui.barrier))},
            {"dialog", ui.dialog},
            {"dialog_text", ui.dialog_text},
            {"quit", ui.quit}}}};
}

}  // namespace pabd
