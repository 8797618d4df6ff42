// See recording.h.
#include "app/session/recording.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "app/session/record_parts.h"
#include "sim/error.h"
#include "sim/scene/hash.h"
#include "sim/scene/text.h"
#include "sim/scene/tuning.h"
#include "sim/trace/trace.h"

namespace pabd {
namespace {

constexpr std::string_view kMagic = "pabd-rec";
constexpr std::uint32_t kVersion = 1;
constexpr std::size_t kHeadBytes = 8 + 4 + 8, kChecksumBytes = 16;
constexpr std::size_t kKeyDistance = 32;  // steps between two states that are written
constexpr std::size_t kLeastMoment = 100, kLeastText = 4, kPullBytes = 4 + 7 * 8;  // bytes at least

enum Flag : std::uint8_t { kStart = 1, kEdit = 2, kPulls = 4, kState = 8, kHash = 16, kAllFlags = 31 };

std::string checksum(std::string_view bytes) {
  Hash64 hash;
  hash.add_text(bytes);
  return hash.hex();
}

// Numbers what is shared, in the order of first use.
template <class T>
class Table {
 public:
  std::uint32_t number_of(const std::shared_ptr<const T>& item) {
    const auto [at, fresh] = numbers_.try_emplace(item.get(), static_cast<std::uint32_t>(items_.size()));
    if (fresh) items_.push_back(item);
    return at->second;
  }
  const std::vector<std::shared_ptr<const T>>& items() const { return items_; }

 private:
  std::map<const T*, std::uint32_t> numbers_;
  std::vector<std::shared_ptr<const T>> items_;
};

void write_moment(const Moment& m, bool with_state, std::uint32_t params, std::uint32_t pulls,
                  ByteWriter& out) {
  const std::string hash = m.state ? state_hash(*m.state) : m.hash;
  out.u8(static_cast<std::uint8_t>((m.start ? kStart : 0) | (m.edit ? kEdit : 0) | (m.pulls ? kPulls : 0) |
                                   (with_state ? kState : 0) | (hash.empty() ? 0 : kHash)));
  out.u32(params);
  if (m.pulls) out.u32(pulls);
  write_report(m.report, out);
  out.raw(hash);
  if (with_state) write_state(*m.state, out);
}

// The models that edits lead to, one after the other.
class ModelChain {
 public:
  ModelChain(const std::shared_ptr<const Scene>& scene) : scene_(scene), model_(scene, &scene->model) {
    sizes_.c.resize(scene->model.shape.size(), Vec3::Zero());
    sizes_.R.resize(sizes_.c.size(), Mat3::Identity());
    sizes_.v = sizes_.omega = sizes_.c;
  }

  const std::shared_ptr<const Model>& model() const { return model_; }

  // `state`: after the edit; needed where a joint is added, whose frames are those of its poses.
  void carry_out(const ModelEdit& edit, const State* state) {
    auto model = std::make_shared<Model>(*model_);
    if (std::holds_alternative<AddJoint>(edit)) {
      State poses = *state;
      apply_edit(edit, scene_->joint_law, *model, poses);
    } else {
      apply_edit(edit, scene_->joint_law, *model, sizes_);
    }
    model_ = std::move(model);
  }
  // Bodies that there will be after it.
  Index size_after(const ModelEdit& edit) const {
    return model_->size() + (std::holds_alternative<AddBody>(edit) ? 1 : 0) -
           (std::holds_alternative<RemoveBody>(edit) ? 1 : 0);
  }

 private:
  std::shared_ptr<const Scene> scene_;
  std::shared_ptr<const Model> model_;
  State sizes_;  // of the right size, for edits that look at no pose
};

class Decoder {
 public:
  Decoder(std::string_view payload, const std::string& source, const std::shared_ptr<const Scene>& scene,
          std::size_t memory)
      : in_(payload, source), scene_(scene), models_(scene), timeline_(memory) {}

  Timeline decode() {
    check_scene();
    const std::uint64_t forgotten = in_.u64();
    for (std::size_t k = in_.count(kLeastText); k > 0; --k)
      params_.push_back(std::make_shared<const Params>(patched(scene_->params, in_.text(), "recording")));
    read_edits(forgotten);
    read_pulls();
    for (std::size_t k = in_.count(kLeastMoment); k > 0; --k) read_moment();
    in_.require(!timeline_.empty(), "there are no moments in it");
    in_.require(next_edit_ == edits_.size(), "an edit belongs to no moment");
    in_.require(in_.left() == 0, "there is more in it than belongs to it");
    return std::move(timeline_);
  }

 private:
  void check_scene() {
    const std::string hash = in_.text(), name = in_.text();
    const std::uint32_t bodies = in_.u32();
    if (hash != scene_->hash || bodies != scene_->model.shape.size()) {
      const bool other = name != scene_->name;
      in_.fail(fmt::format(
          "a recording of the scene {} with {} bodies{}; open that scene first", printable(name), bodies,
          other ? ", not of " + printable(scene_->name) : " as it was then: it has changed since"));
    }
  }

  void read_edits(std::uint64_t forgotten) {
    const std::size_t n = in_.count(kLeastText + 1);
    const std::uint32_t gone = in_.u32();
    in_.require(gone <= n, "edits are missing");
    std::vector<Timeline::ForgottenEdit> list;
    for (std::size_t k = 0; k < n; ++k) {
      const std::string text = in_.text();
      const ModelEdit edit = edit_from_json(text, "recording");
      const bool adds_joint = std::holds_alternative<AddJoint>(edit);
      auto made = std::make_shared<const MadeEdit>(MadeEdit{text, adds_joint});
      if (k >= gone) {
        edits_.push_back(std::move(made));
        continue;
      }
      std::shared_ptr<const State> state;
      if (adds_joint) state = std::make_shared<const State>(read_state(in_, models_.size_after(edit)));
      models_.carry_out(edit, state.get());
      list.push_back({std::move(made), std::move(state)});
    }
    in_.require(forgotten <= std::uint64_t{1} << 40, "too many moments are forgotten");
    timeline_.set_forgotten(static_cast<std::size_t>(forgotten), std::move(list));
  }

  void read_pulls() {
    for (std::size_t k = in_.count(4); k > 0; --k) {
      std::vector<Pull> list(in_.count(kPullBytes));
      for (Pull& pull : list) {
        const std::uint32_t body = in_.u32();
        in_.require(body <= 1u << 30, "a hand is on a body that is none");
        pull.body = static_cast<Index>(body);
        in_.matrix(pull.r);
        in_.matrix(pull.target);
        pull.kappa = in_.finite();
        in_.require(pull.kappa > 0, "a hand has no strength");
      }
      pulls_.push_back(std::make_shared<const std::vector<Pull>>(std::move(list)));
    }
  }

  template <class T>
  const T& at(const std::vector<T>& table) {
    const std::uint32_t i = in_.u32();
    in_.require(i < table.size(), "it names what is not in its tables");
    return table[i];
  }

  void read_moment() {
    const std::uint8_t flags = in_.u8();
    in_.require(flags <= kAllFlags, "a moment is of an unknown kind");
    Moment m;
    m.start = (flags & kStart) != 0;
    m.params = at(params_);
    if (flags & kPulls) m.pulls = at(pulls_);
    m.report = read_report(in_);
    if (flags & kHash) m.hash = std::string(in_.raw(kChecksumBytes));
    const bool first = timeline_.empty(), edited = (flags & kEdit) != 0;
    in_.require(!edited || m.start, "an edit is no start");
    in_.require(!(first || m.start) || (flags & kState), "a start has no state");
    if (edited) {
      in_.require(next_edit_ < edits_.size(), "an edit is missing");
      m.edit = edits_[next_edit_++];
    }
    const ModelEdit edit = edited ? edit_from_json(m.edit->text, "recording") : ModelEdit{};
    // The edit of a first moment led to it from what is forgotten.
    if (flags & kState)
      m.state = std::make_shared<const State>(
          read_state(in_, edited ? models_.size_after(edit) : models_.model()->size()));
    if (edited) models_.carry_out(edit, m.state.get());
    m.model = models_.model();
    check(m);
    timeline_.add(std::move(m));
  }

  void check(const Moment& m) const {
    if (m.state)
      in_.require(m.state->step == m.report.step && m.state->time == m.report.time,
                  "a state is of another time than its moment");
    if (!timeline_.empty()) {
      const StepReport& before = timeline_.back().report;
      in_.require(m.report.step == before.step + (m.start ? 0 : 1) && m.report.time >= before.time,
                  "moments are out of order");
    }
    if (!m.pulls) return;
    for (const Pull& pull : *m.pulls)
      in_.require(pull.body < m.model->size(), "a hand is on a body that is none");
  }

  ByteReader in_;
  std::shared_ptr<const Scene> scene_;
  ModelChain models_;
  Timeline timeline_;
  std::vector<std::shared_ptr<const Params>> params_;
  std::vector<Pulls> pulls_;
  std::vector<std::shared_ptr<const MadeEdit>> edits_;  // of moments
  std::size_t next_edit_ = 0;
};

}  // namespace

std::string encode_recording(const Run& run) {
  const Timeline& timeline = run.timeline();
  Table<Params> params;
  Table<std::vector<Pull>> pulls;
  std::size_t edits = timeline.forgotten_edits().size();
  ByteWriter moments;
  std::size_t written = 0;  // the last moment with its state
  for (std::size_t i = 0; i < timeline.size(); ++i) {
    const Moment& m = timeline[i];
    const bool needed = i == 0 || m.start || i + 1 == timeline.size();
    const bool with_state = m.state && (needed || i - written >= kKeyDistance);
    if (with_state) written = i;
    if (m.edit) ++edits;
    write_moment(m, with_state, params.number_of(m.params), m.pulls ? pulls.number_of(m.pulls) : 0, moments);
  }

  ByteWriter out;
  out.text(run.scene().hash);
  out.text(run.scene().name);
  out.u32(run.scene().model.shape.size());
  out.u64(timeline.forgotten());
  out.u32(params.items().size());
  for (const auto& p : params.items()) out.text(params_json(*p));
  out.u32(edits);
  out.u32(timeline.forgotten_edits().size());
  for (const auto& e : timeline.forgotten_edits()) {
    out.text(e.made->text);
    if (e.state) write_state(*e.state, out);
  }
  for (std::size_t i = 0; i < timeline.size(); ++i)
    if (timeline[i].edit) out.text(timeline[i].edit->text);
  out.u32(pulls.items().size());
  for (const auto& list : pulls.items()) {
    out.u32(list->size());
    for (const Pull& pull : *list) {
      out.u32(static_cast<std::uint32_t>(pull.body));
      out.matrix(pull.r);
      out.matrix(pull.target);
      out.number(pull.kappa);
    }
  }
  out.u32(timeline.size());
  out.raw(moments.take());
  const std::string payload = out.take();

  ByteWriter file;
  file.raw(kMagic);
  file.u32(kVersion);
  file.u64(payload.size());
  file.raw(payload);
  std::string bytes = file.take();
  bytes += checksum(bytes);
  return bytes;
}

Timeline decode_recording(const std::string& bytes, const std::string& source,
                          const std::shared_ptr<const Scene>& scene, std::size_t memory) {
  ByteReader in(bytes, source);
  if (bytes.size() < kHeadBytes || in.raw(kMagic.size()) != kMagic)
    in.fail("no recording of this program; save one with 'save recording'");
  const std::uint32_t version = in.u32();
  if (version != kVersion) {
    in.fail(
        fmt::format("a recording of version {}, this program reads version {}; use the program that made it",
                    version, kVersion));
  }
  const std::uint64_t size = in.u64();
  const std::size_t least = kHeadBytes + kChecksumBytes;
  in.require(bytes.size() >= least && size == bytes.size() - least, "it is cut off, or too long");
  const std::string_view all(bytes);
  in.require(
      all.substr(bytes.size() - kChecksumBytes) == checksum(all.substr(0, bytes.size() - kChecksumBytes)),
      "its checksum is another one");
  try {
    return Decoder(all.substr(kHeadBytes, static_cast<std::size_t>(size)), source, scene, memory).decode();
  } catch (const Error& error) {  // of parameters and edits in it
    const std::string what = error.what();
    if (what.starts_with(source)) throw;
    in.fail("damaged recording: " + what);
  }
}

std::optional<std::int64_t> first_difference(const Timeline& recorded, int threads) {
  std::size_t from = recorded.size() - 1;
  while (from > 0 && (from + 1 == recorded.size() || !recorded[from].state)) --from;
  if (!recorded[from].state) return std::nullopt;
  State state = *recorded[from].state;
  StepWorkspace workspace;
  StepReport report;
  StepOptions options;
  options.threads = threads;
  for (std::size_t i = from; i < recorded.size(); ++i) {
    const Moment& m = recorded[i];
    if ((m.start || i == from) && m.state) {
      state = *m.state;
    } else {
      options.pulls = m.pulls ? *m.pulls : std::vector<Pull>{};
      step(*m.model, *m.params, options, state, workspace, report);
    }
    if (!m.hash.empty() && state_hash(state) != m.hash) return m.report.step;
  }
  return std::nullopt;
}

}  // namespace pabd
