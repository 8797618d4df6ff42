// SPDX-License-Identifier: MIT
// See recording.h: reading.
#include "app/session/recording.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <utility>

#include "app/session/record_parts.h"
#include "sim/base/counted.h"
#include "sim/base/error.h"
#include "sim/base/hash.h"
#include "sim/base/input_file.h"
#include "sim/scene/text.h"
#include "sim/scene/tuning.h"
#include "sim/trace/trace.h"

namespace pabd {
namespace {

constexpr std::size_t kLeastMoment = 100, kLeastText = 4, kPullBytes = 4 + 7 * 8;  // bytes at least

ByteSource file_source(const std::string& path) {
  const auto fail = [path](const std::string& why) {
    throw Error(ErrorKind::file, path, "cannot be read: " + why);
  };
  const auto file = std::make_shared<const Descriptor>(require_input(path, "a recording"));
  struct stat info;
  if (::fstat(file->get(), &info) != 0) fail(system_reason(errno));
  if (!S_ISREG(info.st_mode)) fail("it is a pipe, and a recording is read twice; save it to a file");
  const auto read = [file, fail](std::uint64_t at, char* to, std::size_t n) {
    while (n > 0) {
      const ssize_t got = ::pread(file->get(), to, n, static_cast<off_t>(at));
      if (got < 0 && errno == EINTR) continue;
      if (got <= 0) fail(got < 0 ? system_reason(errno) : "it was cut off while it was read");
      at += static_cast<std::uint64_t>(got);
      to += got;
      n -= static_cast<std::size_t>(got);
    }
  };
  return {static_cast<std::uint64_t>(info.st_size), read};
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
  Decoder(ByteReader payload, const std::shared_ptr<const Scene>& scene, std::size_t memory)
      : in_(std::move(payload)), scene_(scene), models_(scene), timeline_(memory) {}

  Timeline decode() {
    check_scene();
    const std::uint64_t forgotten = in_.u64();
    for (std::size_t k = in_.count(kLeastText); k > 0; --k)
      params_.push_back(std::make_shared<const Params>(patched(scene_->params, in_.text(), "recording")));
    read_edits(forgotten);
    read_pulls();
    for (std::size_t k = in_.count(kLeastMoment); k > 0; --k) read_moment();
    in_.require(!timeline_.empty(), "there are no moments in it");
    in_.require(!timeline_.back().device || timeline_.back().state, "its end has no state");
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
          "a recording of the scene {} with {}{}; open that scene first", printable(name),
          counted(bodies, "body", "bodies"),
          other ? ", not of " + printable(scene_->name) : " as it was then: it has changed since"));
    }
  }

  void read_edits(std::uint64_t forgotten) {
    const std::size_t n = in_.count(kLeastText + 1);
    const std::uint32_t gone = in_.u32();
    in_.require(gone <= n, "edits are missing");
    std::shared_ptr<const EditChain> chain;
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
      chain =
          std::make_shared<const EditChain>(EditChain{std::move(made), std::move(state), std::move(chain)});
    }
    in_.require(forgotten <= std::uint64_t{1} << 40, "too many moments are forgotten");
    timeline_.set_forgotten(static_cast<std::size_t>(forgotten), std::move(chain));
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
    in_.require(flags <= kRecordAllFlags, "a moment is of an unknown kind");
    Moment m;
    m.start = (flags & kRecordStart) != 0;
    m.device = (flags & kRecordDevice) != 0;
    m.params = at(params_);
    if (flags & kRecordPulls) m.pulls = at(pulls_);
    m.report = read_report(in_);
    if (flags & kRecordHash) m.hash = std::string(in_.raw(kRecordChecksumBytes));
    const bool first = timeline_.empty(), edited = (flags & kRecordEdit) != 0;
    in_.require(!edited || m.start, "an edit is no start");
    in_.require(!(first || m.start) || (flags & kRecordState), "a start has no state");
    in_.require(!(m.start && m.device), "a device made what is no step");
    // What is computed again begins at a state.
    in_.require(first || m.device || m.start || !timeline_.back().device || timeline_.back().state,
                "the state before a step is missing");
    if (edited) {
      in_.require(next_edit_ < edits_.size(), "an edit is missing");
      m.edit = edits_[next_edit_++];
    }
    const ModelEdit edit = edited ? edit_from_json(m.edit->text, "recording") : ModelEdit{};
    // The edit of a first moment led to it from what is forgotten.
    if (flags & kRecordState)
      m.state = std::make_shared<const State>(
          read_state(in_, edited ? models_.size_after(edit) : models_.model()->size()));
    if (edited) models_.carry_out(edit, m.state.get());
    m.model = models_.model();
    check(m);
    timeline_.add(std::move(m));
  }

  void check(const Moment& m) const {
    if (m.state) {
      in_.require(m.state->joint_force.empty() || m.state->joint_force.size() == m.model->joints.size(),
                  "a state has another number of joints than its model");
      in_.require(m.state->step == m.report.step && m.state->time == m.report.time,
                  "a state is of another time than its moment");
    }
    if (!timeline_.empty()) {
      const StepSummary& before = timeline_.back().report;
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

// Bytes [0, end) and their checksum behind.
bool checksum_fits(const ByteSource& in, std::uint64_t end) {
  TextHash64 hash(end);
  std::string part;
  for (std::uint64_t at = 0; at < end; at += part.size()) {
    part.resize(static_cast<std::size_t>(std::min<std::uint64_t>(kStreamPart, end - at)));
    in.read(at, part.data(), part.size());
    hash.add(part);
  }
  part.resize(kRecordChecksumBytes);
  in.read(end, part.data(), part.size());
  return part == hash.finished().hex();
}

Timeline decode(const ByteSource& bytes, const std::string& source, const std::shared_ptr<const Scene>& scene,
                std::size_t memory) {
  ByteReader head(bytes, 0, bytes.size, source);
  if (bytes.size < kRecordHeadBytes || head.raw(kRecordMagic.size()) != kRecordMagic)
    head.fail("no recording of this program; save one with 'save recording'");
  const std::uint32_t version = head.u32();
  if (version != kRecordVersion) {
    head.fail(
        fmt::format("a recording of version {}, this program reads version {}; use the program that made it",
                    version, kRecordVersion));
  }
  const std::uint64_t size = head.u64();
  const std::uint64_t least = kRecordHeadBytes + kRecordChecksumBytes;
  head.require(bytes.size >= least && size == bytes.size - least, "it is cut off, or too long");
  const std::uint64_t end = kRecordHeadBytes + size;
  head.require(checksum_fits(bytes, end), "its checksum is another one");
  try {
    return Decoder(ByteReader(bytes, kRecordHeadBytes, end, source), scene, memory).decode();
  } catch (const Error& error) {  // of parameters and edits in it
    if (error.kind() != ErrorKind::bad_input || error.source() == source) throw;
    head.fail(std::string("damaged recording: ") + error.what());
  }
}

}  // namespace

Timeline decode_recording(const std::string& bytes, const std::string& source,
                          const std::shared_ptr<const Scene>& scene, std::size_t memory) {
  const auto read = [&bytes](std::uint64_t at, char* to, std::size_t n) { bytes.copy(to, n, at); };
  return decode({bytes.size(), read}, source, scene, memory);
}

Timeline read_recording(const std::string& path, const std::shared_ptr<const Scene>& scene,
                        std::size_t memory) {
  return decode(file_source(path), path, scene, memory);
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
    if ((m.start || m.device || i == from) && m.state) {
      state = *m.state;
    } else if (m.device) {
      return std::nullopt;  // nobody else can tell
    } else {
      options.pulls = m.pulls ? *m.pulls : std::vector<Pull>{};
      step(*m.model, *m.params, options, state, workspace, report);
    }
    if (!m.hash.empty() && state_hash(state) != m.hash) return m.report.step;
  }
  return std::nullopt;
}

}  // namespace pabd
