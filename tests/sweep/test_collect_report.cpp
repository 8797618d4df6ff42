// SPDX-License-Identifier: MIT
// The files of a collection: all or none, and a report in which text is only text.
#include <catch2/catch.hpp>

#include "app/plots/markup.h"
#include "app/sweep/collect_write.h"
#include "tests/support/errors.h"
#include "tests/sweep/swept_folder.h"

namespace pabd::test_collect_report {

using namespace test;

namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

}  // namespace

TEST_CASE("markup and bytes as RFC 4648 and HTML have them") {
  CHECK(escape_markup("<a href=\"x\" b='y'>&\n\x01") == "&lt;a href=&quot;x&quot; b=&#39;y&#39;&gt;&amp;  ");
  CHECK(escape_markup("κ = 1") == "κ = 1");
  const char* const vectors[][2] = {{"", ""},
                                    {"f", "Zg=="},
                                    {"fo", "Zm8="},
                                    {"foo", "Zm9v"},
                                    {"foob", "Zm9vYg=="},
                                    {"fooba", "Zm9vYmE="},
                                    {"foobar", "Zm9vYmFy"},
                                    {"\xff\xfe\xfd", "//79"}};
  for (const auto& v : vectors) CHECK(base64(v[0]) == v[1]);
}

TEST_CASE("the report needs nothing else, and nothing of a sweep is markup in it") {
  const std::string evil = "<script>alert(1)</script>\\\"'&";
  const SweptFolder folder("{\"scene\": \"" + evil + "\", \"metrics\": [\"<img src=x>\"]}");
  for (int i = 0; i < 4; ++i) {
    folder.add({.index = i,
                .parameters = {{"contact.N", std::to_string(1 + i % 2)},
                               {"<b>key</b>", i < 2 ? "\"" + evil + "\"" : "\"w\""}},
                .status = i == 3 ? "refused" : "done",
                .why = i == 3 ? evil : "",
                .metrics = {{"<img src=x>", "1e-" + std::to_string(i)}},
                .step_time = 1.0 + i,
                .picture = fake_picture(i)});
  }
  write_bytes(folder.path() / "tasks/<i>odd", "");
  const TempFolder out;
  const CollectedSweep sweep = collect_sweep(folder.path());
  write_collection(sweep, out.path(), {});
  const std::string html = read_bytes(out / "report.html");
  CHECK(count(html, "<script") == 0);
  CHECK(count(html, "<img src=x>") == 0);
  CHECK(count(html, "<b>") == 0);
  CHECK(count(html, "<i>") == 0);
  CHECK(count(html, "&lt;script&gt;alert(1)&lt;/script&gt;") >= 4);  // scene, two cells, why
  CHECK(count(html, "http:") + count(html, "https:") + count(html, "url(") == 0);
  CHECK(html.find("default-src 'none'; img-src data:;") != std::string::npos);
  CHECK(count(html, "<img ") == count(html, "src=\"data:image/"));
  CHECK(count(html, "src=\"data:image/png;base64,") == 1);      // the sheet
  CHECK(count(html, "src=\"data:image/svg+xml;base64,") == 3);  // the front, and two maps
  CHECK(count(html, "<tr") == 5);
  CHECK(html.ends_with("</body>\n</html>\n"));
  CHECK(html.find(base64(read_bytes(out / "pareto.svg"))) != std::string::npos);
}

TEST_CASE("the report says what is acceptable, and in its first heading where nothing is") {
  for (const bool none : {false, true}) {
    const SweptFolder folder(R"({"scene": "two_boxes", "accept": {"overlap": 0.3, "unsolved": 0.5}})");
    for (int i = 0; i < 2; ++i)
      folder.add({.index = i,
                  .parameters = {{"contact.N", std::to_string(i + 1)}},
                  .faults = none || i == 1 ? "bodies overlap by 1.22 m" : "",
                  .metrics = {{"penetration", "1"}}});
    const TempFolder out;
    write_collection(collect_sweep(folder.path()), out.path(), {});
    const std::string html = read_bytes(out / "report.html");
    const std::string heading = html.substr(html.find("<h2>"));
    CHECK(heading.starts_with(none ? "<h2>None is acceptable</h2>" : "<h2>Which is best</h2>"));
    CHECK(count(html, none ? "2 tasks: 2 done (2 not acceptable)" : "2 tasks: 2 done (1 not acceptable)") ==
          1);
    CHECK(count(html, "<p class=\"best\">") == (none ? 0 : 1));
    CHECK(
        count(
            html,
            "Acceptable: overlap up to 0.3 and gaps of joints up to 0.1 of the smallest movable body&#39;s "
            "inner radius, energy from nowhere up to 0.05 of what moved, unsolved steps up to 0.5 of all") ==
        1);
  }
}

TEST_CASE("a collection has its files under names of their own, and replaces none unasked") {
  const SweptFolder folder;
  for (int i = 0; i < 4; ++i) {
    folder.add({.index = i,
                .parameters = {{"contact.N", std::to_string(1 + i % 2)},
                               {"contact.kappa", std::to_string(1 + i / 2)}},
                .metrics = {{"a/b", std::to_string(i)}, {"a:b", std::to_string(3 - i)}, {"../up", "1"}}});
  }
  const CollectedSweep sweep = collect_sweep(folder.path());
  const TempFolder out;
  const CollectionWords words = write_collection(sweep, out.path(), {});
  CHECK(words.ranking.size() == 4);
  CHECK(words.notes.empty());
  CHECK(out.names() == std::vector<std::string>{"heat____up.png", "heat____up.svg", "heat_a_b.png",
                                                "heat_a_b.svg", "heat_a_b_.png", "heat_a_b_.svg",
                                                "ranking.txt", "report.html", "sheet.png", "table.csv",
                                                "table.jsonl", "table.npy", "timing.csv"});
  write_bytes(out / "ranking.txt", "mine");
  std::filesystem::remove(out / "table.csv");
  CHECK(caught([&] { write_collection(sweep, out.path(), {}); }).kind == ErrorKind::exists);
  CHECK(read_bytes(out / "ranking.txt") == "mine");
  CHECK_FALSE(std::filesystem::exists(out / "table.csv"));  // nothing was begun
  write_collection(sweep, out.path(), {.force = true});
  CHECK(read_bytes(out / "ranking.txt") != "mine");
}

TEST_CASE("a sample that is too large for a sheet has all but that, and says so") {
  // 26,000 pictures of the least width are 162 × 161, wider than a PNG file may be.
  CollectedSweep sweep;
  for (const char* key : {"contact.N", "contact.kappa"}) sweep.parameters.push_back({key, key, key, ""});
  sweep.metrics.push_back({"penetration", "penetration", "penetration", "m"});
  for (int i = 0; i < 26000; ++i) {
    SweptTask task;
    task.index = i;
    for (const int value : {i, 7 * i % 26000})
      task.parameters.push_back({1.0 * value, std::to_string(value)});
    task.status = SweptStatus::done;
    task.metrics = {1e-3 * (i + 1)};
    sweep.tasks.push_back(std::move(task));
  }
  const TempFolder out;
  const CollectionWords words = write_collection(sweep, out.path(), {});
  REQUIRE(words.notes.size() == 1);
  CHECK(words.notes[0].starts_with("no contact sheet: 162 × 161 pictures"));
  CHECK(read_bytes(out / "report.html").find(words.notes[0]) != std::string::npos);
  CHECK(count(read_bytes(out / "table.csv"), "\n") == 26001);
  CHECK(std::filesystem::exists(out / "heat_penetration.png"));
  CHECK_FALSE(std::filesystem::exists(out / "sheet.png"));
}

TEST_CASE("tasks that no cell shows are counted") {
  const SweptFolder folder;
  for (int i = 0; i < 5; ++i)
    folder.add({.index = i,
                .parameters = {{"contact.N", std::to_string(1 + i % 2)},
                               {"contact.kappa", std::to_string(1 + i / 2 % 2)}},
                .metrics = {{"drift", "1"}}});
  const TempFolder out;
  const CollectionWords words = write_collection(collect_sweep(folder.path()), out.path(), {});
  REQUIRE(words.notes.size() == 1);  // 4 has the parameters of 0
  CHECK(words.notes[0].starts_with("1 task in no cell"));
  CHECK(read_bytes(out / "report.html").find(words.notes[0]) != std::string::npos);
}

TEST_CASE("a sweep without tasks, or with damaged ones only, is reported all the same") {
  const SweptFolder folder;
  const TempFolder out;
  write_collection(collect_sweep(folder.path()), out.path(), {.force = true});
  CHECK(read_bytes(out / "report.html").find("there is no task yet") != std::string::npos);
  folder.add({.index = 0});
  write_bytes(folder.task_folder(0) / "task.json", "{");
  write_collection(collect_sweep(folder.path()), out.path(), {.force = true});
  CHECK(read_bytes(out / "report.html").find("1 damaged") != std::string::npos);
}

}  // namespace pabd::test_collect_report
