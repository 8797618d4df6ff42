// SPDX-License-Identifier: MIT
// The comparison against pictures that differ as pictures of a simulation do when something is wrong.
#include <catch2/catch.hpp>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "render/output/compare_images.h"
#include "render/output/compare_report.h"
#include "render/output/png.h"
#include "tests/support/errors.h"
#include "tests/support/picture.h"
#include "tests/support/temp_folder.h"

namespace pabd::test_compare {

namespace {

constexpr auto same = CompareTier::same_class;
constexpr auto cross = CompareTier::cross_class;

Image picture(void (*change)(PictureOptions&)) {
  PictureOptions options;
  change(options);
  return draw_picture(options);
}

struct Mutation {
  const char* name;
  Image image;
  bool passes_cross;
};

std::vector<Mutation> mutations() {
  const Image original = draw_picture();
  return {{"box turned by 1 degree", picture([](PictureOptions& o) { o.turn = 1; }), true},
          {"albedo 2 % lower", picture([](PictureOptions& o) { o.albedo = 0.98; }), true},
          {"moved by 1 pixel", moved(original, 1, 0), true},
          {"moved by 1 pixel both ways", moved(original, 1, 1), true},
          {"small box missing", picture([](PictureOptions& o) { o.small_box = false; }), false},
          {"line missing", picture([](PictureOptions& o) { o.line = false; }), false},
          {"shadow missing", picture([](PictureOptions& o) { o.shadow = false; }), false},
          {"albedo 10 % lower", picture([](PictureOptions& o) { o.albedo = 0.9; }), false},
          {"box turned by 8 degrees", picture([](PictureOptions& o) { o.turn = 8; }), false},
          {"moved by 3 pixels", moved(original, 3, 0), false}};
}

}  // namespace

TEST_CASE("a picture equals itself in both tiers") {
  const Image image = draw_picture();
  for (CompareTier tier : {same, cross}) {
    const CompareResult result = compare_images(image, image, tier);
    CHECK(result.equal);
    CHECK(result.reason.empty());
    CHECK(result.max_difference == 0);
    CHECK(result.differing == 0);
  }
}

TEST_CASE("every change of the picture is seen within a renderer class, and the gross ones across classes") {
  const Image original = draw_picture();
  for (const Mutation& mutation : mutations()) {
    INFO(mutation.name);
    const CompareResult strict = compare_images(mutation.image, original, same);
    CHECK_FALSE(strict.equal);
    CHECK_FALSE(strict.reason.empty());
    // Both ways: a line too many is as wrong as a line missing.
    for (const CompareResult& loose :
         {compare_images(mutation.image, original, cross), compare_images(original, mutation.image, cross)}) {
      INFO(loose.reason);
      CHECK(loose.equal == mutation.passes_cross);
    }
  }
}

TEST_CASE("another way of smoothing edges passes across classes and fails within one") {
  const Image original = draw_picture();
  for (int samples : {1, 2}) {
    const PictureOptions options = [samples] {
      PictureOptions o;
      o.samples = samples;
      return o;
    }();
    const Image other = draw_picture(options);
    const CompareResult loose = compare_images(other, original, cross);
    INFO(loose.reason);
    CHECK(loose.equal);
    CHECK_FALSE(compare_images(other, original, same).equal);
    // and what is missing is still seen then
    PictureOptions missing = options;
    missing.small_box = false;
    CHECK_FALSE(compare_images(draw_picture(missing), original, cross).equal);
    missing = options;
    missing.line = false;
    CHECK_FALSE(compare_images(draw_picture(missing), original, cross).equal);
  }
}

TEST_CASE("the limits within a class: 1 level, 0.1 % of pixels") {
  Image expected;
  expected.resize(200, 100);  // 0.1 % is 20 pixels
  std::fill(expected.rgb.begin(), expected.rgb.end(), std::uint8_t{100});
  Image actual = expected;
  for (std::size_t i = 0; i < 20; ++i) actual.rgb[i * 3 * 50] += 1;
  CHECK(compare_images(actual, expected, same).equal);
  CHECK(compare_images(actual, expected, same).differing == Approx(0.001).epsilon(1e-12));
  actual.rgb[1] += 1;  // the same pixel in another channel
  CHECK(compare_images(actual, expected, same).equal);
  actual.rgb[21 * 3 * 50] -= 1;
  CHECK_FALSE(compare_images(actual, expected, same).equal);

  actual = expected;
  actual.rgb[3 * (200 * 40 + 70)] += 2;  // one pixel by two levels
  const CompareResult result = compare_images(actual, expected, same);
  CHECK_FALSE(result.equal);
  CHECK(result.max_difference == 2);
  CHECK(result.worst_tile_x == 64);
  CHECK(result.worst_tile_y == 32);
}

TEST_CASE("the limits across classes: 3 pixels of a tile by over 16, tile means by 3.5") {
  Image expected;
  expected.resize(64, 48);
  std::fill(expected.rgb.begin(), expected.rgb.end(), std::uint8_t{100});
  const auto at = [](int x, int y) { return static_cast<std::size_t>(3 * (64 * y + x)); };

  Image actual = expected;
  for (int i = 0; i < 3; ++i) actual.rgb[at(20 + 2 * i, 20)] = 180;
  CHECK(compare_images(actual, expected, cross).equal);
  actual.rgb[at(26, 20)] = 180;
  CHECK_FALSE(compare_images(actual, expected, cross).equal);
  CHECK(compare_images(actual, expected, cross).worst_tile_pixels == 4);
  CHECK(compare_images(actual, expected, cross).worst_tile_x == 16);
  CHECK_FALSE(compare_images(expected, actual, cross).equal);  // four pixels missing
  actual.rgb[at(26, 20)] = 116;                                // by 16: not over 16
  CHECK(compare_images(actual, expected, cross).equal);

  for (int level : {103, 104}) {  // a whole tile by 3 or by 4
    actual = expected;
    for (int y = 16; y < 32; ++y) {
      for (int x = 32; x < 48; ++x) actual.rgb[at(x, y) + 2] = static_cast<std::uint8_t>(level);
    }
    CHECK(compare_images(actual, expected, cross).equal == (level == 103));
  }
}

TEST_CASE("a border tile is whole, so that one pixel there does not decide") {
  Image expected;
  expected.resize(49, 33);  // one column and one row more than whole tiles
  std::fill(expected.rgb.begin(), expected.rgb.end(), std::uint8_t{100});
  Image actual = expected;
  actual.rgb[actual.rgb.size() - 1] = 130;
  CHECK(compare_images(actual, expected, cross).equal);
}

TEST_CASE("sizes must agree") {
  Image a = test_frame(20, 10, 1), b = test_frame(10, 20, 1);
  const CompareResult result = compare_images(a, b, cross);
  CHECK_FALSE(result.equal);
  CHECK(result.reason.find("20x10") != std::string::npos);
  CHECK(result.reason.find("10x20") != std::string::npos);
  CHECK_FALSE(compare_images(Image{}, Image{}, same).equal);
  CHECK_FALSE(compare_images(a, Image{}, same).equal);
  a.rgb.pop_back();
  CHECK_FALSE(compare_images(a, a, same).equal);
}

TEST_CASE("tiny images have one tile") {
  const Image a = test_frame(3, 2, 1);
  CHECK(compare_images(a, a, cross).equal);
  Image b = a;
  for (auto& value : b.rgb) value = static_cast<std::uint8_t>(value + 60);
  CHECK_FALSE(compare_images(a, b, cross).equal);
}

TEST_CASE("the difference picture shows where") {
  const Image original = draw_picture();
  PictureOptions options;
  options.small_box = false;
  const Image difference = difference_image(draw_picture(options), original);
  REQUIRE(difference.width == original.width);
  // equal pixels are a third as bright and grey, different ones bright
  CHECK(difference.rgb[0] == difference.rgb[1]);
  CHECK(difference.rgb[0] < 90);
  CHECK(*std::max_element(difference.rgb.begin(), difference.rgb.end()) > 200);

  const Image odd = difference_image(test_frame(10, 4, 0), test_frame(6, 8, 0));
  CHECK(odd.width == 10);
  CHECK(odd.height == 8);
  CHECK(difference_image(Image{}, Image{}).rgb.empty());
  if (const char* folder = std::getenv("PABD_SAVE_PICTURES")) {
    write_png(std::filesystem::path(folder) / "picture.png", original);
    write_png(std::filesystem::path(folder) / "difference.png", difference);
  }
}

TEST_CASE("a failure is saved for people and scripts") {
  const TempFolder folder;
  const Image expected = draw_picture();
  const Image actual = moved(expected, 1, 0);
  const CompareResult result = compare_images(actual, expected, same);
  save_failure(folder / "deep/er", "scene", actual, expected, result, same);
  CHECK(read_png(folder / "deep/er/scene.actual.png").rgb == actual.rgb);
  CHECK(read_png(folder / "deep/er/scene.expected.png").rgb == expected.rgb);
  CHECK(read_png(folder / "deep/er/scene.diff.png").rgb == difference_image(actual, expected).rgb);
  const auto json = nlohmann::json::parse(read_bytes(folder / "deep/er/scene.json"));
  CHECK(json["equal"] == false);
  CHECK(json["tier"] == "same_class");
  CHECK(json["reason"] == result.reason);
  CHECK(json["max_difference"] == result.max_difference);
  CHECK(json["worst_tile"]["x"] == result.worst_tile_x);
  CHECK(json["diff"] == (folder / "deep/er/scene.diff.png").string());

  write_bytes(folder / "file", "");
  CHECK(caught([&] { save_failure(folder / "file/below", "scene", actual, expected, result, same); }).kind ==
        file_error);
  // a file name that is no UTF-8 must not break the report
  CHECK_NOTHROW(nlohmann::json::parse(compare_json(result, cross, "\xff.png")));
}

TEST_CASE("renderer classes") {
  CHECK(renderer_class("llvmpipe (LLVM 15.0.6, 256 bits)") == "llvmpipe-256");
  CHECK(renderer_class("llvmpipe (LLVM 19.1.1 256 bits)") == "llvmpipe-256");
  CHECK(renderer_class("llvmpipe (LLVM 15.0.6, 128 bits)") == "llvmpipe-128");
  CHECK(renderer_class("llvmpipe (LLVM 15.0.6, 512 bits)") == "llvmpipe-512");
  CHECK(renderer_class("softpipe") == "softpipe");
  CHECK(renderer_class("zink (llvmpipe (LLVM 15.0.6, 256 bits))") == "zink");
  CHECK(renderer_class("NVIDIA GeForce RTX 3080/PCIe/SSE2") == "nvidia");
  CHECK(renderer_class("Quadro P2000/PCIe/SSE2") == "nvidia");
  CHECK(renderer_class("AMD Radeon RX 6800 (radeonsi, navi21, LLVM 15.0.6, DRM 3.49, 6.1.0)") == "amd");
  CHECK(renderer_class("Mesa Intel(R) UHD Graphics 620 (KBL GT2)") == "intel");
  CHECK(renderer_class("Panfrost X1") == "panfrost");
  CHECK(renderer_class("../../etc (odd)") == "etc");  // it becomes a folder name
  CHECK(renderer_class("") == "unknown");
}

}  // namespace pabd::test_compare
