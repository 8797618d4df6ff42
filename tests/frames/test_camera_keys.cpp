// SPDX-License-Identifier: MIT
// Camera keys as a file: every bit comes back, and what is no such file is refused with its place.
#include "app/frames/camera_keys.h"

#include <catch2/catch.hpp>
#include <filesystem>

#include "app/frames/camera_option.h"
#include "sim/base/error.h"
#include "tests/support/files.h"

namespace pabd::test_camera_keys {

namespace {

CameraKeys some_keys() {
  CameraKeys keys;
  keys.scene = "a \"scene\"";
  keys.keys = {{0.1, {{1.0 / 3, 2, 3e-7}, {0, 0.5, 0}, {0, 1, 0}, 45}},
               {0.30000000000000004, {{0, 9, 0}, {0, 1, 0}, {0, 0, -1}, 33.3}},
               {2, {{-5, 1, 2}, {1, 1, 1}, {0, 1, 0}, 60}}};
  return keys;
}

std::string refusal(const std::string& json) {
  try {
    static_cast<void>(parse_camera_keys(json, "k.json"));
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

std::string with_key(const std::string& key) {
  return R"({"format":"pabd-camera","version":1,"keys":[)" + key + "]}";
}

}  // namespace

TEST_CASE("camera keys come back to the last bit") {
  const CameraKeys keys = some_keys();
  const CameraKeys back = parse_camera_keys(camera_keys_json(keys), "k.json");
  CHECK(back.scene == keys.scene);
  REQUIRE(back.keys.size() == keys.keys.size());
  for (std::size_t i = 0; i < keys.keys.size(); ++i) {
    CHECK(back.keys[i].time == keys.keys[i].time);
    CHECK(back.keys[i].pose.eye == keys.keys[i].pose.eye);
    CHECK(back.keys[i].pose.target == keys.keys[i].pose.target);
    CHECK(back.keys[i].pose.up == keys.keys[i].pose.up);
    CHECK(back.keys[i].pose.fov == keys.keys[i].pose.fov);
  }
}

TEST_CASE("keys are kept in order of time, one a time") {
  std::vector<CameraKey> keys;
  for (const double time : {2.0, 0.0, 1.0, 2.0 + 1e-9, -1.0}) {
    CameraKey key;
    key.time = time;
    key.pose.fov = 30 + time;
    add_camera_key(keys, key);
  }
  REQUIRE(keys.size() == 4);
  CHECK(keys[0].time == -1);
  CHECK(keys[1].time == 0);
  CHECK(keys[2].time == 1);
  CHECK(keys[3].pose.fov > 32);  // the later one of both
}

TEST_CASE("a file that holds no camera keys is refused") {
  CHECK(refusal(with_key(R"({"time":0,"eye":[1,2,3],"target":[0,0,0]})")).empty());
  CHECK_THAT(refusal("{"), Catch::Contains("k.json"));
  CHECK_THAT(refusal("{}"), Catch::Contains("/format"));
  CHECK_THAT(refusal(R"({"format":"pabd-camera","version":2,"keys":[]})"), Catch::Contains("/version"));
  CHECK_THAT(refusal(R"({"format":"pabd-camera","version":1,"keys":[]})"), Catch::Contains("/keys"));
  CHECK_THAT(refusal(with_key("1")), Catch::Contains("/keys/0"));
  CHECK_THAT(refusal(with_key(R"({"eye":[1,2,3],"target":[0,0,0]})")), Catch::Contains("/keys/0/time"));
  CHECK_THAT(refusal(with_key(R"({"time":0,"eye":[1,2],"target":[0,0,0]})")), Catch::Contains("/keys/0/eye"));
  CHECK_THAT(refusal(with_key(R"({"time":0,"eye":[1,2,1e99],"target":[0,0,0]})")), Catch::Contains("/eye"));
  CHECK_THAT(refusal(with_key(R"({"time":0,"eye":[0,0,0],"target":[0,0,0]})")), Catch::Contains("different"));
  CHECK_THAT(refusal(with_key(R"({"time":0,"eye":[1,0,0],"target":[0,0,0],"up":[0,0,0]})")),
             Catch::Contains("/up"));
  CHECK_THAT(refusal(with_key(R"({"time":0,"eye":[1,0,0],"target":[0,0,0],"fov":180})")),
             Catch::Contains("/fov"));
  const std::string whole = camera_keys_json(some_keys());
  for (std::size_t n = 0; n + 2 < whole.size(); ++n) CHECK_FALSE(refusal(whole.substr(0, n)).empty());
}

TEST_CASE("a camera in words is the same camera, and a file of keys is a camera option") {
  Camera camera;
  camera.eye = {1.0f / 3, -2e-5f, 7};
  camera.target = {0.1f, 0.2f, 0.3f};
  camera.fov = 41.7f;
  for (const Vec3f& up : {Vec3f(0, 1, 0), Vec3f(0.1f, 0, -1)}) {
    camera.up = up;
    const Camera back = apply_camera(parse_camera(camera_words(camera)), Camera{}, 3);
    CHECK(back.eye == camera.eye);
    CHECK(back.target == camera.target);
    CHECK(back.up == camera.up);
    CHECK(back.fov == camera.fov);
  }
  const auto path = std::filesystem::temp_directory_path() / "pabd_camera_keys_test.json";
  write_bytes(path, camera_keys_json(some_keys()));
  const CameraOption option = parse_camera(path.string());
  CHECK(apply_camera(option, camera, -5).eye == rounded(some_keys().keys[0].pose).eye);
  CHECK(apply_camera(option, camera, 9).fov == 60);
  const CameraPose between = camera_at(some_keys().keys, 1.0);
  CHECK(apply_camera(option, camera, 1.0).eye == rounded(between).eye);
  std::filesystem::remove(path);
  CHECK_THROWS_AS(parse_camera(path.string()), Error);
}

}  // namespace pabd::test_camera_keys
