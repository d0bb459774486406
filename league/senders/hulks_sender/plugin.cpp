// SPDX-License-Identifier: MIT
// Sender plugin around algorithm.hpp. What there is to say it learns from the offers of the assigner `hulks`, by their
// urgency: 1 is to be said at once, 0.5 is the claim of the striker. Packets take all offers along that fit.
#include <array>
#include <vector>

#include <regista/choose_offers.hpp>
#include <regista/sender.hpp>

#include "algorithm.hpp"

namespace {

using hulks_sender::Cause, hulks_sender::Settings;

struct HulksSender {
  static constexpr auto id = "hulks_sender", version = "1.0.0",
                        summary = "The striker's claim at once and every 2 s; in Playing nobody else speaks";
  static constexpr unsigned reads = REGISTA_READS_NOTHING;
  static constexpr std::array<const char*, 2> reasons{"news_of_striker", "claim_again"};

  Settings settings;
  int silent_at = 20;
  static constexpr std::tuple parameters{
      regista::integer("silent_at", &HulksSender::silent_at, {0, 10000}, "1",
                       "Packets of the team at which it falls silent; HULKs 2024: 20"),
      regista::within(
          &HulksSender::settings,
          regista::real("resend", &Settings::resend, {0.1, 60.0}, "s",
                        "Time after which the striker says its claim again; HULKs 2024: 2")
              .tunable(),
          regista::real("gap", &Settings::gap, {0.0, 60.0}, "s",
                        "Least time between two packets of a robot in Playing; HULKs 2024: 1")
              .tunable(),
          regista::real("ready_period", &Settings::ready_period, {0.0, 600.0}, "s",
                        "Time between two packets of a robot in Ready and Set, by which the others learn that it "
                        "plays; 0: none (assumption)"))};

  hulks_sender::Sender sender;
  int number = 1, team_size = 1;
  std::vector<regista::PendingOffer> pending;
  std::vector<std::size_t> chosen;

  void setup(const regista::Environment& environment) {
    number = environment->own_number;
    team_size = static_cast<int>(environment->team_size);
    pending.reserve(64);
    chosen.reserve(64);
  }
  void reset(std::uint64_t) { sender = {}; }

  std::optional<int> decide(const regista::Frame& frame, const regista::SendQuery& query, regista::Grants out) {
    const int phase = frame.mine().game().phase;
    hulks_sender::Situation now;
    now.time = frame.time();
    now.number = number;
    now.team_size = team_size;
    now.playing = phase == REGISTA_PHASE_PLAYING;
    now.ready_or_set = phase == REGISTA_PHASE_READY || phase == REGISTA_PHASE_SET;
    now.has_packets = query.budget.packets_left > regista::in_this_game(silent_at, query.budget);
    now.since_own = query.budget.since_own;
    pending.clear();
    for (const regista::Offer& offer : query.offers) {
      pending.push_back({offer.bytes, offer.urgency});
      if (offer.bytes > query.budget.bytes_free) continue;
      now.has_news = now.has_news || offer.urgency >= 1.0;
      now.is_striker = now.is_striker || offer.urgency >= 0.5;
    }
    const std::optional<Cause> cause = sender.decide(settings, now);
    if (!cause) return std::nullopt;
    regista::choose_offers(pending, query.budget.bytes_free, chosen);
    for (const std::size_t index : chosen) out.grant(query.offers[index]);
    if (*cause == Cause::ready) return REGISTA_EVENT_PERIOD;
    return regista::own_reason(*cause == Cause::news ? 0 : 1);
  }
};

}  // namespace

REGISTA_PLUGIN(HulksSender, regista::sender)
