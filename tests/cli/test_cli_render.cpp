// SPDX-License-Identifier: MIT
// pabd render: frames, their text chunks, videos, resuming, interrupting.
#include <array>
#include <catch2/catch.hpp>
#include <csignal>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <set>

#include "render/output/png.h"
#include "tests/cli/program.h"

namespace pabd::test_cli_render {

using namespace test;
using pabd::PngText;
using pabd::read_png;
using pabd::read_png_text;

namespace {

std::vector<std::string> render(const std::string& out, const std::vector<std::string>& more) {
  std::vector<std::string> command = {"render", "two_boxes", "--size", "160x90", "--quiet", "-o", out};
  command.insert(command.end(), more.begin(), more.end());
  return command;
}

}  // namespace

TEST_CASE("a sequence has a PNG a frame; the first shows the start") {
  const CommandFolder folder;
  REQUIRE(run_pabd(render(folder / "f{frame:04}.png", {"--frames", "4"})).exit_code == 0);
  CHECK(folder.names() == std::vector<std::string>{"f0000.png", "f0001.png", "f0002.png", "f0003.png"});
  REQUIRE(run_pabd(render(folder / "start.png", {"--time", "0"})).exit_code == 0);
  CHECK(read_png(folder / "start.png").rgb == read_png(folder / "f0000.png").rgb);
  CHECK(read_png(folder / "f0003.png").rgb != read_png(folder / "f0000.png").rgb);
  CHECK(read_png(folder / "f0003.png").width == 160);
  CHECK(read_png(folder / "f0003.png").height == 90);
}

TEST_CASE("a still shows the state at its time, a step a frame at 60 a second") {
  const CommandFolder folder;
  REQUIRE(run_pabd(render(folder / "f{frame}.png", {"--frames", "7"})).exit_code == 0);
  REQUIRE(run_pabd(render(folder / "still.png", {"--time", "0.1"})).exit_code == 0);
  CHECK(read_text(folder / "still.png") == read_text(folder / "f6.png"));
  REQUIRE(run_pabd(render(folder / "last.png", {"--frames", "7"})).exit_code == 0);
  CHECK(read_text(folder / "last.png") == read_text(folder / "f6.png"));
  // Half as many frames a second: every second step.
  REQUIRE(run_pabd(render(folder / "h{frame}.png", {"--frames", "4", "--fps", "30"})).exit_code == 0);
  CHECK(read_png(folder / "h3.png").rgb == read_png(folder / "f6.png").rgb);
}

TEST_CASE("a block that stands at the side keeps its shadow when what moves comes together") {
  const CommandFolder folder;
  write_text(folder / "s.json", R"({ "format": "pabd-scene", "version": 1, "gravity": [0, 0, 0], "bodies": [
    { "shape": { "type": "plane" } },
    { "shape": { "type": "box", "size": [1, 1, 1] }, "fixed": true, "position": [0, 0.5, -4] },
    { "shape": { "type": "sphere", "radius": 0.1 }, "position": [-3, 0.3, 2], "velocity": [2, 0, 0] },
    { "shape": { "type": "sphere", "radius": 0.1 }, "position": [3, 0.3, 2], "velocity": [-2, 0, 0] } ] })");
  std::vector<pabd::Image> images;
  for (const char* time : {"0", "1.4"}) {
    REQUIRE(run_pabd({"render", folder / "s.json", "--size", "320x180", "--quiet", "--force", "--time", time,
                      "--camera", "eye=0,5,6,target=0,0,-1", "-o", folder / "p.png"})
                .exit_code == 0);
    images.push_back(read_png(folder / "p.png"));
  }
  int other = 0, darker = 0;  // of the upper half, where the block is
  for (std::size_t k = 0; k < images[0].rgb.size() / 2; k += 3) {
    other += std::abs(images[0].rgb[k] - images[1].rgb[k]) > 20;
    darker += images[0].rgb[k] < 190;  // than the floor
  }
  CHECK(darker > 400);
  CHECK(other < darker / 10);
}

TEST_CASE("a render is as long as its scene says, unless it is told") {
  const CommandFolder folder;
  const auto frames = [&](const char* name, std::vector<std::string> more) {
    more.insert(more.end(), {"--set", "duration=0.1"});
    REQUIRE(run_pabd(render(folder / (std::string(name) + "{frame}.png"), more)).exit_code == 0);
    std::size_t count = 0;
    for (const std::string& file : folder.names()) count += file.starts_with(name);
    return count;
  };
  CHECK(frames("scene", {}) == 6);
  CHECK(frames("time", {"--time", "0.05"}) == 3);
  CHECK(frames("frames", {"--frames", "2"}) == 2);
  REQUIRE(run_pabd(render(folder / "still.png", {"--set", "duration=0.05"})).exit_code == 0);
  CHECK(read_png_text(folder / "still.png").at("Time") == "0.050000 s");
  const Outcome outcome = run_pabd(render(folder / "none.mp4", {"--set", "duration=0.001"}));
  CHECK(outcome.exit_code == 2);
  CHECK(outcome.err.find("duration of the scene 0.001: shorter than one frame") != std::string::npos);
}

TEST_CASE("every PNG says where it comes from") {
  const CommandFolder folder;
  REQUIRE(run_pabd(render(folder / "{frame}.png",
                          {"--frames", "3", "--set", "contact.kappa=auto", "--camera", "front"}))
              .exit_code == 0);
  const PngText text = read_png_text(folder / "2.png");
  CHECK(text.at("Software").starts_with("pabd 0."));
  CHECK(text.at("Scene") == "two boxes");
  CHECK(text.at("Scene hash").size() == 16);
  CHECK_FALSE(text.at("GL_RENDERER").empty());
  CHECK(text.at("Frame") == "2");
  CHECK(text.at("Time") == "0.033333 s");
  const auto parameters = nlohmann::json::parse(text.at("Parameters"));
  CHECK(parameters["contact"]["kappa"].get<double>() > 0);  // what "auto" came to
  CHECK(parameters["time_step"].get<double>() == Approx(1.0 / 60).margin(1e-12));
  CHECK(parameters.count("joints_default") == 0);  // no joints
  CHECK(nlohmann::json::parse(text.at("View"))["camera"] == "front");

  REQUIRE(run_pabd(render(folder / "b{frame}.png", {"--frames", "1", "--set", "contact.N=8"})).exit_code ==
          0);
  const PngText other = read_png_text(folder / "b0.png");
  CHECK(other.at("Scene hash") != text.at("Scene hash"));
  CHECK(nlohmann::json::parse(other.at("Parameters"))["contact"]["N"] == 8);
}

TEST_CASE("every PNG of a scene with joints tells their law, with the stiffness that auto came to") {
  const CommandFolder folder;
  const auto law_of = [&](const std::vector<std::string>& more) {
    std::vector<std::string> command = {"render", "pendulum", "-o",     folder / "p.png", "--force",
                                        "--time", "0",        "--size", "160x90"};
    command.insert(command.end(), more.begin(), more.end());
    const Outcome outcome = run_pabd(command);
    CAPTURE(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    return nlohmann::json::parse(read_png_text(folder / "p.png").at("Parameters"))["joints_default"];
  };
  const auto soft = law_of({});
  CHECK(soft["potential"] == "soft");
  CHECK(soft["kappa"].get<double>() > 1);
  CHECK(soft.size() == 2);
  const auto hard = law_of({"--set", "joints_default.potential=hard", "--set", "joints_default.kappa=250"});
  CHECK(hard == nlohmann::json::parse(R"({"potential": "hard", "kappa": 250, "N": 4, "d_hat": 0.01})"));
}

TEST_CASE("raw frames on standard output have three bytes a pixel and nothing else") {
  const CommandFolder folder;
  const Outcome raw = run_pabd(render("-", {"--frames", "3"}));
  CHECK(raw.exit_code == 0);
  REQUIRE(raw.out.size() == 3u * 160 * 90 * 3);
  REQUIRE(run_pabd(render(folder / "{frame}.png", {"--frames", "3"})).exit_code == 0);
  const auto last = read_png(folder / "2.png").rgb;
  CHECK(std::equal(last.begin(), last.end(), raw.out.end() - static_cast<std::ptrdiff_t>(last.size()),
                   [](std::uint8_t a, char b) { return a == static_cast<std::uint8_t>(b); }));
}

TEST_CASE("overlays, cameras and --set change the picture; a repetition does not") {
  const CommandFolder folder;
  const auto picture = [&](const std::vector<std::string>& more) {
    std::vector<std::string> options = {"--time", "0.2", "--force"};
    options.insert(options.end(), more.begin(), more.end());
    REQUIRE(run_pabd(render(folder / "p.png", options)).exit_code == 0);
    return read_png(folder / "p.png").rgb;
  };
  const auto plain = picture({});
  CHECK(picture({}) == plain);
  CHECK(picture({"--threads", "2"}) == plain);
  for (const char* overlay :
       {"params", "barrier", "convergence", "series", "contacts", "plots", "all", "boxes", "axes", "scale"}) {
    CAPTURE(overlay);
    CHECK(picture({"--overlay", overlay}) != plain);
  }
  CHECK(picture({"--overlay", "none"}) == plain);
  CHECK(picture({"--overlay", "bonds"}) == plain);  // there are none
  for (const char* camera : {"front", "side", "top", "iso", "orbit:90", "fov=20", "eye=3,3,3,target=0,1,0"}) {
    CAPTURE(camera);
    CHECK(picture({"--camera", camera}) != plain);
  }
  CHECK(picture({"--set", "gravity=[0,0,0]"}) != plain);
}

TEST_CASE("a render continues from a state") {
  const CommandFolder folder;
  REQUIRE(run_pabd({"run", "two_boxes", "--steps", "6", "--quiet", "--state", folder / "s.json"}).exit_code ==
          0);
  REQUIRE(run_pabd(render(folder / "a.png", {"--time", "0", "--from", folder / "s.json"})).exit_code == 0);
  REQUIRE(run_pabd(render(folder / "b.png", {"--time", "0.1"})).exit_code == 0);
  // Without an explicit camera the frame is the scene's, so that both see the same.
  CHECK(read_png(folder / "a.png").rgb == read_png(folder / "b.png").rgb);
}

TEST_CASE("videos have the size and the number of frames asked for") {
  const CommandFolder folder;
  for (const char* name : {"a.mp4", "a.webm"}) {
    CAPTURE(name);
    const Outcome outcome = run_pabd(render(folder / name, {"--time", "0.2"}));
    CAPTURE(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    CHECK(probe_video(folder / name) == "160,90,12");
  }
  REQUIRE(run_pabd(render(folder / "a.gif", {"--frames", "5", "--fps", "10"})).exit_code == 0);
  CHECK(probe_video(folder / "a.gif") == "160,90,5");
  CHECK(folder.names().size() == 3);
}

TEST_CASE("a GIF is small and slow unless it is asked for otherwise") {
  const CommandFolder folder;
  REQUIRE(run_pabd({"render", "stack", "-o", folder / "a.gif", "--time", "0.2", "--quiet"}).exit_code == 0);
  CHECK(probe_video(folder / "a.gif") == "640,360,4");
  REQUIRE(run_pabd({"render", "stack", "-o", folder / "b.gif", "--time", "0.2", "--quiet", "--fps", "30",
                    "--size", "160x90"})
              .exit_code == 0);
  CHECK(probe_video(folder / "b.gif") == "160,90,6");
}

TEST_CASE("render names what it wrote, and how much") {
  const CommandFolder folder;
  const auto said = [&](const std::string& out, const std::vector<std::string>& more) {
    auto command = render(out, more);
    std::erase(command, "--quiet");
    const Outcome outcome = run_pabd(command);
    CAPTURE(outcome.err);
    CHECK(outcome.exit_code == 0);
    const auto at = outcome.err.find("wrote ");
    return at == std::string::npos ? "" : outcome.err.substr(at, outcome.err.find('\n', at) - at);
  };
  const std::string video = folder / "a.mp4";
  CHECK(said(video, {"--frames", "6"})
            .starts_with("wrote " + video + ": 6 frames of 160x90, 0.1 s at 60 a second, "));
  CHECK(said(video, {"--frames", "1", "--force"}).starts_with("wrote " + video + ": 1 frame of 160x90"));
  // Of odd sides the file has even ones.
  const Outcome odd =
      run_pabd({"render", "stack", "-o", folder / "odd.mp4", "--frames", "1", "--size", "161x91"});
  CHECK(odd.err.find("1 frame of 162x92") != std::string::npos);
  const std::string still = folder / "a.png";
  CHECK(said(still, {"--time", "0"}).starts_with("wrote " + still + ": 160x90, "));
  CHECK(said(folder / "f{frame:02}.png", {"--frames", "3"}) ==
        "wrote " + folder / "f00.png" + " … " + folder / "f02.png" + ": 3 frames of 160x90");
  CHECK(said(folder / "f{frame:02}.png", {"--frames", "4", "--resume"}) ==
        "wrote " + folder / "f03.png" + ": 1 frame of 160x90");
}

TEST_CASE("a video says where it came from: scene, hash, parameters and view") {
  const CommandFolder folder;
  const std::string still = folder / "a.png";
  REQUIRE(run_pabd(render(still, {"--time", "0", "--set", "contact.kappa=77"})).exit_code == 0);
  const PngText expected = read_png_text(still);
  for (const char* name : {"a.mp4", "a.webm", "a.gif"}) {
    CAPTURE(name);
    REQUIRE(run_pabd(render(folder / name, {"--frames", "2", "--set", "contact.kappa=77"})).exit_code == 0);
    std::string found;
    if (std::string(name) == "a.gif") {
      found = read_text(folder / name);
      const auto at = found.find("GL_RENDERER: ");
      REQUIRE(at != std::string::npos);
      std::string text;  // parts of at most 255 bytes, each after its length
      for (std::size_t i = found.rfind("\x21\xFE", at) + 2; found.at(i) != 0;) {
        const auto n = static_cast<unsigned char>(found[i]);
        text += found.substr(i + 1, n);
        i += n + 1u;
      }
      CHECK(found.back() == 0x3B);
      found = text;
    } else {
      found = run_command(
                  {"ffprobe", "-v", "error", "-show_entries", "format_tags", "-of", "json", folder / name})
                  .out;
      const auto tags = nlohmann::json::parse(found)["format"]["tags"];
      found.clear();
      for (const auto& [key, value] : tags.items()) found += key + ": " + value.get<std::string>() + "\n";
    }
    CAPTURE(found);
    for (const char* key : {"Scene", "Scene hash", "Parameters", "Software", "GL_RENDERER"}) {
      CAPTURE(key);
      CHECK(found.find(": " + expected.at(key)) != std::string::npos);
    }
    CHECK(found.find("\"kappa\":77") != std::string::npos);
  }
}

TEST_CASE("--quality changes how smooth a picture is, and its text says so") {
  const CommandFolder folder;
  const auto picture = [&](const std::string& name, const std::vector<std::string>& more) {
    std::vector<std::string> options = {"--time", "0"};
    options.insert(options.end(), more.begin(), more.end());
    REQUIRE(run_pabd(render(folder / name, options)).exit_code == 0);
    return read_png(folder / name).rgb;
  };
  const auto plain = picture("plain.png", {}), good = picture("good.png", {"--quality", "good"});
  const auto draft = picture("draft.png", {"--quality", "draft"});
  const auto best = picture("best.png", {"--quality", "best"});
  CHECK(plain == good);
  CHECK(draft != good);
  CHECK(best.size() == good.size());
  CHECK(read_png_text(folder / "good.png") == read_png_text(folder / "plain.png"));
  CHECK(read_png_text(folder / "draft.png").at("View").find("\"quality\":\"draft\"") != std::string::npos);
  // With one sample a pixel an edge has no steps between its two colours: fewer colours.
  const auto colours = [](const auto& rgb) {
    std::set<std::array<unsigned, 3>> out;
    for (std::size_t i = 0; i + 2 < rgb.size(); i += 3) out.insert({rgb[i], rgb[i + 1], rgb[i + 2]});
    return out.size();
  };
  CHECK(colours(draft) < colours(good));
}

TEST_CASE("a sequence that was cut short is continued byte for byte") {
  const CommandFolder whole, cut;
  const std::vector<std::string> options = {"--frames", "9", "--overlay", "all"};
  auto resumed = options;
  resumed.push_back("--resume");
  REQUIRE(run_pabd(render(whole / "{frame:02}.png", options)).exit_code == 0);
  REQUIRE(run_pabd(render(cut / "{frame:02}.png", options)).exit_code == 0);

  SECTION("frames are missing at the end") {
    for (const char* name : {"05.png", "06.png", "07.png", "08.png"}) std::filesystem::remove(cut / name);
  }
  SECTION("a frame is missing in the middle") { std::filesystem::remove(cut / "03.png"); }
  SECTION("the last frame is cut off") {
    std::filesystem::remove(cut / "08.png");
    write_text(cut / "07.png", read_text(cut / "07.png").substr(0, 3000));
  }
  SECTION("nothing is there") {
    for (const std::string& name : cut.names()) std::filesystem::remove(cut / name);
  }
  SECTION("everything is there") {}
  const Outcome outcome = run_pabd(render(cut / "{frame:02}.png", resumed));
  CAPTURE(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  REQUIRE(cut.names() == whole.names());
  for (const std::string& name : whole.names()) {
    CAPTURE(name);
    CHECK(read_text(cut / name) == read_text(whole / name));
  }
}

TEST_CASE("frames of another run are not continued") {
  const CommandFolder folder;
  REQUIRE(run_pabd(render(folder / "{frame}.png", {"--frames", "2"})).exit_code == 0);
  const std::string before = read_text(folder / "1.png");
  for (const std::vector<std::string>& change : std::vector<std::vector<std::string>>{
           {"--set", "contact.N=2"}, {"--camera", "top"}, {"--fps", "30"}, {"--overlay", "params"}}) {
    std::vector<std::string> options = {"--frames", "4", "--resume"};
    options.insert(options.end(), change.begin(), change.end());
    CAPTURE(change);
    const Outcome outcome = run_pabd(render(folder / "{frame}.png", options));
    CHECK(outcome.exit_code == 2);
    CHECK(is_error_line(outcome.err, {"0.png", "another run"}));
  }
  CHECK(folder.names().size() == 2);
  CHECK(read_text(folder / "1.png") == before);
}

TEST_CASE("an interrupted sequence keeps its whole frames and can be continued") {
  const CommandFolder folder;
  const auto has_third_frame = [&](const std::string&) {
    return std::filesystem::exists(folder / "0002.png");
  };
  const Outcome outcome = run_pabd_interrupted(render(folder / "{frame:04}.png", {"--frames", "100000"}),
                                               SIGINT, has_third_frame);
  CHECK(outcome.exit_code == 130);
  CHECK(outcome.err.empty());
  const auto names = folder.names();
  REQUIRE(names.size() >= 3);
  for (std::size_t i = 0; i < names.size(); ++i) {
    CAPTURE(names[i]);
    CHECK(std::stoul(names[i]) == i);
    CHECK(read_png(folder / names[i]).width == 160);
  }
  const std::string frames = std::to_string(names.size() + 2);
  REQUIRE(run_pabd(render(folder / "{frame:04}.png", {"--frames", frames, "--resume"})).exit_code == 0);
  CHECK(folder.names().size() == names.size() + 2);
}

TEST_CASE("an interrupted video is published with the frames it has") {
  for (const auto& [signal, code] : {std::pair{SIGINT, 130}, {SIGTERM, 143}}) {
    const CommandFolder folder;
    // The first line of progress comes when frames have been drawn and handed on.
    const auto has_progress = [](const std::string& err) {
      return err.find(" frames ") != std::string::npos;
    };
    const Outcome outcome = run_pabd_interrupted(
        {"render", "two_boxes", "--size", "160x90", "--frames", "100000", "-o", folder / "a.mp4"}, signal,
        has_progress);
    CAPTURE(outcome.err);
    CHECK(outcome.exit_code == code);
    REQUIRE(folder.names() == std::vector<std::string>{"a.mp4"});
    const std::string facts = probe_video(folder / "a.mp4");
    CHECK(facts.starts_with("160,90,"));
    const int frames = std::stoi(facts.substr(7));
    CHECK(frames >= 1);
    CHECK(frames < 100000);
  }
}

TEST_CASE("the same signal twice in a moment publishes the video as one does") {
  const CommandFolder folder;
  const Outcome outcome = run_pabd_interrupted(
      {"render", "pile", "--size", "640x360", "--frames", "100000", "-o", folder / "a.mp4"}, SIGINT,
      [](const std::string& err) { return err.find(" frames ") != std::string::npos; }, 2);
  CHECK(outcome.exit_code == 130);
  CHECK(folder.names() == std::vector<std::string>{"a.mp4"});
  CHECK(probe_video(folder / "a.mp4").starts_with("640,360,"));
}

}  // namespace pabd::test_cli_render
