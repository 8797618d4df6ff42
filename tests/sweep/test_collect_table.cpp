// SPDX-License-Identifier: MIT
// The tables, byte by byte.
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>

#include "app/sweep/collect_table.h"
#include "tests/sweep/swept_folder.h"

namespace pabd::test_collect_table {

using namespace test;

namespace {

const std::string kPlan = R"({"parameters": [{"key": "contact.d_hat", "values": [0.01]},
  {"key": "contact.barrier", "values": ["log"]}], "metrics": ["penetration"]})";

void fill(const SweptFolder& folder, const std::vector<int>& order, double step_time) {
  for (const int i : order) {
    FakeTask task{.index = i,
                  .parameters = {{"contact.d_hat", i == 0 ? "0.1" : "1e-05"},
                                 {"contact.barrier", i == 1 ? "\"a,\\\"b\\\"\"" : "\"log\""}}};
    task.metrics = {{"penetration", i == 1 ? "null" : "0.1"}};
    if (i == 2) task.status = "diverged", task.why = "left, bounds";
    task.step_time = step_time * (i + 1);
    folder.add(task);
  }
}

std::uint64_t word_at(const std::string& bytes, std::size_t at, int size) {
  std::uint64_t word = 0;
  for (int i = size - 1; i >= 0; --i)
    word = word << 8 | static_cast<unsigned char>(bytes[at + static_cast<std::size_t>(i)]);
  return word;
}
double real_at(const std::string& bytes, std::size_t at) {
  const std::uint64_t word = word_at(bytes, at, 8);
  double value = 0;
  std::memcpy(&value, &word, 8);
  return value;
}

}  // namespace

TEST_CASE("the table as CSV and as JSON lines") {
  const SweptFolder folder(kPlan);
  fill(folder, {0, 1, 2}, 0.25);
  const CollectedSweep sweep = collect_sweep(folder.path());
  const auto hash = [](int i) { return SweptFolder::hash_of(i); };
  CHECK(table_csv(sweep) ==
        "index,hash,contact.d_hat,contact.barrier,status,penetration,step,time\n"
        "0," +
            hash(0) +
            ",0.1,log,done,0.1,60,1\n"
            "1," +
            hash(1) +
            ",1e-05,\"a,\"\"b\"\"\",done,,60,1\n"
            "2," +
            hash(2) + ",1e-05,log,diverged,0.1,60,1\n");
  CHECK(table_jsonl(sweep) ==
        "{\"index\":0,\"hash\":\"" + hash(0) +
            "\",\"parameters\":{\"contact.d_hat\":0.1,\"contact.barrier\":\"log\"},"
            "\"status\":\"done\",\"metrics\":{\"penetration\":0.1},\"step\":60,\"time\":1.0}\n"
            "{\"index\":1,\"hash\":\"" +
            hash(1) +
            "\",\"parameters\":{\"contact.d_hat\":1e-05,\"contact.barrier\":\"a,\\\"b\\\"\"},"
            "\"status\":\"done\",\"metrics\":{},\"step\":60,\"time\":1.0}\n"
            "{\"index\":2,\"hash\":\"" +
            hash(2) +
            "\",\"parameters\":{\"contact.d_hat\":1e-05,\"contact.barrier\":\"log\"},"
            "\"status\":\"diverged\",\"why\":\"left, "
            "bounds\",\"metrics\":{\"penetration\":0.1},\"step\":60,\"time\":1.0}\n");
  CHECK(timing_csv(sweep) ==
        "index,hash,seconds,threads,step_time\n"
        "0," +
            hash(0) +
            ",0.015,1,0.25\n"
            "1," +
            hash(1) +
            ",0.03,1,0.5\n"
            "2," +
            hash(2) + ",0.045,1,0.75\n");
}

TEST_CASE("tasks made in another order, at other speeds, give the same tables") {
  const SweptFolder a(kPlan), b(kPlan);
  fill(a, {0, 1, 2}, 0.25);
  fill(b, {2, 0, 1}, 7.5);
  const CollectedSweep x = collect_sweep(a.path()), y = collect_sweep(b.path());
  CHECK(table_csv(x) == table_csv(y));
  CHECK(table_jsonl(x) == table_jsonl(y));
  CHECK(table_npy(x) == table_npy(y));
  CHECK(timing_csv(x) != timing_csv(y));
}

TEST_CASE("the table as a NumPy file") {
  const SweptFolder folder(kPlan);
  fill(folder, {0, 1, 2}, 0.25);
  const std::string npy = table_npy(collect_sweep(folder.path()));
  REQUIRE(npy.substr(0, 8) == std::string("\x93NUMPY\x01\x00", 8));
  const std::size_t data = 10 + word_at(npy, 8, 2);
  CHECK(data % 64 == 0);
  CHECK(npy[data - 1] == '\n');
  const std::string header = npy.substr(10, data - 10);
  CHECK(header.find(
            "[('index', '<i8'), ('hash', '<U16'), ('contact.d_hat', '<f8'), ('contact.barrier', '<U5'), "
            "('status', '<U8'), ('penetration', '<f8'), ('step', '<i8'), ('time', '<f8'), ]") !=
        std::string::npos);
  CHECK(header.find("'shape': (3,)") != std::string::npos);
  const std::size_t row = 8 + 64 + 8 + 20 + 32 + 8 + 8 + 8;
  REQUIRE(npy.size() == data + 3 * row);
  for (std::size_t i = 0; i < 3; ++i) CHECK(word_at(npy, data + i * row, 8) == i);
  CHECK(real_at(npy, data + 72) == 0.1);
  CHECK(word_at(npy, data + 80, 4) == U'l');
  CHECK(word_at(npy, data + 80 + 12, 4) == 0);  // "log" is padded
  CHECK(real_at(npy, data + 132) == 0.1);
  CHECK(std::isnan(real_at(npy, data + row + 132)));
  CHECK(word_at(npy, data + 140, 8) == 60);
}

TEST_CASE("names of columns that would not be told apart, or end a text of Python, are changed") {
  const SweptFolder folder;
  folder.add({.index = 0, .parameters = {{"status", "1"}, {"it's", "2"}}});
  const std::string npy = table_npy(collect_sweep(folder.path()));
  CHECK(npy.find("('it\\'s', '<f8')") != std::string::npos);
  CHECK(npy.find("('status_', '<f8')") != std::string::npos);
  CHECK(npy.find("('status', '<U4')") != std::string::npos);
}

}  // namespace pabd::test_collect_table
