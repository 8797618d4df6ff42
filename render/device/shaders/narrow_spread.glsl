// SPDX-License-Identifier: MIT
// spread.h: a few of many points.
const int MOST_POINTS = 8, MOST_CANDIDATES = max(HULL_VERTICES, 2 * FACE_CORNERS);

wide3 candidate[MOST_CANDIDATES];
wide candidate_d[MOST_CANDIDATES];
uint candidate_name[MOST_CANDIDATES];
int chosen[MOST_POINTS];  // of the candidates

// Returns how many are chosen.
int choose_spread(int count, wide reach, wide same) {
  int few = min(count, MOST_POINTS);
  for (int k = 0; k < few; ++k) chosen[k] = k;
  if (count <= MOST_POINTS) return few;
  wide apart2[MOST_CANDIDATES];
  wide lowest = NONE;
  for (int k = 0; k < count; ++k) {
    apart2[k] = NONE;
    lowest = min(lowest, candidate_d[k]);
  }
  int next = 0;
  while (candidate_d[next] > lowest + same) ++next;
  few = 0;
  while (few < MOST_POINTS && next >= 0) {
    chosen[few] = next;
    ++few;
    apart2[next] = -wide(1.0lf);
    wide3 last = candidate[next];
    next = -1;
    wide best = 0;
    for (int k = 0; k < count; ++k) {
      wide nearest2 = apart2[k];
      if (nearest2 < 0) continue;
      wide3 between = candidate[k] - last;
      nearest2 = min(nearest2, dot(between, between));
      apart2[k] = nearest2;
      wide weight = 1 - wide(0.9lf) * (candidate_d[k] - lowest) / (reach - lowest);
      wide score = weight * weight * nearest2;
      if (next < 0 || score > best * (1 + beyond_rounding(1e-6lf))) {
        next = k;
        best = score;
      }
    }
    // next < 0: candidates that are not numbers.
  }
  return few;
}
