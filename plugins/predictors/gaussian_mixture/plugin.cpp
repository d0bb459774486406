// SPDX-License-Identifier: MIT
// Glue of the predictor `gaussian_mixture`; the model is in algorithm.hpp.
#include <regista/predictor.hpp>

#include "../planar_exchange.hpp"
#include "algorithm.hpp"

namespace {

using gaussian_mixture::Component;
using gaussian_mixture::Parameters;

struct GaussianMixture {
  static constexpr auto id = "gaussian_mixture", version = "1.1.0",
                        summary = "Opponents: a Gaussian mixture; predict, match, merge, prune";
  static constexpr unsigned reads = REGISTA_READS_NOTHING;
  static constexpr unsigned subjects = REGISTA_SUBJECT_OPPONENTS;

  Parameters settings;
  static constexpr std::tuple parameters{regista::within(
      &GaussianMixture::settings,
      regista::real("speed", &Parameters::speed, {0.02, 10.0}, "m/s",
                    "Standard deviation of each component of an opponent's velocity; fitted to NAOs in matches; SPL "
                    "teams have 0.1 to 0.4")
          .tunable()
          .log_scale(),
      regista::real("persistence", &Parameters::persistence, {0.1, 20.0}, "s",
                    "Time constant with which an opponent's velocity is forgotten; fitted to NAOs in matches")
          .tunable()
          .log_scale(),
      regista::real("gate", &Parameters::gate, {1.0, 30.0}, "1",
                    "Largest squared Mahalanobis distance of a sighting to a component; 13.8 is the 0.999 quantile of "
                    "chi-square with 2 degrees of freedom")
          .tunable(),
      regista::real("merge_distance", &Parameters::merge_distance, {0.0, 2.0}, "m",
                    "Components nearer than this become one, unless both were just seen; our choice; SPL teams have "
                    "1.1")
          .tunable(),
      regista::real("detection_probability", &Parameters::detection_probability, {0.05, 0.99}, "1",
                    "Probability that a robot in the visible area is seen; 0.6 up to 4 m by SPL detectors")
          .tunable(),
      regista::real("false_probability", &Parameters::false_probability, {0.001, 0.5}, "1",
                    "Probability of a false sighting where a component is; assumption")
          .tunable()
          .log_scale(),
      regista::real("birth_weight", &Parameters::birth_weight, {0.01, 0.99}, "1",
                    "Probability of existence after the first sighting; assumption")
          .tunable(),
      regista::real("prune_weight", &Parameters::prune_weight, {0.001, 0.5}, "1",
                    "Components below this probability are dropped; assumption")
          .tunable()
          .log_scale(),
      regista::real("forget_after", &Parameters::forget_after, {0.5, 60.0}, "s",
                    "A component unseen for longer is dropped; our choice, see docs/predictors.md; SPL teams have 8")
          .tunable())};

  void setup(const regista::Environment& environment) {
    settings.body_radius = environment->robot_radius;
    mixture = gaussian_mixture::Mixture(settings);
  }

  void reset(std::uint64_t) { mixture.reset(); }

  void predict(double dt, const regista::Motion*, const regista::Frame*) { mixture.predict(dt); }

  void correct(regista::Span<regista::Measurement> measurements, const regista::VisibleArea& area) {
    const double half = std::min(area.half_angle, pi);
    mixture.correct(image.read(measurements, REGISTA_MEASURED_ROBOT, smallest_variance),
                    {{area.x, area.y},
                     {std::cos(area.heading), std::sin(area.heading)},
                     std::cos(half),
                     half < pi ? std::sin(half) : 0.0,
                     area.range_robot});
  }

  void absorb(regista::Span<regista::Track> tracks, double age) {
    mixture.clear();
    for (const regista::Track& heard : tracks) {
      Component component;
      component.state = planar::state_of(heard);
      if ((heard.flags & REGISTA_TRACK_VELOCITY) == 0) {
        stand(component.state);
        component.state.velocity_covariance.diagonal().setConstant(settings.speed * settings.speed);
      }
      component.label = heard.label;
      component.weight = heard.weight;
      component.age = heard.age;
      mixture.add(component);
    }
    if (age > 0.0) mixture.predict(age);
  }

  // All are written before the first is copied: a copy right behind the writes waits for them.
  void tracks(regista::Tracks out) const {
    for (const Component& each : mixture) {
      regista::Track& track = out.add();
      track.label = each.label;
      track.flags = mixture.velocity_believed(each) ? REGISTA_TRACK_VELOCITY : 0;
      write_position(each.state, track);
      write_velocity(each.state, track);
      track.weight = each.weight;
      track.age = each.age;
    }
  }

  static constexpr double pi = 3.14159265358979323846;
  static constexpr double smallest_variance = 1e-6;  // m^2: nothing is seen better than 1 mm

  gaussian_mixture::Mixture mixture;
  planar::Image image;
};

}  // namespace

REGISTA_PLUGIN(GaussianMixture, regista::predictor)
