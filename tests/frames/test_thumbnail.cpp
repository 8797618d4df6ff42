// SPDX-License-Identifier: MIT
// Thumbnails: the picture, and a cache that never stands in the way.
#include "app/frames/thumbnail.h"

#include <catch2/catch.hpp>
#include <cstdlib>
#include <optional>

#include "app/frames/linear_light.h"
#include "render/output/png.h"
#include "sim/base/error.h"
#include "tests/support/golden.h"
#include "tests/support/places.h"
#include "tests/support/temp_folder.h"

namespace pabd::test_thumbnail {

namespace fs = std::filesystem;

namespace {

const std::string kHash = "0123456789abcdef";

// Sets or (null) removes a variable of the environment for a while.
class Variable {
 public:
  Variable(const char* name, const char* value) : name_(name) {
    if (const char* before = std::getenv(name)) before_ = before;
    if (value != nullptr) {
      setenv(name, value, 1);
    } else {
      unsetenv(name);
    }
  }
  ~Variable() {
    if (before_) {
      setenv(name_, before_->c_str(), 1);
    } else {
      unsetenv(name_);
    }
  }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  const char* name_;
  std::optional<std::string> before_;
};

Image some_picture() {
  Image image;
  image.resize(kThumbnailWidth, kThumbnailHeight);
  for (std::size_t k = 0; k < image.rgb.size(); ++k) image.rgb[k] = static_cast<std::uint8_t>(k * 31 % 251);
  return image;
}

}  // namespace

TEST_CASE("the thumbnail of a shipped scene") {
  std::vector<ContextAttempt> attempts;
  const auto context = create_headless_context(Backend::automatic, attempts);
  Renderer renderer(*context, 32, 32);
  const Scene scene = load_scene(places::scenes() + "/pyramid.json");
  const Image image = draw_thumbnail(renderer, scene);
  REQUIRE(image.width == kThumbnailWidth);
  REQUIRE(image.height == kThumbnailHeight);
  const CompareResult result = check_golden(image, "thumbnail", renderer.gl_renderer());
  INFO(result.reason);
  CHECK(result.equal);
}

TEST_CASE("halving averages light, not bytes") {
  Image image;
  image.resize(5, 2);                                                // the last column has no partner
  image.rgb = {0, 10, 255, 255, 10, 255, 7, 7, 7, 7, 7, 7, 9, 9, 9,  //
               0, 10, 255, 255, 10, 255, 7, 7, 7, 7, 7, 7, 9, 9, 9};
  const Image half = halved(image);
  REQUIRE(half.width == 2);
  REQUIRE(half.height == 1);
  // Half the light of white is 188 in sRGB.
  CHECK(half.rgb == std::vector<std::uint8_t>{188, 10, 255, 7, 7, 7});
}

TEST_CASE("what was stored is found again, and only that") {
  const TempFolder folder;
  const ThumbnailCache cache(folder.path() / "not" / "there" / "yet");
  CHECK_FALSE(cache.find(kHash));
  REQUIRE(cache.store(kHash, some_picture()));
  const auto found = cache.find(kHash);
  REQUIRE(found);
  CHECK(found->rgb == some_picture().rgb);
  CHECK_FALSE(cache.find("fedcba9876543210"));
  CHECK(fs::exists(folder.path() / "not" / "there" / "yet" / (kHash + ".png")));
}

TEST_CASE("what is damaged, of another size, scene or version is not found, and can be replaced") {
  const TempFolder folder;
  const ThumbnailCache cache(folder.path());
  const fs::path file = folder.path() / (kHash + ".png");
  REQUIRE(cache.store("fedcba9876543210", some_picture()));
  fs::copy_file(folder.path() / "fedcba9876543210.png", file);
  CHECK_FALSE(cache.find(kHash));  // of another scene

  REQUIRE(cache.store(kHash, some_picture()));
  const auto size = fs::file_size(file);
  fs::resize_file(file, size / 2);
  CHECK_FALSE(cache.find(kHash));
  fs::resize_file(file, 10);
  CHECK_FALSE(cache.find(kHash));
  write_bytes(file, "no picture at all, but long enough to hold a header");
  CHECK_FALSE(cache.find(kHash));

  PngText text = {{"Software", "pabd 0.0.1 thumbnail 1"}, {"Scene hash", kHash}};
  write_png(file, some_picture(), text);
  CHECK_FALSE(cache.find(kHash));
  Image large;
  large.resize(2 * kThumbnailWidth, kThumbnailHeight);
  write_png(file, large, text);
  CHECK_FALSE(cache.find(kHash));

  REQUIRE(cache.store(kHash, some_picture()));
  CHECK(cache.find(kHash));
}

TEST_CASE("names that are no hash reach no file") {
  const TempFolder folder;
  const ThumbnailCache cache(folder.path());
  for (const char* name :
       {"", "..", "../../etc/passwd", "0123456789ABCDEF", "0123456789abcde/", "0123456789abcdef0"}) {
    CAPTURE(name);
    CHECK_FALSE(cache.store(name, some_picture()));
    CHECK_FALSE(cache.find(name));
  }
  CHECK(fs::is_empty(folder.path()));
  CHECK_FALSE(cache.store(kHash, Image{}));
}

TEST_CASE("without a folder, or with one that cannot be, nothing is kept and nothing breaks") {
  const ThumbnailCache none(std::nullopt);
  CHECK_FALSE(none.store(kHash, some_picture()));
  CHECK_FALSE(none.find(kHash));
  const TempFolder folder;
  write_bytes(folder.path() / "file", "in the way");
  const ThumbnailCache blocked(folder.path() / "file" / "thumbnails");
  CHECK_FALSE(blocked.store(kHash, some_picture()));
  CHECK_FALSE(blocked.find(kHash));
}

TEST_CASE("the folder is that of the XDG convention") {
  {
    const Variable xdg("XDG_CACHE_HOME", "/somewhere/cache"), home("HOME", "/home/someone");
    CHECK(ThumbnailCache::default_folder() == fs::path("/somewhere/cache/pabd/thumbnails"));
  }
  {
    const Variable xdg("XDG_CACHE_HOME", "relative"), home("HOME", "/home/someone");
    CHECK(ThumbnailCache::default_folder() == fs::path("/home/someone/.cache/pabd/thumbnails"));
  }
  const Variable xdg("XDG_CACHE_HOME", nullptr), home("HOME", nullptr);
  CHECK_FALSE(ThumbnailCache::default_folder());
}

TEST_CASE("the oldest go when there are too many") {
  const TempFolder folder;
  const ThumbnailCache cache(folder.path());
  const auto now = fs::file_time_type::clock::now();
  for (std::size_t k = 0; k < ThumbnailCache::kMostFiles; ++k) {
    const fs::path file = folder.path() / (std::to_string(k) + ".png");
    write_bytes(file, "x");
    fs::last_write_time(file, now - std::chrono::hours(1000 - static_cast<long>(k)));
  }
  write_bytes(folder.path() / "notes.txt", "not a thumbnail");
  REQUIRE(cache.store(kHash, some_picture()));
  CHECK_FALSE(fs::exists(folder.path() / "0.png"));
  CHECK(fs::exists(folder.path() / "1.png"));
  CHECK(fs::exists(folder.path() / "notes.txt"));
  CHECK(cache.find(kHash));
}

}  // namespace pabd::test_thumbnail
