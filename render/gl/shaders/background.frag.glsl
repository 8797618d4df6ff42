// SPDX-License-Identifier: MIT
// The gradient behind everything.
out vec4 fragment;
void main() { fragment = vec4(background(gl_FragCoord.y), 0.0); }
