// SPDX-License-Identifier: MIT
// The server as programs see it: page, actions, state, pictures, events, files.
#include <catch2/catch.hpp>
#include <filesystem>

#include "render/output/png.h"
#include "tests/serve/client.h"
#include "tests/support/files.h"
#include "tests/support/places.h"

namespace pabd::test_serve_api {

namespace fs = std::filesystem;
using Json = nlohmann::json;

namespace {

Image decoded(const std::string& png) {
  const TempFolder folder;
  write_bytes(folder / "a.png", png);
  return read_png(folder / "a.png");
}

}  // namespace

TEST_CASE("the page comes with its types and a policy without exceptions") {
  const RunningServer server;
  const HttpAnswer page = http(server.port(), "GET", "/");
  CHECK(page.status == 200);
  CHECK(page.body.find("<!doctype html>") == 0);
  CHECK(page.head.find("text/html; charset=utf-8") != std::string::npos);
  for (const char* line :
       {"Content-Security-Policy: default-src 'none'; script-src 'self'; style-src 'self'; "
        "img-src 'self' blob: data:; connect-src 'self'; frame-ancestors 'none'; base-uri 'none'; "
        "form-action 'none'",
        "X-Content-Type-Options: nosniff", "Referrer-Policy: no-referrer", "Cache-Control: no-store",
        "Cross-Origin-Opener-Policy: same-origin", "Cross-Origin-Resource-Policy: same-origin"})
    CHECK(page.head.find(line) != std::string::npos);
  // Nothing in it that the policy forbids.
  for (const char* word : {"<style", "style=\"", "onclick", "onload", "javascript:", "src=\"http",
                           "href=\"http", "src=\"//", "href=\"//"}) {
    CAPTURE(word);
    CHECK(page.body.find(word) == std::string::npos);
  }
  CHECK(http(server.port(), "GET", "/", "Host: evil.org\r\n").status == 421);
  CHECK(http(server.port(), "GET", "/", "Origin: http://evil.org\r\n").status == 403);
  CHECK(http(server.port(), "GET", "/state").status == 401);
  CHECK(http(server.port(), "GET", "/state", bearer(server.watch())).status == 200);
  CHECK(http(server.port(), "POST", "/actions", bearer(server.watch()), "[]").status == 403);
}

TEST_CASE("a script is carried out, and says where it went wrong") {
  const RunningServer server;
  const HttpAnswer done =
      server.act(Json::parse(R"([{"do":"step","steps":5},{"do":"print","at":"/a/step"}])"));
  CHECK(done.status == 200);
  CHECK(Json::parse(done.body) == Json::parse(R"({"done":2,"printed":["/a/step 5"]})"));
  const Json state = server.state();
  CHECK(state["a"]["step"] == 5);

  const HttpAnswer wrong =
      server.act(Json::parse(R"([{"do":"step"},{"do":"expect","at":"/a/step","is":99}])"));
  CHECK(wrong.status == 422);
  CHECK(Json::parse(wrong.body)["action"] == 1);
  CHECK(Json::parse(wrong.body)["error"].get<std::string>().find("expected") != std::string::npos);
  const HttpAnswer unknown = server.act(Json::parse(R"([{"do":"step"},{"do":"step"},{"do":"jump"}])"));
  CHECK(unknown.status == 422);
  CHECK(Json::parse(unknown.body)["action"] == 2);
  CHECK(server.state()["a"]["step"] == 6);  // nothing of the last one
  for (const std::string& broken : {std::string("no JSON"), std::string(100000, '['), std::string("{}")}) {
    const HttpAnswer answer = http(server.port(), "POST", "/actions", bearer(server.control()), broken);
    CHECK(answer.status == 422);
    CHECK(Json::parse(answer.body).contains("error"));
  }
}

TEST_CASE("pictures have the size that was asked for, with and without panels") {
  const RunningServer server;
  const Image window = decoded(server.get("/frame.png").body);
  CHECK(window.width == 640);
  CHECK(window.height == 400);
  const Image large = decoded(server.get("/frame.png?width=800&height=600").body);
  CHECK(large.width == 800);
  const Image scene = decoded(server.get("/frame.png?width=800&height=600&panels=0").body);
  CHECK(scene.height == 600);
  CHECK(scene.rgb != large.rgb);
  CHECK(server.get("/frame.png?width=5").status == 400);
}

TEST_CASE("a picture of another size is none that the controller's hand is in") {
  const RunningServer server([](ServerOptions&, LobbyOptions& lobby) {
    lobby.desk.width = 1280;
    lobby.desk.height = 720;
  });
  const auto kappa = [&] { return server.state()["a"]["kappa"].get<double>(); };
  // The handle of κ, dragged a little: held, it would be elsewhere in a window of another size.
  CHECK(server.act(Json::parse(R"([{"do":"step","steps":60}])")).status == 200);
  const double before = kappa();
  CHECK(
      server.act(Json::parse(R"([{"do":"mouse","at":[1036,199],"to":[1036,223],"how":"drag","end":"hold"}])"))
          .status == 200);
  const double held = kappa();
  CHECK(held < 0.9 * before);
  const std::string watch = bearer(server.watch());
  const std::string other = "/frame.png?width=900&height=500";
  CHECK(http(server.port(), "GET", other, watch).status == 503);
  CHECK(http(server.port(), "GET", other + "&panels=0", watch).status == 200);
  CHECK(http(server.port(), "GET", "/frame.png?width=1280&height=720", watch).status == 200);
  CHECK(kappa() == held);
  CHECK(server.act(Json::parse(R"([{"do":"mouse","at":[1036,223],"how":"release"}])")).status == 200);
  CHECK(decoded(http(server.port(), "GET", other, watch).body).width == 900);
  CHECK(kappa() == held);
}

TEST_CASE("a script has no window that a page could not have") {
  const RunningServer server;
  const HttpAnswer large = server.act(Json::parse(R"([{"do":"window","size":[8192,8192]}])"));
  CHECK(large.status == 422);
  CHECK(Json::parse(large.body)["error"].get<std::string>().find("a served window") != std::string::npos);
  CHECK(server.act(Json::parse(R"([{"do":"window","size":[8192,8192],"may_fail":true},{"do":"step"}])"))
            .status == 200);
  CHECK(server.state()["a"]["step"] == 1);
}

TEST_CASE("events are lines, one a change, until somebody closes") {
  RunningServer server;
  Socket events(server.port());
  events.send("GET /events HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(server.port()) + "\r\n" +
              bearer(server.watch()) + "\r\n");
  CHECK(events.read_until("\r\n\r\n").starts_with("HTTP/1.1 200"));
  CHECK(events.read_until("\"event\":\"scene\"").find("\"event\":\"scene\"") != std::string::npos);
  CHECK(server.act(Json::parse(R"([{"do":"step","steps":3}])")).status == 200);
  CHECK(events.read_until("\"step\":3").ends_with("\"step\":3"));
  CHECK(server.act(Json::parse(R"([{"do":"save_scene","path":"kept.json"}])")).status == 200);
  CHECK(events.read_until("kept.json").ends_with("kept.json"));
  server.stop();
  CHECK(events.read_to_end().ends_with("\r\n0\r\n\r\n"));  // told, not cut off
}

TEST_CASE("a folder that is full takes no file more, whoever would write it") {
  const RunningServer server;
  const std::string control = bearer(server.control());
  write_bytes(server.root() / "large", "");
  fs::resize_file(server.root() / "large", FileRoot::kMostBytes + 1);  // it has a hole
  CHECK(http(server.port(), "PUT", "/files/a.json", control, "{}").status == 413);
  for (const char* action :
       {R"({"do":"save_scene","path":"a.json"})", R"({"do":"save_recording","path":"a.pabdrec"})",
        R"({"do":"screenshot","path":"a.png"})", R"({"do":"frame","path":"a.png"})",
        R"({"do":"record","path":"a.gif"})", R"({"do":"save_camera","path":"a.json"})"}) {
    CAPTURE(action);
    const HttpAnswer answer = server.act(Json::array({Json::parse(action)}));
    CHECK(answer.status == 422);
    CHECK(answer.body.find("no room") != std::string::npos);
  }
  CHECK(server.root().names() == std::vector<std::string>{"large"});
  CHECK(server.act(Json::parse(R"([{"do":"load_recording","path":"none.pabdrec"}])")).body.find("no room") ==
        std::string::npos);
}

TEST_CASE("files go up and down, and into scenes") {
  const RunningServer server;
  const std::string control = bearer(server.control());
  CHECK(Json::parse(server.get("/files").body) == Json::parse(R"({"files":[]})"));
  const std::string scene = read_bytes(fs::path(places::scenes()) / "stack.json");
  CHECK(http(server.port(), "PUT", "/files/mine.json", control, scene).status == 201);
  CHECK(server.get("/files/mine.json").body == scene);
  CHECK(server.get("/files/mine.json").head.find("attachment") != std::string::npos);
  CHECK(Json::parse(server.get("/files").body)["files"][0]["bytes"] == scene.size());
  CHECK(server.get("/files/other.json").status == 404);
  CHECK(server
            .act(Json::parse(R"([{"do":"load","scene":"mine.json"},{"do":"save_patch","path":"p.json"},
                                   {"do":"frame","path":"f.png"},{"do":"screenshot","path":"s.png"}])"))
            .status == 200);
  CHECK(server.state()["scene"]["name"] == "stack");
  for (const char* name : {"p.json", "f.png", "s.png"}) CHECK(fs::exists(server.root() / name));
}

TEST_CASE("no action leads out of the folder") {
  const TempFolder outside;
  write_bytes(outside / "secret.json", read_bytes(fs::path(places::scenes()) / "stack.json"));
  write_bytes(outside / "secret.obj", "v 0 0 0 secret\n");
  const RunningServer server;
  fs::create_symlink(outside / "secret.json", server.root() / "link.json");
  fs::create_symlink(outside / "new.json", server.root() / "dangling.json");
  const std::string secret = (outside / "secret.json").string();
  const auto refused = [&](const Json& action) {
    const HttpAnswer answer = server.act(Json::array({action}));
    CAPTURE(action.dump(), answer.body);
    CHECK(answer.status == 422);
    CHECK(answer.body.find("v 0 0 0") == std::string::npos);
  };
  for (const std::string& path :
       {outside.path().string() + "/out.json", std::string("../out.json"), std::string("link.json"),
        std::string("dangling.json"), std::string(".hidden"), std::string("sub/out.json"),
        std::string("{out}/x.json")}) {
    for (const char* command : {"save_scene", "save_patch", "save_recording", "apply_patch", "load_recording",
                                "save_camera", "load_camera"})
      refused({{"do", command}, {"path", path}, {"force", true}});
    refused({{"do", "load"}, {"scene", path}});
  }
  for (const std::string& path : {outside.path().string() + "/out.png", std::string("../out.png"),
                                  std::string("a/b.png"), std::string("{frame:04}.png")}) {
    refused({{"do", "screenshot"}, {"path", path}});
    refused({{"do", "screenshot"}, {"path", path}, {"ui", false}});
    refused({{"do", "frame"}, {"path", path}});
    refused({{"do", "record"}, {"path", path}});
    refused({{"do", "export_plot"}, {"panel", "barrier"}, {"path", path}});
  }
  refused({{"do", "load"}, {"scene", secret}});
  // A scene of theirs that names a mesh elsewhere, and an edit, and a setting of a shipped scene.
  const std::string mesh = (outside / "secret.obj").string();
  const Json body = {{"shape", {{"type", "mesh"}, {"file", mesh}}}, {"mass", 1}};
  Json scene = Json::parse(read_bytes(fs::path(places::scenes()) / "stack.json"));
  scene["bodies"].push_back(body);
  CHECK(http(server.port(), "PUT", "/files/spy.json", bearer(server.control()), scene.dump()).status == 201);
  refused({{"do", "load"}, {"scene", "spy.json"}});
  refused({{"do", "edit"}, {"edit", {{"do", "add_body"}, {"shape", body["shape"]}, {"mass", 1}}}});
  CHECK(outside.names() == std::vector<std::string>{"secret.json", "secret.obj"});
}

}  // namespace pabd::test_serve_api
