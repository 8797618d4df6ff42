// SPDX-License-Identifier: MIT
// Mesh files: three formats give the same hull, and whatever is wrong with a file is refused with its place.
#include <bit>

#include "sim/body/mass_properties.h"
#include "sim/scene/mesh_library.h"
#include "sim/scene/random.h"
#include "tests/scene/scene_helpers.h"
#include "tests/support/files.h"
#include "tests/support/places.h"

namespace pabd::test_meshes {

using namespace test;

namespace {

const std::filesystem::path kAssets = places::assets();

// The unit cube from 0 to 1, in each format.
const std::string kObj = R"(# a cube
mtllib none.mtl
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
v 0 0 1
v 1 0 1
v 1 1 1 0.5 0.5 0.5
v 0 1 1
vn 0 0 1
f 4 3 2 1
f 5//1 6//1 7//1 8//1
f 1 2 6 5
f 2 3 7 6
f 3 4 8 7
f -5 -8 -4 -1
)";

const double kCorners[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                               {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
const int kQuads[6][4] = {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};

void put(std::string& out, std::uint64_t bits, int bytes, bool big = false) {
  for (int k = 0; k < bytes; ++k) out += static_cast<char>(bits >> (8 * (big ? bytes - 1 - k : k)) & 255);
}

std::uint32_t bits_of(double x) { return std::bit_cast<std::uint32_t>(static_cast<float>(x)); }

void put_text(std::string& out, const double* p) {
  for (int k = 0; k < 3; ++k) out.append(" ").append(std::to_string(p[k]));
}

std::string stl_text() {
  std::string out = "solid cube of mine\n";
  for (const auto& q : kQuads) {
    for (const int start : {0, 2}) {
      out += "facet normal 0 0 0\nouter loop\n";
      for (int k = 0; k < 3; ++k) {
        const double* p = kCorners[q[(start + k) % 4]];
        out += "vertex";
        put_text(out, p);
        out += "\n";
      }
      out += "endloop\nendfacet\n";
    }
  }
  return out + "endsolid cube of mine\n";
}

std::string stl_binary() {
  std::string out = "solid";  // some programs write that here too
  out.resize(80, ' ');
  put(out, 12, 4);
  for (const auto& q : kQuads) {
    for (const int start : {0, 2}) {
      out.append(12, '\0');
      for (int k = 0; k < 3; ++k) {
        for (const double x : kCorners[q[(start + k) % 4]]) put(out, bits_of(x), 4);
      }
      out.append(2, '\0');
    }
  }
  return out;
}

std::string ply(const std::string& format) {
  std::string out =
      "ply\nformat " + format +
      " 1.0\ncomment a cube\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z\n"
      "property uchar red\nelement face 6\nproperty list uchar int vertex_indices\nend_header\n";
  const bool big = format == "binary_big_endian";
  for (const auto& p : kCorners) {
    if (format == "ascii") {
      put_text(out, p);
      out += " 7\n";
      continue;
    }
    for (const double x : p) put(out, bits_of(x), 4, big);
    out += '\7';
  }
  for (const auto& q : kQuads) {
    if (format == "ascii") {
      out += "4";
      for (const int v : q) out.append(" ").append(std::to_string(v));
      out += "\n";
      continue;
    }
    out += '\4';
    for (const int v : q) put(out, static_cast<std::uint64_t>(v), 4, big);
  }
  return out;
}

struct Sample {
  const char* name;
  std::string bytes;
  const char* ending;
};

std::vector<Sample> samples() {
  return {{"obj", kObj, "obj"},
          {"stl text", stl_text(), "stl"},
          {"stl binary", stl_binary(), "stl"},
          {"ply text", ply("ascii"), "ply"},
          {"ply little", ply("binary_little_endian"), "ply"},
          {"ply big", ply("binary_big_endian"), "ply"}};
}

std::string refusal(const std::string& bytes, const char* ending, double scale = 1) {
  try {
    const Hull hull = read_mesh_hull(bytes, ending, scale);
    REQUIRE(hull.data);
    REQUIRE(hull.data->volume > 0);
    REQUIRE(hull.data->second_moment.allFinite());
    return {};
  } catch (const Error& error) {
    REQUIRE(error.kind() == ErrorKind::bad_input);
    const std::string message = error.what();
    REQUIRE(message.find('\n') == std::string::npos);
    return message;
  }
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

}  // namespace

TEST_CASE("every format gives the cube", "[mesh]") {
  for (const Sample& sample : samples()) {
    INFO(sample.name);
    const Hull hull = read_mesh_hull(sample.bytes, sample.ending, 2);
    CHECK(hull.data->vertices.size() == 8);
    CHECK(hull.data->faces.size() == 6);
    CHECK(hull.data->volume == Approx(8).epsilon(1e-13));
    CHECK((hull.data->centroid - Vec3::Ones()).norm() < 1e-13);
    const Mat3 J = mass_properties(Box{Vec3::Ones()}, 1).J;
    CHECK((hull.data->second_moment - J).norm() < 1e-12 * J.norm());
  }
}

TEST_CASE("damaged OBJ files name the line", "[mesh]") {
  const auto check = [](const std::string& text, const std::string& place, const std::string& what) {
    const std::string message = refusal(text, "obj");
    CHECK_THAT(message, Catch::StartsWith(place) && Catch::Contains(what));
  };
  check("", "line 1", "without a face");
  check(replaced(kObj, "v 1 0 0", "v 1 0"), "line 4", "finite number");
  check(replaced(kObj, "v 1 0 0", "v 1 nan 0"), "line 4", "finite number");
  check(replaced(kObj, "v 1 0 0", "v 1 1e999 0"), "line 4", "finite number");
  check(replaced(kObj, "f 4 3 2 1", "f 4 3 2 9"), "line 12", "no point");
  check(replaced(kObj, "f 4 3 2 1", "f 4 3 2 0"), "line 12", "no point");
  check(replaced(kObj, "f 4 3 2 1", "f 4 3 2 -9"), "line 12", "no point");
  check(replaced(kObj, "f 4 3 2 1", "f 4 3 2 99999999999999999999"), "line 12", "whole number");
  check(replaced(kObj, "f 4 3 2 1", "f 4 3"), "line 12", "three or more");
  check(replaced(kObj, "f 4 3 2 1", "f 4/x 3 2 1"), "line 12", "numbers of points");
  check(replaced(kObj, "f 4 3 2 1", "curv 0 1"), "line 12", "unknown word");
  check(replaced(kObj, "f 4 3 2 1", ""), "line ", "open at the edge");
}

TEST_CASE("damaged STL files name the line or byte", "[mesh]") {
  const std::string text = stl_text(), binary = stl_binary();
  CHECK_THAT(refusal("", "stl"), Catch::StartsWith("byte 0"));
  CHECK_THAT(refusal(replaced(text, "endloop", "endlop"), "stl"),
             Catch::StartsWith("line 7") && Catch::Contains("expected \"endloop\""));
  CHECK_THAT(refusal(replaced(text, "vertex 0", "vertex x"), "stl"), Catch::Contains("finite number"));
  CHECK_THAT(refusal(text.substr(0, text.find("endfacet")), "stl"), Catch::Contains("end of the file"));
  CHECK_THAT(refusal("solid\nendsolid\n", "stl"), Catch::Contains("without a facet"));
  CHECK_THAT(refusal(binary.substr(5), "stl"), Catch::StartsWith("byte 80"));
  std::string bad = binary;
  bad[84 + 50 + 12 + 2] = '\xc0';  // NaN
  bad[84 + 50 + 12 + 3] = '\x7f';
  CHECK_THAT(refusal(bad, "stl"), Catch::StartsWith("byte 146") && Catch::Contains("not finite"));
  bad = binary;
  bad[0] = 'x';
  for (std::size_t k = 80; k < 84; ++k) bad[k] = '\xff';
  CHECK_THAT(refusal(bad, "stl"), Catch::StartsWith("byte 80") && Catch::Contains("4294967295"));
  std::string open = binary.substr(0, binary.size() - 50);
  open[80] = 11;
  CHECK_THAT(refusal(open, "stl"), Catch::StartsWith("byte ") && Catch::Contains("open at the edge"));
}

TEST_CASE("damaged PLY files name the line or byte", "[mesh]") {
  const std::string text = ply("ascii"), binary = ply("binary_little_endian");
  const auto check = [&](const std::string& from, const std::string& to, const std::string& what) {
    INFO(from << " -> " << to);
    CHECK_THAT(refusal(replaced(text, from, to), "ply"), Catch::StartsWith("line ") && Catch::Contains(what));
    CHECK_FALSE(
        refusal(replaced(binary, from == "ascii" ? "binary_little_endian" : from, to), "ply").empty());
  };
  check("ply", "plx", "expected \"ply\"");
  check("ascii", "unicode", "unknown format");
  check("vertex 8", "vertex 99999999999", "more than 600000 points");
  check("face 6", "face 99999999999", "more than 200000 faces");
  check("vertex 8", "vertex -8", "negative count");
  check("vertex 8", "vertex 9", "");
  check("face 6", "face 7", "ends early");
  check("face 6", "face 5", "open at the edge");
  check("property float z", "property float w", "lack x, y or z");
  check("vertex_indices", "indices", "vertex_indices");
  check("float x", "flot x", "unknown type");
  check("end_header", "", "");
  check("element face", "element vertex", "twice");
  check("comment", "element huge 99999999999999\nproperty char c\ncomment", "");
  CHECK_THAT(refusal(replaced(text, "4 3 2 1 0", "4 3 2 1 8"), "ply"), Catch::Contains("no point 8"));
  CHECK_THAT(refusal(replaced(text, "4 3 2 1 0", "4 3 2 1 -1"), "ply"), Catch::Contains("no point -1"));
  CHECK_THAT(refusal(replaced(text, "4 3 2 1 0", "4 3 2 1 0.5"), "ply"), Catch::Contains("no point 0.5"));
  CHECK_THAT(refusal(replaced(text, "4 3 2 1 0", "2 3 2"), "ply"), Catch::Contains("three or more"));
  // An element without properties takes no room, however many there are.
  CHECK(refusal(replaced(text, "comment", "element huge 99999999999999\ncomment"), "ply").empty());
  CHECK_THAT(refusal(binary.substr(0, binary.size() - 1), "ply"), Catch::StartsWith("byte "));
}

TEST_CASE("flat, tiny and huge meshes are refused", "[mesh]") {
  std::string flat = kObj;
  for (const char* corner : {"v 0 0 1", "v 1 0 1", "v 1 1 1", "v 0 1 1"}) {
    std::string down = corner;
    down.back() = '0';
    flat = replaced(flat, corner, down);
  }
  CHECK_THAT(refusal(flat, "obj"), Catch::Contains("one plane"));
  CHECK_THAT(refusal(kObj, "obj", 1e-7), Catch::Contains("larger \"scale\""));
  CHECK_THAT(refusal(kObj, "obj", 1e7), Catch::Contains("smaller \"scale\""));
  std::string many;
  for (int k = 0; k < 600001; ++k) many += "v 0 0 0\n";
  CHECK_THAT(refusal(many, "obj"), Catch::StartsWith("line 600001"));
  CHECK_THAT(refusal(kObj, "xyz"), Catch::Contains(".obj, .stl or .ply"));
}

TEST_CASE("changed, lost and doubled bytes of every format give a hull or a refusal", "[mesh]") {
  Random random(99);
  for (const Sample& sample : samples()) {
    INFO(sample.name);
    int refusals = 0;
    constexpr int kRounds = 3000;
    for (int i = 0; i < kRounds; ++i) {
      std::string bytes = sample.bytes;
      const std::size_t at = random.bits() % bytes.size();
      switch (i % 5) {
        case 0:
          bytes[at] = static_cast<char>(random.bits() & 0xff);
          break;
        case 1:
          bytes[at] = "0123456789-+.e \n"[random.bits() % 16];
          break;
        case 2:
          bytes.erase(at, 1 + random.bits() % 4);
          break;
        case 3: {
          const std::size_t from = random.bits() % bytes.size();
          bytes.insert(at, bytes.substr(from, random.bits() % 20));
          break;
        }
        default:
          bytes.resize(at);
          break;
      }
      refusals += refusal(bytes, sample.ending).empty() ? 0 : 1;
    }
    CHECK(refusals > kRounds / 4);
  }
}

TEST_CASE("the body sits at the centre of mass, and the hash follows the file's content", "[mesh]") {
  const auto folder = std::filesystem::temp_directory_path() / "pabd_test_meshes";
  std::filesystem::create_directories(folder);
  const auto load = [&](const std::string& mesh, const std::string& name) {
    write_bytes(folder / name, mesh);
    return parse_scene(only_body(
                           R"({ "name": "m", "position": [1, 2, 3], "mass": 5, "shape": { "type": "mesh",
      "file": ")" + name + R"(", "scale": 0.5 } }, { "shape": { "type": "mesh", "file": ")" +
                           name + R"(", "scale": 0.5 } })"),
                       "test.json", folder, {});
  };
  const Scene a = load(kObj, "a.obj");
  CHECK(a.initial.c[0] == Vec3(1, 2, 3));
  CHECK(a.model.mass[0] == 5);
  const auto& hull = std::get<Hull>(a.model.shape[0]);
  CHECK(hull.data->volume == Approx(0.125));
  CHECK((hull.data->centroid - Vec3::Constant(0.25)).norm() < 1e-14);
  CHECK(hull.data == std::get<Hull>(a.model.shape[1]).data);  // read once
  CHECK(load(kObj, "b.obj").hash == a.hash);
  CHECK(load(kObj + "# more\n", "b.obj").hash != a.hash);
  std::filesystem::remove_all(folder);
}

TEST_CASE("shipped meshes are hulls of the stated kind", "[mesh]") {
  MeshLibrary meshes(kAssets / "meshes");
  const auto faces = [&](const char* file) { return meshes.load(file, 1).hull.data->faces.size(); };
  CHECK(faces("wedge.obj") == 6);
  CHECK(faces("octahedron.ply") == 8);
  CHECK(faces("rock.stl") == 20);
  CHECK(faces("hexagon.stl") == 8);
  CHECK(meshes.load("octahedron.ply", 1).hull.data->volume == Approx(4.0 / 3).epsilon(1e-12));
  CHECK(meshes.load("wedge.obj", 1).hull.data->centroid.norm() < 1e-8);
}

}  // namespace pabd::test_meshes
