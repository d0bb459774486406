// SPDX-License-Identifier: MIT
// A predictor models one part of the world (psi and delta of the paper): the own pose, the ball, the opponents, or the
// teammates. The class has
//
//   static constexpr unsigned subjects = REGISTA_SUBJECT_BALL;        what it can model, or-ed
//   void predict(double dt, const regista::Motion*, const regista::Frame* last);
//   void correct(regista::Span<regista::Measurement>, const regista::VisibleArea&);
//   void absorb(regista::Span<regista::Track>, double age);
//   void tracks(regista::Tracks out) const;                           out.add() = a track to fill in
//
// regista_environment::subject says in setup() which part this instance models.
#pragma once

#include <optional>
#include <stdexcept>

#include <regista/plugin.hpp>

namespace regista {

using Motion = regista_motion;
using Measurement = regista_measurement;
using VisibleArea = regista_visible_area;
using Track = regista_track;

// The host's buffer for the estimate.
class Tracks {
 public:
  Tracks(Track* out, std::uint32_t capacity, std::uint32_t* count) : out_(out), capacity_(capacity), count_(count) {}
  std::size_t capacity() const { return capacity_; }
  std::size_t size() const { return *count_; }
  void add(const Track& track) { next() = track; }
  // A track of zeros, to be filled in place: cheaper than a copy.
  Track& add() {
    Track& track = next();
    track = {};
    return track;
  }

 private:
  Track& next() {
    if (*count_ == capacity_) throw std::length_error("more tracks than the host has room for");
    return out_[(*count_)++];
  }

  Track* out_;
  std::uint32_t capacity_;
  std::uint32_t* count_;
};

struct predictor {
  static constexpr std::int32_t kind = REGISTA_KIND_PREDICTOR;

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
        [](void* instance, Track* out, std::uint32_t capacity, std::uint32_t* count, regista_error* error) {
          *count = 0;
          return detail::guarded(error,
                                 [&] { static_cast<const Class*>(instance)->tracks(Tracks(out, capacity, count)); });
        }};
    return &calls;
  }
};

}  // namespace regista
