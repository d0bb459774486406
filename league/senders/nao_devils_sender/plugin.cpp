// SPDX-License-Identifier: MIT
// Sender plugin around algorithm.hpp. It belongs to the assigner nao_devils: an urgent offer of another plugin is a new
// map of that one.
//
// Limits of the team count what teammates told, so packets with such news say so: a segment of one byte for each kind.
// As nobody knows which news a packet will be for, there is an offer of each all the time, and one of them is granted.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <regista/choose_offers.hpp>
#include <regista/mailbox.hpp>
#include <regista/sender.hpp>

#include "algorithm.hpp"

namespace {

using nao_devils::Limit, nao_devils::News, nao_devils::Settings;

constexpr std::array<const char*, nao_devils::kinds_of_news> names{"new_map", "chaser_changed", "ball_off", "moved"};
constexpr std::uint32_t label_bytes = 3;                              // of a segment with one byte
constexpr std::array said_news{News::map, News::chaser, News::ball};  // of which limits of the team count

constexpr regista::Range seconds{0.0, 60.0}, metres{0.0, 20.0};

constexpr auto window(const char* name, Limit Settings::*limit, const char* doc) {
  return regista::within(limit, regista::real(name, &Limit::window, seconds, "s", doc).tunable());
}

struct NaoDevilsSender {
  static constexpr auto id = "nao_devils_sender", version = "1.0.0",
                        summary =
                            "A packet for a new map, a new ball chaser, the ball or the own place, each at a rate";
  static constexpr unsigned reads = REGISTA_READS_PREVIOUS;
  static constexpr auto reasons = names;

  Settings settings;
  std::string chaser = "striker";
  static constexpr std::tuple parameters{
      regista::text("chaser", &NaoDevilsSender::chaser, "Name of the role that plays the ball, in any list of roles"),
      regista::within(
          &NaoDevilsSender::settings,
          window("map_interval", &Settings::map_team, "Least time between two new maps of the team; Nao Devils: 3"),
          regista::within(
              &Settings::chaser_team,
              regista::integer("chaser_packets", &Limit::count, {1, nao_devils::Times::most}, "1",
                               "Packets of the team for a new chaser within chaser_window; Nao Devils: 3"),
              regista::real("chaser_window", &Limit::window, seconds, "s", "The time for these; Nao Devils: 4.5")),
          window("chaser_interval", &Settings::chaser_own,
                 "Least time between two such packets of this robot; Nao Devils: 5"),
          window("ball_interval", &Settings::ball_team,
                 "Least time between two packets of the team for the ball; Nao Devils: 1"),
          window("moved_interval", &Settings::moved_own,
                 "Least time between two packets of this robot for its place; Nao Devils: 1"),
          regista::real("moved_far", &Settings::moved_far, metres, "m",
                        "News is a place so far off the last one that was sent; Nao Devils: 1.2")
              .tunable(),
          regista::real("moved_near", &Settings::moved_near, metres, "m",
                        "The same of the ball chaser and near the ball; Nao Devils: 0.5")
              .tunable(),
          regista::real("moved_slow", &Settings::moved_slow, metres, "m", "The same of a slow robot; Nao Devils: 0.2")
              .tunable(),
          regista::real("near_ball", &Settings::near_ball, metres, "m", "What is near the ball; Nao Devils: 1.5"),
          regista::real("slow_speed", &Settings::slow_speed, {0.0, 5.0}, "m/s", "What is slow (assumption)"),
          regista::real("ball_off", &Settings::ball_off, metres, "m",
                        "News is a ball so far off where the team has it; Nao Devils: 1")
              .tunable(),
          regista::real("ball_lacked", &Settings::ball_lacked, seconds, "s",
                        "News is any ball when the team has heard of no sighting for so long (assumption)")
              .tunable(),
          regista::real(
              "share_at_first", &Settings::share_at_first, {0.0, 1.0}, "1",
              "Packets left at least, as a share of what even spending leaves, at the start; Nao Devils: 0.9"),
          regista::real("share_grows_in", &Settings::share_grows_in, {1.0, 10000.0}, "s",
                        "In this time that share grows by 1, up to 1; Nao Devils: 900"),
          regista::real("team_silence", &Settings::team_silence, seconds, "s",
                        "A packet may be sent in any case when the team was silent for so long; Nao Devils: 1.1")
              .tunable(),
          regista::real(
              "turn", &Settings::turn, {0.0, 5.0}, "s",
              "Robot after robot waits for so much more silence, so that they do not send at once; longer than a "
              "packet takes, and a decision (assumption)")
              .tunable(),
          regista::integer("reserve", &Settings::reserve, {0, 10000}, "1",
                           "Packets of the team at which it falls silent; Nao Devils: 5"))};

  regista::Mailbox mailbox;
  nao_devils::Sender sender;
  int own = 1, team_size = 1;
  std::vector<bool> chases;                              // by id of the role
  std::vector<double> newest;                            // when each robot told each news last
  std::array<std::uint64_t, said_news.size()> labels{};  // pending offers, 0: none
  std::vector<regista::PendingOffer> pending;
  std::vector<std::size_t> place_of, chosen;  // of what is pending among all offers

  void setup(const regista::Environment& environment, regista::Mailbox way_out) {
    mailbox = way_out;
    own = environment->own_number;
    team_size = static_cast<int>(environment->team_size);
    for (const regista::Role& role : environment.roles()) chases.push_back(chaser == role.name);
    newest.assign(environment->team_size * said_news.size(), -std::numeric_limits<double>::infinity());
    pending.reserve(64);
    place_of.reserve(64);
    chosen.reserve(64);
  }
  void reset(std::uint64_t) {
    sender = {};
    labels = {};
    std::fill(newest.begin(), newest.end(), -std::numeric_limits<double>::infinity());
  }

  std::optional<int> decide(const regista::Frame& frame, const regista::SendQuery& query, regista::Grants out) {
    const std::optional<News> news = sender.decide(settings, situation(frame, query));
    if (news) grant(*news, query, out);
    keep_labels(frame.time());
    if (!news) return std::nullopt;
    return regista::own_reason(static_cast<std::size_t>(*news));
  }

  void receive(const regista::Message& message) {
    const int number = message.sender();
    const auto bytes = message.bytes();
    if (bytes.size() != 1 || bytes[0] >= said_news.size() || number < 1) return;
    const std::size_t place = static_cast<std::size_t>(number - 1) * said_news.size() + bytes[0];
    if (place >= newest.size() || message.time_sent() <= newest[place]) return;  // heard before, or overtaken
    newest[place] = message.time_sent();
    sender.told(said_news[bytes[0]], message.time_sent());
  }
  void transmitted(std::uint64_t handle) { forget(handle); }
  void dropped(std::uint64_t handle) { forget(handle); }

  // "sent for: chaser_changed".
  std::string describe(std::span<const std::uint8_t> said) const {
    if (said.size() != 1 || said[0] >= said_news.size()) return "no news of this team";
    return std::string("sent for: ") + names[static_cast<std::size_t>(said_news[said[0]])];
  }

 private:
  nao_devils::Situation situation(const regista::Frame& frame, const regista::SendQuery& query) const {
    const regista::World mine = frame.mine(), common = frame.common();
    const regista::Robot &self = mine.robot(own), &told = common.robot(own);
    nao_devils::Situation now;
    now.number = own;
    now.team_size = team_size;
    now.time = frame.time();
    now.has_new_map = std::any_of(query.offers.begin(), query.offers.end(), [&](const regista::Offer& offer) {
      return is_new_map(offer) && offer.bytes + label_bytes <= query.budget.bytes_free;
    });
    now.is_chaser = is_role_of_chaser(frame.previous_task(own));
    now.said_chaser = (told.flags & REGISTA_ROBOT_KNOWN) != 0 && is_role_of_chaser(told.role);
    for (const regista::Event& event : query.events) {
      if (event.kind == REGISTA_EVENT_BALL_MOVED) now.ball_off = event.value;
      if (event.kind == REGISTA_EVENT_BALL_KNOWN_AGAIN) now.ball_lacked = event.value;
    }
    now.x = self.pose[0];
    now.y = self.pose[1];
    now.speed = std::hypot(self.velocity[0], self.velocity[1]);
    if (mine.ball_known())
      now.ball_distance = std::hypot(mine.ball().position[0] - now.x, mine.ball().position[1] - now.y);
    now.packets_left = query.budget.packets_left;
    now.reserve = regista::in_this_game(settings.reserve, query.budget);
    now.line = query.budget.line;
    now.since_team = query.budget.since_team;
    return now;
  }
  static bool is_new_map(const regista::Offer& offer) { return offer.urgency >= 1.0; }
  bool is_role_of_chaser(int role) const {
    return role >= 0 && static_cast<std::size_t>(role) < chases.size() && chases[static_cast<std::size_t>(role)];
  }

  // All that fits, with what the packet is for. A new map goes along only when the packet is for it: it is the first of
  // all news, so for another one maps may not come yet.
  void grant(News news, const regista::SendQuery& query, regista::Grants out) {
    std::uint32_t free = query.budget.bytes_free;
    pending.clear();
    place_of.clear();
    for (std::size_t place = 0; place < query.offers.size(); ++place) {
      const regista::Offer& offer = query.offers[place];
      if (const auto label = std::find(labels.begin(), labels.end(), offer.handle); label != labels.end()) {
        const News says = said_news[static_cast<std::size_t>(label - labels.begin())];
        if (says != news || offer.bytes > free) continue;
        free -= offer.bytes;
        out.grant(offer);
      } else if (news == News::map || !is_new_map(offer)) {
        pending.push_back({offer.bytes, offer.urgency});
        place_of.push_back(place);
      }
    }
    regista::choose_offers(pending, free, chosen);
    for (const std::size_t index : chosen) out.grant(query.offers[place_of[index]]);
  }

  void keep_labels(double time) {
    constexpr double lasts = 10.0;  // s
    for (std::size_t k = 0; k < labels.size(); ++k) {
      const auto byte = static_cast<std::uint8_t>(k);
      if (labels[k] == 0) labels[k] = mailbox.offer(std::span(&byte, 1), 0.0, time + lasts);
    }
  }
  void forget(std::uint64_t handle) {
    for (std::uint64_t& label : labels) {
      if (label == handle) label = 0;
    }
  }
};

}  // namespace

REGISTA_PLUGIN(NaoDevilsSender, regista::sender)
