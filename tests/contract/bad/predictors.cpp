// SPDX-License-Identifier: MIT
// Predictors that break one promise each.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "bad.hpp"

namespace {

using regista::Measurement;
using regista::Motion;
using regista::Span;
using regista::Track;
using regista::Tracks;
using regista::VisibleArea;

// Of a ball or an opponent.
Track sound(int label, double x = 0.0, double y = 0.0) {
  Track t{};
  t.label = label;
  t.x = x;
  t.y = y;
  for (const std::size_t i : {0u, 2u}) t.covariance[i] = 0.1;
  for (const std::size_t i : {4u, 6u}) t.motion[i] = 0.1;
  t.weight = 1.0;
  return t;
}
// Of a robot of the own team.
Track sound_pose(int label) {
  Track t = sound(label);
  t.pose = {0.0, 0.0, 0.1, 0.1, {0.0, 0.0}};
  return t;
}

// A sound model of the own pose that knows nothing; the plugins below spoil what it shows.
template <unsigned Subjects>
struct Ignorant : bad::Described {
  static constexpr unsigned subjects = Subjects;
  int own = 0;
  void setup(const regista::Environment& environment) { own = environment->own_number; }
  void predict(double, const Motion*, const regista::Frame*) {}
  void correct(Span<Measurement>, const VisibleArea&) {}
  void absorb(Span<Track>, double) {}
};
using Self = Ignorant<REGISTA_SUBJECT_SELF>;
using Opponents = Ignorant<REGISTA_SUBJECT_OPPONENTS>;

// One track of the own pose, spoilt by `spoil`.
template <class Spoil>
void show(const Self& self, Tracks out, Spoil spoil) {
  Track t = sound_pose(self.own);
  spoil(t);
  out.add(t);
}

struct NanTrack : Self {
  static constexpr auto id = "nan_track";
  void tracks(Tracks out) const {
    show(*this, out, [](Track& t) { t.vy = std::numeric_limits<double>::quiet_NaN(); });
  }
};
struct IndefiniteCovariance : Self {
  static constexpr auto id = "indefinite_covariance";
  void tracks(Tracks out) const {
    show(*this, out, [](Track& t) { t.covariance[1] = 0.11; });
  }
};
// Sound as a place, and as a velocity, but not together.
struct IndefiniteMotion : Ignorant<REGISTA_SUBJECT_BALL> {
  static constexpr auto id = "indefinite_motion";
  void tracks(Tracks out) const {
    Track t = sound(1);
    t.motion[2] = 0.11;
    out.add(t);
  }
};
struct TooFar : Self {
  static constexpr auto id = "too_far";
  void tracks(Tracks out) const {
    show(*this, out, [](Track& t) { t.x = 1.1e4; });
  }
};
struct NegativeVariance : Self {
  static constexpr auto id = "negative_variance";
  void tracks(Tracks out) const {
    show(*this, out, [](Track& t) { t.pose.heading_variance = -0.1; });
  }
};
struct NegativeVelocityVariance : Self {
  static constexpr auto id = "negative_velocity_variance";
  void tracks(Tracks out) const {
    show(*this, out, [](Track& t) { t.pose.velocity_variance = -0.1; });
  }
};
struct FullTurn : Self {
  static constexpr auto id = "full_turn";
  void tracks(Tracks out) const {
    show(*this, out, [](Track& t) { t.pose.heading = -std::numbers::pi; });
  }
};
struct NoWeight : Self {
  static constexpr auto id = "no_weight";
  void tracks(Tracks out) const {
    show(*this, out, [](Track& t) { t.weight = 0.0; });
  }
};
struct FromTheFuture : Self {
  static constexpr auto id = "from_the_future";
  void tracks(Tracks out) const {
    show(*this, out, [](Track& t) { t.age = -0.1; });
  }
};
struct NobodySelf : Self {
  static constexpr auto id = "nobody_self";
  void tracks(Tracks) const {}
};
struct SomeoneElse : Self {
  static constexpr auto id = "someone_else";
  void tracks(Tracks out) const { out.add(sound_pose(own + 1)); }
};
// Surer and surer without having seen anything.
struct SelfConfident : Self {
  static constexpr auto id = "self_confident";
  double variance = 0.1;
  void reset(std::uint64_t) { variance = 0.1; }
  void predict(double, const Motion*, const regista::Frame*) { variance *= 0.99; }
  void correct(Span<Measurement>, const VisibleArea&) { variance = 0.1; }
  void tracks(Tracks out) const {
    show(*this, out, [this](Track& t) { t.covariance[0] = t.covariance[2] = variance; });
  }
};
struct SureOfHeading : Self {
  static constexpr auto id = "sure_of_heading";
  double variance = 0.1;
  void reset(std::uint64_t) { variance = 0.1; }
  void predict(double, const Motion*, const regista::Frame*) { variance *= 0.99; }
  void correct(Span<Measurement>, const VisibleArea&) { variance = 0.1; }
  void tracks(Tracks out) const {
    show(*this, out, [this](Track& t) { t.pose.heading_variance = variance; });
  }
};
struct SameLabels : Opponents {
  static constexpr auto id = "same_labels";
  void tracks(Tracks out) const {
    out.add(sound(1));
    out.add(sound(1, 1.0));
  }
};
// Names what it sees anew each time.
struct Renames : Opponents {
  static constexpr auto id = "renames";
  int next = 0;
  std::vector<Track> now;
  void reset(std::uint64_t) {
    next = 0;
    now.clear();
  }
  void correct(Span<Measurement> seen, const VisibleArea&) {
    now.clear();
    for (const Measurement& m : seen) now.push_back(sound(++next, m.position[0], m.position[1]));
  }
  void absorb(Span<Track>, double) { now.clear(); }
  void tracks(Tracks out) const {
    for (std::size_t k = 0; k < std::min(now.size(), out.capacity()); ++k) out.add(now[k]);
  }
};
struct Invents : Opponents {
  static constexpr auto id = "invents";
  int next = 1;
  void reset(std::uint64_t) { next = 1; }
  void predict(double, const Motion*, const regista::Frame*) { ++next; }
  void tracks(Tracks out) const { out.add(sound(next)); }
};
struct KeepsAfterAbsorb : Opponents {
  static constexpr auto id = "keeps_after_absorb";
  void tracks(Tracks out) const {
    for (int label = 1; label <= 7; ++label) out.add(sound(label));
  }
};
struct TooManyTracks : Opponents {
  static constexpr auto id = "too_many_tracks";
  std::size_t seen = 0;
  void reset(std::uint64_t) { seen = 0; }
  void correct(Span<Measurement> measured, const VisibleArea&) { seen += measured.size(); }
  void tracks(Tracks out) const {
    for (std::size_t k = 0; k < seen; ++k) out.add(sound(static_cast<int>(k)));
  }
};
struct WorstFirst : Ignorant<REGISTA_SUBJECT_BALL> {
  static constexpr auto id = "worst_first";
  void tracks(Tracks out) const {
    Track likely = sound(1), unlikely = sound(2, 1.0);
    likely.weight = 0.9;
    unlikely.weight = 0.1;
    out.add(unlikely);
    out.add(likely);
  }
};
struct DescendingLabels : Ignorant<REGISTA_SUBJECT_TEAMMATES> {
  static constexpr auto id = "descending_labels";
  void tracks(Tracks out) const {
    for (int label = 7; label >= 1; --label) out.add(sound_pose(label));
  }
};
struct StrangeTeammate : Ignorant<REGISTA_SUBJECT_TEAMMATES> {
  static constexpr auto id = "strange_teammate";
  void tracks(Tracks out) const {
    for (int label = 1; label <= 8; ++label) out.add(sound_pose(label));
  }
};
struct DeafToTeammates : Ignorant<REGISTA_SUBJECT_TEAMMATES> {
  static constexpr auto id = "deaf_to_teammates";
  void tracks(Tracks) const {}
};
struct CountsTracks : Opponents {
  static constexpr auto id = "counts_tracks";
  void tracks(Tracks out) const {
    static int calls = 0;
    out.add(sound(1, 1e-3 * ++calls));
  }
  void absorb(Span<Track>, double) {}
};
// Sound but for elements that are longer than it knows.
struct StepsByTrackSize : Opponents {
  static constexpr auto id = "steps_by_track_size";
  std::vector<Track> now;
  void reset(std::uint64_t) { now.clear(); }
  void absorb(Span<Track> said, double) {
    now.clear();
    if (said.empty()) return;
    const Track* first = &said[0];
    for (std::size_t k = 0; k < said.size(); ++k) {
      Track t = first[k];
      if (!(t.weight > 0.0)) t = sound(t.label);
      t.label = static_cast<int>(k);
      now.push_back(t);
    }
  }
  void tracks(Tracks out) const {
    for (const Track& t : now) out.add(t);
  }
};
// Takes the room for an array of what it knows.
struct StepsByTrackRoom : Ignorant<REGISTA_SUBJECT_BALL> {
  static constexpr auto id = "steps_by_track_room";
};
struct careless_predictor {
  static constexpr std::int32_t kind = REGISTA_KIND_PREDICTOR;
  template <class Class>
  static const void* table() {
    static const regista_predictor calls = [] {
      struct Shown : Class {
        void tracks(Tracks) const {}
      };
      regista_predictor out = *static_cast<const regista_predictor*>(regista::predictor::table<Shown>());
      out.tracks = [](void*, regista_room* room, regista_error*) -> std::int32_t {
        auto* const tracks = static_cast<Track*>(room->data);
        tracks[0] = sound(1);
        tracks[1] = sound(2);
        room->count = 2;
        return REGISTA_OK;
      };
      return out;
    }();
    return &calls;
  }
};

// Teammates stand where they said, and so they are told of later; what is told, the plugins below spoil.
struct Standing : Ignorant<REGISTA_SUBJECT_TEAMMATES> {
  std::vector<Track> now;
  void reset(std::uint64_t) { now.clear(); }
  void predict(double dt, const Motion*, const regista::Frame*) {
    for (Track& t : now) t = later(t, dt);
  }
  void absorb(Span<Track> said, double age) {
    for (const Track& told : said) {
      const auto place = std::find_if(now.begin(), now.end(), [&](const Track& t) { return t.label >= told.label; });
      if (place != now.end() && place->label == told.label) {
        *place = later(told, age);
      } else {
        now.insert(place, later(told, age));
      }
    }
  }
  void tracks(Tracks out) const {
    for (const Track& t : now) out.add(t);
  }
  static Track later(Track t, double age) {
    t.age += age;
    t.covariance[0] += 0.01 * age;
    return t;
  }
};
struct ForgetsTheAge : Standing {
  static constexpr auto id = "forgets_the_age";
  Track track_at(const Track& told, double) const { return told; }
};
struct ForgetsTheTarget : Standing {
  static constexpr auto id = "forgets_the_target";
  Track track_at(const Track& told, double age) const {
    Track t = later(told, age);
    t.pose.target[1] += 1e-6;
    return t;
  }
};
struct ChangesTheModel : Standing {
  static constexpr auto id = "changes_the_model";
  mutable int asked = 0;
  void reset(std::uint64_t seed) {
    Standing::reset(seed);
    asked = 0;
  }
  Track track_at(const Track& told, double age) const { return ++asked, later(told, age); }
  void tracks(Tracks out) const {
    for (Track t : now) {
      t.weight /= 1.0 + asked;
      out.add(t);
    }
  }
};

}  // namespace

REGISTA_PLUGINS(
    regista::Plugin<NanTrack, regista::predictor>, regista::Plugin<IndefiniteCovariance, regista::predictor>,
    regista::Plugin<IndefiniteMotion, regista::predictor>, regista::Plugin<TooFar, regista::predictor>,
    regista::Plugin<NegativeVelocityVariance, regista::predictor>,
    regista::Plugin<NegativeVariance, regista::predictor>, regista::Plugin<FullTurn, regista::predictor>,
    regista::Plugin<NoWeight, regista::predictor>, regista::Plugin<FromTheFuture, regista::predictor>,
    regista::Plugin<NobodySelf, regista::predictor>, regista::Plugin<SomeoneElse, regista::predictor>,
    regista::Plugin<SelfConfident, regista::predictor>, regista::Plugin<SureOfHeading, regista::predictor>,
    regista::Plugin<SameLabels, regista::predictor>, regista::Plugin<Renames, regista::predictor>,
    regista::Plugin<Invents, regista::predictor>, regista::Plugin<KeepsAfterAbsorb, regista::predictor>,
    regista::Plugin<TooManyTracks, regista::predictor>, regista::Plugin<WorstFirst, regista::predictor>,
    regista::Plugin<DescendingLabels, regista::predictor>, regista::Plugin<StrangeTeammate, regista::predictor>,
    regista::Plugin<DeafToTeammates, regista::predictor>, regista::Plugin<CountsTracks, regista::predictor>,
    regista::Plugin<StepsByTrackSize, regista::predictor>, regista::Plugin<StepsByTrackRoom, careless_predictor>,
    regista::Plugin<ForgetsTheAge, regista::predictor>, regista::Plugin<ForgetsTheTarget, regista::predictor>,
    regista::Plugin<ChangesTheModel, regista::predictor>)
