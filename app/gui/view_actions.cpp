// SPDX-License-Identifier: MIT
// See view_actions.h.
#include "app/gui/view_actions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <vector>

#include "app/frames/camera_keys.h"
#include "app/gui/camera_motion.h"
#include "app/gui/pictures.h"
#include "app/gui/scene_view.h"
#include "app/workbench/command_json.h"
#include "render/visual/bounds.h"
#include "sim/base/error.h"
#include "sim/base/shell_quoted.h"
#include "sim/scene/text.h"

namespace pabd {
namespace {

constexpr double kStepBack = 1.4;  // between cut-off sides and small bodies

Vec3 point(const std::vector<double>& v, const char* command, const char* what) {
  if (v.size() != 3 ||
      !std::all_of(v.begin(), v.end(), [](double x) { return std::isfinite(x) && std::abs(x) <= 1e6; })) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: \"{}\": expected three numbers up to 1e6, in metres", command, what));
  }
  return {v[0], v[1], v[2]};
}

struct Actor {
  const Snapshot& sim;
  const Viewport& port;
  UiState& ui;

  void operator()(const command::Panel& c) const {
    const WindowPanel& panel = find_panel(c.panel);
    if (c.on) return ui.bring(panel);
    ui.open[panel.slot] = false;
  }
  void operator()(const command::PanelSize& c) const {
    const auto border = static_cast<Border>(place_in(kBorders, c.border));
    const SizeRange range = size_range(border);
    if (c.size != 0 && !(c.size >= range.least && c.size <= range.most))
      throw Error(ErrorKind::bad_input, fmt::format("panel_size: of \"{}\" expected {} to {}, or 0, got {}",
                                                    c.border, range.least, range.most, c.size));
    ui.sizes[border] = c.size;
  }
  void operator()(const command::Theme& c) const { ui.dark = c.dark; }
  void operator()(const command::Scale& c) const {
    if (!(c.factor >= 0.5 && c.factor <= 4))
      throw Error(ErrorKind::bad_input, fmt::format("scale: expected 0.5 to 4, got {}", c.factor));
    ui.scale = c.factor;
  }
  void operator()(const command::Help& c) const { ui.help = c.on; }
  void operator()(const command::Palette& c) const { ui.palette = c.on; }
  void operator()(const command::HideUi& c) const { ui.hidden = c.on; }
  void operator()(const command::Look& c) const {
    CameraPose pose = ui.camera;
    pose.eye = point(c.eye, "look", "eye");
    pose.target = point(c.target, "look", "target");
    if (!(pose.distance() > 1e-6))
      throw Error(ErrorKind::bad_input, "look: the eye is in the target; expected two different points");
    if (c.fov != 0) {
      if (!(c.fov >= 1 && c.fov <= 170))
        throw Error(ErrorKind::bad_input,
                    fmt::format("look: \"fov\": expected 1 to 170 degrees, got {}", c.fov));
      pose.fov = c.fov;
    }
    ui.camera = pose;
  }
  void operator()(const command::LookFrom& c) const {
    static constexpr AxisView kSides[] = {AxisView::front, AxisView::right, AxisView::top,   AxisView::iso,
                                          AxisView::back,  AxisView::left,  AxisView::bottom};
    const std::size_t i = place_in(kLookFrom, c.choice);
    if (i == 0) return look_as_scene(*sim.scene, port, ui);
    frame_spots(everything(true), look_from(ui.camera, kSides[i - 1]), port, ui);
  }
  void operator()(const command::Ortho& c) const {
    ui.camera.orthographic = c.on;
    if (ui.framed && !ui.framed->spots->empty()) frame_spots(ui.framed->spots, ui.camera, port, ui);
  }
  void operator()(const command::Follow& c) const {
    if (c.body.empty()) return ui.follow.reset();
    const Index body = index_of(Selection::Kind::body, c.body, "follow");
    if (is_plane(sim.a.model->shape[static_cast<std::size_t>(body)]))
      throw Error(ErrorKind::bad_input,
                  fmt::format("follow: {} is a plane, and never moves", in_quotes(c.body)));
    ui.follow = body;
  }
  void operator()(const command::FrameSelection&) const {
    if (ui.selection.kind == Selection::Kind::none)
      return frame_spots(everything(false), ui.camera, port, ui);
    if (const auto sphere = selected_sphere()) ui.camera = frame_sphere(ui.camera, port, *sphere);
  }
  void operator()(const command::Select& c) const {
    Selection selection;
    selection.kind = static_cast<Selection::Kind>(place_in(kSelectionKinds, c.kind));
    if (selection.kind != Selection::Kind::none) selection.index = index_of(selection.kind, c.item, "select");
    if (!c.at.empty()) selection.at = point(c.at, "select", "at");
    if (!c.normal.empty()) selection.normal = point(c.normal, "select", "normal");
    if (selection.kind == Selection::Kind::contact) {
      const ContactReport& contact = sim.a.report.contact_reports[static_cast<std::size_t>(selection.index)];
      selection.a = contact.a;
      selection.b = contact.b;
    }
    ui.selection = selection;
    ui.joining.reset();
    if (selection.kind != Selection::Kind::none) ui.shown[inspector_tab.slot] = &inspector_tab;
  }
  void operator()(const command::Join& c) const {
    if (c.type.empty()) return ui.joining.reset();
    if (ui.selection.kind != Selection::Kind::body)
      throw Error(ErrorKind::bad_input, "join: select the first body, by a double-click on it");
    ui.joining = Joining{c.type, ui.selection.index, ui.selection.at};
  }
  void operator()(const command::ColorBy& c) const {
    ui.color = static_cast<ColorQuantity>(place_in(kColors, c.choice));
  }
  void operator()(const command::ContactsBy& c) const {
    ui.contacts_by = contact_quantity(c.choice);
    ui.contacts = true;
  }
  void operator()(const command::Show& c) const {
    const std::size_t i = place_in(mark_choices(), c.what);
    (i == 0 ? ui.contacts : i == 1 ? ui.bonds : ui.marks.*(picture_marks()[i - 2].on)) = c.on;
  }
  void operator()(const command::Background& c) const {
    ui.theme = picture_themes()[place_in(kBackgrounds, c.choice)];
  }
  void operator()(const command::Trail& c) const {
    TrailPoint point = parse_trail(c.of, "trail");
    if (!point.body.empty())
      point.body =
          sim.a.model->name[static_cast<std::size_t>(index_of(Selection::Kind::body, point.body, "trail"))];
    std::erase(ui.trails, point);
    if (c.on) ui.trails.push_back(point);
  }
  void operator()(const command::CompareView& c) const {
    const bool side = c.choice == "side";
    // A picture of half the width needs more distance.
    const bool by_hand = !ui.framed || rounded(ui.camera) != ui.framed->camera;
    if (sim.b && side != ui.side_by_side && by_hand)
      ui.camera.eye =
          ui.camera.target + (side ? kStepBack : 1 / kStepBack) * (ui.camera.eye - ui.camera.target);
    ui.side_by_side = side;
  }
  void operator()(const command::BarrierView& c) const {
    const command::BarrierView& now = ui.barrier;
    if (c.quantity != now.quantity || c.against != now.against || c.log != now.log || c.energy != now.energy)
      whole(barrier_tab.name);
    ui.barrier = c;
  }
  void operator()(const command::ConvergenceView& c) const {
    if (c.choice != ui.convergence) whole(convergence_tab.name);
    ui.convergence = c.choice;
  }
  void operator()(const command::PlotView& c) const {
    PlotZoom& zoom = ui.zoom[place_in(kPlottingPanels, c.panel)];
    zoom = {ends(c.x, "x"), ends(c.y, "y"), ends(c.right, "right")};
  }
  void operator()(const command::SeriesView& c) const {
    if (c.quantity != ui.series || c.x != ui.series_x || c.y != ui.series_y) whole(series_tab.name);
    ui.series = c.quantity;
    ui.series_x = c.x;
    ui.series_y = c.y;
  }
  void operator()(const command::DifferenceView& c) const { ui.difference = c.choice; }
  void operator()(const command::Ask& c) const {
    ui.dialog = c.what;
    ui.dialog_text = c.text;
  }
  void operator()(const command::OpenSweep& c) const {
    std::error_code ignored;
    const std::string folder =
        c.folder.empty() ? "" : std::filesystem::absolute(c.folder, ignored).lexically_normal().string();
    const std::uint64_t asked = ui.sweep.asked + 1;
    if (folder != ui.sweep.folder) ui.sweep = {};
    ui.sweep.folder = folder;
    ui.sweep.asked = asked;
    ui.sweep.reading = !folder.empty();
    if (folder.empty()) return;
    ui.bring(sweep_tab);
  }
  void operator()(const command::SweepView& c) const {
    if (!ui.sweep.read)
      throw Error(ErrorKind::bad_input, "sweep_view: no sweep is open; open_sweep opens one");
    shown_of(*ui.sweep.read, c);
    ui.sweep.view = c;
  }
  void operator()(const command::AddCameraKey&) const {
    add_camera_key(ui.camera_keys, {sim.a.state->time, ui.camera});
    ui.keys_unsaved = true;
  }
  void operator()(const command::DropCameraKey& c) const {
    const auto count = std::ssize(ui.camera_keys);
    if (c.index < 0 || c.index >= count)
      throw Error(ErrorKind::bad_input, fmt::format("drop_camera_key: expected a number below {}", count));
    ui.camera_keys.erase(ui.camera_keys.begin() + c.index);
    ui.keys_unsaved = !ui.camera_keys.empty();
  }
  void operator()(const command::ClearCameraKeys&) const {
    ui.camera_keys.clear();
    ui.keys_unsaved = false;
  }
  void operator()(const command::Fly& c) const { ui.fly = c.on; }
  void operator()(const command::Along& c) const { ui.along = c.on; }
  void operator()(const command::Costs& c) const { ui.costs = c.on; }
  // The others need more than the state.
  template <class C>
  void operator()(const C&) const {}

  // Other quantities have other ranges.
  void whole(const char* panel) const { ui.zoom[place_in(kPlottingPanels, panel)] = {}; }

  static std::optional<PlotRange> ends(const std::vector<double>& v, const char* what) {
    if (v.empty()) return std::nullopt;
    if (v.size() != 2 || !std::isfinite(v[0]) || !std::isfinite(v[1]) || !(v[0] < v[1]))
      throw Error(ErrorKind::bad_input,
                  fmt::format("plot_view: \"{}\": expected two numbers, the lower one first", what));
    return PlotRange{v[0], v[1]};
  }

  // What is there now; with `ahead` also where the scene's bodies go from its start on.
  std::shared_ptr<const std::vector<Spot>> everything(bool ahead) const {
    auto spots = std::make_shared<std::vector<Spot>>(spots_of(*sim.a.model, *sim.a.state));
    if (sim.b) {
      const std::vector<Spot> of_b = spots_of(*sim.b->model, *sim.b->state);
      spots->insert(spots->end(), of_b.begin(), of_b.end());
    }
    const bool as_loaded = sim.a.model->size() == sim.scene->model.size();
    if (ahead && as_loaded && ui.scene_spots)
      spots->insert(spots->end(), ui.scene_spots->begin(), ui.scene_spots->end());
    return spots;
  }

  Index index_of(Selection::Kind kind, const std::string& item, const char* command) const {
    const Model& model = *sim.a.model;
    const std::size_t count = kind == Selection::Kind::body    ? model.shape.size()
                              : kind == Selection::Kind::joint ? model.joints.size()
                                                               : sim.a.report.contact_reports.size();
    for (std::size_t i = 0; i < count; ++i) {
      if (kind == Selection::Kind::body && model.name[i] == item) return static_cast<Index>(i);
      if (kind == Selection::Kind::joint && !item.empty() && model.joints[i].name == item)
        return static_cast<Index>(i);
    }
    const bool digits =
        !item.empty() && item.size() <= 9 && item.find_first_not_of("0123456789") == item.npos;
    if (digits && std::stoul(item) < count) return static_cast<Index>(std::stoul(item));
    throw Error(ErrorKind::bad_input, fmt::format("{}: there is no {}; expected a name, or a number below {}",
                                                  command, in_quotes(item), count));
  }

  std::optional<BoundingSphere> selected_sphere() const {
    const Model& model = *sim.a.model;
    const auto body_sphere = [&](Index body) -> std::optional<BoundingSphere> {
      const auto i = static_cast<std::size_t>(body);
      const double radius = bounding_radius(model.shape[i]);
      if (!std::isfinite(radius) || !has_finite_pose(*sim.a.state, body)) return std::nullopt;
      return BoundingSphere{sim.a.state->c[i], 1.5 * radius};
    };
    const auto index = static_cast<std::size_t>(ui.selection.index);
    const auto& contacts = sim.a.report.contact_reports;
    const auto is = [&](Selection::Kind kind, std::size_t count) {
      return ui.selection.kind == kind && index < count;
    };
    if (is(Selection::Kind::body, model.shape.size())) return body_sphere(ui.selection.index);
    if (is(Selection::Kind::joint, model.joints.size())) {
      const Joint& joint = model.joints[index];
      return body_sphere(joint.j != kWorld ? joint.j : joint.i);
    }
    if (is(Selection::Kind::contact, contacts.size()))
      return BoundingSphere{contacts[index].y_b, 20 * sim.a.params.contact.d_hat};
    return bounding_sphere(model, *sim.a.state);
  }
};

}  // namespace

void apply_view_command(const ViewCommand& command, const Snapshot& sim, const Viewport& port, UiState& ui) {
  std::visit([](const auto& c) { check_words(c); }, command);
  std::visit(Actor{sim, port, ui}, command);
}

void remember_scene(const std::string& path, std::vector<std::string>& recent) {
  if (path.empty()) return;
  std::error_code ignored;
  const std::string full = std::filesystem::absolute(path, ignored).lexically_normal().string();
  std::erase(recent, full);
  recent.insert(recent.begin(), full);
  if (recent.size() > kMostRecent) recent.resize(kMostRecent);
}

std::string render_command(const Snapshot& sim, const UiState& ui) {
  std::string out = "pabd render " + sh_word(sim.scene_path) + " -o " + sh_word(sim.scene->name + ".mp4");
  for (const auto& [key, value] : sim.a.changed) out += " --set " + sh_word(key + "=" + value);
  if (const std::string overlay = overlay_words(ui); overlay != "none") out += " --overlay " + overlay;
  if (ui.color != ColorQuantity::body)
    out += std::string(" --color-by ") + kColorNames[static_cast<std::size_t>(ui.color)];
  if (ui.contacts && ui.contacts_by != ContactQuantity::gap)
    out += std::string(" --contacts-by ") + kContactQuantities[static_cast<std::size_t>(ui.contacts_by)];
  if (ui.theme != &kStudioTheme) out += " --theme " + std::string(ui.theme->name);
  for (const TrailPoint& point : ui.trails) out += " --trail " + sh_word(trail_words(point));
  out += " --camera " + sh_word(camera_words(followed_view(sim, ui), sim.scene->model, sim.scene->initial));
  return out;
}

}  // namespace pabd
