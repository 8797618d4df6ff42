// One triangle that covers the whole viewport: three vertices without attributes.
#pragma once

namespace pabd {

// GLSL: corner() of this vertex, in clip coordinates; vertex stage. The viewport is −1 … 1 in both of them.
inline constexpr const char* kCornerGlsl = R"(
vec2 corner() { return vec2((gl_VertexID & 1) * 4 - 1, (gl_VertexID & 2) * 2 - 1); }
)";

}  // namespace pabd
