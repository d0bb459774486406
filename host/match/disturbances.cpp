// SPDX-License-Identifier: MIT
#include "match/disturbances.hpp"

#include <algorithm>
#include <cmath>

#include "match/chance.hpp"
#include "match/physics_world.hpp"

namespace regista::match {
namespace {

using Kind = config::Incident::Kind;
using Choice = config::Incident::Whom::Choice;

double exponential(Chance& chance, double mean) { return -mean * std::log(1.0 - chance.uniform()); }

// Converts the profile's permanent burst loss to an incident that affects all robots and never ends.
config::Incident standing(const config::Burst& burst) {
  config::Incident incident;
  incident.kind = Kind::burst_loss;
  incident.at = {0.0};
  incident.mean_good = burst.mean_good;
  incident.mean_bad = burst.mean_bad;
  incident.loss = burst.loss;
  return incident;
}

}  // namespace

Disturbances::Disturbances(const config::Disturbance& disturbance, const config::FieldSize& field, int team_size,
                           std::uint64_t seed, Side side)
    : disturbance_(&disturbance), field_(field), team_size_(team_size), seed_(seed), side_(side), now_(at(team_size)) {
  const auto add = [&](config::Incident incident, int object) {
    const config::Burst usual;
    incident.mean_bad = incident.mean_bad.value_or(usual.mean_bad);
    incident.mean_good = incident.mean_good.value_or(usual.mean_good);
    incidents_.push_back({incident, object, never, 0, std::vector<Victim>(now_.size())});
    schedule(incidents_.back(), 0.0);
  };
  const config::Burst& burst = disturbance.radio.burst;
  if (burst.loss > 0.0) add(standing(burst), 0);
  for (std::size_t i = 0; i < disturbance.incidents.size(); ++i) {
    add(disturbance.incidents[i], static_cast<int>(i) + 1);
  }
  if (incidents_.empty() && !disturbance.radio.silence) next_ = never;
}

// Computes when the next occurrence of the incident begins. after: match time of the last occurrence, s.
void Disturbances::schedule(OngoingIncident& ongoing, double after) const {
  const config::Incident& incident = ongoing.incident;
  if (!incident.per_hour) {
    ongoing.next = ongoing.occurrence < incident.at.size() ? incident.at[ongoing.occurrence] : never;
    return;
  }
  if (*incident.per_hour <= 0.0) return;
  Chance chance(seed_, Purpose::incident_time, side_, 0, ongoing.object, ongoing.occurrence);
  ongoing.next = after + exponential(chance, 3600.0 / *incident.per_hour);
}

void Disturbances::strike(OngoingIncident& ongoing, double time) const {
  const config::Incident& incident = ongoing.incident;
  Vector ghost;
  if (incident.kind == Kind::ghost_ball) {
    if (incident.x) {
      ghost = {*incident.x, *incident.y};
    } else {
      Chance chance(seed_, Purpose::incident_place, side_, 0, ongoing.object, ongoing.occurrence);
      ghost.x = field_.length * (chance.uniform() - 0.5);
      ghost.y = field_.width * (chance.uniform() - 0.5);
    }
  }
  int drawn = 0;
  if (incident.robots.choice == Choice::any) {
    Chance chance(seed_, Purpose::incident_robot, side_, 0, ongoing.object, ongoing.occurrence);
    drawn = 1 + static_cast<int>(chance.uniform() * team_size_);
  }
  for (int number = 1; number <= team_size_; ++number) {
    const bool listed = std::ranges::find(incident.robots.numbers, number) != incident.robots.numbers.end();
    if (incident.robots.choice != Choice::all && number != drawn && !listed) continue;
    strike(ongoing, ongoing.victims[at(number - 1)], number, ghost, time);
  }
}

void Disturbances::strike(OngoingIncident& ongoing, Victim& victim, int number, Vector ghost, double time) const {
  const bool was_over = victim.until <= time;
  victim.until = ongoing.incident.duration ? time + *ongoing.incident.duration : never;
  victim.ghost = ghost;
  ++victim.strikes;
  if (ongoing.incident.kind != Kind::burst_loss || !was_over) return;
  // Draws the first state of the channel from the channel's long-term shares of good and bad time.
  const double bad = *ongoing.incident.mean_bad, good = *ongoing.incident.mean_good;
  Chance chance(seed_, Purpose::burst, side_, number, ongoing.object, victim.drawn++);
  victim.bad = !chance.bernoulli(bad / (bad + good));
  switch_channel(ongoing, victim, number, time);
}

void Disturbances::switch_channel(const OngoingIncident& ongoing, Victim& victim, int number, double time) const {
  victim.bad = !victim.bad;
  const double mean = victim.bad ? *ongoing.incident.mean_bad : *ongoing.incident.mean_good;
  Chance chance(seed_, Purpose::burst, side_, number, ongoing.object, victim.drawn++);
  victim.switches = time + exponential(chance, mean);
}

void Disturbances::afflict(const OngoingIncident& ongoing, const Victim& victim, Affliction& out) const {
  const config::Incident& incident = ongoing.incident;
  switch (incident.kind) {
    case Kind::pose_bias:
      out.bias.x += incident.x.value_or(0.0);
      out.bias.y += incident.y.value_or(0.0);
      out.bias.heading += incident.heading.value_or(0.0);
      break;
    case Kind::mirror_flip:
      out.flipped = true;
      break;
    case Kind::ghost_ball:
      if (out.ghost_count < Affliction::most_ghosts) out.ghosts[out.ghost_count++] = victim.ghost;
      break;
    case Kind::blind_camera:
      out.blind = true;
      break;
    case Kind::radio_delay:
      out.delay += *incident.delay;
      break;
    case Kind::radio_jitter:
      out.jitter += *incident.jitter;
      break;
    case Kind::burst_loss:
      if (victim.bad) out.loss = either(out.loss, incident.loss.value_or(1.0));
      break;
    case Kind::radio_silence:
      out.silent = true;
      break;
    case Kind::crash:
      out.crashed = true;
      break;
    case Kind::slow_robot:
      out.speed *= *incident.speed;
      break;
  }
}

bool Disturbances::update(double time) {
  if (time < next_ - instant) return false;
  next_ = never;
  for (Affliction& each : now_) {
    each = {};
    each.silent = disturbance_->radio.silence;
  }
  for (OngoingIncident& ongoing : incidents_) {
    while (time >= ongoing.next - instant) {
      strike(ongoing, time);
      const double began = ongoing.next;
      ++ongoing.occurrence;
      schedule(ongoing, began);
    }
    next_ = std::min(next_, ongoing.next);
    for (int number = 1; number <= team_size_; ++number) {
      Victim& victim = ongoing.victims[at(number - 1)];
      Affliction& affliction = now_[at(number - 1)];
      if (ongoing.incident.kind == Kind::mirror_flip) affliction.flips += victim.strikes;
      if (time >= victim.until - instant) {
        victim.until = -never;
        continue;
      }
      next_ = std::min(next_, victim.until);
      if (ongoing.incident.kind == Kind::burst_loss) {
        while (time >= victim.switches - instant) switch_channel(ongoing, victim, number, victim.switches);
        next_ = std::min(next_, victim.switches);
      }
      afflict(ongoing, victim, affliction);
    }
  }
  return true;
}

}  // namespace regista::match
