// SPDX-License-Identifier: MIT
// Sender plugin around algorithm.hpp: finds out whether this robot has the fast role; takes along what offers fit.
#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include <regista/choose_offers.hpp>
#include <regista/sender.hpp>

#include "algorithm.hpp"

namespace {

using fixed_rate::Settings;

struct FixedRate {
  static constexpr auto id = "fixed_rate", version = "1.2.0", summary = "A packet every so many seconds";
  static constexpr unsigned reads = REGISTA_READS_PREVIOUS;
  Settings settings;
  std::string fast_role = "striker";
  bool lasts = true;
  static constexpr std::tuple parameters{
      regista::within(
          &FixedRate::settings,
          regista::real("period", &Settings::period, {0.5, 120.0}, "s", "Time between two packets of a robot; SPQR: 8")
              .tunable(),
          regista::real("fast_period", &Settings::fast_period, {0.5, 120.0}, "s",
                        "The same for the robot that has the fast role; SPQR: 4")
              .tunable()),
      regista::text("fast_role", &FixedRate::fast_role,
                    "Name of the fast role, in any list of roles; empty: none, all send alike; SPQR: striker"),
      regista::within(
          &FixedRate::settings,
          regista::integer(
              "reserve", &Settings::reserve, {0, 10000}, "1",
              "Packets of the team that are never spent; more than 0 where the count of packets comes late")),
      regista::boolean(
          "lasts", &FixedRate::lasts,
          "Longer periods when less than an even share of the budget is left, so that it lasts to the end; "
          "our choice"),
      regista::within(
          &FixedRate::settings,
          regista::boolean("at_once", &Settings::at_once,
                           "A robot that takes the fast role is due by the fast period at once, as in SPQR's released "
                           "code; false: after its next packet, so that a change of role is no event"))};

  int team_size = 1;

  fixed_rate::Schedule schedule, fresh;
  std::vector<bool> is_fast;  // by id of the role
  std::vector<regista::PendingOffer> offers;
  std::vector<std::size_t> chosen;

  void setup(const regista::Environment& environment) {
    fresh = fixed_rate::Schedule(environment->own_number, static_cast<int>(environment->team_size));
    schedule = fresh;
    team_size = static_cast<int>(environment->team_size);
    for (const regista::Role& role : environment.roles()) is_fast.push_back(fast_role == role.name);
    // A team without the role of the default sends alike; another name is asked for, and must be a role.
    const bool asked = !fast_role.empty() && fast_role != FixedRate{}.fast_role;
    if (asked && std::ranges::find(is_fast, true) == is_fast.end()) {
      std::string known;
      for (const regista::Role& role : environment.roles())
        known += (known.empty() ? "" : ", ") + std::string(role.name);
      throw std::invalid_argument("fixed_rate: fast_role: no list of roles has \"" + fast_role + "\"; known: " + known);
    }
    offers.reserve(16);
    chosen.reserve(16);
  }
  void reset(std::uint64_t) { schedule = fresh; }

  std::optional<int> decide(const regista::Frame& frame, const regista::SendQuery& query, regista::Grants out) {
    const int task = frame.previous_task(frame.own_number());
    const bool fast =
        task >= 0 && static_cast<std::size_t>(task) < is_fast.size() && is_fast[static_cast<std::size_t>(task)];
    const regista::Budget& budget = query.budget;
    const int kept = regista::in_this_game(settings.reserve, budget);
    const double longer = lasts ? fixed_rate::stretch(budget.packets_left - kept, budget.line - kept, team_size) : 1.0;
    if (!schedule.decide({longer * settings.period, longer * settings.fast_period, kept, settings.at_once},
                         frame.time(), budget.since_own, fast, budget.packets_left)) {
      return std::nullopt;
    }
    offers.clear();
    for (const regista::Offer& offer : query.offers) offers.push_back({offer.bytes, offer.urgency});
    regista::choose_offers(offers, budget.bytes_free, chosen);
    for (const std::size_t index : chosen) out.grant(query.offers[index]);
    return REGISTA_EVENT_PERIOD;
  }
};

}  // namespace

REGISTA_PLUGIN(FixedRate, regista::sender)
