// SPDX-License-Identifier: MIT
// Glue of the predictor `gm_phd`; the filter is in algorithm.hpp.
#include <array>
#include <cmath>
#include <regista/predictor.hpp>
#include <span>

#include "algorithm.hpp"

namespace {

using gm_phd::Component;
using gm_phd::Parameters;
using gm_phd::Sighting;

struct GmPhd {
  static constexpr auto id = "gm_phd", version = "1.0.0",
                        summary = "Opponents: Gaussian mixture PHD filter; what is not looked at is not forgotten";
  static constexpr unsigned reads = REGISTA_READS_NOTHING;
  static constexpr unsigned subjects = REGISTA_SUBJECT_OPPONENTS;

  Parameters settings;
  double border_deviation = 0.2, told_for = 30.0;
  static constexpr std::tuple parameters{
      regista::within(
          &GmPhd::settings,
          regista::real("speed", &Parameters::speed, {0.02, 3.0}, "m/s",
                        "Standard deviation of each component of an opponent's velocity; SPL teams have 0.1 to 0.4, "
                        "Small Size robots drive at 1")
              .tunable()
              .log_scale(),
          regista::real("persistence", &Parameters::persistence, {0.1, 20.0}, "s",
                        "Time constant with which an opponent's velocity decays; 0.8 s fits Small Size League robots")
              .tunable()
              .log_scale(),
          regista::real(
              "survival", &Parameters::survival, {0.5, 1.0}, "1",
              "Probability that a robot is still on the field after one second; 0.99 as usual for PHD filters"),
          regista::real(
              "detection_probability", &Parameters::detection, {0.05, 0.999}, "1",
              "Probability that a robot in the visible area is seen in one image; 0.98 as usual for PHD filters, SPL "
              "detectors up to 4 m rather 0.6")
              .tunable(),
          regista::real("clutter_density", &Parameters::clutter_density, {1e-6, 1.0}, "1/m^2",
                        "False sightings per square metre of view and image; assumption: one in 250 images of 8 m^2")
              .tunable()
              .log_scale(),
          regista::real("birth_density", &Parameters::birth_density, {1e-6, 1.0}, "1/m^2",
                        "Robots that appear, not known before, per square metre of view and image; with it a first "
                        "sighting weighs birth_density / (birth_density + clutter_density); assumption")
              .tunable()
              .log_scale()),
      regista::real("border_deviation", &GmPhd::border_deviation, {0.0, 2.0}, "m",
                    "Standard deviation of the borders of the visible area from where they are believed to be; "
                    "assumption: the own pose's error")
          .tunable(),
      regista::within(
          &GmPhd::settings,
          regista::real(
              "gate", &Parameters::gate, {1.0, 50.0}, "1",
              "Largest squared Mahalanobis distance of a sighting to a component; 18.42 is the 0.9999 quantile "
              "of chi-square with 2 degrees of freedom"),
          regista::real("prune_weight", &Parameters::prune_weight, {1e-9, 0.01}, "1",
                        "Components of a smaller expected number of robots are dropped; 1e-5 by Vo and Ma")
              .log_scale(),
          regista::real(
              "merge_distance", &Parameters::merge_distance, {0.0, 20.0}, "1",
              "Components whose means have a smaller squared Mahalanobis distance become one; 4 by Vo and Ma"),
          regista::real("confirm_weight", &Parameters::confirm_weight, {0.01, 1.0}, "1",
                        "A component is reported once it stands for so many robots; 0.5 by Vo and Ma")
              .tunable(),
          regista::real("told_weight", &Parameters::told_weight, {1e-5, 1.0}, "1",
                        "A reported component stays reported until it stands for fewer robots than this: a few misses "
                        "are borne; assumption")
              .tunable()
              .log_scale()),
      regista::real("told_for", &GmPhd::told_for, {0.5, 600.0}, "s",
                    "A component unseen for longer is kept but not reported; assumption")
          .tunable()};

  void setup(const regista::Environment&) { filter = gm_phd::Filter(settings); }

  void reset(std::uint64_t) { filter.reset(); }

  void predict(double dt, const regista::Motion*, const regista::Frame*) { filter.predict(dt); }

  void correct(regista::Span<regista::Measurement> measurements, const regista::VisibleArea& area) {
    std::size_t count = 0;
    for (const regista::Measurement& each : measurements) {
      if (each.kind != REGISTA_MEASURED_ROBOT || count == seen.size()) continue;
      seen[count++] = {each.position[0], each.position[1], each.covariance[0] + smallest_variance, each.covariance[1],
                       each.covariance[2] + smallest_variance};
    }
    const bool all_round = area.half_angle >= pi;
    filter.correct(
        std::span(seen.data(), count),
        {area.x, area.y, std::cos(area.heading), std::sin(area.heading), all_round ? -1.0 : std::cos(area.half_angle),
         all_round ? 0.0 : std::sin(area.half_angle), area.range_robot, border_deviation * border_deviation});
  }

  void absorb(regista::Span<regista::Track> tracks, double age) {
    filter.clear();
    for (const regista::Track& heard : tracks) {
      const auto& place = heard.covariance;
      const auto& rest = heard.motion;
      Component component;
      component.x = heard.x;
      component.y = heard.y;
      component.pxx = place[0];
      component.pxy = place[1];
      component.pyy = place[2];
      if ((heard.flags & REGISTA_TRACK_VELOCITY) != 0) {
        component.vx = heard.vx;
        component.vy = heard.vy;
        component.cxx = rest[0];
        component.cxy = rest[1];
        component.cyx = rest[2];
        component.cyy = rest[3];
        component.vxx = rest[4];
        component.vxy = rest[5];
        component.vyy = rest[6];
      } else {
        component.vxx = component.vyy = settings.speed * settings.speed;
      }
      component.label = heard.label;
      component.weight = heard.weight;
      component.age = heard.age;
      filter.add(component);
    }
    if (age > 0.0) filter.predict(age);
  }

  // The heaviest come first, so that those are told for whom the host has room. All are written before the first is
  // copied: a copy right behind the writes waits for them.
  void tracks(regista::Tracks out) const {
    const auto room = static_cast<std::ptrdiff_t>(out.capacity());
    for (const Component& each :
         std::span(filter.begin(), filter.begin() + std::min(room, filter.end() - filter.begin()))) {
      if (!filter.told(each) || each.age > told_for) continue;
      regista::Track& track = out.add();
      track.label = each.label;
      track.flags = filter.velocity_believed(each) ? REGISTA_TRACK_VELOCITY : 0;
      track.x = each.x;
      track.y = each.y;
      track.vx = each.vx;
      track.vy = each.vy;
      const std::array place{each.pxx, each.pxy, each.pyy};
      const std::array rest{each.cxx, each.cxy, each.cyx, each.cyy, each.vxx, each.vxy, each.vyy};
      std::ranges::copy(place, track.covariance);
      std::ranges::copy(rest, track.motion);
      track.weight = std::min(each.weight, 1.0);
      track.age = each.age;
    }
  }

  static constexpr double pi = 3.14159265358979323846;
  static constexpr double smallest_variance = 1e-6;  // m^2: nothing is seen better than 1 mm

  gm_phd::Filter filter;
  std::array<Sighting, 32> seen{};  // of one image; more are ignored
};

}  // namespace

REGISTA_PLUGIN(GmPhd, regista::predictor)
