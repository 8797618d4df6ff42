// SPDX-License-Identifier: MIT
// exp(−h/λ) of the height h above the floor.
in float height;
out vec4 fragment;
void main() { fragment = vec4(exp(-max(height, 0.0))); }
