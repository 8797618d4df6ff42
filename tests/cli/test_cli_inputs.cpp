// SPDX-License-Identifier: MIT
// Inputs that are no files, without end, too long, or full of what a terminal would obey; outputs that are
// inputs.
#include <sys/stat.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <new>
#include <system_error>

#include "app/cli/report_error.h"
#include "sim/base/utf8.h"
#include "tests/cli/program.h"
#include "tests/support/places.h"
#include "tests/support/sanitized.h"

namespace pabd::test_cli_inputs {

namespace fs = std::filesystem;
using namespace test;

namespace {

using Command = std::vector<std::string>;

// Every option that reads a file, with `file` for it.
std::vector<Command> readers(const std::string& file, const std::string& out) {
  const Command small = {"--frames", "1", "--size", "64x48", "--quiet", "-o", out};
  const auto render = [&](Command command) {
    command.insert(command.end(), small.begin(), small.end());
    return command;
  };
  return {{"run", file, "--steps", "1"},
          {"run", "two_boxes", "--steps", "1", "--from", file},
          render({"render", file}),
          render({"render", "two_boxes", "--from", file}),
          render({"render", "two_boxes", "--ab", file}),
          render({"render", "two_boxes", "--camera", file}),
          {"view", "two_boxes", "--headless", "--script", file},
          {"plot", "convergence", file, "-o", out},
          {"compare", file, file}};
}

bool is_printable(const std::string& err) {
  for (const char c : err)
    if (static_cast<unsigned char>(c) < 0x20 && c != '\n') return false;
  return pabd::is_utf8_text(err);
}

}  // namespace

TEST_CASE("what is no file is refused with exit code 3, at once, wherever it is named") {
  const CommandFolder folder;
  fs::create_symlink("/dev/zero", folder / "zero.json");
  fs::create_symlink("loop.json", folder / "loop.json");
  REQUIRE(::mkfifo((folder / "fifo.json").c_str(), 0600) == 0);
  fs::create_directory(folder / "folder.json");
  for (const auto& [name, words] : {std::pair{"zero.json", "it is a device"},
                                    {"loop.json", "symbolic links"},
                                    {"fifo.json", "it is a pipe"},
                                    {"folder.json", "it is a folder"}}) {
    for (const Command& command : readers(folder / name, folder / "out.png")) {
      CAPTURE(command);
      // A scene that is a folder is usage: a name in it is missing.
      const bool is_scene = command[0] != "compare" && command[command[0] == "plot" ? 2 : 1] == folder / name;
      const bool usage = is_scene && std::string(name) == "folder.json";
      const Outcome outcome = run_pabd(command);
      CAPTURE(outcome.err);
      CHECK(outcome.exit_code == (usage ? 2 : 3));
      CHECK(is_error_line(outcome.err, {name, usage ? "is a directory" : words}));
    }
  }
  CHECK_FALSE(fs::exists(folder / "out.png"));
}

TEST_CASE("what is longer than its kind can be is refused before it is read") {
  const CommandFolder folder;
  const std::string file = folder / "long.json";
  write_text(file, "");
  REQUIRE(::truncate(file.c_str(), off_t{1} << 42) == 0);  // without a byte on the disk
  for (const Command& command : readers(file, folder / "out.png")) {
    CAPTURE(command);
    const Outcome outcome = run_pabd(command);
    CAPTURE(outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(is_error_line(outcome.err, {"long.json"}));
  }
}

TEST_CASE("a file from a shell's pipe works, also where two runs need it") {
  const CommandFolder folder;
  write_text(folder / "scene.json", small_scene());
  write_text(folder / "patch.json", R"({"contact": {"N": 5}})");
  const auto shell = [&](const std::string& script) {
    return run_command({"bash", "-c", script, places::program(), folder.path().string()});
  };
  Outcome outcome = shell("\"$0\" run <(cat \"$1/scene.json\") --steps 2 --quiet --state \"$1/s.json\"");
  CAPTURE(outcome.err);
  CHECK(outcome.exit_code == 0);
  outcome = shell("cat \"$1/scene.json\" | \"$0\" run /dev/stdin --steps 2 --quiet --trace -");
  CHECK(outcome.exit_code == 0);
  CHECK(line_count(outcome.out) == 3);
  outcome = shell(
      "\"$0\" render <(cat \"$1/scene.json\") --from <(cat \"$1/s.json\") --ab <(cat \"$1/patch.json\") "
      "--frames 2 --size "
      "64x48 --quiet -o \"$1/a.png\"");
  CAPTURE(outcome.err);
  CHECK(outcome.exit_code == 0);
  CHECK(fs::exists(folder / "a.png"));
}

TEST_CASE("text of an input cannot steer the terminal") {
  const CommandFolder folder;
  const std::string evil = "\x1b]0;owned\x07\x1b[31m\xff\xc2\x9b\n\r";
  write_text(folder / "good.json", small_scene());
  write_text(folder / "key.json", small_scene("", R"("N": 3, "ka)" + evil + R"(pa": 5)"));
  write_text(folder / "word.json", small_scene("", R"("barrier": "log\u001b[31m\u009b")"));
  write_text(folder / "mesh.json", small_scene(R"("shape": { "type": "mesh", "file": "mesh.obj" })"));
  write_text(folder / "mesh.obj", "v 1 2 " + evil + "\nf " + evil);
  write_text(folder / (evil.substr(0, 18) + ".json"), "{}");
  write_text(folder / "text.png", evil);
  std::vector<Command> commands = {
      {"run", folder / "good.json", "--steps", "1", "--set", "contact." + evil + "=1"},
      {"run", folder / "good.json", "--steps", "1", "--set", "contact.barrier=\"" + evil + "\""},
      {"run", "good.json" + evil},
      {"run", folder / "good.json", "--steps", evil},
      {"run", folder / "good.json", "--" + evil},
      {evil},
      {"render", folder / "good.json", "--overlay", evil, "-o", folder / "a.png"},
      {"render", folder / "good.json", "--camera", evil, "-o", folder / "a.png"},
      {"render", folder / "good.json", "-o", evil},
      {"compare", folder / "text.png", folder / "text.png"},
      {"compare", evil, evil}};
  for (const char* name : {"key.json", "word.json", "mesh.json"}) {
    for (const Command& command : readers(folder / name, folder / "a.png")) commands.push_back(command);
  }
  commands.push_back({"run", folder / (evil.substr(0, 18) + ".json")});
  for (const Command& command : commands) {
    CAPTURE(command);
    const Outcome outcome = run_pabd(command);
    CHECK(outcome.exit_code >= 2);
    CHECK(outcome.exit_code <= 3);
    CHECK(is_error_line(outcome.err, {}));
    CHECK(is_printable(outcome.err));
    CHECK(is_printable(outcome.out));
  }
}

TEST_CASE("a file that is read is never overwritten, by whatever name, even with --force") {
  const CommandFolder folder;
  fs::copy(places::assets() + "/meshes", folder.path() / "meshes");
  const std::string mesh = "hexagon.stl";
  const std::string scene = folder / "scene.json";
  write_text(scene, small_scene(R"("shape": { "type": "mesh", "file": "meshes/)" + mesh + R"(" })"));
  write_text(folder / "patch.json", R"({"contact": {"N": 5}})");
  fs::create_symlink("scene.json", folder / "link.json");
  fs::create_hard_link(scene, folder / "hard.png");
  REQUIRE(run_pabd({"run", scene, "--steps", "1", "--quiet", "--state", folder / "s.json"}).exit_code == 0);
  const std::string mesh_file = folder / ("meshes/" + mesh);
  fs::create_symlink(mesh_file, folder / "mesh.svg");
  REQUIRE(run_pabd({"plot", "barrier", "-o", folder / "p.png"}).exit_code == 0);
  write_text(folder / "script.json", R"([{"do": "frame", "path": "hard.png"}])");
  fs::create_hard_link(folder / "script.json", folder / "script.png");
  write_text(folder / "script.json", R"([{"do": "frame", "path": "script.png"}])");
  const Command small = {"--frames", "1", "--size", "64x48", "--quiet", "--force"};
  const auto render = [&](Command command) {
    command.insert(command.end(), small.begin(), small.end());
    return command;
  };
  std::vector<Command> commands = {
      {"run", scene, "--steps", "1", "--force", "--state", scene},
      {"run", scene, "--steps", "1", "--force", "--trace", folder / "link.json"},
      {"run", folder / "link.json", "--steps", "1", "--force", "--state", folder / "hard.png"},
      {"run", scene, "--steps", "1", "--force", "--iterations", mesh_file},
      {"run", scene, "--steps", "1", "--force", "--from", folder / "s.json", "--state", folder / "s.json"},
      render({"render", scene, "-o", folder / "hard.png"}),
      {"plot", "convergence", scene, "--force", "-o", folder / "mesh.svg"},
      {"compare", folder / "p.png", folder / "p.png", "--force", "--diff", folder / "p.png"},
      {"view", scene, "--headless", "--force", "--script", folder / "script.json", "-o",
       folder.path().string()}};
  std::map<std::string, std::string> before;
  for (const char* name : {"scene.json", "patch.json", "s.json", "p.png", "script.json"})
    before[folder / name] = read_text(folder / name);
  before[mesh_file] = read_text(mesh_file);
  for (const Command& command : commands) {
    CAPTURE(command);
    const Outcome outcome = run_pabd(command);
    CAPTURE(outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(is_error_line(outcome.err, {"never overwritten"}));
    for (const auto& [name, text] : before) CHECK(read_text(name) == text);
  }
}

TEST_CASE("what a sequence of frames would write over an input stops it") {
  const CommandFolder folder;
  write_text(folder / "scene.json", small_scene());
  fs::create_hard_link(folder / "scene.json", folder / "f2.png");
  const Outcome outcome = run_pabd({"render", folder / "scene.json", "--frames", "4", "--size", "64x48",
                                    "--quiet", "--force", "-o", folder / "f{frame}.png"});
  CHECK(outcome.exit_code == 2);
  CHECK(is_error_line(outcome.err, {"f2.png", "never overwritten"}));
  CHECK(read_text(folder / "scene.json") == small_scene());
}

TEST_CASE("a driver that is chosen by the environment and does not work: exit code 4 with what helps") {
  const CommandFolder folder;
  for (const auto& [name, value, backend] :
       {std::tuple{"GALLIUM_DRIVER", "softpipe",
                   "auto"},  // cannot draw with several samples, which best asks for
        {"GALLIUM_DRIVER", "softpipe", "osmesa"},
        {"GALLIUM_DRIVER", "bogus", "auto"},
        {"GALLIUM_DRIVER", "bogus", "osmesa"},  // crashes in Mesa 22
        {"MESA_GLSL_VERSION_OVERRIDE", "120", "auto"},
        {"MESA_GLSL_VERSION_OVERRIDE", "120", "osmesa"},  // so does this
        {"MESA_GL_VERSION_OVERRIDE", "2.1", "auto"}}) {
    CAPTURE(name, value, backend);
    Setting setting;
    setting.environment = {{name, value}};
    const Outcome outcome = run_pabd({"render", "two_boxes", "--frames", "1", "--size", "64x48", "--quiet",
                                      "--quality", "best", "--backend", backend, "-o", folder / "a.png"},
                                     setting);
    CAPTURE(outcome.err);
    CHECK(outcome.exit_code == 4);
    const auto lines = lines_of(outcome.err);  // Mesa may say something, too
    REQUIRE_FALSE(lines.empty());
    CHECK(
        is_error_line(lines.back() + "\n", {std::string("unset ") + name, std::string(name) + "=" + value}));
    CHECK(run_pabd({"doctor"}, setting).exit_code == 0);
  }
  CHECK(folder.names().empty());
}

TEST_CASE("every kind of error has its exit code; out of memory and what the system refuses are no defects") {
  using pabd::cli::report_error;
  CHECK(report_error(std::make_exception_ptr(std::bad_alloc())) == 3);
  CHECK(report_error(std::make_exception_ptr(std::bad_array_new_length())) == 3);
  CHECK(report_error(std::make_exception_ptr(fs::filesystem_error(
            "status", "x", std::make_error_code(std::errc::too_many_symbolic_link_levels)))) == 3);
  CHECK(report_error(std::make_exception_ptr(std::logic_error("x"))) == 1);
  // The table of the README.
  using pabd::ErrorKind;
  for (const auto& [kind, code] : {std::pair{ErrorKind::defect, 1},
                                   {ErrorKind::bad_input, 2},
                                   {ErrorKind::exists, 2},
                                   {ErrorKind::file, 3},
                                   {ErrorKind::no_context, 4},
                                   {ErrorKind::diverged, 5},
                                   {ErrorKind::encoder, 6},
                                   {ErrorKind::images_differ, 7}})
    CHECK(report_error(std::make_exception_ptr(pabd::Error(kind, "x"))) == code);
#if !defined(PABD_SANITIZED)  // which reserves more than any limit at its start
  const CommandFolder folder;
  write_text(folder / "many.json",
             R"({ "format": "pabd-scene", "version": 1, "name": "many",
                  "generate": [ { "type": "pile", "count": 500000, "size": [1, 1, 1], "position": [0, 1, 0] } ] })");
  Setting little;
  little.most_memory = 200'000'000;
  const Outcome outcome = run_pabd({"run", folder / "many.json", "--steps", "1", "--threads", "1"}, little);
  CAPTURE(outcome.err);
  CHECK(outcome.exit_code == 3);
  CHECK(is_error_line(outcome.err, {"out of memory"}));
#endif
}

#if !defined(PABD_SANITIZED)
TEST_CASE(
    "where the address space is too small for the driver of OpenGL, no signal ends the program unsaid") {
  for (const std::size_t megabytes : {300, 400, 500, 600, 700}) {
    CAPTURE(megabytes);
    const CommandFolder folder;
    Setting little;
    little.most_memory = megabytes * 1'000'000;
    const Outcome outcome = run_pabd({"render", "two_boxes", "--quiet", "-o", folder / "a.png"}, little);
    CAPTURE(outcome.err);
    // How much it needs depends on threads that come and go: what was let in may still crash, and says so last.
    CHECK((outcome.exit_code == 0 || outcome.exit_code == 1 || outcome.exit_code == 3 ||
           outcome.exit_code == 4));
    const std::vector<std::string> lines = lines_of(outcome.err);
    CHECK((outcome.exit_code == 0 || (!lines.empty() && lines.back().starts_with("pabd: error: "))));
    CHECK(folder.names().size() == (outcome.exit_code == 0 ? 1 : 0));
  }
}
#endif

}  // namespace pabd::test_cli_inputs
