// SPDX-License-Identifier: MIT
// Text chunks, and finding the last whole frame by them.
#include "app/frames/frame_text.h"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/session/joint_settings.h"
#include "render/output/frame_sink.h"
#include "sim/base/error.h"
#include "sim/base/ordered_json.h"
#include "sim/scene/tuning.h"
#include "sim/scene/write_values.h"
#include "sim/trace/trace.h"

namespace pabd {
namespace {

// What each frame has of its own.
constexpr const char *kFrame = "Frame", *kTime = "Time";

// Invalid UTF-8 in a name must not end a run.
std::string dump(const OrderedJson& json) {
  return json.dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
}

std::string camera_text(const Scene& scene, const std::string& option) {
  if (!option.empty()) return option;
  return scene.camera ? "scene" : "auto";
}

}  // namespace

std::string parameters_json(const Params& params, double kappa, const BondLaw* joints) {
  Params resolved = params;
  resolved.contact.kappa = kappa;
  OrderedJson json = OrderedJson::parse(params_json(resolved));
  json["solver"].erase("device");  // who made the steps has an entry of its own
  if (joints) add_law(*joints, json["joints_default"]);
  return dump(json);
}

PngText common_text(const Scene& scene, const ViewFacts& facts, const FrameView& a, const FrameView* b,
                    const std::string& ab_view, const Scene* scene_b) {
  OrderedJson view_json = {{"size", {facts.width, facts.height}},
                           {"fps", facts.fps},
                           {"overlay", facts.overlay},
                           {"camera", camera_text(scene, facts.camera)}};
  if (facts.theme != "studio") view_json["theme"] = facts.theme;
  if (facts.color_by != "body") view_json["color_by"] = facts.color_by;
  if (facts.contacts_by != "gap") view_json["contacts_by"] = facts.contacts_by;
  if (!facts.trails.empty()) view_json["trails"] = facts.trails;
  if (!facts.grid.empty()) view_json["grid"] = facts.grid;
  const BondLaw* joints = a.model->joints.empty() ? nullptr : &scene.joint_law;
  if (facts.quality != "good") view_json["quality"] = facts.quality;
  if (b) view_json["ab"] = ab_view;
  PngText text = {
      {"Software", "pabd " PABD_VERSION}, {"Scene", scene.name},
      {"Scene hash", scene.hash},         {"Parameters", parameters_json(a.params, a.kappa, joints)},
      {"Start", state_hash(*a.state)},    {"View", dump(view_json)},
      {"GL_RENDERER", facts.gl_renderer},
  };
  if (!b) return text;
  const BondLaw& law_b = (scene_b ? *scene_b : scene).joint_law;
  const bool other_law = !same_law(scene.joint_law, law_b);
  OrderedJson patch = OrderedJson::parse(patch_json(a.params, b->params));
  if (other_law) add_law(law_b, patch["joints_default"]);
  text["B patch"] = dump(patch);
  text["B parameters"] = parameters_json(b->params, b->kappa, joints || other_law ? &law_b : nullptr);
  return text;
}

PngText frame_text(const PngText& common, int frame, double time) {
  PngText text = common;
  text[kFrame] = std::to_string(frame);
  text[kTime] = fmt::format("{:.6f} s", time);
  return text;
}

int find_resume_frame(const std::string& out, int frames, const PngText& common) {
  int next = 0;
  while (next < frames && std::filesystem::exists(frame_path(out, next))) {
    const std::string path = frame_path(out, next).string();
    PngText found;
    try {
      found = read_png_text(path);
    } catch (const Error&) {
      break;  // not whole: drawn again
    }
    found.erase(kFrame);
    found.erase(kTime);
    const auto [here, there] = std::mismatch(common.begin(), common.end(), found.begin(), found.end());
    if (here != common.end() || there != found.end()) {
      // The first key in which the two differ; the other one may not have it.
      const bool ours = there == found.end() || (here != common.end() && here->first <= there->first);
      const std::string& key = ours ? here->first : there->first;
      const auto value = [&](const PngText& text) { return text.count(key) > 0 ? text.at(key) : ""; };
      throw Error(
          ErrorKind::bad_input,
          fmt::format(
              "--resume: {} comes from another run (its chunk '{}' is '{}', here it is '{}'); use the "
              "same command line, or --force without --resume to start over",
              path, key, value(found), value(common)));
    }
    ++next;
  }
  // The text chunks come before the picture, so that the last file's picture is looked at too.
  while (next > 0) {
    try {
      static_cast<void>(read_png(frame_path(out, next - 1)));
      break;
    } catch (const Error&) {
      --next;
    }
  }
  return next;
}

}  // namespace pabd
