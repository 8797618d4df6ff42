// SPDX-License-Identifier: MIT
// Edges softened over a pixel.
flat in vec4 color;
flat in float half_width;
noperspective in float across;
out vec4 fragment;
void main() { fragment = vec4(color.rgb, color.a * clamp(half_width + 0.5 - abs(across), 0.0, 1.0)); }
