// SPDX-License-Identifier: MIT
// The helper that other tests compare their pictures with.
#include <catch2/catch.hpp>

#include <cstdlib>
#include <sstream>

#include "render/output/png.h"
#include "tests/support/golden.h"
#include "tests/support/picture.h"
#include "tests/support/temp_folder.h"

namespace pabd::test_golden {

namespace {

const std::string mesa = "llvmpipe (LLVM 15.0.6, 128 bits)";
const std::string other = "llvmpipe (LLVM 15.0.6, 512 bits)";

// The environment variable as this test needs it, and as it was afterwards.
class UpdateWish {
 public:
  explicit UpdateWish(const char* value) {
    if (const char* before = std::getenv("PABD_UPDATE_GOLDEN")) before_ = before;
    set(value);
  }
  ~UpdateWish() { set(before_.empty() ? nullptr : before_.c_str()); }

 private:
  static void set(const char* value) {
    if (value) {
      ::setenv("PABD_UPDATE_GOLDEN", value, 1);
    } else {
      ::unsetenv("PABD_UPDATE_GOLDEN");
    }
  }
  std::string before_;
};

}  // namespace

TEST_CASE("golden pictures") {
  const TempFolder folder;
  std::ostringstream notes;
  const GoldenFolders folders = {folder / "golden", folder / "failures", &notes};
  const Image picture = draw_picture();
  const Image shifted = moved(picture, 1, 0);

  {
    const UpdateWish none(nullptr);
    const CompareResult missing = check_golden(picture, "boxes", mesa, folders);
    CHECK_FALSE(missing.equal);
    CHECK(missing.reason.find("PABD_UPDATE_GOLDEN=1") != std::string::npos);
    CHECK(read_png(folder / "failures/boxes.actual.png").rgb == picture.rgb);
    CHECK_FALSE(std::filesystem::exists(folder / "failures/boxes.expected.png"));
  }
  {
    const UpdateWish yes("1");
    CHECK(check_golden(picture, "boxes", mesa, folders).equal);
  }
  const UpdateWish none(nullptr);
  CHECK(read_png(folder / "golden/llvmpipe-128/boxes.png").rgb == picture.rgb);
  CHECK(check_golden(picture, "boxes", mesa, folders).equal);
  // one pixel apart: wrong for the same class, right for another one
  const CompareResult failed = check_golden(shifted, "boxes", mesa, folders);
  CHECK_FALSE(failed.equal);
  CHECK(failed.reason.find("failures/boxes.") != std::string::npos);
  CHECK(std::filesystem::exists(folder / "failures/boxes.diff.png"));
  CHECK(std::filesystem::exists(folder / "failures/boxes.json"));
  CHECK(notes.str().empty());
  CHECK(check_golden(shifted, "boxes", other, folders).equal);
  PictureOptions empty;
  empty.small_box = false;
  CHECK_FALSE(check_golden(draw_picture(empty), "boxes", other, folders).equal);
  // said, but once
  CHECK(notes.str() ==
        "no approved pictures of class llvmpipe-512: compared leniently with class llvmpipe-128\n");
  // a class with its own baseline is held to it
  {
    const UpdateWish yes("1");
    CHECK(check_golden(shifted, "boxes", other, folders).equal);
  }
  CHECK(check_golden(shifted, "boxes", other, folders).equal);
  CHECK_FALSE(check_golden(picture, "boxes", other, folders).equal);
  // or to a second one
  {
    const UpdateWish second("2");
    CHECK(check_golden(picture, "boxes", other, folders).equal);
  }
  CHECK(check_golden(picture, "boxes", other, folders).equal);
  CHECK(check_golden(shifted, "boxes", other, folders).equal);
  CHECK_FALSE(check_golden(moved(picture, 3, 0), "boxes", other, folders).equal);
  // where it has some, a picture that is missing is named
  {
    const UpdateWish yes("1");
    CHECK(check_golden(picture, "bricks", mesa, folders).equal);
  }
  notes.str("");
  CHECK(check_golden(picture, "bricks", other, folders).equal);
  CHECK(notes.str() ==
        "no approved picture bricks of class llvmpipe-512: compared leniently with class llvmpipe-128\n");
}

}  // namespace pabd::test_golden
