// bench_peers_ENGINE SCENE [THREADS]: one row of the table, in Markdown, on stdout. --list names the scenes,
// --head prints the table's head.
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <string>

#include "sim/error.h"
#include "tests/bench/peers/measure.h"

namespace {

using namespace pabd;
using namespace pabd::peers;

constexpr const char* kHead =
    "| scene | engine | threads | ms/step | CPU ms/step | ms/step, last s | steps | max pen. mm | max pen., "
    "last s | "
    "mean pen., last s | overlap, last s | top shift mm | top drop mm | end kinetic J | peak MiB |\n"
    "|---|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n";

std::string row(const std::string& name, const PeerScene& peer, int threads) {
  const Measurement m = measure(peer, threads);
  const auto mm = [](double metres) { return fmt::format("{:.3g}", 1000 * metres); };
  const std::string shift = peer.has_top ? mm(m.top_shift) : "–", drop = peer.has_top ? mm(m.top_drop) : "–";
  if (!m.repeatable) fmt::print(stderr, "{}: the two runs of {} ended differently\n", name, engine_name());
  return fmt::format(
      "| {} | {} | {} | {:.3f} | {:.3f} | {:.3f} | {} | {} | {} | {} | {} | {} | {} | {:.2g} | {:.1f} |\n",
      name, engine_name(), threads, m.median_ms, m.median_cpu_ms, m.median_last_ms, kSteps, mm(m.run.max),
      mm(m.last.max), mm(m.last.mean()), mm(m.ruler_last.max), shift, drop, m.kinetic, m.peak_mib);
}

int run(int count, char** arguments) {
  const std::string first = count > 1 ? arguments[1] : "";
  if (first == "--list") {
    for (const std::string& name : scene_names()) fmt::print("{}\n", name);
    return 0;
  }
  if (first == "--head") {
    fmt::print("{}", kHead);
    return 0;
  }
  const std::string threads = count > 2 ? arguments[2] : "1";
  if (first.empty() || count > 3 || threads.size() != 1 || threads[0] < '1' || threads[0] > '9') {
    throw Error(ExitCode::bad_input, "expected: SCENE [THREADS from 1 to 9], --list or --head");
  }
  fmt::print("{}", row(first, peer_scene(first), threads[0] - '0'));
  return std::fflush(stdout) == 0 ? 0 : static_cast<int>(ExitCode::file);
}

}  // namespace

int main(int count, char** arguments) {
  try {
    return run(count, arguments);
  } catch (const Error& error) {
    fmt::print(stderr, "{}: {}\n", arguments[0], error.what());
    return static_cast<int>(error.code());
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}: {}\n", arguments[0], error.what());
    return static_cast<int>(ExitCode::defect);
  }
}
