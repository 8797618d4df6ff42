// SPDX-License-Identifier: MIT
// See narrow_on_device.h.
#include "tests/device/narrow_on_device.h"

#include <algorithm>
#include <array>

#include "render/device/compute_functions.h"
#include "render/device/narrow_parts.h"

namespace pabd::testing {
namespace {

constexpr std::size_t kMostFound = 16, kMostOfParts = 96;  // contacts of a pair
constexpr std::size_t kNumbers = 7, kWords = 2;            // of a contact
constexpr std::size_t kPlacement = 2 * 12 + 1;
constexpr GLuint kGroup = 64;

const ShaderPart kMain = {"narrow main", R"glsl(
layout(local_size_x = 64) in;
layout(std430, binding = 2) readonly buffer Placements { double placement[]; };
layout(std430, binding = 3) readonly buffer ShapesOf { uvec2 shapes_of[]; };
layout(std430, binding = 4) writeonly buffer Numbers { double number[]; };
layout(std430, binding = 5) writeonly buffer Words { uint word[]; };
layout(std430, binding = 6) writeonly buffer Counts { uint found_of[]; };
uniform uint pair_count;

dvec3 vector_of(uint at) { return dvec3(placement[at], placement[at + 1u], placement[at + 2u]); }
dmat3 matrix_of(uint at) { return dmat3(vector_of(at), vector_of(at + 3u), vector_of(at + 6u)); }

void main() {
  uint pair = gl_GlobalInvocationID.x;
  if (pair >= pair_count) return;
  found_count = 7;  // of an earlier pair
  uint place = 25u * pair, shape_first = shapes_of[pair].x, shape_second = shapes_of[pair].y;
  bool first_is_plane = shapes[shape_first].kind == uint(PLANE);
  dvec3 c_first = vector_of(place), c_second = vector_of(place + 12u), origin = first_is_plane ? c_second : c_first;
  c_first -= origin;
  c_second -= origin;
  dmat3 R_first = matrix_of(place + 3u), R_second = matrix_of(place + 15u);
#ifdef SOLIDS
  turn_facets(shape_first, c_first, R_first, shape_second, c_second, R_second);
#endif
  double reach = placement[place + 24u];
  uint parts = parts_of(shape_first), part_pairs = parts * parts_of(shape_second), count = 0u;
  for (uint k = 0u; k < part_pairs; ++k) {
    dvec3 c_0 = c_first, c_1 = c_second;  // no array: see keeps_doubles
    uint shape_0 = part_of(shape_first, k % parts, c_0, R_first);
    uint shape_1 = part_of(shape_second, k / parts, c_1, R_second);
#ifdef PARTS
    if (!parts_may_meet(shape_0, c_0, shape_1, c_1, reach)) continue;
#endif
    place_pair(shape_0, c_0, R_first, shape_1, c_1, R_second);
    find_contacts(reach_of_facets(reach, shape_0, shape_1));
    for (int i = 0; i < contacts_found() && count < MOST; ++i) {
      FoundContact p = found_contact(i);
      uint feature = p.feature & ~SECOND_OWNS, owner = (p.feature & SECOND_OWNS) != 0u ? 1u : 0u;
      Measured m;
      if (owner != 0u) m = measured(p, shape_1, c_1, R_second, shape_0, c_0, R_first);
      else m = measured(p, shape_0, c_0, R_first, shape_1, c_1, R_second);
#ifdef PARTS
      feature = part_name(shape_first, k % parts, k / parts, feature);
#endif
      m.y_b += origin;
      uint at = MOST * pair + count;
      for (int j = 0; j < 3; ++j) {
        number[7u * at + uint(j)] = m.y_b[j];
        number[7u * at + 3u + uint(j)] = m.n[j];
      }
      number[7u * at + 6u] = m.d;
      word[2u * at] = feature;
      word[2u * at + 1u] = owner | (m.stays ? 0u : 2u) | (m.d < reach ? 0u : 4u);
      ++count;
    }
  }
  found_of[pair] = count;
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
  const bool of_parts = kind_0 == kDeviceCompound || kind_1 == kDeviceCompound;
  const std::size_t most = of_parts ? kMostOfParts : kMostFound;
  const std::string room = "const uint MOST = " + std::to_string(most) + "u;\n" + hull_sizes(table);
  std::vector<ShaderPart> parts = {
      {"header", "#version 430 core\n"}, {"numbers", inside_->numbers}, {"room", room.c_str()}};
  const std::vector<ShaderPart> narrow = narrow_parts(kind_0, kind_1, table.has_solids);
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
  std::vector<double> numbers(pairs.size() * most * kNumbers);
  std::vector<std::uint32_t> words(pairs.size() * most * kWords), counts(pairs.size());
  static_assert(kPlacement == 25 && kNumbers == 7 && kWords == 2);  // as the main has them
  const Buffer shape_buffer(gl, 0, table.shapes), hull_buffer(gl, 1, table.hulls);
  const Buffer placement_buffer(gl, 2, placements), shapes_buffer(gl, 3, shapes);
  const Buffer number_buffer(gl, 4, numbers), word_buffer(gl, 5, words);
  const Buffer count_buffer(gl, 6, counts);
  gl.Uniform1ui(gl.GetUniformLocation(program, "pair_count"), static_cast<GLuint>(pairs.size()));
  gl.DispatchCompute((static_cast<GLuint>(pairs.size()) + kGroup - 1) / kGroup, 1, 1);
  gl.MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  number_buffer.read(numbers);
  word_buffer.read(words);
  count_buffer.read(counts);
  gl.DeleteProgram(program);

  std::vector<std::vector<ContactPoint>> out(pairs.size());
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    // What stays stands for the other corners of its solid.
    bool touches[2] = {};
    for (std::size_t i = most * k; i < most * k + counts[k]; ++i)
      if ((words[kWords * i + 1] & 2) == 0) touches[words[kWords * i + 1] & 1] = true;
    for (std::size_t i = most * k; i < most * k + counts[k]; ++i) {
      const double* x = &numbers[kNumbers * i];
      const std::uint32_t* word = &words[kWords * i];
      const Vec3 y_b(x[0], x[1], x[2]), n(x[3], x[4], x[5]);
      const Index a = word[1] & 1;
      if ((word[1] & 4) != 0 || ((word[1] & 2) != 0 && touches[a])) continue;
      out[k].push_back({a, 1 - a, y_b - x[6] * n, y_b, n, x[6], word[0]});
    }
    std::sort(out[k].begin(), out[k].end(),
              [](const ContactPoint& p, const ContactPoint& q) { return p.feature < q.feature; });
  }
  return out;
}

}  // namespace pabd::testing
