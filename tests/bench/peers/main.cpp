// SPDX-License-Identifier: MIT
// bench_peers_ENGINE SCENE [THREADS]: one row of a table, in Markdown, on stdout. --list names the scenes
// that this engine takes, --threads the most threads that it can use, --kind SCENE whether it shows contacts
// or joints, --head KIND prints a table's head.
#include <fmt/format.h>

#include <charconv>
#include <cstdio>
#include <exception>
#include <string>

#include "sim/base/error.h"
#include "tests/bench/peers/measure.h"

namespace {

using namespace pabd;
using namespace pabd::peers;

constexpr const char* kContactHead =
    "| scene | engine | threads | ms/step | CPU ms/step | ms/step, last s | steps | max pen. mm | max pen., "
    "last s | "
    "mean pen., last s | overlap, last s | top shift mm | top drop mm | end kinetic J | peak MiB |\n"
    "|---|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n";

constexpr const char* kJointHead =
    "| scene | engine | threads | ms/step | CPU ms/step | steps | joint drift mm | overlap mm, last s | end "
    "kinetic kJ | energy % | peak MiB |\n"
    "|---|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n";

constexpr const char* kKinds[] = {"contacts", "joints"};

std::string mm(double metres) { return fmt::format("{:.3g}", 1000 * metres); }

std::string contact_columns(const PeerScene& peer, const Measurement& m) {
  const std::string shift = peer.has_top ? mm(m.top_shift) : "–", drop = peer.has_top ? mm(m.top_drop) : "–";
  return fmt::format("{:.3f} | {} | {} | {} | {} | {} | {} | {} | {:.2g}", m.median_last_ms, m.steps,
                     mm(m.run.max), mm(m.last.max), mm(m.last.mean()), mm(m.ruler_last.max), shift, drop,
                     m.kinetic);
}

std::string joint_columns(const PeerScene& peer, const Measurement& m) {
  const std::string energy = peer.is_hung ? fmt::format("{:+.2f}", 100 * m.energy_change) : "–";
  return fmt::format("{} | {} | {} | {:.4g} | {}", m.steps, mm(m.drift), mm(m.ruler_last.max),
                     m.kinetic / 1000, energy);
}

std::string row(const std::string& name, const PeerScene& peer, int threads) {
  const Measurement m = measure(peer, threads);
  if (!m.repeatable) fmt::print(stderr, "{}: the two runs of {} ended differently\n", name, engine_name());
  return fmt::format("| {} | {} | {} | {:.3f} | {:.3f} | {} | {:.1f} |\n", name, engine_name(), threads,
                     m.median_ms, m.median_cpu_ms,
                     peer.kind == SceneKind::contacts ? contact_columns(peer, m) : joint_columns(peer, m),
                     m.peak_mib);
}

// 0 for what is not a number.
int number(const std::string& text) {
  int value = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  return error == std::errc() && rest == end ? value : 0;
}

int run(int count, char** arguments) {
  const std::string first = count > 1 ? arguments[1] : "", second = count > 2 ? arguments[2] : "";
  if (first == "--list" && count == 2) {
    for (const std::string& name : scene_names()) {
      if (engine_takes(scene_engines(name))) fmt::print("{}\n", name);
    }
    return 0;
  }
  if (first == "--threads" && count == 2) {
    fmt::print("{}\n", engine_threads());
    return 0;
  }
  if (first == "--kind" && count == 3) {
    fmt::print("{}\n", kKinds[static_cast<std::size_t>(scene_kind(second))]);
    return 0;
  }
  if (first == "--head" && (second == kKinds[0] || second == kKinds[1])) {
    fmt::print("{}", second == kKinds[0] ? kContactHead : kJointHead);
    return 0;
  }
  const int threads = count > 2 ? number(second) : 1;
  if (first.empty() || count > 3 || threads < 1 || threads > engine_threads()) {
    throw Error(ErrorKind::bad_input,
                fmt::format("expected: SCENE [THREADS from 1 to {}], --list, --threads, --kind SCENE, "
                            "--head contacts or --head joints",
                            engine_threads()));
  }
  if (!engine_takes(scene_engines(first))) {
    throw Error(ErrorKind::bad_input, "scene '" + first + "': expected one of those that --list prints");
  }
  fmt::print("{}", row(first, peer_scene(first), threads));
  return std::fflush(stdout) == 0 ? 0 : 1;
}

}  // namespace

int main(int count, char** arguments) {
  try {
    return run(count, arguments);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}: {}\n", arguments[0], error.what());
    return 1;
  }
}
