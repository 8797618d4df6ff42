// SPDX-License-Identifier: MIT
// PLY, text and binary: x, y, z of "vertex" and the list "vertex_indices" (or "vertex_index") of "face".
// Other elements and properties are read over.
#include <fmt/format.h>

#include <array>
#include <bit>
#include <cmath>
#include <optional>

#include "sim/scene/mesh_surface.h"
#include "sim/scene/text.h"

namespace pabd {
namespace {

enum class Type { i8, u8, i16, u16, i32, u32, f32, f64 };
enum class Encoding { text, little, big };

struct Property {
  std::string_view name;
  Type type;
  std::optional<Type> count;  // of a list
};

struct Element {
  std::string_view name;
  std::uint64_t count;
  std::uint64_t line;
  std::vector<Property> properties;
};

struct Header {
  Encoding encoding = Encoding::text;
  std::vector<Element> elements;
};

Type type_of(const MeshText& text, std::string_view word) {
  constexpr std::pair<std::string_view, Type> kNames[] = {
      {"char", Type::i8},   {"int8", Type::i8},     {"uchar", Type::u8},   {"uint8", Type::u8},
      {"short", Type::i16}, {"int16", Type::i16},   {"ushort", Type::u16}, {"uint16", Type::u16},
      {"int", Type::i32},   {"int32", Type::i32},   {"uint", Type::u32},   {"uint32", Type::u32},
      {"float", Type::f32}, {"float32", Type::f32}, {"double", Type::f64}, {"float64", Type::f64}};
  for (const auto& [name, type] : kNames) {
    if (name == word) return type;
  }
  text.refuse(fmt::format("unknown type {}; expected \"float\", \"int\" and the like", in_quotes(word)));
}

Encoding read_encoding(MeshText& text) {
  const std::string_view word = text.word();
  if (text.word() != "1.0") text.refuse("expected \"format … 1.0\"");
  if (word == "ascii") return Encoding::text;
  if (word == "binary_little_endian") return Encoding::little;
  if (word == "binary_big_endian") return Encoding::big;
  text.refuse(
      fmt::format("unknown format {}; expected \"ascii\", \"binary_little_endian\" or "
                  "\"binary_big_endian\"",
                  in_quotes(word)));
}

Header read_header(MeshText& text) {
  constexpr std::size_t kMostEntries = 1000;
  Header out;
  if (text.word() != "ply") text.refuse("expected \"ply\" in the first line");
  bool has_format = false;
  std::size_t entries = 0;
  while (text.next_line()) {
    const std::string_view key = text.word();
    if (++entries > kMostEntries) text.refuse("more than 1000 lines of header; expected \"end_header\"");
    if (key == "comment" || key == "obj_info" || key.empty()) continue;
    if (key == "end_header") {
      if (!has_format) text.refuse("the header has no format; expected \"format ascii 1.0\" or a binary one");
      text.next_line();
      return out;
    }
    if (key == "format") {
      out.encoding = read_encoding(text);
      has_format = true;
    } else if (key == "element") {
      const std::string_view name = text.word();
      const std::int64_t count = text.integer(text.word());
      if (count < 0) text.refuse("a negative count; expected 0 or more");
      for (const Element& other : out.elements) {
        if (other.name == name) text.refuse(fmt::format("the element {} appears twice", in_quotes(name)));
      }
      out.elements.push_back({name, static_cast<std::uint64_t>(count), text.line(), {}});
    } else if (key == "property") {
      if (out.elements.empty()) text.refuse("a property before any element; expected \"element\" first");
      Property property{};
      std::string_view type = text.word();
      if (type == "list") {
        property.count = type_of(text, text.word());
        type = text.word();
      }
      property.type = type_of(text, type);
      property.name = text.word();
      out.elements.back().properties.push_back(property);
    } else {
      text.refuse(fmt::format("unknown word {}; expected \"element\", \"property\" or \"end_header\"",
                              in_quotes(key)));
    }
  }
  text.refuse("the file ends in its header; expected \"end_header\"");
}

// Values of the body, one after the other.
class Values {
 public:
  Values(MeshText& text, std::string_view bytes, Encoding encoding)
      : text_(text), bytes_(bytes), at_(text.position()), encoding_(encoding) {}

  const char* unit() const { return encoding_ == Encoding::text ? "line" : "byte"; }
  std::uint64_t place() const { return encoding_ == Encoding::text ? text_.line() : at_; }
  [[noreturn]] void refuse(const std::string& message) const { refuse_mesh(unit(), place(), message); }

  double next(Type type) {
    if (encoding_ != Encoding::text) return binary(type);
    const std::string_view word = text_.word_anywhere();
    if (word.empty()) refuse("the file ends early; expected as much as its header announces");
    return text_.number(word);
  }
  // A whole number from 0 to `most`.
  std::uint64_t index(Type type, std::uint64_t most, const char* what) {
    const double x = next(type);
    if (!(x >= 0 && x <= static_cast<double>(most) && x == std::floor(x))) {
      refuse(fmt::format("{} {}; expected a whole number from 0 to {}", what, x, most));
    }
    return static_cast<std::uint64_t>(x);
  }

 private:
  double binary(Type type) {
    constexpr std::array<std::size_t, 8> kBytes{1, 1, 2, 2, 4, 4, 4, 8};
    const std::size_t size = kBytes[static_cast<std::size_t>(type)];
    if (bytes_.size() - at_ < size) refuse("the file ends early; expected as much as its header announces");
    std::uint64_t raw = 0;
    for (std::size_t k = 0; k < size; ++k) {
      const std::size_t from = encoding_ == Encoding::big ? at_ + k : at_ + size - 1 - k;
      raw = raw << 8 | static_cast<unsigned char>(bytes_[from]);
    }
    at_ += size;
    switch (type) {
      case Type::i8:
        return static_cast<std::int8_t>(raw);
      case Type::i16:
        return static_cast<std::int16_t>(raw);
      case Type::i32:
        return static_cast<std::int32_t>(raw);
      case Type::f32:
        return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(raw)));
      case Type::f64:
        return std::bit_cast<double>(raw);
      default:
        return static_cast<double>(raw);
    }
  }

  MeshText& text_;
  std::string_view bytes_;
  std::size_t at_;
  Encoding encoding_;
};

constexpr std::uint64_t kLongestList = kMostMeshBytes;

void skip(Values& in, const Property& property) {
  const std::uint64_t count =
      property.count ? in.index(*property.count, kLongestList, "a list of length") : 1;
  for (std::uint64_t k = 0; k < count; ++k) in.next(property.type);
}

void read_vertices(Values& in, const Element& element, MeshSurface& out) {
  limit_points(element.count, "line", element.line);
  int found = 0;
  for (const Property& p : element.properties) {
    if (!p.count && (p.name == "x" || p.name == "y" || p.name == "z")) ++found;
  }
  if (found != 3)
    refuse_mesh("line", element.line, "the vertices lack x, y or z; expected each of them once");
  for (std::uint64_t i = 0; i < element.count; ++i) {
    Vec3 point = Vec3::Zero();
    for (const Property& p : element.properties) {
      const int axis = p.name == "x" ? 0 : p.name == "y" ? 1 : p.name == "z" ? 2 : -1;
      if (p.count || axis < 0) {
        skip(in, p);
        continue;
      }
      point[axis] = in.next(p.type);
      if (!std::isfinite(point[axis])) in.refuse("a coordinate is not finite; expected finite numbers");
    }
    out.points.push_back(point);
  }
}

bool is_corner_list(const Property& p) {
  return p.count && (p.name == "vertex_indices" || p.name == "vertex_index");
}

void read_faces(Values& in, const Element& element, std::uint64_t points, MeshSurface& out) {
  limit_faces(element.count, "line", element.line);
  int lists = 0;
  for (const Property& p : element.properties) lists += is_corner_list(p) ? 1 : 0;
  if (lists != 1) refuse_mesh("line", element.line, "the faces lack a list \"vertex_indices\"; expected one");
  for (std::uint64_t i = 0; i < element.count; ++i) {
    for (const Property& p : element.properties) {
      if (!is_corner_list(p)) {
        skip(in, p);
        continue;
      }
      MeshSurface::Face face{static_cast<std::uint32_t>(out.corners.size()), 0, in.place()};
      face.count = static_cast<std::uint32_t>(in.index(*p.count, kMostMeshFaces, "a face of points:"));
      if (face.count < 3) in.refuse("a face of fewer than three points; expected three or more");
      for (std::uint32_t k = 0; k < face.count; ++k) {
        out.corners.push_back(static_cast<std::uint32_t>(in.index(p.type, points - 1, "there is no point")));
      }
      if (out.corners.size() > 4 * kMostMeshFaces) limit_faces(kMostMeshFaces + 1, in.unit(), in.place());
      out.faces.push_back(face);
    }
  }
}

}  // namespace

MeshSurface read_ply(std::string_view bytes) {
  MeshText text(bytes);
  const Header header = read_header(text);
  const Element* vertices = nullptr;
  const Element* faces = nullptr;
  for (const Element& element : header.elements) {
    if (element.name == "vertex") vertices = &element;
    if (element.name == "face") faces = &element;
  }
  if (vertices == nullptr || vertices->count == 0) text.refuse("the file has no vertices; expected some");
  if (faces == nullptr || faces->count == 0) text.refuse("the file has no faces; expected some");

  MeshSurface out;
  Values in(text, bytes, header.encoding);
  out.place_unit = in.unit();
  for (const Element& element : header.elements) {
    if (&element == vertices) {
      read_vertices(in, element, out);
    } else if (&element == faces) {
      read_faces(in, element, vertices->count, out);
    } else if (!element.properties.empty()) {  // each takes room: the end of the file stops a huge count
      for (std::uint64_t i = 0; i < element.count; ++i) {
        for (const Property& p : element.properties) skip(in, p);
      }
    }
  }
  return out;
}

}  // namespace pabd
