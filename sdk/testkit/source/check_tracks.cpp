// SPDX-License-Identifier: MIT
// One track by itself, and the tracks of a model among each other.
#include <regista/testkit/check_tracks.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <set>

namespace regista::testkit {

bool detail::is_covariance(const double (&p)[16]) {
  double scale[4], c[4][4];
  for (int i = 0; i < 4; ++i) {
    if (!(p[5 * i] >= 0.0)) return false;
    scale[i] = std::sqrt(p[5 * i]);
  }
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      const double unit = scale[i] * scale[j];
      if (unit == 0.0) {
        if (p[4 * i + j] != 0.0) return false;
        c[i][j] = i == j ? 1.0 : 0.0;
      } else {
        if (std::abs(p[4 * i + j] - p[4 * j + i]) > 1e-9 * unit) return false;
        c[i][j] = p[4 * i + j] / unit;
      }
    }
    c[i][i] += 1e-9;
  }
  for (int k = 0; k < 4; ++k) {  // Cholesky
    for (int m = 0; m < k; ++m) c[k][k] -= c[k][m] * c[k][m];
    if (!(c[k][k] > 0.0)) return false;
    c[k][k] = std::sqrt(c[k][k]);
    for (int i = k + 1; i < 4; ++i) {
      for (int m = 0; m < k; ++m) c[i][k] -= c[i][m] * c[k][m];
      c[i][k] /= c[k][k];
    }
  }
  return true;
}

namespace {

bool all_finite(const regista_track& t) {
  const double single[] = {t.x,   t.y,         t.heading,  t.vx, t.vy, t.turn_rate, t.weight, t.heading_variance,
                           t.age, t.target[0], t.target[1]};
  const auto finite = [](double value) { return std::isfinite(value); };
  return std::all_of(std::begin(single), std::end(single), finite) &&
         std::all_of(std::begin(t.covariance), std::end(t.covariance), finite);
}

}  // namespace

void check_track(const regista_track& t, Findings& f) {
  if (!all_finite(t)) return f.say("tracks: a value of a track is not finite");
  if (!(t.heading > -std::numbers::pi && t.heading <= std::numbers::pi)) {
    f.say("tracks: a heading is outside (-pi, pi]");
  }
  if (!(t.weight > 0.0 && t.weight <= 1.0)) f.say("tracks: a weight is outside (0, 1]");
  if (t.heading_variance < 0.0) f.say("tracks: a variance of the heading is negative");
  if (t.age < 0.0) f.say("tracks: an age is negative");
  if (!detail::is_covariance(t.covariance)) f.say("tracks: a covariance is not symmetric and positive semi-definite");
}

void check_tracks(const std::vector<regista_track>& tracks, std::uint32_t subject, int own_number, int team_size,
                  Findings& f) {
  std::set<std::int32_t> labels;
  for (const regista_track& t : tracks) {
    check_track(t, f);
    if (!labels.insert(t.label).second) f.say("tracks: two tracks have one label");
  }
  if (subject == REGISTA_SUBJECT_SELF && (tracks.size() != 1 || tracks.front().label != own_number)) {
    f.say("tracks: the own pose must be exactly one track, labelled with the own number");
  }
  for (std::size_t i = 1; i < tracks.size(); ++i) {
    if (subject == REGISTA_SUBJECT_BALL && tracks[i].weight > tracks[i - 1].weight) {
      f.say("tracks: the best hypothesis of the ball does not come first");
    }
    if (subject == REGISTA_SUBJECT_TEAMMATES && tracks[i].label < tracks[i - 1].label) {
      f.say("tracks: the labels of teammates do not ascend");
    }
  }
  if (subject == REGISTA_SUBJECT_TEAMMATES && !labels.empty() &&
      (*labels.begin() < 1 || *labels.rbegin() > team_size)) {
    f.say("tracks: the label of a teammate is no shirt number");
  }
}

void check_no_new_labels(const std::vector<regista_track>& before, const std::vector<regista_track>& after,
                         Findings& f) {
  for (const regista_track& t : after) {
    const bool known = std::any_of(before.begin(), before.end(), [&](const auto& b) { return b.label == t.label; });
    if (!known) f.say("predict: a label appeared although nothing was measured");
  }
}

}  // namespace regista::testkit
