// SPDX-License-Identifier: MIT
#include "plugin/predictor.hpp"

#include <fmt/format.h>

#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

namespace regista::plugin {
namespace {

constexpr double largest_number = std::numeric_limits<double>::max();

bool has_pose(std::uint32_t subject) { return subject == REGISTA_SUBJECT_SELF || subject == REGISTA_SUBJECT_TEAMMATES; }

// Returns a word whose sign bit is set if |value| >= 2^exponent or value is NaN. Faster than a comparison of numbers.
template <int exponent>
std::uint64_t beyond(double value) {
  constexpr std::uint64_t sign = std::uint64_t{1} << 63;
  return (std::bit_cast<std::uint64_t>(value) & ~sign) + (std::uint64_t{1024 - exponent + 1} << 52);
}

// Quick checks of the fields of a track and of its pose. The result is true for nearly all valid tracks and false for
// all invalid tracks. One branch on this result replaces twenty branches.
bool clearly_sound(const regista_track& t) {
  constexpr int near = 13;  // 8192, a little less than farthest
  static_assert(1 << near <= farthest);
  constexpr std::uint64_t one = std::bit_cast<std::uint64_t>(1.0);
  const auto weight = std::bit_cast<std::uint64_t>(t.weight), age = std::bit_cast<std::uint64_t>(t.age);
  const std::uint64_t place = beyond<near>(t.x) | beyond<near>(t.y) | beyond<near>(t.vx) | beyond<near>(t.vy);
  const std::uint64_t certainty = (weight - 1) | (one - weight);  // has the sign bit set for a weight of 0 or above 1
  return static_cast<std::int64_t>(place | certainty | age | beyond<1024>(t.age)) >= 0;
}
bool clearly_sound(const regista_track& t, const regista_track_pose& pose) {
  const bool has_target = (t.flags & REGISTA_TRACK_HAS_TARGET) != 0;
  const double heading = std::abs(pose.heading), turn_rate = std::abs(pose.turn_rate),
               target_x = std::abs(pose.target[0]), target_y = std::abs(pose.target[1]);
  const bool turned = (heading <= std::numbers::pi) & (turn_rate <= largest_number);
  const bool certain = (pose.heading_variance >= 0.0) & (pose.heading_variance <= largest_number) &
                       (pose.velocity_variance >= 0.0) & (pose.velocity_variance <= largest_number);
  const bool aimed = (!has_target) | ((target_x <= largest_number) & (target_y <= largest_number));
  return turned & certain & aimed & clearly_definite(t.covariance);
}

void note_answer(const Instance& instance, std::span<const regista_track> tracks, bool poses) {
  if (!instance.is_traced()) [[likely]]
    return;
  AnswerDigest rest;
  for (const regista_track& each : tracks) {
    if (!poses) {
      rest(each.motion);
      continue;
    }
    rest(each.pose.heading, each.pose.turn_rate, each.pose.heading_variance, each.pose.velocity_variance);
    if ((each.flags & REGISTA_TRACK_HAS_TARGET) != 0) rest(each.pose.target);
  }
  instance.answered(tracks, rest.value());
}

void check(const Instance& instance, const regista_track& t, bool has_pose) {
  const auto wrong = [&](const char* what, double value) {
    instance.fail("tracks", "{} of label {} is {}", what, t.label, value);
  };
  struct Field {
    const char* name;
    double value;
  };
  const bool has_target = has_pose && (t.flags & REGISTA_TRACK_HAS_TARGET) != 0;
  const regista_track_pose pose = has_pose ? t.pose : regista_track_pose{};
  for (const Field& field : {Field{"x", t.x},
                             {"y", t.y},
                             {"heading", pose.heading},
                             {"vx", t.vx},
                             {"vy", t.vy},
                             {"turn rate", pose.turn_rate},
                             {"heading variance", pose.heading_variance},
                             {"velocity variance", pose.velocity_variance},
                             {"weight", t.weight},
                             {"age", t.age},
                             {"x of the target", has_target ? pose.target[0] : 0.0},
                             {"y of the target", has_target ? pose.target[1] : 0.0}}) {
    if (!std::isfinite(field.value)) wrong(field.name, field.value);
  }
  for (const Field& field : {Field{"x", t.x}, {"y", t.y}, {"vx", t.vx}, {"vy", t.vy}}) {
    if (std::abs(field.value) > farthest) wrong(field.name, field.value);
  }
  if (std::abs(pose.heading) > std::numbers::pi) wrong("heading", pose.heading);
  if (pose.heading_variance < 0.0) wrong("heading variance", pose.heading_variance);
  if (pose.velocity_variance < 0.0) wrong("velocity variance", pose.velocity_variance);
  if (!(t.weight > 0.0 && t.weight <= 1.0)) wrong("weight", t.weight);
  if (t.age < 0.0) wrong("age", t.age);
  switch (has_pose ? examine_covariance(t.covariance) : examine_covariance(t.covariance, t.motion)) {
    case Covariance::valid:
      return;
    case Covariance::not_finite:
      instance.fail("tracks", "covariance of label {} is not finite", t.label);
    case Covariance::not_semi_definite:
      instance.fail("tracks", "covariance of label {} is not positive semi-definite", t.label);
  }
}

void check_together(const Instance& instance, std::span<const regista_track> tracks) {
  const regista_environment& environment = instance.environment();
  switch (environment.subject) {
    case REGISTA_SUBJECT_SELF:
      if (tracks.size() != 1 || tracks[0].label != environment.own_number) [[unlikely]] {
        const std::string first = tracks.empty() ? "" : fmt::format(", the first with label {}", tracks[0].label);
        instance.fail("tracks", "self is one track with label {}; there are {}{}", environment.own_number,
                      tracks.size(), first);
      }
      return;
    case REGISTA_SUBJECT_BALL:
      for (std::size_t i = 1; i < tracks.size(); ++i) {
        if (tracks[i].weight > tracks[0].weight) [[unlikely]] {
          instance.fail("tracks", "hypothesis {} has weight {}, the first only {}", i, tracks[i].weight,
                        tracks[0].weight);
        }
      }
      return;
    case REGISTA_SUBJECT_TEAMMATES:
      for (std::size_t i = 0; i < tracks.size(); ++i) {
        const std::int32_t label = tracks[i].label;
        if (label < 1 || static_cast<std::uint32_t>(label) > environment.team_size) [[unlikely]]
          instance.fail("tracks", "robot {} of {} does not exist", label, environment.team_size);
        if (i > 0 && label <= tracks[i - 1].label) [[unlikely]]
          instance.fail("tracks", "label {} comes after {}", label, tracks[i - 1].label);
      }
      return;
    default:
      // Labels in ascending order are unique, and most lists are in this order.
      if (std::ranges::is_sorted(tracks, std::ranges::less_equal{}, &regista_track::label)) return;
      for (std::size_t i = 1; i < tracks.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
          if (tracks[i].label == tracks[j].label) [[unlikely]]
            instance.fail("tracks", "label {} stands in tracks {} and {}", tracks[i].label, j, i);
        }
      }
  }
}

}  // namespace

Predictor::Predictor(std::shared_ptr<Instance> instance) : CallsOfKind(std::move(instance)) {
  const std::uint32_t subject = instance_->environment().subject;
  const std::size_t usual = subject == REGISTA_SUBJECT_TEAMMATES ? instance_->environment().team_size : 16;
  tracks_.reserve(subject == REGISTA_SUBJECT_SELF ? 1 : usual);  // a larger number is rare: it costs one allocation
  instance_->rooms().tracks.open(track_capacity);
  if ((calls_->subjects & subject) == 0) {
    instance_->fail("create", "models {}, not {}", subject_names(calls_->subjects),
                    subject == 0 ? "nothing" : subject_names(subject));
  }
}

void Predictor::predict(double dt, const regista_motion* motion, const regista_frame* last) {
  assert(dt > 0.0);
  instance_->call_with(
      [](Inputs& inputs, double, const regista_motion* moved, const regista_frame* before) {
        inputs.add("motion", moved);
        inputs.add("last", before);
      },
      "predict", calls_->predict, dt, motion, instance_->shown(last));
}

void Predictor::correct(std::span<const regista_measurement> measurements, const regista_visible_area& area) {
  const regista_span raw{measurements.data(), static_cast<std::uint32_t>(measurements.size()),
                         sizeof(regista_measurement)};
  instance_->call_with(
      [](Inputs& inputs, regista_span measured, const regista_visible_area* seen) {
        inputs.add("measurements", measured);
        inputs.add("area", seen);
      },
      "correct", calls_->correct, raw, &area);
}

void Predictor::absorb(std::span<const regista_track> tracks, double age) {
  assert(age >= 0.0);
  const regista_span raw{tracks.data(), static_cast<std::uint32_t>(tracks.size()), sizeof(regista_track)};
  instance_->call_with([](Inputs& inputs, regista_span heard, double) { inputs.add("tracks", heard); }, "absorb",
                       calls_->absorb, raw, age);
}

std::span<const regista_track> Predictor::tracks() {
  GuardedBuffer<regista_room>& room = instance_->rooms().track_room;
  GuardedBuffer<regista_track>& written = instance_->rooms().tracks;
  *instance_->open(room) = {instance_->open(written, track_capacity), track_capacity, 0, sizeof(regista_track), 0};
  instance_->call("tracks", calls_->tracks, room.data());
  instance_->check("tracks", Instance::Written{written, "tracks"}, Instance::Written{room, "number of tracks"});
  // Reads only the count of the struct, because the plugin may have overwritten the other members.
  const std::uint32_t count = room.data()->count;
  if (count > track_capacity) [[unlikely]]
    instance_->fail("tracks", "wrote {} tracks into room for {}", count, track_capacity);
  const std::span<const regista_track> out = written.first(count);
  const bool poses = has_pose(instance_->environment().subject);
  for (const regista_track& track : out) {
    const bool sound = poses ? clearly_sound(track) && clearly_sound(track, track.pose)
                             : clearly_sound(track) && clearly_definite(track.covariance, track.motion);
    if (!sound) [[unlikely]]
      check(*instance_, track, poses);
  }
  check_together(*instance_, out);
  note_answer(*instance_, out, poses);
  tracks_.assign(out.begin(), out.end());
  return tracks_;
}

}  // namespace regista::plugin
