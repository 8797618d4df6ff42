// SPDX-License-Identifier: MIT
// Signals, and an encoder that stands still: what was done is published, what is temporary goes, and nothing
// that was started goes on.
#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <thread>

#include "tests/cli/program.h"
#include "tests/support/fake_ffmpeg.h"
#include "tests/support/places.h"
#include "tests/support/running.h"
#include "tests/support/sanitized.h"

namespace pabd::test_cli_signals {

namespace fs = std::filesystem;
using namespace test;
using pabd::all_ended;
using pabd::FakeFfmpeg;

namespace {

std::vector<std::string> video(const std::string& out, const std::vector<std::string>& more = {}) {
  std::vector<std::string> command = {"render", "two_boxes", "--size", "64x48", "--quiet", "-o", out};
  command.insert(command.end(), more.begin(), more.end());
  return command;
}

// The real ffmpeg where a video is read back, and `rest` where one is written.
std::string watched(const std::string& rest) {
  return "PATH=\"${PATH#*:}\"\ncase \"$*\" in *framecrc*) exec ffmpeg \"$@\" ;; esac\n" + rest;
}

}  // namespace

TEST_CASE("the same signal twice in a moment is one request: the run ends whole") {
  for (const auto& [signal, code] : {std::pair{SIGTERM, 143}, {SIGHUP, 129}, {SIGINT, 130}}) {
    // The program cannot end before the second signal: its encoder waits to be let go.
    const FakeFfmpeg fake(
        watched("ffmpeg \"$@\"\nstatus=$?\n> \"$HERE/over\"\nuntil [ -e \"$HERE/go\" ]; do sleep 0.01; done\n"
                "exit $status\n"));
    const CommandFolder folder;
    RunningPabd program(
        {"render", "two_boxes", "--size", "64x48", "--frames", "1000000", "-o", folder / "a.mp4"});
    program.wait_until([](const std::string& err) { return err.find(" frames ") != err.npos; });
    program.signal(signal);
    // Two signals that wait at the same time count as one.
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    program.signal(signal);
    program.signal(SIGTERM);  // as a terminal that closes sends several
    program.wait_until([&](const std::string&) { return fs::exists(fake / "over"); });
    pabd::write_bytes(fake / "go", "");
    const Outcome outcome = program.wait();
    CAPTURE(outcome.err);
    CHECK(outcome.exit_code == code);
    CHECK(folder.names() == std::vector<std::string>{"a.mp4"});
    CHECK(probe_video(folder / "a.mp4").starts_with("64,48,"));
  }
}

TEST_CASE("a second request later ends the program at once, and leaves neither file nor program") {
  const FakeFfmpeg fake(
      "echo $$ > \"$HERE/pids\"\nsleep 1000 &\necho $! >> \"$HERE/pids\"\ncat > /dev/null\n> "
      "\"$HERE/over\"\nwait\n");
  const CommandFolder folder;
  RunningPabd program(video(folder / "a.mp4", {"--frames", "3"}));
  program.wait_until([&](const std::string&) { return fs::exists(fake / "over"); });
  CHECK(folder.names().size() == 1);
  program.signal(SIGHUP);
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // that is what "later" means
  program.signal(SIGTERM);
  const Outcome outcome = program.wait();
  CHECK(outcome.exit_code == 143);
  CHECK(folder.names().empty());
  CHECK(all_ended(pabd::read_bytes(fake / "pids"), 2));
}

TEST_CASE("a crash leaves nothing temporary either") {
  const CommandFolder folder;
  RunningPabd program({"run", "two_boxes", "--steps", "1000000000", "--quiet", "--trace", folder / "t.csv"});
  program.wait_until([&](const std::string&) { return !folder.names().empty(); });
  program.signal(SIGQUIT);
  CHECK(program.wait().exit_code == 128 + SIGQUIT);
  CHECK(folder.names().empty());
}

TEST_CASE(
    "a stray signal, a limit of time or a crash leaves nothing temporary; a crash is a line and an exit "
    "code") {
#if defined(PABD_SANITIZED)  // whose own handlers say what crashed
  const int signals[] = {SIGUSR1, SIGUSR2, SIGALRM, SIGXCPU};
#else
  const int signals[] = {SIGUSR1, SIGUSR2, SIGALRM, SIGXCPU, SIGSEGV, SIGABRT, SIGBUS};
#endif
  for (const int signal : signals) {
    CAPTURE(signal);
    const CommandFolder folder;
    RunningPabd program(
        {"run", "two_boxes", "--steps", "1000000000", "--quiet", "--trace", folder / "t.csv"});
    program.wait_until([&](const std::string&) { return !folder.names().empty(); });
    program.signal(signal);
    const Outcome outcome = program.wait();
    const bool crash = signal == SIGSEGV || signal == SIGABRT || signal == SIGBUS;
    CHECK(outcome.exit_code == (crash ? 1 : 128 + signal));
    CHECK(is_error_line(outcome.err, {"the program crashed", "ulimit -v"}) == crash);
    CHECK(folder.names().empty());
  }
}

TEST_CASE("a hang-up that the program was told to ignore is ignored") {
  const CommandFolder folder;
  const Outcome outcome =
      run_command({"sh", "-c",
                   "trap '' HUP\n\"$0\" run two_boxes --steps 1000000000 --quiet --trace \"$1\" & pid=$!\n"
                   "until ls -A \"$2\" | grep -q tmp; do sleep 0.01; done\nkill -HUP $pid\nsleep 0.1\n"
                   "kill -TERM $pid\nwait $pid",
                   places::program(), folder / "t.csv", folder.path().string()});
  CHECK(outcome.exit_code == 143);
  CHECK(folder.names() == std::vector<std::string>{"t.csv"});
}

TEST_CASE("an encoder that makes no progress is exit code 6, and nothing is left") {
  const std::string here = "echo $$ > \"$HERE/pids\"\nsleep 1000 &\necho $! >> \"$HERE/pids\"\n";
  for (const char* script : {"sleep 1000\n", "cat > /dev/null\nsleep 1000\n"}) {
    const FakeFfmpeg fake(here + script);
    const CommandFolder folder;
    const Outcome outcome =
        run_pabd(video(folder / "a.mp4", {"--frames", "300", "--encoder-timeout", "0.5"}));
    CAPTURE(outcome.err);
    CHECK(outcome.exit_code == 6);
    CHECK(is_error_line(outcome.err, {"a.mp4", "no progress for 0.5 s", "--encoder-timeout"}));
    CHECK(folder.names().empty());
    CHECK(all_ended(pabd::read_bytes(fake / "pids"), 2));
  }
  const Outcome range = run_pabd(video("a.mp4", {"--frames", "3", "--encoder-timeout", "0"}));
  CHECK(range.exit_code == 2);
  CHECK(is_error_line(range.err, {"--encoder-timeout"}));
}

TEST_CASE("doctor does not wait for an ffmpeg that says nothing") {
  const FakeFfmpeg fake("echo 'ffmpeg version 0 by nobody'\nsleep 1000 &\necho $! >> \"$HERE/pids\"\n");
  const Outcome outcome = run_pabd({"doctor"});
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.out.find("libx264 (.mp4) no (it encoded nothing)") != std::string::npos);
}

}  // namespace pabd::test_cli_signals
