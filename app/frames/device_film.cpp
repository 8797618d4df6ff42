// SPDX-License-Identifier: MIT
// See device_film.h.
#include "app/frames/device_film.h"

#include <utility>

#include "app/frames/scene_framing.h"
#include "app/session/step_at_time.h"
#include "render/visual/body_parts.h"

namespace pabd {
namespace {

VisualOptions options_of(const Run& run) {
  VisualOptions options;
  options.looks = looks_of(run.scene(), run.model());
  return options;
}

DeviceOptions solver_options(bool contacts) {
  DeviceOptions options;
  options.time_phases = true;
  options.report_contacts = contacts;
  return options;
}

}  // namespace

bool DeviceFilm::shows_all(const Run& run, const OverlayChoice& overlay, const CameraOption& camera) {
  const bool opaque = all_opaque(looks_of(run.scene(), run.model()));
  const bool plain = !overlay.bonds && overlay.color == ColorQuantity::body &&
                     overlay.contacts_by == ContactQuantity::gap && !overlay.needs_iterations() &&
                     overlay.panels.needing(&OverlayPanel::contacts) == nullptr &&
                     !overlay.marks.velocities && !overlay.marks.boxes;
  return opaque && plain && camera.follow.empty() && run.pulls() == nullptr &&
         DeviceSolver::why_not(run.model(), run.params()).empty();
}

DeviceFilm::DeviceFilm(GlContext& context, const Run& start, const FrameRange& range, bool contacts,
                       LiveSource::Skipped skipped, Stepped stepped)
    : DeviceFilm(context, start, range, contacts, std::move(skipped), std::move(stepped),
                 body_parts(start.model(), options_of(start))) {}

DeviceFilm::DeviceFilm(GlContext& context, const Run& start, const FrameRange& range, bool contacts,
                       LiveSource::Skipped skipped, Stepped stepped, const BodyParts& parts)
    : view_(start.view()),
      range_(range),
      contacts_(contacts),
      skipped_(std::move(skipped)),
      stepped_(std::move(stepped)),
      first_step_(view_.state->step),
      solver_(context, *view_.model, *view_.state, solver_options(contacts)),
      bodies_(context, parts, solver_.pose_buffer(), {.late_bounds = false}),
      sphere_(context, *view_.model, *view_.state, parts, solver_.pose_buffer()) {
  now_.step = view_.state->step;
  now_.time = view_.state->time;
}

std::optional<Frame> DeviceFilm::next(const Stop& stop) {
  while (next_ < range_.count) {
    const int frame = next_++;
    if (!advance_to(first_step_ + steps_until(range_.time(frame), view_.params.h), stop)) return {};
    if (frame >= range_.first) {
      view_.state = std::make_shared<const State>(now_);
      view_.history = reports_.view();
      return make_frame(frame, {view_});
    }
    if (skipped_) skipped_(frame + 1, view_.report);
  }
  return {};
}

bool DeviceFilm::advance_to(std::int64_t step, const Stop& stop) {
  while (now_.step < step) {
    if (stop()) return false;
    const StepSummary& made = solver_.step(view_.params);
    if (made.status == StepStatus::non_finite) {
      diverged_ = made;
      return false;
    }
    now_.step = made.step;
    now_.time = made.time;
    view_.report = {};
    static_cast<StepSummary&>(view_.report) = made;
    add_report(reports_, made);
    if (stepped_) stepped_(made, 0);
  }
  return true;
}

BodiesOnDevice DeviceFilm::bodies() {
  if (contacts_ && now_.step > first_step_)
    bodies_.mark_contacts(*view_.model, solver_.contact_buffers(), {.d_hat = view_.params.contact.d_hat});
  return {&bodies_, sphere_()};
}

}  // namespace pabd
