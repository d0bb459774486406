// SPDX-License-Identifier: MIT
#include "config/disturbance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "config/read.hpp"
#include "config/scalar.hpp"
#include "config/team.hpp"
#include "texts/message.hpp"

namespace regista::config {
namespace {

using Kind = Incident::Kind;
using Whom = Incident::Whom;

constexpr double longest = 1e6;  // s
constexpr Range moments{0.0, longest};

int robot_number(const Node& node, const std::string& what) {
  return static_cast<int>(integer_within(node, what, {1, 22}, "robots"));
}

Whom to_whom(const Node& node, const std::string& what, Mistakes& mistakes) {
  const bool scalar = node.kind() == Node::Kind::scalar;
  if (scalar && node.text() == "all") return {Whom::Choice::all, {}};
  if (scalar && node.text() == "any") return {Whom::Choice::any, {}};
  Whom whom{Whom::Choice::listed, {}};
  if (node.kind() == Node::Kind::sequence) {
    if (node.elements().empty()) throw Error(node.where(), what + ": an empty list; leave the incident out");
    attempt_each(node, what, mistakes, [&](const Node& element, const std::string& path, std::size_t) {
      const int number = robot_number(element, path);
      if (std::ranges::find(whom.numbers, number) != whom.numbers.end()) {
        throw Error(element.where(), fmt::format("{}: {} is given twice", what, number));
      }
      whom.numbers.push_back(number);
    });
    std::ranges::sort(whom.numbers);
    return whom;
  }
  const bool number = !node.text().empty() && node.text().find_first_not_of("0123456789") == std::string::npos;
  if (!scalar || !number) refuse_kind(node, what, "all, any, a number or a list of numbers");
  whom.numbers.push_back(robot_number(node, what));
  return whom;
}

Node written(const Whom& whom) {
  if (whom.choice == Whom::Choice::all) return Node::scalar("all");
  if (whom.choice == Whom::Choice::any) return Node::scalar("any");
  return sequence_of(whom.numbers, [](int number) { return Node::scalar(fmt::format("{}", number)); });
}

std::vector<double> to_moments(const Node& node, const std::string& what, Mistakes& mistakes) {
  if (node.kind() == Node::Kind::scalar) return {real_within(node, what, moments, "s")};
  if (node.kind() != Node::Kind::sequence) refuse_kind(node, what, "a number of seconds or a list of them");
  if (node.elements().empty()) throw Error(node.where(), what + ": an empty list; leave the incident out");
  std::vector<double> times;
  attempt_each(node, what, mistakes, [&](const Node& element, const std::string& path, std::size_t) {
    times.push_back(real_within(element, path, moments, "s"));
    if (times.size() > 1 && times.back() <= times[times.size() - 2]) {
      throw Error(element.where(), what + ": the moments are not in their order");
    }
  });
  return times;
}

Node written(const std::vector<double>& times) {
  if (times.empty()) return {};
  const Node all = sequence_of(times, [](double time) { return Node::scalar(real_text(time)); });
  return times.size() == 1 ? all.elements().front() : all;
}

template <class Value>
Own own(std::string definition, Value& value, Value (*to_value)(const Node&, const std::string&, Mistakes&)) {
  const auto read = [&value, to_value](const Node& node, const std::string& what, Mistakes& mistakes) {
    value = to_value(node, what, mistakes);
  };
  return {std::move(definition), read, [&value] { return written(value); }};
}

// A value of incidents that not every kind of incident has.
struct Value {
  std::string_view key;
  std::optional<double> Incident::*member;
  std::vector<Kind> of;  // kinds that have the value
  bool needed;           // whether these kinds require the value
};

const std::vector<Value>& values() {
  static const std::vector<Value> all{
      {"x", &Incident::x, {Kind::pose_bias, Kind::ghost_ball}, false},
      {"y", &Incident::y, {Kind::pose_bias, Kind::ghost_ball}, false},
      {"heading_deg", &Incident::heading, {Kind::pose_bias}, false},
      {"delay", &Incident::delay, {Kind::radio_delay}, true},
      {"jitter", &Incident::jitter, {Kind::radio_jitter}, true},
      {"mean_good", &Incident::mean_good, {Kind::burst_loss}, false},
      {"mean_bad", &Incident::mean_bad, {Kind::burst_loss}, false},
      {"loss", &Incident::loss, {Kind::burst_loss}, false},
      {"speed", &Incident::speed, {Kind::slow_robot}, true},
  };
  return all;
}

bool among(const std::vector<Kind>& kinds, Kind kind) { return std::ranges::find(kinds, kind) != kinds.end(); }

}  // namespace

static Map declare(Burst& burst) {
  return {{
      real("mean_good", burst.mean_good, {0.01, longest}, "s", "mean time between two bursts"),
      real("mean_bad", burst.mean_bad, {0.01, longest}, "s", "mean length of a burst"),
      real("loss", burst.loss, {0, 1}, "1", "probability per packet and receiver within a burst; 0 is off"),
  }};
}

static Map declare(Disturbance::Radio& radio) {
  return {{
      real("loss", radio.loss, {0, 1}, "1", "probability per packet and receiver"),
      real("delay", radio.delay, {0, 60}, "s", "of every packet"),
      real("jitter", radio.jitter, {0, 60}, "s", "width of a uniform law on top of the delay"),
      section("burst", radio.burst, "loss in bursts, of each receiver by itself"),
      boolean("silence", radio.silence, "no packet reaches anybody"),
  }};
}

static Map declare(Disturbance::Camera& camera) {
  return {{
      real("ball_blindness", camera.ball_blindness, {0, 1}, "1", "probability that a sighting of the ball is lost"),
      real("ghost_balls", camera.ghost_balls, {0, 50}, "1/s", "false balls of each robot, anywhere in its view"),
  }};
}

static Map declare(Incident& incident) {
  return {.fields =
              {
                  name("name", incident.name, "of this incident, for paths"),
                  required(choice("kind", incident.kind, incident_kinds(), "what happens")),
                  {"robots", "whom it strikes: all, any (one drawn anew each time), a number or a list of numbers",
                   own("robots", incident.robots, to_whom)},
                  {"at", "s of match time when it begins, or a list of them", own("moments", incident.at, to_moments)},
                  real("per_hour", incident.per_hour, {0, 36000}, "1/h", "how often on average; at random"),
                  real("for", incident.duration, moments, "s", "how long; without it, to the end"),
                  real("x", incident.x, coordinates, "m", "pose_bias: along the field; ghost_ball: where"),
                  real("y", incident.y, coordinates, "m", "pose_bias: to the left; ghost_ball: where"),
                  degrees("heading_deg", incident.heading, {-180, 180}, "deg", "pose_bias: of the heading"),
                  real("delay", incident.delay, {0, 60}, "s", "radio_delay: of every packet"),
                  real("jitter", incident.jitter, {0, 60}, "s", "radio_jitter: width of a uniform law"),
                  real("mean_good", incident.mean_good, {0.01, longest}, "s", "burst_loss: mean time between bursts"),
                  real("mean_bad", incident.mean_bad, {0.01, longest}, "s", "burst_loss: mean length of a burst"),
                  real("loss", incident.loss, {0, 1}, "1", "burst_loss: probability per packet within a burst"),
                  real("speed", incident.speed, {0, 1}, "1", "slow_robot: part of the speed that is left"),
              },
          .exactly_one = {"at", "per_hour"}};
}

Map declare(Disturbance& disturbance) {
  return {{
      required(name("disturbance", disturbance.name, "name of this disturbance")),
      section("radio", disturbance.radio, "of all robots, all the time"),
      section("camera", disturbance.camera, "of all robots, all the time"),
      list("incidents", disturbance.incidents, 0, 64, "what strikes some robots at some time"),
  }};
}

const std::vector<std::string>& incident_kinds() {
  static const std::vector<std::string> names{"pose_bias",   "mirror_flip",  "ghost_ball", "blind_camera",
                                              "radio_delay", "radio_jitter", "burst_loss", "radio_silence",
                                              "crash",       "slow_robot"};
  return names;
}

std::string path_of(const Disturbance& disturbance, std::size_t incident) {
  const std::optional<std::string>& name = disturbance.incidents[incident].name;
  return name ? "incidents." + *name : fmt::format("incidents.{}", incident);
}

void check(const Disturbance& disturbance, const Node& document, Mistakes& mistakes) {
  const Refusals wrong(document, mistakes);
  for (std::size_t i = 0; i < disturbance.incidents.size(); ++i) {
    const Incident& incident = disturbance.incidents[i];
    const std::string path = fmt::format("incidents.{}", i), path_of_kind = path + ".kind";
    const std::string named = path_of(disturbance, i);
    const std::string& kind = incident_kinds()[static_cast<std::size_t>(incident.kind)];
    // The message points at the incident, because the incident lacks the key.
    const auto lacks = [&](std::string_view key, const std::string& reason) {
      const std::string missing = fmt::format("{}.{}", path, key);
      if (mistakes.doubtful(path_of_kind) || mistakes.doubtful(missing)) return;
      mistakes.attempt(missing, [&] { refuse(document, {path}, reason); });
    };
    std::vector<std::string> known;
    bool any = false;
    for (const Value& value : values()) {
      if (!among(value.of, incident.kind)) continue;
      known.emplace_back(value.key);
      any = any || incident.*value.member || mistakes.doubtful(fmt::format("{}.{}", path, value.key));
    }
    for (const Value& value : values()) {
      const bool there = (incident.*value.member).has_value();
      if (there && !among(value.of, incident.kind)) {
        wrong({fmt::format("{}.{}", path, value.key), path_of_kind},
              "{}.{}: makes no sense for {}, whose values are: {}", named, value.key, kind,
              known.empty() ? "none of its own" : texts::join(known));
      }
      if (!there && value.needed && among(value.of, incident.kind)) {
        lacks(value.key, fmt::format("missing key \"{}\" in {}", value.key, named));
      }
    }
    if (incident.kind == Kind::pose_bias && !any) {
      lacks("x", fmt::format("{}: by how much? expected {}", named, texts::join(known)));
    }
    if (incident.kind == Kind::ghost_ball && incident.x.has_value() != incident.y.has_value()) {
      lacks(incident.x ? "y" : "x", named + ": expected x and y, or neither for a place drawn at random");
    }
  }
}

void check(const Disturbance& disturbance, const Rules& rules, const Node& document) {
  Mistakes first(Mistakes::After::stop);
  const Refusals wrong(document, first);
  for (std::size_t i = 0; i < disturbance.incidents.size(); ++i) {
    for (const int number : disturbance.incidents[i].robots.numbers) {
      if (number <= rules.team_size) continue;
      wrong({fmt::format("incidents.{}.robots", i)}, "disturbance {}: {} strikes robot {}, a team has {} robots",
            disturbance.name, path_of(disturbance, i), number, rules.team_size);
    }
  }
  for (int number = 1; number <= rules.team_size; ++number) {
    int ghosts = 0;
    for (std::size_t i = 0; i < disturbance.incidents.size(); ++i) {
      const Incident& incident = disturbance.incidents[i];
      const bool listed = std::ranges::find(incident.robots.numbers, number) != incident.robots.numbers.end();
      if (incident.kind != Kind::ghost_ball) continue;
      if (incident.robots.choice == Whom::Choice::listed && !listed) continue;
      if (++ghosts <= most_ghost_balls) continue;
      wrong({fmt::format("incidents.{}", i)},
            "disturbance {}: {} is one more than the {} ghost balls that can strike robot {}", disturbance.name,
            path_of(disturbance, i), most_ghost_balls, number);
    }
  }
}

}  // namespace regista::config
