// SPDX-License-Identifier: MIT
// exp(−h/λ) of the height h above the floor.
in float height;
flat in float strength;
out vec4 fragment;
void main() { fragment = vec4(strength * exp(-max(height, 0.0))); }
