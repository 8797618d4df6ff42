// SPDX-License-Identifier: MIT
// See recording.h: writing. The size and the tables come first in the file, so everything is gone through
// twice: to count, then to write. Nothing is held but the part that is being written.
#include <map>

#include "app/session/record_parts.h"
#include "app/session/recording.h"
#include "sim/base/hash.h"
#include "sim/scene/tuning.h"
#include "sim/trace/trace.h"

namespace pabd {
namespace {

constexpr std::size_t kKeyDistance = 32;  // steps between two states that are written

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

struct Tables {
  explicit Tables(const Timeline& timeline) {
    for (std::size_t i = 0; i < timeline.size(); ++i) {
      params.number_of(timeline[i].params);
      if (timeline[i].pulls) pulls.number_of(timeline[i].pulls);
    }
  }

  Table<Params> params;
  Table<std::vector<Pull>> pulls;
};

void write_moment(const Moment& m, bool with_state, Tables& tables, ByteWriter& out) {
  std::string hash = m.hash;
  if (m.state) hash = out.counts_only() ? std::string(kRecordChecksumBytes, '0') : state_hash(*m.state);
  out.u8(static_cast<std::uint8_t>((m.start ? kRecordStart : 0) | (m.edit ? kRecordEdit : 0) |
                                   (m.pulls ? kRecordPulls : 0) | (with_state ? kRecordState : 0) |
                                   (m.device ? kRecordDevice : 0) | (hash.empty() ? 0 : kRecordHash)));
  out.u32(tables.params.number_of(m.params));
  if (m.pulls) out.u32(tables.pulls.number_of(m.pulls));
  write_report(m.report, out);
  out.raw(hash);
  if (with_state) write_state(*m.state, out);
}

void write_edits(const Timeline& timeline, ByteWriter& out) {
  std::vector<const EditChain*> edits;
  std::size_t forgotten = 0;
  for (const EditChain* edit = timeline.edits().get(); edit; edit = edit->before.get()) edits.push_back(edit);
  for (const EditChain* edit = timeline.forgotten_edits().get(); edit; edit = edit->before.get()) ++forgotten;
  out.u32(edits.size());
  out.u32(forgotten);
  for (std::size_t k = 0; k < edits.size(); ++k) {
    const EditChain& edit = *edits[edits.size() - 1 - k];
    out.text(edit.made->text);
    if (k < forgotten && edit.state) write_state(*edit.state, out);
  }
}

void write_pulls(const Tables& tables, ByteWriter& out) {
  out.u32(tables.pulls.items().size());
  for (const auto& list : tables.pulls.items()) {
    out.u32(list->size());
    for (const Pull& pull : *list) {
      out.u32(static_cast<std::uint32_t>(pull.body));
      out.matrix(pull.r);
      out.matrix(pull.target);
      out.number(pull.kappa);
    }
  }
}

void write_payload(const Run& run, Tables& tables, ByteWriter& out) {
  const Timeline& timeline = run.timeline();
  out.text(run.scene().hash);
  out.text(run.scene().name);
  out.u32(run.scene().model.shape.size());
  out.u64(timeline.forgotten());
  out.u32(tables.params.items().size());
  for (const auto& p : tables.params.items()) out.text(params_json(*p));
  write_edits(timeline, out);
  write_pulls(tables, out);
  out.u32(timeline.size());
  std::size_t written = 0;  // the last moment with its state
  for (std::size_t i = 0; i < timeline.size(); ++i) {
    const Moment& m = timeline[i];
    const bool needed = i == 0 || m.start || i + 1 == timeline.size();
    const bool with_state = m.state && (needed || m.device || i - written >= kKeyDistance);
    if (with_state) written = i;
    write_moment(m, with_state, tables, out);
  }
}

}  // namespace

void write_recording(const Run& run, const std::function<void(std::string_view)>& out) {
  Tables tables(run.timeline());
  ByteWriter counted;
  write_payload(run, tables, counted);
  TextHash64 hash(kRecordHeadBytes + counted.size());
  ByteWriter file([&](std::string_view part) {
    hash.add(part);
    out(part);
  });
  file.raw(kRecordMagic);
  file.u32(kRecordVersion);
  file.u64(counted.size());
  write_payload(run, tables, file);
  file.flush();
  out(hash.finished().hex());
}

std::string encode_recording(const Run& run) {
  std::string bytes;
  write_recording(run, [&](std::string_view part) { bytes += part; });
  return bytes;
}

}  // namespace pabd
