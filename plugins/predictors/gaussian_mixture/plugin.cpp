// SPDX-License-Identifier: MIT
// Glue of the predictor `gaussian_mixture`; the model is in algorithm.hpp.
#include <regista/predictor.hpp>
#include <span>

#include "algorithm.hpp"

namespace {

using gaussian_mixture::Component;
using gaussian_mixture::Sighting;

struct GaussianMixture {
  static constexpr auto id = "gaussian_mixture", version = "1.0.0",
                        summary = "Opponents: a Gaussian mixture; predict, match, merge, prune";
  static constexpr unsigned subjects = REGISTA_SUBJECT_OPPONENTS;

  static constexpr gaussian_mixture::Parameters initial{};
  double speed = initial.speed;
  double persistence = initial.persistence;
  double gate = initial.gate;
  double merge_distance = initial.merge_distance;
  double detection_probability = initial.detection_probability;
  double false_probability = initial.false_probability;
  double birth_weight = initial.birth_weight;
  double prune_weight = initial.prune_weight;
  double forget_after = initial.forget_after;

  static constexpr std::tuple parameters{
      regista::real("speed", &GaussianMixture::speed, {0.02, 10.0}, "m/s",
                    "Standard deviation of each component of an opponent's velocity; SPL teams have 0.1 to 0.4")
          .tunable()
          .log_scale(),
      regista::real("persistence", &GaussianMixture::persistence, {0.1, 20.0}, "s",
                    "Time constant with which an opponent's velocity is forgotten; assumption: a few steps of the walk")
          .tunable()
          .log_scale(),
      regista::real("gate", &GaussianMixture::gate, {1.0, 30.0}, "1",
                    "Largest squared Mahalanobis distance of a sighting to a component; 9.21 is the 0.99 quantile of "
                    "chi-square with 2 degrees of freedom")
          .tunable(),
      regista::real("merge_distance", &GaussianMixture::merge_distance, {0.0, 2.0}, "m",
                    "Components nearer than this become one, unless both were just seen; 1.1 as SPL teams have it")
          .tunable(),
      regista::real("detection_probability", &GaussianMixture::detection_probability, {0.05, 0.99}, "1",
                    "Probability that a robot in the visible area is seen; 0.6 up to 4 m by SPL detectors")
          .tunable(),
      regista::real("false_probability", &GaussianMixture::false_probability, {0.001, 0.5}, "1",
                    "Probability of a false sighting where a component is; assumption")
          .tunable()
          .log_scale(),
      regista::real("birth_weight", &GaussianMixture::birth_weight, {0.01, 0.99}, "1",
                    "Probability of existence after the first sighting; assumption")
          .tunable(),
      regista::real("prune_weight", &GaussianMixture::prune_weight, {0.001, 0.5}, "1",
                    "Components below this probability are dropped; assumption")
          .tunable()
          .log_scale(),
      regista::real("forget_after", &GaussianMixture::forget_after, {0.5, 60.0}, "s",
                    "A component unseen for longer is dropped; 8 as SPL teams have it")
          .tunable()};

  void setup(const regista::Environment& environment) {
    mixture =
        gaussian_mixture::Mixture({speed, persistence, gate, merge_distance, detection_probability, false_probability,
                                   birth_weight, prune_weight, forget_after, 2.0 * environment->robot_radius});
  }

  void reset(std::uint64_t) { mixture.reset(); }

  void predict(double dt, const regista::Motion*, const regista::Frame*) { mixture.predict(dt); }

  void correct(regista::Span<regista::Measurement> measurements, const regista::VisibleArea& area) {
    std::size_t count = 0;
    for (const regista::Measurement& each : measurements) {
      if (each.kind != REGISTA_MEASURED_ROBOT || count == seen.size()) continue;
      Sighting& sighting = seen[count++];
      sighting.position << each.position[0], each.position[1];
      sighting.covariance << each.covariance[0], each.covariance[1], each.covariance[1], each.covariance[4];
      sighting.covariance.diagonal().array() += smallest_variance;
    }
    mixture.correct(std::span(seen.data(), count), {{area.x, area.y},
                                                    {std::cos(area.heading), std::sin(area.heading)},
                                                    std::cos(std::min(area.half_angle, pi)),
                                                    area.range_robot});
  }

  void absorb(regista::Span<regista::Track> tracks, double age) {
    mixture.clear();
    for (const regista::Track& heard : tracks) {
      const auto& c = heard.covariance;
      Component component;
      component.position << heard.x, heard.y;
      component.position_covariance << c[0], c[1], c[4], c[5];
      if ((heard.flags & REGISTA_TRACK_VELOCITY) != 0) {
        component.velocity << heard.vx, heard.vy;
        component.cross << c[2], c[3], c[6], c[7];
        component.velocity_covariance << c[10], c[11], c[14], c[15];
      } else {
        component.velocity_covariance.diagonal().setConstant(speed * speed);
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
      track.x = each.position.x();
      track.y = each.position.y();
      track.vx = each.velocity.x();
      track.vy = each.velocity.y();
      for (int i = 0; i < 2; ++i) {
        for (int j = 0; j < 2; ++j) {
          track.covariance[4 * i + j] = each.position_covariance(i, j);
          track.covariance[4 * i + j + 2] = each.cross(i, j);
          track.covariance[4 * (i + 2) + j] = each.cross(j, i);
          track.covariance[4 * (i + 2) + j + 2] = each.velocity_covariance(i, j);
        }
      }
      track.weight = each.weight;
      track.age = each.age;
    }
  }

  static constexpr double pi = 3.14159265358979323846;
  static constexpr double smallest_variance = 1e-6;  // m^2: nothing is seen better than 1 mm

  gaussian_mixture::Mixture mixture;
  std::array<Sighting, 32> seen{};  // of one image; more are ignored
};

}  // namespace

REGISTA_PLUGIN(GaussianMixture, regista::predictor)
