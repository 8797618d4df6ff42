// SPDX-License-Identifier: MIT
// Contacts of two edges, or axes of capsules, that run nearly side by side: at both ends of the part that
// they share, each with its own distance and normal, so that nothing jumps while the angle between them goes
// through zero. Where they cross so much that a place between is clearly nearer, there as well.
//
//   a, b     lines p + s u, |s| ≤ h_a, and q + t v, |t| ≤ h_b                       m
//   g(t)     from the foot on a to the place t of b: normal to u, linear in t       m
//   cones    g must lead out of a over the edge and not over a face beside it, and into b likewise

struct EdgeLine {
  wide3 middle, direction;  // direction: unit
  wide half_length;
  wide3 into_0, into_1;  // along the two faces, away from the edge; 0 of a capsule
};

static constexpr int SIDE_NEAREST = 0, SIDE_LOW = 1, SIDE_HIGH = 2;  // along a

// A place of b and the way to it from a.
struct SidePlace {
  int where;
  wide3 y;      // on the line b
  wide3 n;      // unit
  wide apart;   // from the line a along n
  wide t;       // place on b
};

static constexpr wide ALONG_SINE = 0.2;  // of the angle up to which two lines run side by side

int side_where;  // of the places that side_by_side found last, four bits each
wide3 side_t = wide3(0, 0, 0), side_apart = wide3(0, 0, 0);

bool runs_along(wide3 u, wide3 v) {
  wide3 w = cross(u, v);
  return dot(w, w) < ALONG_SINE * ALONG_SINE;
}

// The part where value + rise t ≥ 0.
void keep_part(wide value, wide rise, wide& low, wide& high) {
  if (rise > 0) low = max(low, -value / rise);
  if (rise < 0) high = min(high, -value / rise);
  if (rise == 0 && value < 0) high = low;
}

// Returns how many places there are: 0 when the lines do not run side by side, share no part or touch.
//   slack     a place between the ends counts when it is nearer than both by more than this; m
//   shortest  part that counts; m
int side_by_side(EdgeLine on_a, EdgeLine on_b, wide slack, wide shortest) {
  wide3 u = on_a.direction, v = on_b.direction, w = on_b.middle - on_a.middle;
  if (!runs_along(u, v)) return 0;
  wide uv = dot(u, v), s_0 = dot(u, w);
  wide3 g_0 = w - s_0 * u, slope = v - uv * u;
  wide low = -on_b.half_length, high = on_b.half_length;
  keep_part(on_a.half_length + s_0, uv, low, high);
  keep_part(on_a.half_length - s_0, -uv, low, high);
  keep_part(-dot(on_a.into_0, g_0), -dot(on_a.into_0, slope), low, high);
  keep_part(-dot(on_a.into_1, g_0), -dot(on_a.into_1, slope), low, high);
  keep_part(dot(on_b.into_0, g_0), dot(on_b.into_0, slope), low, high);
  keep_part(dot(on_b.into_1, g_0), dot(on_b.into_1, slope), low, high);
  if (!(high - low > shortest)) return 0;

  wide middle = 0.5 * (low + high), half_part = 0.5 * (high - low), t = low;
  int count = 0;
  side_where = 0;
  bool more = true;
  // Both ends, then the nearest place.
  for (int k = 0; k < 3 && more; ++k) {
    wide3 g = g_0 + t * slope;
    wide apart = sqrt(dot(g, g));
    if (apart > beyond_rounding(1.0e-12) * (on_a.half_length + on_b.half_length)) {
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
      // The nearest place is G t = −A from the middle, which runs off to the ends as the lines become parallel;
      // a little added to G holds it back there, at the price of half of `slack`.
      wide G = dot(slope, slope), A = dot(slope, g_0 + middle * slope);
      more = G > 0;
      if (more) {
        wide3 g_nearest = g_0 + (middle + clamp(-A / G, -half_part, half_part)) * slope;
        wide nearest = sqrt(dot(g_nearest, g_nearest)), held = 4 * nearest * slack / (half_part * half_part);
        more = nearest < min(side_apart.x, side_apart.y) - slack;
        t = middle + clamp(-A / (G + held), -half_part, half_part);
      }
    }
  }
  return count;
}

// Place k of those that side_by_side found last.
SidePlace side_place(EdgeLine on_a, EdgeLine on_b, int k) {
  wide3 u = on_a.direction, v = on_b.direction, w = on_b.middle - on_a.middle;
  wide t = at(side_t, k), apart = at(side_apart, k);
  wide3 g = (w - dot(u, w) * u) + t * (v - dot(u, v) * u);
  SidePlace place = {side_where >> 4 * k & 15, on_b.middle + t * v, g / apart, apart, t};
  return place;
}

// From y_a on the line a along n to the surface of a capsule about b. The way goes on from there to the place
// on b, through the side of its cylinder or, where that leads past the end of it, through the cap.
wide distance_to_capsule(SidePlace p, EdgeLine axis, wide radius) {
  wide along = dot(p.n, axis.direction), slope = abs(along), cosine2 = 1 - slope * slope;
  wide to_end = along < 0 ? axis.half_length - p.t : axis.half_length + p.t;
  wide to_side = radius / sqrt(cosine2);
  if (slope * to_side <= to_end) return p.apart - to_side;
  return p.apart - (to_end * slope + sqrt(radius * radius - to_end * to_end * cosine2));
}
