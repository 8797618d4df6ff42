// SPDX-License-Identifier: MIT
// The ffmpeg program, fed through a pipe.
#include "render/output/encoder_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <utility>

#include "render/output/ffmpeg_arguments.h"
#include "sim/base/counted.h"
#include "sim/base/error.h"

namespace pabd {
namespace {

constexpr int kPollMs = 50;
constexpr int kLastReads = 1000;         // of what ffmpeg left in the pipes, each up to 4 KiB
constexpr double kVersionPatience = 10;  // s
constexpr const char* kOtherWay = "write PNG files: frames/{frame:04}.png";  // without ffmpeg

[[noreturn]] void fail_system(const std::string& name, int reason) {
  throw Error(ErrorKind::encoder,
              fmt::format("{}: ffmpeg could not be started: {}", name, system_reason(reason)));
}

// What ffmpeg said, on one line.
std::string joined(std::string text) {
  text = without_addresses(std::move(text));
  while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.pop_back();
  std::string line;
  for (const char c : text) {
    if (c == '\n') {
      line += "; ";
    } else if (c != '\r') {
      line += c;
    }
  }
  return line;
}

}  // namespace

// How long ffmpeg has made no progress.
class EncoderProcess::Patience {
 public:
  explicit Patience(const EncoderProcess& encoder) : encoder_(encoder) { moved(); }

  void reset() { since_ = Clock::now(); }
  bool is_over() {
    if (moved()) reset();
    return std::chrono::duration<double>(Clock::now() - since_).count() > encoder_.setup_.patience;
  }

 private:
  using Clock = std::chrono::steady_clock;

  bool moved() {
    struct stat file = {};
    ::stat(encoder_.setup_.file.c_str(), &file);
    const std::array<long long, 4> now = {encoder_.frames_.load(), static_cast<long long>(file.st_size),
                                          static_cast<long long>(file.st_mtim.tv_sec),
                                          static_cast<long long>(file.st_mtim.tv_nsec)};
    return std::exchange(seen_, now) != now;
  }

  const EncoderProcess& encoder_;
  std::array<long long, 4> seen_{};
  Clock::time_point since_ = Clock::now();
};

EncoderProcess::EncoderProcess(EncoderSetup setup) : setup_(std::move(setup)) {
  int over[2];
  if (::pipe2(over, O_CLOEXEC) != 0) fail_system(setup_.name, errno);
  over_read_ = Descriptor(over[0]);
  over_write_ = Descriptor(over[1]);
  std::vector<std::string> command = {"ffmpeg"};
  command.insert(command.end(), setup_.arguments.begin(), setup_.arguments.end());
  const int reason = child_.start(command);
  if (reason == ENOENT) {
    throw Error(ErrorKind::encoder,
                fmt::format("{}: ffmpeg was not found in PATH; install it: apt-get install ffmpeg, or {}",
                            setup_.name, kOtherWay));
  }
  if (reason != 0) fail_system(setup_.name, reason);
  // A frame should fit into few writes; being refused (a limit for users) only costs speed.
  ::fcntl(child_.input.get(), F_SETPIPE_SZ, 1 << 20);
  for (const Descriptor* pipe : {&child_.input, &child_.output, &child_.errors})
    ::fcntl(pipe->get(), F_SETFL, ::fcntl(pipe->get(), F_GETFL) | O_NONBLOCK);
  listener_ = std::thread([this] { listen(); });
}

EncoderProcess::~EncoderProcess() { end_and_hear(); }

// Empties both outputs of ffmpeg all the time: it would stop when one of them is full. Whoever else holds
// them open when it has ended is not waited for.
void EncoderProcess::listen() {
  LineSplitter progress([this](std::string_view line) {
    if (line.starts_with("frame=")) frames_ = std::strtol(std::string(line.substr(6)).c_str(), nullptr, 10);
  });
  const auto hear = [&](std::string_view bytes) { progress.append(bytes.data(), bytes.size()); };
  std::array<pollfd, 3> sources = {
      {{child_.output.get(), POLLIN, 0}, {child_.errors.get(), POLLIN, 0}, {over_read_.get(), POLLIN, 0}}};
  bool over = false;
  int heard_after = 0;
  while (sources[0].fd >= 0 || sources[1].fd >= 0) {
    if (::poll(sources.data(), sources.size(), -1) < 0) {
      if (errno == EINTR) continue;
      break;
    }
    const bool heard = read_pipes(sources, hear, tail_);
    if (over && (!heard || ++heard_after > kLastReads)) break;
    over = sources[2].revents != 0;
  }
  progress.finish();
}

void EncoderProcess::end_and_hear() {
  child_.end();
  child_.input.close();
  if (!listener_.joinable()) return;
  over_write_.close();
  listener_.join();
}

void EncoderProcess::write(const void* data, std::size_t size) {
  const BlockSigpipe no_signal;
  const char* from = static_cast<const char*>(data);
  for (Patience patience(*this); size > 0;) {
    const ssize_t n = ::write(child_.input.get(), from, size);
    if (n > 0) {
      from += n;
      size -= static_cast<std::size_t>(n);
      patience.reset();
      continue;
    }
    const int reason = n == 0 ? EIO : errno;
    if (reason == EINTR) continue;
    if (reason == EAGAIN) {
      pollfd ready = {child_.input.get(), POLLOUT, 0};
      ::poll(&ready, 1, kPollMs);
      if (patience.is_over()) give_up();
      continue;
    }
    // Why it does not read any more is what it says at its end, which may take a moment.
    child_.input.close();
    for (int i = 0; i < 400 && !child_.has_ended(); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    fail(reason == EPIPE ? "ffmpeg ended too early"
                         : fmt::format("ffmpeg took no frame: {}", system_reason(reason)));
  }
}

long EncoderProcess::finish() {
  child_.input.close();
  for (Patience patience(*this); !child_.has_ended();) {
    if (patience.is_over()) give_up();
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  end_and_hear();
  if (child_.exit_status() != 0) fail("ffmpeg failed");
  if (!tail_.text().empty()) fail("ffmpeg complained, so that the video may be damaged and was not kept");
  return frames_;
}

void EncoderProcess::finish_after(long sent) {
  if (sent == 0)
    throw Error(ErrorKind::encoder, fmt::format("{}: there was no frame to encode", setup_.name));
  const long encoded = finish();
  if (encoded == sent) return;
  throw Error(
      ErrorKind::encoder,
      fmt::format("{}: ffmpeg ended well but reported {} of {}; the video was not kept, write it again",
                  setup_.name, counted(encoded, "frame"), sent));
}

void EncoderProcess::give_up() {
  end_and_hear();
  const std::string said = joined(tail_.text());
  throw Error(
      ErrorKind::encoder,
      fmt::format("{}: ffmpeg made no progress for {:g} s and was ended{}; if it only needs longer, give "
                  "it more with --encoder-timeout, or {}",
                  setup_.name, setup_.patience, said.empty() ? "" : ": " + said, kOtherWay));
}

void EncoderProcess::fail(const std::string& what) {
  end_and_hear();
  const std::string said = joined(tail_.text());
  std::string remedy;
  if (said.find("Unknown encoder") != std::string::npos) {
    remedy = "; install a complete ffmpeg: apt-get install ffmpeg";
  } else if (said.find("No space left") != std::string::npos) {
    remedy = "; free some space or choose another disk";
  }
  throw Error(ErrorKind::encoder, fmt::format("{}: {} ({}): {}{}", setup_.name, what, child_.ending(),
                                              said.empty() ? "it gave no reason" : said, remedy));
}

void check_video(const std::string& name, const std::filesystem::path& file, const VideoFacts& expected,
                 double patience) {
  VideoFacts found;
  Arguments command = words("ffmpeg {} -i", kQuietFfmpeg);
  append(command, {file_argument(file)});
  append(command,
         words("-map 0:v:0 -c copy -f framecrc pipe:1"));  // the size of the picture, then a line a frame
  const ChildOutcome outcome = run_child(command, patience, [&](std::string_view line) {
    if (line.starts_with("#dimensions 0: ")) {
      std::sscanf(std::string(line.substr(15)).c_str(), "%dx%d", &found.width, &found.height);
    } else if (!line.empty() && line.front() != '#') {
      ++found.frames;
    }
  });
  const auto refuse = [&](const std::string& what) {
    throw Error(
        ErrorKind::encoder,
        fmt::format("{}: ffmpeg ended well, but what it wrote {}; the video was not kept: is the disk "
                    "full?",
                    name, what));
  };
  if (outcome.too_slow) refuse(fmt::format("could not be read back within {:g} s", patience));
  if (outcome.status != 0 || !outcome.errors.empty())
    refuse("cannot be read back (" + one_line(without_addresses(outcome.errors)) + ")");
  if (found.frames != expected.frames || found.width != expected.width || found.height != expected.height) {
    refuse(fmt::format("has {} of {}x{} pixels, not {} of {}x{}", counted(found.frames, "frame"), found.width,
                       found.height, expected.frames, expected.width, expected.height));
  }
}

std::string ffmpeg_version() {
  std::string first;
  const auto keep_first = [&](std::string_view line) {
    if (first.empty()) first = line;
  };
  const ChildOutcome outcome =
      run_child({"ffmpeg", "-version"}, kVersionPatience, keep_first, kVersionPatience);
  return outcome.status == 0 ? first : "";
}

}  // namespace pabd
