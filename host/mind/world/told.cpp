// SPDX-License-Identifier: MIT
#include "mind/world/told.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace regista::mind {
namespace {

// Two robots cannot be told apart below the distance at which the fusion takes them for one (B-Human: 1.1 m).
constexpr double one_object = 1.1;
constexpr double same_object_gate = 9.21;   // chi-square, two degrees of freedom, 99 %
constexpr double least_kept_weight = 0.05;  // of what is worth keeping

// Squared Mahalanobis distance of the places, under the sum of both covariances.
double squared_mahalanobis(const regista_track& a, const regista_track& b) {
  const double xx = a.covariance[0] + b.covariance[0], xy = a.covariance[1] + b.covariance[1];
  const double yy = a.covariance[2] + b.covariance[2], dx = a.x - b.x, dy = a.y - b.y;
  const double determinant = xx * yy - xy * xy;
  return determinant > 0.0 ? (yy * dx * dx - 2.0 * xy * dx * dy + xx * dy * dy) / determinant : same_object_gate + 1.0;
}

bool nearer_than(const regista_track& a, const regista_track& b, double distance) {
  const double dx = a.x - b.x, dy = a.y - b.y;
  return dx * dx + dy * dy <= distance * distance;
}

bool may_have_looked_at(const SenderView& sender, const regista_track& track) {
  const Vector2d arm(track.x - sender.pose.x, track.y - sender.pose.y);
  return arm.squaredNorm() <= sender.range * sender.range &&
         std::abs(wrap(angle_of(arm) - sender.pose.heading)) <= sender.half_angle;
}

// What is left of the probability of a track that the sender did not tell.
double weight_untold(const regista_track& track, const SenderView& sender) {
  if (!sender.tells_all) return track.weight;
  if (track.age < sender.tells_up_to) return 0.0;  // it would have told it, did it still believe it
  if (!may_have_looked_at(sender, track)) return track.weight;
  return track.weight * (1.0 - sender.probability) / (1.0 - track.weight * sender.probability);
}

}  // namespace

void merge_told(std::span<const regista_track> known, std::span<const regista_track> told, const SenderView& sender,
                std::vector<regista_track>& out) {
  out.assign(told.begin(), told.end());
  // Least distance first: a track is continued by the nearest told one that nothing nearer has continued.
  std::int32_t fresh = 0;
  for (const regista_track& each : known) fresh = std::max(fresh, each.label);
  std::uint64_t continued = 0, continuing = 0;  // bits; predictors have fewer tracks
  const auto has = [](std::uint64_t bits, std::size_t i) { return (bits >> i & 1u) != 0; };
  const std::size_t known_count = std::min<std::size_t>(known.size(), 64),
                    told_count = std::min<std::size_t>(told.size(), 64);
  for (;;) {
    double least = same_object_gate;
    std::optional<std::pair<std::size_t, std::size_t>> pair;
    for (std::size_t i = 0; i < known_count; ++i) {
      for (std::size_t j = 0; j < told_count; ++j) {
        if (has(continued, i) || has(continuing, j)) continue;
        const double d2 = squared_mahalanobis(known[i], told[j]);
        if (d2 > least || (d2 == least && pair)) continue;
        least = d2;
        pair = {i, j};
      }
    }
    if (!pair) break;
    continued |= std::uint64_t{1} << pair->first;
    continuing |= std::uint64_t{1} << pair->second;
    out[pair->second].label = known[pair->first].label;
  }
  for (std::size_t j = 0; j < told_count; ++j) {
    if (!has(continuing, j)) out[j].label = ++fresh;
  }
  for (std::size_t i = 0; i < known_count; ++i) {
    if (has(continued, i)) continue;
    if (std::ranges::any_of(told, [&](const regista_track& each) { return nearer_than(each, known[i], one_object); }))
      continue;
    const double weight = weight_untold(known[i], sender);
    if (weight < least_kept_weight) continue;
    out.push_back(known[i]);
    out.back().weight = weight;
  }
}

}  // namespace regista::mind
