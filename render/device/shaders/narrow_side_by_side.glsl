// SPDX-License-Identifier: MIT
// side_by_side.h: contacts of two edges, or axes of capsules, that run nearly side by side.
struct EdgeLine {
  wide3 middle, direction;
  wide half_length;
  wide3 into_0, into_1;  // along the two faces, away from the edge; 0 of a capsule
};

const int SIDE_NEAREST = 0, SIDE_LOW = 1, SIDE_HIGH = 2;  // along a

struct SidePlace {
  int where;
  wide3 y, n;
  wide apart, t;
};

const wide ALONG_SINE = wide(0.2lf);

int side_where;               // of the places, four bits each
wide3 side_t, side_apart;

bool runs_along(wide3 u, wide3 v) {
  wide3 w = cross(u, v);
  return dot(w, w) < ALONG_SINE * ALONG_SINE;
}

// The part where value + rise t ≥ 0.
void keep_part(wide value, wide rise, inout wide low, inout wide high) {
  if (rise > 0) low = max(low, -value / rise);
  if (rise < 0) high = min(high, -value / rise);
  if (rise == 0 && value < 0) high = low;
}

// Returns how many places there are.
int side_by_side(EdgeLine a, EdgeLine b, wide slack, wide shortest) {
  wide3 u = a.direction, v = b.direction, w = b.middle - a.middle;
  if (!runs_along(u, v)) return 0;
  wide uv = dot(u, v), s_0 = dot(u, w);
  wide3 g_0 = w - s_0 * u, slope = v - uv * u;
  wide low = -b.half_length, high = b.half_length;
  keep_part(a.half_length + s_0, uv, low, high);
  keep_part(a.half_length - s_0, -uv, low, high);
  keep_part(-dot(a.into_0, g_0), -dot(a.into_0, slope), low, high);
  keep_part(-dot(a.into_1, g_0), -dot(a.into_1, slope), low, high);
  keep_part(dot(b.into_0, g_0), dot(b.into_0, slope), low, high);
  keep_part(dot(b.into_1, g_0), dot(b.into_1, slope), low, high);
  if (!(high - low > shortest)) return 0;

  wide middle = wide(0.5lf) * (low + high), half_part = wide(0.5lf) * (high - low);
  int count = 0;
  side_where = 0;
  wide t = low;
  bool more = true;
  for (int k = 0; k < 3 && more; ++k) {
    wide3 g = g_0 + t * slope;
    wide apart = sqrt(dot(g, g));
    if (apart > beyond_rounding(1e-12lf) * (a.half_length + b.half_length)) {
      int where = k == 2 ? SIDE_NEAREST : (k == 0) == (uv > 0) ? SIDE_LOW : SIDE_HIGH;
      side_where |= where << 4 * count;
      if (count == 0) {
        side_t.x = t;
        side_apart.x = apart;
      } else if (count == 1) {
        side_t.y = t;
        side_apart.y = apart;
      } else {
        side_t.z = t;
        side_apart.z = apart;
      }
      ++count;
    }
    if (k == 0) t = high;
    if (k == 1 && count < 2) {
      count = 0;
      more = false;
    } else if (k == 1) {
      wide G = dot(slope, slope), A = dot(slope, g_0 + middle * slope), nearest = NONE;
      if (G > 0) {
        wide3 g_nearest = g_0 + (middle + clamp(-A / G, -half_part, half_part)) * slope;
        nearest = sqrt(dot(g_nearest, g_nearest));
      }
      more = nearest < min(side_apart.x, side_apart.y) - slack;
      wide held = 4 * nearest * slack / (half_part * half_part);
      t = middle + clamp(-A / (G + held), -half_part, half_part);
    }
  }
  return count;
}

// Place k of those that side_by_side found last.
SidePlace side_place(EdgeLine a, EdgeLine b, int k) {
  wide3 u = a.direction, v = b.direction, w = b.middle - a.middle;
  wide t = at(side_t, k), apart = at(side_apart, k);
  wide3 g = (w - dot(u, w) * u) + t * (v - dot(u, v) * u);
  return SidePlace(side_where >> 4 * k & 15, b.middle + t * v, g / apart, apart, t);
}

wide distance_to_capsule(SidePlace p, EdgeLine b, wide radius) {
  wide slope = dot(p.n, b.direction), cosine2 = 1 - slope * slope;
  wide to_end = slope < 0 ? b.half_length - p.t : b.half_length + p.t;
  wide to_side = radius / sqrt(cosine2);
  if (abs(slope) * to_side <= to_end) return p.apart - to_side;
  return p.apart - (to_end * abs(slope) + sqrt(radius * radius - to_end * to_end * cosine2));
}
