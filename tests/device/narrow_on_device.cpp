// SPDX-License-Identifier: MIT
// See narrow_on_device.h.
#include "tests/device/narrow_on_device.h"

#include <algorithm>
#include <array>

#include "render/device/compute_functions.h"
#include "render/device/narrow_parts.h"

namespace pabd::testing {
namespace {

constexpr std::size_t kMostFound = 16, kNumbers = 7, kWords = 1 + 2 * kMostFound;
constexpr std::size_t kPlacement = 2 * 12 + 1;
constexpr GLuint kGroup = 64;

const ShaderPart kMain = {"narrow main", R"glsl(
layout(local_size_x = 64) in;
layout(std430, binding = 2) readonly buffer Placements { double placement[]; };
layout(std430, binding = 3) readonly buffer ShapesOf { uvec2 shapes_of[]; };
layout(std430, binding = 4) writeonly buffer Numbers { double number[]; };
layout(std430, binding = 5) writeonly buffer Words { uint word[]; };
uniform uint pair_count;

dvec3 vector_of(uint at) { return dvec3(placement[at], placement[at + 1u], placement[at + 2u]); }
dmat3 matrix_of(uint at) { return dmat3(vector_of(at), vector_of(at + 3u), vector_of(at + 6u)); }

void main() {
  uint k = gl_GlobalInvocationID.x;
  if (k >= pair_count) return;
  found_count = 7;  // of an earlier pair
  uint place = 25u * k;
  bool first_is_plane = shapes[shapes_of[k].x].kind == uint(PLANE);
  dvec3 c_first = vector_of(place), c_second = vector_of(place + 12u), origin = first_is_plane ? c_second : c_first;
  place_pair(shapes_of[k].x, c_first - origin, matrix_of(place + 3u), shapes_of[k].y, c_second - origin,
             matrix_of(place + 15u));
  find_contacts(wide(placement[place + 24u]));
  word[33u * k] = uint(contacts_found());
  for (int i = 0; i < contacts_found(); ++i) {
    FoundContact p = found_contact(i);
    dvec3 y_b = dvec3(p.y_b), n = dvec3(p.n);
    double d = double(p.d);
#ifdef WIDE_IS_FLOAT
    uint owner = (p.feature & SECOND_OWNS) != 0u ? 1u : 0u;
    uint place_a = place + 12u * owner, place_b = place + 12u - 12u * owner;
    d = measured_again(p, shapes_of[k][owner], vector_of(place_a) - origin, matrix_of(place_a + 3u),
                       shapes_of[k][1u - owner], vector_of(place_b) - origin, matrix_of(place_b + 3u), y_b, n);
#endif
    y_b += origin;
    uint at = 7u * (16u * k + uint(i));
    for (int j = 0; j < 3; ++j) {
      number[at + uint(j)] = y_b[j];
      number[at + 3u + uint(j)] = n[j];
    }
    number[at + 6u] = d;
    word[33u * k + 1u + 2u * uint(i)] = p.feature & ~SECOND_OWNS;
    word[33u * k + 2u + 2u * uint(i)] = (p.feature & SECOND_OWNS) != 0u ? 1u : 0u;
  }
}
)glsl"};

std::unique_ptr<GlContext> some_context() {
  std::vector<ContextAttempt> attempts;
  return create_headless_context(Backend::automatic, attempts);
}

// A storage buffer at its binding.
class Buffer {
 public:
  template <class T>
  Buffer(const ComputeFunctions& gl, GLuint binding, const std::vector<T>& data) : gl_(gl) {
    gl.GenBuffers(1, &id_);
    gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, id_);
    gl.BufferData(GL_SHADER_STORAGE_BUFFER, static_cast<GLsizeiptr>(data.size() * sizeof(T)), data.data(),
                  GL_DYNAMIC_DRAW);
  }
  ~Buffer() { gl_.DeleteBuffers(1, &id_); }
  Buffer(const Buffer&) = delete;
  Buffer& operator=(const Buffer&) = delete;

  template <class T>
  void read(std::vector<T>& out) const {
    gl_.BindBuffer(GL_SHADER_STORAGE_BUFFER, id_);
    gl_.GetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, static_cast<GLsizeiptr>(out.size() * sizeof(T)),
                         out.data());
  }

 private:
  const ComputeFunctions& gl_;
  GLuint id_ = 0;
};

}  // namespace

struct NarrowOnDevice::Inside {
  std::unique_ptr<GlContext> context = some_context();
  ComputeFunctions gl{*context};
  const char* numbers = nullptr;
};

NarrowOnDevice::NarrowOnDevice(const char* numbers) : inside_(std::make_unique<Inside>()) {
  inside_->numbers = numbers;
}
NarrowOnDevice::~NarrowOnDevice() = default;

std::vector<std::vector<ContactPoint>> NarrowOnDevice::contacts(const ShapeTable& table, int kind_0,
                                                                int kind_1,
                                                                const std::vector<PlacedPair>& pairs) {
  const ComputeFunctions& gl = inside_->gl;
  std::vector<ShaderPart> parts = {
      {"header", "#version 430 core\n"}, {"numbers", inside_->numbers}, roots_part()};
  const std::vector<ShaderPart> narrow = narrow_parts(kind_0, kind_1);
  parts.insert(parts.end(), narrow.begin(), narrow.end());
  parts.push_back(kMain);
  const GLuint program =
      link_stages(gl, "narrow", std::array{compile_stage(gl, "narrow", GL_COMPUTE_SHADER, parts)});
  gl.UseProgram(program);

  std::vector<double> placements;
  std::vector<std::uint32_t> shapes;
  for (const PlacedPair& pair : pairs) {
    for (int body = 0; body < 2; ++body) {
      placements.insert(placements.end(), pair.c[body].data(), pair.c[body].data() + 3);
      placements.insert(placements.end(), pair.R[body].data(), pair.R[body].data() + 9);
      shapes.push_back(pair.shape[body]);
    }
    placements.push_back(pair.reach);
  }
  std::vector<double> numbers(pairs.size() * kMostFound * kNumbers);
  std::vector<std::uint32_t> words(pairs.size() * kWords);
  static_assert(kPlacement == 25 && kWords == 33);  // as the main has them
  const Buffer shape_buffer(gl, 0, table.shapes), hull_buffer(gl, 1, table.hulls);
  const Buffer placement_buffer(gl, 2, placements), shapes_buffer(gl, 3, shapes);
  const Buffer number_buffer(gl, 4, numbers), word_buffer(gl, 5, words);
  gl.Uniform1ui(gl.GetUniformLocation(program, "pair_count"), static_cast<GLuint>(pairs.size()));
  gl.DispatchCompute((static_cast<GLuint>(pairs.size()) + kGroup - 1) / kGroup, 1, 1);
  gl.MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  number_buffer.read(numbers);
  word_buffer.read(words);
  gl.DeleteProgram(program);

  std::vector<std::vector<ContactPoint>> out(pairs.size());
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    for (std::size_t i = 0; i < words[kWords * k]; ++i) {
      const double* x = &numbers[kNumbers * (kMostFound * k + i)];
      const std::uint32_t* word = &words[kWords * k + 1 + 2 * i];
      const Vec3 y_b(x[0], x[1], x[2]), n(x[3], x[4], x[5]);
      const Index a = word[1] != 0 ? 1 : 0;
      out[k].push_back({a, 1 - a, y_b - x[6] * n, y_b, n, x[6], word[0]});
    }
    std::sort(out[k].begin(), out[k].end(),
              [](const ContactPoint& p, const ContactPoint& q) { return p.feature < q.feature; });
  }
  return out;
}

}  // namespace pabd::testing
