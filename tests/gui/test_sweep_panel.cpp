// SPDX-License-Identifier: MIT
// The panel of a sweep: what it shows of a folder, what the pointer does in its cells, and what it refuses to read.
#include <catch2/catch.hpp>
#include <filesystem>

#include "app/gui/file_list.h"
#include "app/gui/script.h"
#include "app/gui/sweep_cells.h"
#include "app/session/session.h"
#include "render/output/png.h"
#include "sim/trace/trace.h"
#include "tests/gui/script_runner.h"
#include "tests/support/errors.h"
#include "tests/support/golden.h"
#include "tests/sweep/swept_folder.h"

namespace pabd::test_sweep_panel {

using namespace test;
namespace fs = std::filesystem;

namespace {

constexpr const char* kPlan = R"({"scene": "two_boxes", "set": {"solver.iterations": 60},
  "parameters": [{"key": "contact.N"}, {"key": "contact.kappa"}], "metrics": ["penetration", "iterations"]})";

// N = 1 … columns along x, κ = 10, 20, … along y. One diverged, one refused, one unfinished, one without a picture.
void fill(const SweptFolder& folder, int columns = 4, int rows = 3) {
  for (int i = 0; i < columns * rows; ++i) {
    const int n = i % columns, row = i / columns;
    FakeTask task{.index = i,
                  .parameters = {{"contact.N", std::to_string(n + 1)},
                                 {"contact.kappa", std::to_string(10 * (row + 1))}},
                  .metrics = {{"penetration", "1e" + std::to_string(n - 5 - row)},
                              {"iterations", std::to_string(10 * (i + 1))}},
                  .step_time = 0.1 * (i + 1)};
    if (i == 1) task.status = "diverged";
    if (i == 2) task.status = "refused";
    if (i == 2) task.why = "contact.N: expected 1 to 32";
    if (i != 2 && i != 5) task.picture = fake_picture(i);
    folder.add(task);
  }
  fs::remove(folder.task_folder(3) / "result.json");
}

// The run of a task with these parameters, so many steps later; its state is what the task's folder holds.
Session ended(const std::string& n, const std::string& kappa, int steps, const fs::path& task) {
  Session session(std::make_shared<const Scene>(load_scene(
      shipped_scene("two_boxes"), {"solver.iterations=60", "contact.N=" + n, "contact.kappa=" + kappa})));
  for (int i = 0; i < steps; ++i) session.step();
  session.complete_state();
  write_bytes(task / "end.json", state_to_json(session.model(), session.state()));
  return session;
}

std::string renderer;

// How a script ends that begins with the sweep being open; empty: well.
Caught run(const std::string& actions, const SweptFolder& folder, std::string* printed = nullptr) {
  const TempFolder out;
  return caught([&] {
    carry_out(
        Script(R"([{"do":"open_sweep","folder":")" + folder.path().string() + "\"}," + actions + "]", "s"),
        out, renderer, nullptr, printed);
  });
}

}  // namespace

TEST_CASE("an open sweep tells its grid, and takes other axes and metrics") {
  const SweptFolder folder(kPlan);
  fill(folder);
  std::string printed;
  const Caught end = run(R"(
    {"do":"expect","at":"/ui/panels/0","is":"sweep"},
    {"do":"expect","at":"/sweep/tasks","is":12},{"do":"expect","at":"/sweep/done","is":9},
    {"do":"expect","at":"/sweep/diverged","is":1},{"do":"expect","at":"/sweep/refused","is":1},
    {"do":"expect","at":"/sweep/unfinished","is":1},
    {"do":"expect","at":"/sweep/columns","is":4},{"do":"expect","at":"/sweep/rows","is":3},
    {"do":"expect","at":"/sweep/x","is":"contact.N"},{"do":"expect","at":"/sweep/y","is":"contact.kappa"},
    {"do":"expect","at":"/sweep/metric","is":"penetration"},{"do":"expect","at":"/sweep/pictures","is":true},
    {"do":"expect","at":"/message","contains":"12 tasks: 9 done"},
    {"do":"sweep_view","metric":"iterations","x":"contact.kappa","y":"contact.N","pictures":false},
    {"do":"expect","at":"/sweep/columns","is":3},{"do":"expect","at":"/sweep/metric","is":"iterations"},
    {"do":"expect","at":"/sweep/pictures","is":false},
    {"do":"sweep_view","x":"contact.kapa","may_fail":true},
    {"do":"expect","at":"/message","contains":"\"contact.kapa\" is no parameter"},
    {"do":"sweep_view","metric":"drift","may_fail":true},
    {"do":"expect","at":"/message","contains":"\"drift\" is no metric"},
    {"do":"sweep_view","slice":1,"may_fail":true},
    {"do":"expect","at":"/message","contains":"expected 0 to 0"},
    {"do":"expect","at":"/sweep/columns","is":3},
    {"do":"open_sweep","folder":""},{"do":"expect","at":"/sweep","is":null},
    {"do":"sweep_view","may_fail":true},{"do":"expect","at":"/message","contains":"no sweep is open"})",
                         folder);
  CHECK(end.text.empty());
}

TEST_CASE("a run is loaded with what the sweep set, from its start or as it ended") {
  const SweptFolder folder(kPlan);
  fill(folder);
  // Where task 7 (N = 4, κ = 20) ended: the run itself, in 30 steps.
  const std::string hash = state_hash(ended("4", "20", 30, folder.task_folder(7)).state());
  const Caught end = run(R"(
    {"do":"expect","at":"/sweep/loaded","is":null},
    {"do":"load_run","task":7},
    {"do":"expect","at":"/sweep/loaded","is":7},{"do":"expect","at":"/a/params/contact/N","is":4},
    {"do":"expect","at":"/a/params/contact/kappa","is":20},{"do":"expect","at":"/a/params/solver/iterations","is":60},
    {"do":"expect","at":"/a/step","is":0},{"do":"expect","at":"/unsaved","is":false},
    {"do":"step","steps":30},{"do":"expect","at":"/a/hash","is":")" +
                             hash + R"("},
    {"do":"load_run","task":7,"at":"end"},
    {"do":"expect","at":"/sweep/loaded","is":7},{"do":"expect","at":"/a/step","is":30},
    {"do":"expect","at":"/a/hash","is":")" +
                             hash + R"("},
    {"do":"step","steps":5},{"do":"restart"},{"do":"expect","at":"/a/step","is":30},
    {"do":"load","scene":"two_boxes"},{"do":"expect","at":"/sweep/loaded","is":null},
    {"do":"load_run","task":99,"may_fail":true},{"do":"expect","at":"/message","contains":"no task 99"},
    {"do":"load_run","task":7,"at":"middle","may_fail":true},{"do":"expect","at":"/message","contains":"\"start\" or \"end\""},
    {"do":"load_run","task":8,"at":"end","may_fail":true},{"do":"expect","at":"/message","contains":"end.json"},
    {"do":"expect","at":"/sweep/loaded","is":null},
    {"do":"set","key":"contact.N","value":5},
    {"do":"load_run","task":7,"may_fail":true},{"do":"expect","at":"/message","contains":"not saved"},
    {"do":"load_run","task":7,"force":true},{"do":"expect","at":"/a/params/contact/N","is":4})",
                         folder);
  CHECK(end.text == "");
}

TEST_CASE("the panel has its approved pictures, and a click on a cell loads the run that stands there") {
  const SweptFolder made(kPlan);
  fill(made);
  fs::remove_all(made.task_folder(2));  // a cell without a run
  ended("2", "20", 3, made.task_folder(5));
  const TempFolder out;
  fs::copy(made.path(), out / "runs", fs::copy_options::recursive);  // of one name, which is in the picture
  const Caught end = caught([&] {
    carry_out(Script(R"([{"do":"open_sweep","folder":"runs"},
      {"do":"mouse","at":[218,221],"how":"click"},
      {"do":"expect","at":"/sweep/loaded","is":10},{"do":"expect","at":"/a/step","is":0},
      {"do":"expect","at":"/a/params/contact/N","is":3},{"do":"expect","at":"/a/params/contact/kappa","is":30},
      {"do":"mouse","at":[700,600]},{"do":"frame","path":"sweep_pictures.png","of":"left"},
      {"do":"sweep_view","metric":"iterations","pictures":false},
      {"do":"mouse","at":[150,300],"how":"click","with":"shift"},
      {"do":"expect","at":"/sweep/loaded","is":5},{"do":"expect","at":"/a/step","is":3},
      {"do":"expect","at":"/a/params/contact/N","is":2},{"do":"expect","at":"/a/params/contact/kappa","is":20},
      {"do":"mouse","at":[700,600]},{"do":"frame","path":"sweep_colours.png","of":"left"}])",
                     "s"),
              out, renderer);
  });
  CHECK(end.text == "");
  for (const char* name : {"sweep_pictures", "sweep_colours"}) {
    const CompareResult result =
        check_golden(read_png(out / (std::string(name) + ".png")), "gui_" + std::string(name), renderer);
    INFO(result.reason);
    CHECK(result.equal);
  }
}

TEST_CASE("read again, a sweep keeps what is shown of it, as far as it is still there") {
  const SweptFolder folder(kPlan);
  fill(folder);
  OpenedSweep sweep;
  const auto read = [&] { return std::make_shared<const CollectedSweep>(collect_sweep(folder.path())); };
  take_read(sweep, read());
  sweep.view.metric = "iterations";
  sweep.view.pictures = false;
  sweep.loaded = 7;
  fs::remove_all(folder.task_folder(4));
  take_read(sweep, read());
  CHECK(sweep.view.metric == "iterations");
  REQUIRE(sweep.loaded);
  CHECK(sweep.read->tasks[*sweep.loaded].index == 7);
  sweep.view.slice = 1;
  take_read(sweep, read());
  CHECK(sweep.view == command::SweepView{});
  fs::remove_all(folder.task_folder(7));
  take_read(sweep, read());
  CHECK_FALSE(sweep.loaded);
}

TEST_CASE("the folder that is no sweep is refused, and says why in the panel") {
  const SweptFolder folder("[1]");
  const Caught end = run(R"({"do":"wait"})", folder);
  CHECK(end.kind == bad_input);
  CHECK(end.says("an object: the plan of a sweep"));
  const SweptFolder fine(kPlan);
  CHECK(run(R"({"do":"open_sweep","folder":"/nowhere","may_fail":true},
    {"do":"expect","at":"/sweep/problem","contains":"plan.json"},{"do":"expect","at":"/sweep/reading","is":false})",
            fine)
            .text == "");
}

TEST_CASE("cells stand where the pointer finds them, and scroll where they would be too small") {
  const SweptFolder folder(kPlan);
  fill(folder);
  const CollectedSweep sweep = collect_sweep(folder.path());
  const FontMetrics font;
  for (const double unit : {1.0, 2.0}) {
    for (const double width : {120.0, 320.0, 900.0}) {
      for (const bool pictures : {true, false}) {
        CAPTURE(unit, width, pictures);
        const SweepCells cells = sweep_cells(sweep, shown_of(sweep, {}), pictures, width * unit, 400 * unit,
                                             panel_style().scaled(unit), unit, font);
        REQUIRE(cells.tasks.size() == 12);
        CHECK(cells.width <= width * unit);
        CHECK(cells.layout.panels[0].x > 0);  // names and the label stand to the left
        for (std::size_t i = 0; i < 12; ++i) {
          const Rect rect = cells.cell(i);
          CHECK(cell_at(cells, {rect.x + 0.5 * rect.w, rect.y + 0.5 * rect.h}) == i);
          CHECK(rect.w >= 5 * unit - 1);
          CHECK(rect.h >= 15 * unit - 1);
        }
        CHECK_FALSE(cell_at(cells, {1, 1}).has_value());
        CHECK_FALSE(cell_at(cells, {cells.width + 1, 1}).has_value());
        // The lowest row is that of the least κ.
        CHECK(cells.cell(0).y > cells.cell(11).y);
      }
    }
  }
}

TEST_CASE("a sample stands in lines, all of it") {
  const SweptFolder folder(R"({"scene": "two_boxes"})");
  for (int i = 0; i < 23; ++i)
    folder.add({.index = i,
                .parameters = {{"contact.N", std::to_string(1 + i)},
                               {"contact.kappa", std::to_string(10 + 7 * i % 23)},
                               {"contact.d_hat", "0.0" + std::to_string(10 + 11 * i % 23)}},
                .metrics = {{"penetration", "0.1"}}});
  const CollectedSweep sweep = collect_sweep(folder.path());
  const ShownSweep shown = shown_of(sweep, {});
  REQUIRE(shown.grid.scattered);
  const FontMetrics font;
  const SweepCells cells = sweep_cells(sweep, shown, true, 320, 400, panel_style(), 1, font);
  CHECK(cells.columns() == 4);
  CHECK(cells.rows() == 6);
  std::size_t seen = 0;
  for (const auto& task : cells.tasks) seen += task ? 1 : 0;
  CHECK(seen == 23);
  CHECK(cells.tasks[4 * 5] == std::size_t{0});  // the first is at the top left
}

TEST_CASE("in one folder for a visitor a sweep is a folder of it, and nothing is read through a link") {
  const TempFolder root;
  const SweptFolder inside(kPlan), outside(kPlan);
  fill(inside);
  fill(outside);
  fs::copy(inside.path(), root / "sweep", fs::copy_options::recursive);
  fs::create_directory_symlink(outside.path(), root / "link");
  fs::remove(root / "sweep/tasks" / SweptFolder::hash_of(0) / "result.json");
  fs::create_symlink(outside.task_folder(0) / "result.json",
                     root / "sweep/tasks" / SweptFolder::hash_of(0) / "result.json");
  fs::remove_all(root / "sweep/tasks" / SweptFolder::hash_of(6));
  fs::create_directory_symlink(outside.task_folder(6), root / "sweep/tasks" / SweptFolder::hash_of(6));
  write_bytes(outside.task_folder(7) / "end.json", "secret");
  fs::create_symlink(outside.task_folder(7) / "end.json",
                     root / "sweep/tasks" / SweptFolder::hash_of(7) / "end.json");
  const auto files = std::make_shared<const FileRoot>(root.path());
  const auto end = [&](const std::string& actions) {
    return caught(
        [&] { carry_out(Script("[" + actions + "]", "s"), root, renderer, nullptr, nullptr, files); });
  };
  CHECK(end(R"({"do":"open_sweep","folder":"sweep"},{"do":"expect","at":"/sweep/tasks","is":11},
    {"do":"expect","at":"/sweep/damaged","is":1},{"do":"expect","at":"/sweep/done","is":7},
    {"do":"load_run","task":7,"at":"end","may_fail":true},
    {"do":"expect","at":"/message","contains":"task 7 has no file end.json"},
    {"do":"load_run","task":7},{"do":"expect","at":"/a/params/contact/N","is":4})")
            .text == "");
  for (const std::string name : {"link", "..", "none", ".hidden", "sweep/tasks", "/tmp"}) {
    CAPTURE(name);
    CHECK(end(R"({"do":"open_sweep","folder":")" + name + "\"}").kind == bad_input);
  }
  CHECK(end(R"({"do":"load","scene":"two_boxes","from":"/etc/passwd"})").kind == bad_input);
}

TEST_CASE("the folder of a sweep that is dropped is known by its plan") {
  const SweptFolder folder(kPlan);
  const TempFolder other;
  CHECK(kind_of_dropped(folder.path().string()) == DroppedKind::sweep);
  CHECK(kind_of_dropped(other.path().string()) == DroppedKind::scene);
}

}  // namespace pabd::test_sweep_panel
