// See run.h.
#include "app/session/run.h"

#include "sim/error.h"
#include "sim/scene/tuning.h"

namespace pabd {

Run::Run(std::shared_ptr<const Scene> scene, int threads, std::size_t memory)
    : scene_(scene),
      session_(std::move(scene), threads),
      threads_(threads),
      timeline_(memory),
      next_(session_.params()) {
  add_moment();
}

Run Run::fork() const {
  Run out(scene_, threads_, timeline_.budget());
  out.observe(iterations_, contacts_);
  out.timeline_ = timeline_;
  out.seek(cursor_);
  out.next_ = next_;
  out.newest_ = at_end() ? next_ : newest_;
  return out;
}

void Run::observe(bool iterations, bool contacts) {
  iterations_ = iterations;
  contacts_ = contacts;
  session_.record_iterations(iterations);
  session_.report_contacts(contacts);
}

bool Run::advance() {
  if (!at_end()) {
    seek(cursor_ + 1);
    return true;
  }
  session_.set_params(next_);
  if (session_.step().status == StepStatus::non_finite) return false;
  add_moment();
  compare();
  return true;
}

// A moment is reached by the step that led to it, so that its report is whole.
void Run::seek(std::size_t i) {
  const Moment& m = timeline_[i];
  if (at_end()) newest_ = next_;
  if (m.start || i == 0) {
    session_.restore(m.model, *timeline_.state(i, threads_));
  } else {
    session_.restore(m.model, *timeline_.state(i - 1, threads_));
    session_.set_params(*m.params);
    session_.step();
  }
  // The parameters of a start are only those that were in force.
  cursor_ = i;
  if (at_end()) {
    next_ = newest_;  // also those that no step was made with yet
    shared_.reset();
    return;
  }
  shared_ = timeline_[i + 1].params;
  next_ = *shared_;
}

void Run::restart() {
  const Params params = next_;
  seek(0);
  next_ = params;
  shared_.reset();
  branch();
}

void Run::set_params(const Params& params) {
  if (const auto error = check_params(params)) {
    throw Error(ExitCode::bad_input, error->pointer + ": " + error->message);
  }
  if (differences(next_, params).empty()) return;
  if (!at_end()) branch();
  next_ = params;
  shared_.reset();
}

std::vector<IterationRecord> Run::records_with(SolverMethod method) const {
  const Moment& m = timeline_[cursor_];
  if (m.start || cursor_ == 0) return {};
  Params params = *m.params;
  if (params.solver.method != method) {
    params.solver.method = method;
    params.solver.projection = Projection::automatic;  // each method has its own
  }
  State state = *timeline_.state(cursor_ - 1, threads_);
  StepOptions options;
  options.threads = threads_;
  options.record_iterations = true;
  StepWorkspace workspace;
  StepReport report;
  step(*m.model, params, options, state, workspace, report);
  return report.records;
}

void Run::branch() {
  if (at_end()) return;
  left_ = timeline_.branch(cursor_);
  parting_ = Parting{session_.state().time, {}, {}};
}

void Run::add_moment() {
  if (!shared_) shared_ = std::make_shared<const Params>(next_);
  const bool start = timeline_.empty();
  timeline_.add({session_.shared_model(), shared_, std::make_shared<const State>(session_.state()),
                 light_copy(session_.report()), start});
  cursor_ = timeline_.size() - 1;
}

void Run::compare() {
  if (!left_ || left_->empty() || parting_->parted) return;
  const Moment& other = (*left_)[left_->at_time(state().time)];
  if (!other.state || other.report.step != state().step || other.model != shared_model()) return;
  if (!parting_->differs && !same_bits(*other.state, state())) parting_->differs = state().time;
  if (largest_distance(*other.state, state()) > next_.contact.d_hat) parting_->parted = state().time;
}

}  // namespace pabd
