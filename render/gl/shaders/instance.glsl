// SPDX-License-Identifier: MIT
// Attributes of an instance, and what they make of positions and normals: see instance_drawer.h.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 row_x;
layout(location = 3) in vec4 row_y;
layout(location = 4) in vec4 row_z;
layout(location = 5) in vec4 instance_color;
layout(location = 6) in float instance_shaded;

vec3 world_position(vec3 p) {
  vec4 q = vec4(p, 1.0);
  return vec3(dot(row_x, q), dot(row_y, q), dot(row_z, q));
}

// Squared lengths of the three columns: the squared scale along each axis of the primitive.
vec3 squared_scale() { return row_x.xyz * row_x.xyz + row_y.xyz * row_y.xyz + row_z.xyz * row_z.xyz; }

// Transforms are rotations times axis scales, so the normal matrix is M S⁻².
vec3 world_normal(vec3 n) {
  vec3 m = n / max(squared_scale(), vec3(1e-24));
  return normalize(vec3(dot(row_x.xyz, m), dot(row_y.xyz, m), dot(row_z.xyz, m)));
}
