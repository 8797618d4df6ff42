// SPDX-License-Identifier: MIT
// Contacts that were found in float, measured again in double. A gap of a micrometre between bodies of a metre has one
// digit in float, and forces follow the gap: what is found, where and along which normal, is float's; how far apart the
// surfaces are is not.

// The surface's place at x, which is on it but for rounding, both in the body's frame; x where it is not.
dvec3 on_surface(uint shape, dvec3 x) {
  const double NEARLY = 4e-6lf;  // some roundings of float, beside the size
  uint kind = shapes[shape].kind;
  dvec4 size = shapes[shape].size;
  if (kind == uint(PLANE)) return x;
  if (kind == uint(BOX)) {
    dvec3 place = dvec3(x.x < 0 ? -size.x : size.x, x.y < 0 ? -size.y : size.y, x.z < 0 ? -size.z : size.z);
    double near = NEARLY * max(size.x, max(size.y, size.z));
    if (abs(x.x - place.x) < near) x.x = place.x;
    if (abs(x.y - place.y) < near) x.y = place.y;
    if (abs(x.z - place.z) < near) x.z = place.z;
    return x;
  }
  if (kind == uint(HULL)) {
    uint vertex = shapes[shape].first, face = vertex + 3u * shapes[shape].vertices, end = face + 5u * shapes[shape].faces;
    double near = NEARLY * size.x;
    for (uint k = vertex; k < face; k += 3u) {
      dvec3 corner = dvec3(hull_words[k], hull_words[k + 1u], hull_words[k + 2u]), apart = x - corner;
      if (dot(apart, apart) < near * near) return corner;
    }
    // Onto both faces at an edge: the second leaves the first by what is left.
    for (int turn = 0; turn < 3; ++turn) {
      for (uint k = face; k < end; k += 5u) {
        dvec3 n = dvec3(hull_words[k], hull_words[k + 1u], hull_words[k + 2u]);
        double height = dot(n, x) - hull_words[k + 3u];
        if (abs(height) < near) x -= height * n;
      }
    }
    return x;
  }
  // Round: about a point, or the point of the axis that is next to x.
  double half_length = kind == uint(CAPSULE) ? 0.5lf * size.y : 0.0lf;
  dvec3 middle = dvec3(0, clamp(x.y, -half_length, half_length), 0), out_ = x - middle;
  double far = sqrt(dot(out_, out_));
  if (abs(far - size.x) > NEARLY * (size.x + half_length)) return x;
  return middle + (size.x / far) * out_;
}

// Moves y_b, makes n as long as 1, and tells d. Poses of the owner a and the other body b, from the origin that y_b has.
double measured_again(FoundContact f, uint shape_a, dvec3 c_a, dmat3 R_a, uint shape_b, dvec3 c_b, dmat3 R_b,
                      out dvec3 y_b, out dvec3 n) {
  n = dvec3(f.n);
  n /= sqrt(dot(n, n));
  y_b = c_b + R_b * on_surface(shape_b, (dvec3(f.y_b) - c_b) * R_b);
  dvec4 plane = shapes[shape_a].size;
  if (shapes[shape_a].kind == uint(PLANE)) return dot(plane.xyz, y_b - c_a) - plane.w;
  dvec3 y_a = y_b - double(f.d) * n;
  return dot(n, y_b - c_a - R_a * on_surface(shape_a, (y_a - c_a) * R_a));
}
