// SPDX-License-Identifier: MIT
// side_by_side.h: contacts of two edges, or axes of capsules, that run nearly side by side.
struct EdgeLine {
  dvec3 middle, direction;
  double half_length;
  dvec3 into_0, into_1;  // along the two faces, away from the edge; 0 of a capsule
};

const int SIDE_NEAREST = 0, SIDE_LOW = 1, SIDE_HIGH = 2;  // along a

struct SidePlace {
  int where;
  dvec3 y, n;
  double apart, t;
};

const double ALONG_SINE = 0.2lf;

SidePlace side_place[3];

bool runs_along(dvec3 u, dvec3 v) {
  dvec3 w = cross(u, v);
  return dot(w, w) < ALONG_SINE * ALONG_SINE;
}

// The part where value + rise t ≥ 0.
void keep_part(double value, double rise, inout double low, inout double high) {
  if (rise > 0) low = max(low, -value / rise);
  if (rise < 0) high = min(high, -value / rise);
  if (rise == 0 && value < 0) high = low;
}

// Fills `side_place`; returns how many.
int side_by_side(EdgeLine a, EdgeLine b, double slack, double shortest) {
  dvec3 u = a.direction, v = b.direction, w = b.middle - a.middle;
  if (!runs_along(u, v)) return 0;
  double uv = dot(u, v), s_0 = dot(u, w);
  dvec3 g_0 = w - s_0 * u, slope = v - uv * u;
  double low = -b.half_length, high = b.half_length;
  keep_part(a.half_length + s_0, uv, low, high);
  keep_part(a.half_length - s_0, -uv, low, high);
  keep_part(-dot(a.into_0, g_0), -dot(a.into_0, slope), low, high);
  keep_part(-dot(a.into_1, g_0), -dot(a.into_1, slope), low, high);
  keep_part(dot(b.into_0, g_0), dot(b.into_0, slope), low, high);
  keep_part(dot(b.into_1, g_0), dot(b.into_1, slope), low, high);
  if (!(high - low > shortest)) return 0;

  double middle = 0.5lf * (low + high), half_part = 0.5lf * (high - low);
  int count = 0;
  double t = low;
  for (int k = 0; k < 3; ++k) {
    dvec3 g = g_0 + t * slope;
    double apart = sqrt(dot(g, g));
    if (apart > 1e-12lf * (a.half_length + b.half_length)) {
      int where = k == 2 ? SIDE_NEAREST : (k == 0) == (uv > 0) ? SIDE_LOW : SIDE_HIGH;
      side_place[count] = SidePlace(where, b.middle + t * v, g / apart, apart, t);
      ++count;
    }
    if (k == 0) t = high;
    if (k != 1) continue;
    if (count < 2) return 0;
    double G = dot(slope, slope), A = dot(slope, g_0 + middle * slope);
    if (!(G > 0)) return count;
    dvec3 g_nearest = g_0 + (middle + clamp(-A / G, -half_part, half_part)) * slope;
    double nearest = sqrt(dot(g_nearest, g_nearest));
    if (!(nearest < min(side_place[0].apart, side_place[1].apart) - slack)) return count;
    double held = 4 * nearest * slack / (half_part * half_part);
    t = middle + clamp(-A / (G + held), -half_part, half_part);
  }
  return count;
}

double distance_to_capsule(SidePlace p, EdgeLine b, double radius) {
  double slope = dot(p.n, b.direction), cosine2 = 1 - slope * slope;
  double to_end = slope < 0 ? b.half_length - p.t : b.half_length + p.t;
  double to_side = radius / sqrt(cosine2);
  if (abs(slope) * to_side <= to_end) return p.apart - to_side;
  return p.apart - (to_end * abs(slope) + sqrt(radius * radius - to_end * to_end * cosine2));
}
