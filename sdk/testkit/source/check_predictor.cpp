// SPDX-License-Identifier: MIT
// A predictor lives through measurement scenarios; what it holds is looked at after every call.
#include <regista/testkit/kind_checks.hpp>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>

#include <regista/testkit/measurement_scenario.hpp>
#include <regista/testkit/scenes.hpp>

namespace regista::testkit {

namespace {

constexpr int predictor_own = 2, predictor_team = 7;

const char* subject_name(std::uint32_t subject) {
  switch (subject) {
    case REGISTA_SUBJECT_SELF:
      return "own pose";
    case REGISTA_SUBJECT_BALL:
      return "ball";
    case REGISTA_SUBJECT_OPPONENTS:
      return "opponents";
    default:
      return "teammates";
  }
}

EnvironmentBuilder predictor_environment(std::uint32_t subject) {
  return EnvironmentBuilder{}.team_size(predictor_team).own(predictor_own).subject(subject);
}

void check_absorbed(const Tick& tick, const std::vector<regista_track>& tracks, std::uint32_t subject, Findings& f) {
  if (subject != REGISTA_SUBJECT_TEAMMATES) {
    if (tracks.size() > tick.absorbs->size()) f.say("absorb: a packet replaces the whole model, but more is there");
    return;
  }
  for (const regista_track& said : *tick.absorbs) {
    const bool there = std::any_of(tracks.begin(), tracks.end(), [&](const auto& t) { return t.label == said.label; });
    if (!there) f.say("absorb: a teammate that was heard of has no track");
  }
}

void play_tick(Instance& instance, const Tick& tick, const regista_frame* last, std::uint32_t subject,
               Findings& findings, Trail& trail) {
  const auto look = [&] {
    std::vector<regista_track> tracks = instance.tracks();
    trail.add_tracks(tracks, subject);
    check_tracks(tracks, subject, predictor_own, predictor_team, findings);
    return tracks;
  };
  const std::vector<regista_track> before = look();
  instance.predict(tick.dt, tick.motion ? &*tick.motion : nullptr, last);
  check_no_new_labels(before, look(), findings);
  if (tick.corrects) {
    instance.correct(tick.measurements, tick.area);
    look();
  }
  if (tick.absorbs) {
    instance.absorb(*tick.absorbs, tick.packet_age);
    check_absorbed(tick, look(), subject, findings);
  }
}

bool equal(const regista_track& a, const regista_track& b) {
  const auto near = [](double p, double q) { return std::abs(p - q) <= 1e-9 * std::max(1.0, std::abs(q)); };
  const auto all_near = [near](std::span<const double> p, std::span<const double> q) {
    return std::equal(p.begin(), p.end(), q.begin(), near);
  };
  if (a.label != b.label || a.flags != b.flags) return false;
  const bool aims = (a.flags & REGISTA_TRACK_HAS_TARGET) != 0;
  return near(a.x, b.x) && near(a.y, b.y) && near(a.vx, b.vx) && near(a.vy, b.vy) && near(a.weight, b.weight) &&
         near(a.age, b.age) && all_near(a.covariance, b.covariance) && near(a.pose.heading, b.pose.heading) &&
         near(a.pose.turn_rate, b.pose.turn_rate) && near(a.pose.heading_variance, b.pose.heading_variance) &&
         near(a.pose.velocity_variance, b.pose.velocity_variance) && (!aims || all_near(a.pose.target, b.pose.target));
}

// `asked` tells, `model` absorbs and predicts.
void compare_track_at(Instance& asked, Instance& model, const regista_track& told, double age, Findings& findings) {
  const std::uint32_t subject = REGISTA_SUBJECT_TEAMMATES;
  Trail before, after;
  before.add_tracks(asked.tracks(), subject);
  const regista_track answer = asked.track_at(told, age);
  after.add_tracks(asked.tracks(), subject);
  if (before != after) findings.say("track_at: changed the model");
  model.reset(1);
  model.absorb(std::span(&told, 1), 0.0);
  if (age > 0.0) model.predict(age);
  const std::vector<regista_track> tracks = model.tracks();
  if (tracks.size() != 1 || !equal(answer, tracks.front())) {
    findings.say("track_at: is not what the model holds that absorbed the same and predicted");
  }
}

regista_track only_track(Instance& instance) {
  const std::vector<regista_track> tracks = instance.tracks();
  if (tracks.size() != 1) throw CallFailed("tracks: the own pose must be exactly one track");
  return tracks.front();
}

}  // namespace

std::uint32_t detail::subjects_of(const Loaded& plugin) {
  const auto* table = static_cast<const regista_predictor*>(plugin.descriptor().table(REGISTA_KIND_PREDICTOR));
  return table == nullptr ? 0 : table->subjects;
}

bool detail::tells_track_at(const Loaded& plugin) {
  const auto* table = static_cast<const regista_predictor*>(plugin.descriptor().table(REGISTA_KIND_PREDICTOR));
  return table != nullptr && table->track_at != nullptr;
}

std::vector<Scenario> predictor_scenarios(const Loaded& plugin, const Options& options) {
  std::vector<Scenario> out;
  const Scene frame = scenes(predictor_team, options.seed).front();
  for (const std::uint32_t subject : {1u, 2u, 4u, 8u}) {
    if ((detail::subjects_of(plugin) & subject) == 0) continue;
    for (const bool observer : {true, false}) {
      if (observer ? subject == REGISTA_SUBJECT_TEAMMATES : subject == REGISTA_SUBJECT_SELF) continue;
      const std::vector<Tick> scenario = measurement_scenario(subject, observer, subject + (options.seed << 8));
      Scenario r;
      r.environment = predictor_environment(subject);
      r.steps = scenario.size();
      r.name = [subject, observer](std::size_t i) {
        return std::string(subject_name(subject)) + (observer ? ", own model" : ", by packets") + ", tick " +
               std::to_string(i);
      };
      r.play = [scenario, frame, subject](Instance& instance, std::size_t i, const Showing& showing, Findings& findings,
                                          Trail& trail) {
        const Scene last = frame.shown(showing);
        play_tick(instance, scenario[i], i == 0 ? nullptr : &last.raw(), subject, findings, trail);
        if (!last.unchanged()) findings.say("predict: wrote to its input");
      };
      out.push_back(std::move(r));
    }
  }
  return out;
}

Findings check_uncertainty_grows(const Loaded& plugin, const Options& options) {
  Findings findings;
  if ((detail::subjects_of(plugin) & REGISTA_SUBJECT_SELF) == 0) return findings;
  Scenario scenario;
  scenario.environment = predictor_environment(REGISTA_SUBJECT_SELF);
  return detail::everywhere(plugin, options, {scenario},
                            [&plugin](const Corner& corner, const Scenario& r, Findings& f) {
                              for (const double ahead : {0.0, 0.025}) {
                                Instance instance(plugin, r.environment, corner.values);
                                regista_measurement placed{};
                                placed.kind = REGISTA_MEASURED_POSE;
                                placed.position[0] = -2.0;
                                placed.heading = 0.4;
                                for (const std::size_t i : {0u, 2u, 5u}) placed.covariance[i] = 0.01;
                                const regista_visible_area area{-2.0, 0.0, 0.4, 0.48, 5.0, 4.0};
                                instance.correct(std::vector{placed}, area);
                                const regista_motion motion{ahead, 0.0, 0.0};
                                f.where(corner.name, ahead == 0.0 ? "standing" : "walking straight ahead");
                                regista_track before = only_track(instance);
                                for (int tick = 0; tick < 100; ++tick) {
                                  instance.predict(0.1, &motion);
                                  const regista_track after = only_track(instance);
                                  const double position_before = before.covariance[0] + before.covariance[2];
                                  const double position_after = after.covariance[0] + after.covariance[2];
                                  if (position_after < position_before * (1.0 - 1e-9))
                                    f.say("predict: the own position became surer by itself");
                                  if (after.pose.heading_variance < before.pose.heading_variance * (1.0 - 1e-9)) {
                                    f.say("predict: the own heading became surer by itself");
                                  }
                                  before = after;
                                }
                              }
                            });
}

Findings check_track_at(const Loaded& plugin, const Options& options) {
  Scenario teammates;
  teammates.environment = predictor_environment(REGISTA_SUBJECT_TEAMMATES);
  const std::vector<Tick> scenario = measurement_scenario(REGISTA_SUBJECT_TEAMMATES, false, REGISTA_SUBJECT_TEAMMATES);
  return detail::everywhere(plugin, options, {teammates}, [&](const Corner& corner, const Scenario& r, Findings& f) {
    Instance asked(plugin, r.environment, corner.values), model(plugin, r.environment, corner.values);
    for (std::size_t i = 0; i < scenario.size(); ++i) {
      if (!scenario[i].absorbs) continue;
      for (const regista_track& told : *scenario[i].absorbs) {
        for (const double age : {0.0, 0.1, 1.7, 30.0}) {
          f.where(corner.name, "packet of tick " + std::to_string(i) + ", " + std::to_string(age) + " s later");
          compare_track_at(asked, model, told, age, f);
        }
      }
      asked.absorb(*scenario[i].absorbs, scenario[i].packet_age);
    }
  });
}

Findings check_labels_are_stable(const Loaded& plugin, const Options& options) {
  Findings findings;
  if ((detail::subjects_of(plugin) & REGISTA_SUBJECT_OPPONENTS) == 0) return findings;
  Values values(plugin);
  options.base(values);
  Instance instance(plugin, predictor_environment(REGISTA_SUBJECT_OPPONENTS), values);
  const regista_motion stands{};
  const regista_visible_area area{-3.0, 0.0, 0.0, 0.9, 8.0, 8.0};
  std::vector<regista_measurement> seen(2);
  for (std::size_t k = 0; k < 2; ++k) {
    seen[k].kind = REGISTA_MEASURED_ROBOT;
    seen[k].position[0] = 1.0;
    seen[k].position[1] = k == 0 ? -2.0 : 2.0;
    seen[k].covariance[0] = seen[k].covariance[2] = 0.02;
  }
  std::int32_t labels[2] = {0, 0};
  for (int tick = 0; tick < 60; ++tick) {
    std::swap(seen[0], seen[1]);  // the order of measurements says nothing
    instance.predict(0.1, &stands);
    instance.correct(seen, area);
    const std::vector<regista_track> tracks = instance.tracks();
    for (int k = 0; k < 2; ++k) {
      const double y = k == 0 ? -2.0 : 2.0;
      const auto nearest = std::min_element(tracks.begin(), tracks.end(), [y](const auto& a, const auto& b) {
        return std::hypot(a.x - 1.0, a.y - y) < std::hypot(b.x - 1.0, b.y - y);
      });
      if (tick < 10) {
        if (nearest != tracks.end()) labels[k] = nearest->label;
      } else if (nearest == tracks.end() || nearest->label != labels[k] || std::abs(nearest->y - y) > 1.0) {
        findings.say("tracks: an opponent that stands still in view does not keep its track and label");
      }
    }
  }
  return findings;
}

}  // namespace regista::testkit
