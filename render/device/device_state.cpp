// SPDX-License-Identifier: MIT
// See device_state.h.
#include "render/device/device_state.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>

#include "sim/solver/friction.h"

namespace pabd::device {
namespace {

constexpr std::uint32_t kSlides = 1, kRecovers = 2;  // of shaders/device_recovery.glsl, above a pair's count

template <class Real>
struct Vec4r {
  Real x, y, z, w;
};

// Calls visit(Real{}) with the type that the GPU computes in.
template <class Visit>
void with_real(Precision precision, const Visit& visit) {
  if (precision == Precision::single) {
    visit(float{});
  } else {
    visit(double{});
  }
}

template <class Real>
Vec4r<Real> packed(const Vec3& v, double w = 0) {
  return {static_cast<Real>(v.x()), static_cast<Real>(v.y()), static_cast<Real>(v.z()), static_cast<Real>(w)};
}

template <class Item>
std::vector<Item> read_items(const Buffers& buffers, Slot slot, std::size_t count) {
  std::vector<Item> items(count);
  buffers.read(slot, 0, std::as_writable_bytes(std::span(items)));
  return items;
}

// The same a block at a time, which stays in the cache: visit(first, items).
template <class Item, class Visit>
void visit_items(const Buffers& buffers, Slot slot, std::size_t count, const Visit& visit) {
  constexpr std::size_t kBlock = (std::size_t{4} << 20) / sizeof(Item);
  std::vector<Item> items(std::min(count, kBlock));
  for (std::size_t first = 0; first < count; first += kBlock) {
    const std::span<Item> block = std::span(items).first(std::min(kBlock, count - first));
    buffers.read(slot, first * sizeof(Item), std::as_writable_bytes(block));
    visit(first, std::span<const Item>(block));
  }
}

template <class Item>
void write_items(Buffers& buffers, Slot slot, const std::vector<Item>& items) {
  if (buffers.bytes(slot) < items.size() * sizeof(Item)) buffers.make(slot, items.size() * sizeof(Item));
  buffers.write(slot, 0, std::as_bytes(std::span(items)));
}

}  // namespace

std::size_t pair_size(Precision precision) {
  return precision == Precision::single ? sizeof(Pair<float>) : sizeof(Pair<double>);
}

void write_poses(const State& state, Precision precision, Buffers& buffers) {
  const std::size_t n = state.c.size();
  std::vector<device::Pose> poses(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Quat q = Quat(state.R[i]).normalized();
    poses[i] = {{state.c[i].x(), state.c[i].y(), state.c[i].z(), 0}, {q.x(), q.y(), q.z(), q.w()}};
  }
  write_items(buffers, Slot::poses, poses);
  with_real(precision, [&](auto real) {
    std::vector<Vec4r<decltype(real)>> motion;
    for (std::size_t i = 0; i < n; ++i) {
      motion.push_back(packed<decltype(real)>(state.v[i]));
      motion.push_back(packed<decltype(real)>(state.omega[i]));
    }
    write_items(buffers, Slot::motions, motion);
  });
}

void read_poses(Precision precision, const Buffers& buffers, std::uint32_t bodies, State& out) {
  out.c.resize(bodies);
  out.R.resize(bodies);
  out.v.resize(bodies);
  out.omega.resize(bodies);
  visit_items<device::Pose>(buffers, Slot::poses, bodies, [&](std::size_t i, auto poses) {
    for (const auto& [c, q] : poses) {
      out.c[i] = {c[0], c[1], c[2]};
      out.R[i++] = Quat(q[3], q[0], q[1], q[2]).toRotationMatrix();
    }
  });
  with_real(precision, [&](auto real) {
    using Motion = std::array<Vec4r<decltype(real)>, 2>;
    visit_items<Motion>(buffers, Slot::motions, bodies, [&](std::size_t i, auto motions) {
      for (const auto& [v, w] : motions) {
        out.v[i] = Vec3(v.x, v.y, v.z);
        out.omega[i++] = Vec3(w.x, w.y, w.z);
      }
    });
  });
}

// Pairs are listed at a body that moves, so that no list is long: a floor has thousands of contacts.
void write_memory(const State& state, const Model& model, Precision precision, Buffers& buffers,
                  Counters& counters) {
  struct Entry {
    std::uint32_t emitter, other;
    const ContactMemory* memory;
  };
  std::vector<Entry> entries;
  for (const ContactMemory& memory : state.contacts) {
    const auto low = static_cast<std::uint32_t>(memory.pair >> 32),
               high = static_cast<std::uint32_t>(memory.pair);
    const bool swap = model.fixed[low] != 0;
    entries.push_back({swap ? high : low, swap ? low : high, &memory});
  }
  std::stable_sort(entries.begin(), entries.end(), [](const Entry& x, const Entry& y) {
    return std::tie(x.emitter, x.other) < std::tie(y.emitter, y.other);
  });
  std::vector<std::uint32_t> first(state.c.size() + 1, 0), feature;
  with_real(precision, [&](auto real) {
    using Real = decltype(real);
    std::vector<Pair<Real>> pairs;
    std::vector<Vec4r<Real>> stretch;
    for (const Entry& entry : entries) {
      const bool same =
          !pairs.empty() && pairs.back().emitter == entry.emitter && pairs.back().other == entry.other;
      if (!same) {
        const std::uint32_t flags =
            (entry.memory->sliding ? kSlides : 0) | (entry.memory->recovers ? kRecovers : 0);
        // Where they were found is not known: they are found anew.
        pairs.push_back({entry.emitter,
                         entry.other,
                         static_cast<std::uint32_t>(feature.size()),
                         flags << 16,
                         {0, 0, 0, -1},
                         {0, 0, 0, 1}});
        ++first[entry.emitter + 1];
      }
      ++pairs.back().count;
      feature.push_back(entry.memory->feature);
      stretch.push_back(packed<Real>(entry.memory->stretch, 1));
    }
    counters.pairs = static_cast<std::uint32_t>(pairs.size());
    write_items(buffers, Slot::kept_pairs, pairs);
    write_items(buffers, Slot::kept_stretch, stretch);
  });
  std::partial_sum(first.begin(), first.end(), first.begin());
  write_items(buffers, Slot::kept_first, first);
  write_items(buffers, Slot::kept_feature, feature);
}

void read_memory(std::uint32_t pairs, Precision precision, const Buffers& buffers, State& out) {
  out.contacts.clear();
  with_real(precision, [&](auto real) {
    using Real = decltype(real);
    const auto kept = read_items<Pair<Real>>(buffers, Slot::kept_pairs, pairs);
    std::uint32_t contacts = 0;
    for (const Pair<Real>& pair : kept) contacts = std::max(contacts, pair.first + (pair.count & 0xffffu));
    const auto feature = read_items<std::uint32_t>(buffers, Slot::kept_feature, contacts);
    const auto stretch = read_items<Vec4r<Real>>(buffers, Slot::kept_stretch, contacts);
    for (const Pair<Real>& pair : kept) {
      const std::uint32_t flags = pair.count >> 16, end = pair.first + (pair.count & 0xffffu);
      for (std::uint32_t k = pair.first; k < end; ++k) {
        if (stretch[k].w == 0 && (flags & kRecovers) == 0) continue;
        ContactMemory memory{};
        memory.pair = pair_key(static_cast<Index>(pair.emitter), static_cast<Index>(pair.other));
        memory.feature = feature[k];
        memory.stretch = Vec3(stretch[k].x, stretch[k].y, stretch[k].z);
        memory.recovers = (flags & kRecovers) != 0;
        memory.sliding = (flags & kSlides) != 0;
        out.contacts.push_back(memory);
      }
    }
  });
  std::sort(out.contacts.begin(), out.contacts.end(), [](const ContactMemory& x, const ContactMemory& y) {
    return std::tie(x.pair, x.feature) < std::tie(y.pair, y.feature);
  });
}

void read_contacts(std::uint32_t contacts, double d_hat, const Buffers& buffers,
                   std::vector<ContactReport>& out) {
  out.clear();
  for (const ContactTold& told : read_items<ContactTold>(buffers, Slot::told, contacts)) {
    const auto vector = [](const double(&x)[4]) { return Vec3(x[0], x[1], x[2]); };
    const double d = told.y_b[3];
    if (!(d < d_hat)) continue;
    const Vec3 y_b = vector(told.y_b), n = vector(told.n);
    out.push_back({static_cast<Index>(told.ends[0]), static_cast<Index>(told.ends[1]), y_b - d * n, y_b, n, d,
                   told.n[3], vector(told.friction), told.ends[2] != 0, told.friction[3]});
  }
  std::stable_sort(out.begin(), out.end(), [](const ContactReport& x, const ContactReport& y) {
    return pair_key(x.a, x.b) < pair_key(y.a, y.b);
  });
}

void read_colors(std::uint32_t bodies, const Buffers& buffers, std::vector<int>& out) {
  const auto ends = read_items<std::uint32_t>(buffers, Slot::end_first, std::size_t{bodies} + 1);
  const auto colors = read_items<std::uint32_t>(buffers, Slot::color_of, bodies);
  out.assign(bodies, -1);
  for (std::size_t i = 0; i < bodies; ++i) {
    if (ends[i + 1] != ends[i]) out[i] = static_cast<int>(colors[i] & 0xffu) - 1;
  }
}

}  // namespace pabd::device
