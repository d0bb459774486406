// SPDX-License-Identifier: MIT
// One track by itself, and the tracks of a model among each other.
#include <regista/testkit/kind_checks.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <set>
#include <span>

namespace regista::testkit {

namespace {

bool is_semi_definite(const double (&p)[4][4]) {
  double scale[4], c[4][4];
  for (int i = 0; i < 4; ++i) {
    if (!(p[i][i] >= 0.0)) return false;
    scale[i] = std::sqrt(p[i][i]);
  }
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      const double unit = scale[i] * scale[j];
      if (unit == 0.0) {
        if (p[i][j] != 0.0) return false;
        c[i][j] = i == j ? 1.0 : 0.0;
      } else {
        c[i][j] = p[i][j] / unit;
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

bool all_finite(std::span<const double> values) {
  return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

bool has_pose(std::uint32_t subject) { return (subject & (REGISTA_SUBJECT_SELF | REGISTA_SUBJECT_TEAMMATES)) != 0; }

bool all_finite(const regista_track& t, std::uint32_t subject) {
  const double single[] = {t.x, t.y, t.vx, t.vy, t.weight, t.age};
  if (!all_finite(single) || !all_finite(t.covariance)) return false;
  if (!has_pose(subject)) return all_finite(t.motion);
  const regista_track_pose& p = t.pose;
  const double turned[] = {p.heading, p.turn_rate, p.heading_variance, p.velocity_variance};
  return all_finite(turned) && ((t.flags & REGISTA_TRACK_HAS_TARGET) == 0 || all_finite(p.target));
}

constexpr double farthest = 1e4;  // m, and m/s

void check_pose(const regista_track_pose& pose, Findings& f) {
  if (!(pose.heading > -std::numbers::pi && pose.heading <= std::numbers::pi)) {
    f.say("tracks: a heading is outside (-pi, pi]");
  }
  if (pose.heading_variance < 0.0) f.say("tracks: a variance of the heading is negative");
  if (pose.velocity_variance < 0.0) f.say("tracks: a variance of the velocity is negative");
}

}  // namespace

bool detail::is_covariance(const double (&place)[3]) { return is_covariance(place, {}); }

bool detail::is_covariance(const double (&p)[3], const double (&r)[7]) {
  const double all[4][4] = {
      {p[0], p[1], r[0], r[1]}, {p[1], p[2], r[2], r[3]}, {r[0], r[2], r[4], r[5]}, {r[1], r[3], r[5], r[6]}};
  return is_semi_definite(all);
}

void check_track(const regista_track& t, std::uint32_t subject, Findings& f) {
  if (!all_finite(t, subject)) return f.say("tracks: a value of a track is not finite");
  const double bounded[] = {t.x, t.y, t.vx, t.vy};
  if (std::any_of(std::begin(bounded), std::end(bounded), [](double v) { return std::abs(v) > farthest; })) {
    f.say("tracks: a place or velocity is beyond ", farthest);
  }
  if (has_pose(subject)) check_pose(t.pose, f);
  if (!(t.weight > 0.0 && t.weight <= 1.0)) f.say("tracks: a weight is outside (0, 1]");
  if (t.age < 0.0) f.say("tracks: an age is negative");
  const bool sound =
      has_pose(subject) ? detail::is_covariance(t.covariance) : detail::is_covariance(t.covariance, t.motion);
  if (!sound) f.say("tracks: a covariance is not positive semi-definite");
}

void check_tracks(const std::vector<regista_track>& tracks, std::uint32_t subject, int own_number, int team_size,
                  Findings& f) {
  std::set<std::int32_t> labels;
  for (const regista_track& t : tracks) {
    check_track(t, subject, f);
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
