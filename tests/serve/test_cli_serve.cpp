// SPDX-License-Identifier: MIT
// pabd serve as it is started and ended: links, ports, what it refuses, signals with visitors, TLS.
#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <filesystem>

#include "tests/cli/program.h"
#include "tests/serve/client.h"

namespace pabd::test_cli_serve {

namespace fs = std::filesystem;
using namespace test;
using pabd::http;
using pabd::WebSocketPage;

namespace {

struct Link {
  int port = 0;
  std::string token, watch;
};

// The program with its standard output in a file, until it has said where it is.
class Served {
 public:
  explicit Served(std::vector<std::string> arguments,
                  const std::map<std::string, std::string>& environment = {}) {
    Setting setting;
    setting.out_to = folder_ / "out";
    setting.environment = environment;
    setting.folder = folder_.path();
    arguments.insert(arguments.begin(), "serve");
    program_.emplace(arguments, setting);
    program_->wait_until([](const std::string& err) { return err.find("open the link") != err.npos; });
    const auto lines = lines_of(read_text(folder_ / "out"));
    REQUIRE(!lines.empty());
    const std::string& url = lines[0];
    const std::size_t port = url.find(':', 8) + 1;
    link.port = std::stoi(url.substr(port));
    link.token = url.substr(url.find("#k=") + 3);
    if (lines.size() > 1) link.watch = lines[1].substr(lines[1].find("#k=") + 3);
    text = read_text(folder_ / "out");
  }
  Outcome end(int signal) {
    program_->signal(signal);
    return program_->wait();
  }
  Link link;
  std::string text;

 private:
  CommandFolder folder_;
  std::optional<RunningPabd> program_;
};

}  // namespace

TEST_CASE("a simulation that is made on the GPU is served: its context is not the one that draws") {
  Served served({"two_boxes", "--port", "0", "--set", "solver.device=gpu"});
  const std::string key = pabd::bearer(served.link.token);
  const auto done = http(served.link.port, "POST", "/actions", key,
                         R"([{"do":"step","steps":3},{"do":"expect","at":"/a/step","is":3}])");
  CHECK(done.status == 200);
  const auto picture = http(served.link.port, "GET", "/frame.png?width=640&height=400", key);
  CHECK(picture.status == 200);
  CHECK(picture.body.substr(1, 3) == "PNG");
}

TEST_CASE("the link has a port, and a token in its fragment; the second one watches") {
  Served served({"two_boxes", "--port", "0"});
  CHECK(served.text.starts_with("http://127.0.0.1:" + std::to_string(served.link.port) + "/#k="));
  CHECK(served.link.token.size() == 32);
  CHECK(served.link.watch.size() == 32);
  CHECK(served.link.watch != served.link.token);
  CHECK(http(served.link.port, "GET", "/").status == 200);
  // The given port is taken: said so; not given, the next is used.
  const std::string port = std::to_string(served.link.port);
  const Outcome taken = run_pabd({"serve", "two_boxes", "--port", port});
  CHECK(taken.exit_code == 3);
  CHECK(is_error_line(taken.err, {"127.0.0.1", port, "--port"}));
  CHECK(served.end(SIGTERM).exit_code == 0);
  Served alone({"two_boxes", "--port", "0", "--no-watchers"});
  CHECK(alone.link.watch.empty());
  CHECK(alone.end(SIGINT).exit_code == 0);
}

TEST_CASE("SIGTERM with visitors: they are told, nothing temporary stays, the exit code is 0") {
  const CommandFolder temporary;
  Served served({"stack", "--port", "0", "--play"}, {{"TMPDIR", temporary.path().string()}});
  REQUIRE(temporary.names().size() == 1);
  WebSocketPage control(served.link.port), watcher(served.link.port);
  control.say(WebSocketPage::hello(served.link.token, "000000000000000a"));
  watcher.say(WebSocketPage::hello(served.link.watch, "000000000000000b"));
  for (int i = 0; i < 5; ++i) control.until([](const auto& m) { return m.opcode == 2; });
  const auto put = http(served.link.port, "PUT", "/files/a.json", pabd::bearer(served.link.token), "{}");
  CHECK(put.status == 201);
  const auto begin = std::chrono::steady_clock::now();
  const Outcome outcome = served.end(SIGTERM);
  CHECK(std::chrono::steady_clock::now() - begin < std::chrono::seconds(20));
  CHECK(outcome.exit_code == 0);
  CHECK(control.until_close() == 1001);
  CHECK(watcher.until_close() == 1001);
  CHECK(temporary.names().empty());
}

TEST_CASE("--root is kept, with what was saved in it") {
  const CommandFolder folder;
  Served served({"two_boxes", "--port", "0", "--root", folder / "files"});
  CHECK(http(served.link.port, "POST", "/actions", pabd::bearer(served.link.token),
             R"([{"do":"save_scene","path":"kept.json"}])")
            .status == 200);
  CHECK(served.end(SIGTERM).exit_code == 0);
  CHECK(fs::exists(folder / "files/kept.json"));
}

TEST_CASE("what is dangerous or impossible is refused before anything listens") {
  const auto refused = [](std::vector<std::string> arguments, const std::vector<std::string>& words) {
    arguments.insert(arguments.begin(), {"serve", "two_boxes"});
    const Outcome outcome = run_pabd(arguments);
    CAPTURE(outcome.err);
    CHECK(is_error_line(outcome.err, words));
    return outcome.exit_code;
  };
  CHECK(refused({"--listen", "0.0.0.0"}, {"--listen 0.0.0.0", "--tls-cert", "--i-know"}) == 2);
  CHECK(refused({"--listen", "10.1.2.3"}, {"--listen 10.1.2.3"}) == 2);
  CHECK(refused({"--listen", "::"}, {"--listen ::"}) == 2);
  CHECK(refused({"--listen", "127.evil.org"}, {"--listen"}) == 2);
  CHECK(refused({"--listen", "nowhere", "--i-know"}, {"--listen nowhere", "address"}) == 2);
  CHECK(refused({"--tls-cert", "a.pem"}, {"--tls-key"}) == 2);
  CHECK(refused({"--tls-cert", "/nowhere/a.pem", "--tls-key", "/nowhere/b.pem"}, {"/nowhere/a.pem"}) == 3);
  CHECK(refused({"--port", "70000"}, {"--port"}) == 2);
  CHECK(refused({"--sessions", "0"}, {"--sessions"}) == 2);
  CHECK(refused({"--embed", "*"}, {"--embed"}) == 2);
  CHECK(refused({"--embed", "http://a; script-src *"}, {"--embed"}) == 2);
  CHECK(refused({"--root", "/proc/nowhere"}, {"/proc/nowhere"}) == 3);
  const Outcome scene = run_pabd({"serve", "no_such_scene"});
  CHECK(scene.exit_code == 3);
}

TEST_CASE("another name and a frame for notebooks are allowed when they are named") {
  Served served({"two_boxes", "--port", "0", "--host", "node7", "--host", "node8:9000", "--embed",
                 "http://localhost:8888"});
  CHECK(served.text.starts_with("http://node7:"));  // what whoever named it opens
  const int port = served.link.port;
  const auto as = [&](const std::string& host) { return http(port, "GET", "/", "Host: " + host + "\r\n"); };
  CHECK(as("node7:" + std::to_string(port)).status == 200);
  CHECK(as("node8:9000").status == 200);
  CHECK(as("node8:9001").status == 421);
  CHECK(as("localhost:" + std::to_string(port)).head.find("frame-ancestors 'self' http://localhost:8888;") !=
        std::string::npos);
  CHECK(served.end(SIGTERM).exit_code == 0);
  Served forwarded({"two_boxes", "--port", "0", "--host", "node7:9000"});
  CHECK(forwarded.text.starts_with("http://node7:9000/#k="));
  CHECK(forwarded.end(SIGTERM).exit_code == 0);
}

TEST_CASE("with a certificate it is https, and nothing else") {
  const CommandFolder folder;
  const Outcome made =
      run_shell("openssl req -x509 -newkey rsa:2048 -nodes -days 2 -subj /CN=localhost -keyout '" +
                (folder / "k.pem") + "' -out '" + (folder / "c.pem") + "'");
  CAPTURE(made.err);
  REQUIRE(made.exit_code == 0);
  Served served({"two_boxes", "--port", "0", "--tls-cert", folder / "c.pem", "--tls-key", folder / "k.pem"});
  CHECK(served.text.starts_with("https://127.0.0.1:"));
  CHECK(http(served.link.port, "GET", "/").status == 0);
  const std::string url = "https://localhost:" + std::to_string(served.link.port);
  const std::string curl = "curl -sS --max-time 20 --cacert '" + (folder / "c.pem") + "' ";
  CHECK(run_shell(curl + "-o /dev/null -w '%{http_code}' " + url + "/").out == "200");
  CHECK(run_shell(curl + "-H 'Authorization: Bearer " + served.link.token + "' " + url + "/state")
            .out.find("\"a\"") != std::string::npos);
  CHECK(run_shell(curl + "--tls-max 1.1 " + url + "/").exit_code != 0);
  CHECK(served.end(SIGTERM).exit_code == 0);
}

}  // namespace pabd::test_cli_serve
