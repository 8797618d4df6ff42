// SPDX-License-Identifier: MIT
// A line as a quad that faces the camera: four corners an instance.
layout(location = 0) in vec3 a;
layout(location = 1) in vec3 b;
layout(location = 2) in vec4 line_color;
layout(location = 3) in float line_width;
flat out vec4 color;
flat out float half_width;
noperspective out float across;
void main() {
  vec4 p = frame.world_to_clip * vec4(a, 1.0);
  vec4 q = frame.world_to_clip * vec4(b, 1.0);
  // An end behind the eye moves along the line to just in front of it.
  float least = 1e-4 * frame.centre.w;
  if (p.w < least && q.w > least) p = mix(q, p, (q.w - least) / (q.w - p.w));
  if (q.w < least && p.w > least) q = mix(p, q, (p.w - least) / (p.w - q.w));
  vec2 size = 0.5 * frame.viewport.xy;
  vec2 along = q.xy / q.w * size - p.xy / p.w * size;
  along = dot(along, along) > 1e-12 ? normalize(along) : vec2(1.0, 0.0);
  vec2 side = vec2(-along.y, along.x);
  // Thinner than a pixel: a pixel wide, but fainter.
  float wide = line_width * frame.viewport.z;
  half_width = 0.5 * max(wide, 1.0);
  color = vec4(line_color.rgb, line_color.a * min(wide, 1.0));
  float sign = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
  across = sign * (half_width + 0.5);
  vec4 at = (gl_VertexID & 2) == 0 ? p : q;
  gl_Position = vec4(at.xy + side * across / size * at.w, at.zw);
}
