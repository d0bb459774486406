// SPDX-License-Identifier: MIT
// A predictor models one part of the world (psi and delta of the paper): the own pose, the ball, the opponents, or the
// teammates. The class has
//
//   static constexpr unsigned subjects = REGISTA_SUBJECT_BALL;        what it can model, or-ed
//   void predict(double dt, const regista::Motion*, const regista::Frame* last);
//   void correct(regista::Span<regista::Measurement>, const regista::VisibleArea&);
//   void absorb(regista::Span<regista::Track>, double age);
//   void tracks(regista::Tracks out) const;                           out.add() = a track to fill in
//   regista::Track track_at(const regista::Track& told, double age) const;      optional, see abi.h
//
// regista_environment::subject says in setup() which part this instance models.
#pragma once

#include <concepts>
#include <optional>

#include <regista/plugin.hpp>

namespace regista {

using Motion = regista_motion;
using Measurement = regista_measurement;
using VisibleArea = regista_visible_area;
using Track = regista_track;

// The host's room for the estimate.
class Tracks {
 public:
  explicit Tracks(regista_room& raw) : room_(raw) {}
  std::size_t capacity() const { return room_.capacity(); }
  std::size_t size() const { return room_.size(); }
  void add(const Track& track) { room_.add("tracks") = track; }
  // A track of zeros, to be filled in place: cheaper than a copy. The fields are set one by one, because compilers make
  // `track = {}` a string instruction that takes longer than all the rest of a predictor's answer.
  Track& add() {
    Track& track = room_.add("tracks");
    track.label = 0;
    track.flags = 0;
    track.x = track.y = track.vx = track.vy = track.weight = track.age = 0.0;
    auto& place = track.covariance;
    place[0] = place[1] = place[2] = 0.0;
    auto& rest = track.motion;
    rest[0] = rest[1] = rest[2] = rest[3] = rest[4] = rest[5] = rest[6] = 0.0;
    return track;
  }

 private:
  Room<Track> room_;
};

#pragma GCC visibility push(hidden)  // see plugin.hpp
struct predictor {
  static constexpr std::int32_t kind = REGISTA_KIND_PREDICTOR;

  using TrackAt = std::int32_t (*)(void*, const Track*, double, Track*, regista_error*);

  template <class Class>
  static constexpr TrackAt track_at() {
    if constexpr (requires(const Class& plugin, const Track& told) {
                    { plugin.track_at(told, 0.0) } -> std::convertible_to<Track>;
                  }) {
      return [](void* instance, const Track* told, double age, Track* out, regista_error* error) {
        return detail::guarded(error, [&] { *out = static_cast<const Class*>(instance)->track_at(*told, age); });
      };
    } else {
      return nullptr;
    }
  }

  template <class Class>
  static const void* table() {
    static constexpr regista_predictor calls{
        sizeof(regista_predictor),
        Class::subjects,
        [](void* instance, double dt, const Motion* motion, const regista_frame* last, regista_error* error) {
          return detail::guarded(error, [&] {
            const std::optional<Frame> frame = last ? std::optional<Frame>(Frame(*last)) : std::nullopt;
            static_cast<Class*>(instance)->predict(dt, motion, frame ? &*frame : nullptr);
          });
        },
        [](void* instance, regista_span measurements, const VisibleArea* area, regista_error* error) {
          return detail::guarded(
              error, [&] { static_cast<Class*>(instance)->correct(Span<Measurement>(measurements), *area); });
        },
        [](void* instance, regista_span tracks, double age, regista_error* error) {
          return detail::guarded(error, [&] { static_cast<Class*>(instance)->absorb(Span<Track>(tracks), age); });
        },
        [](void* instance, regista_room* out, regista_error* error) {
          return detail::guarded(error, [&] { static_cast<const Class*>(instance)->tracks(Tracks(*out)); });
        },
        track_at<Class>()};
    return &calls;
  }
};
#pragma GCC visibility pop

}  // namespace regista
