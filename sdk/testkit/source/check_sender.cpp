// SPDX-License-Identifier: MIT
// Events, offers and budgets by chance, and what a decision about them must be like.
#include <regista/testkit/kind_checks.hpp>

#include <algorithm>
#include <cstdint>
#include <utility>

#include <regista/testkit/dice.hpp>
#include <regista/testkit/scenario.hpp>
#include <regista/testkit/scenes.hpp>

namespace regista::testkit {

namespace {

struct Query {
  std::vector<regista_event> events;
  std::vector<regista_offer> offers;
  regista_budget budget{};
};

Query query_for(const Scene& scene, std::size_t round, std::uint64_t seed) {
  Dice dice = Dice::with(seed, scene.data().tick * 8 + round);
  Query q;
  for (std::int32_t kind = REGISTA_EVENT_WHISTLE; kind < REGISTA_EVENT_OFFER; ++kind) {
    if (dice.chance(0.15)) q.events.push_back({kind, 0, dice.real(0.0, 20.0)});
  }
  const int offers = dice.integer(0, 5);
  for (int k = 0; k < offers; ++k) {
    const auto handle = static_cast<std::uint64_t>(scene.data().tick * 100 + static_cast<std::uint64_t>(7 * k + 1));
    const auto bytes = static_cast<std::uint32_t>(dice.integer(2, 80));
    const double urgency = dice.chance(0.2) ? 1.0 : dice.real(0.0, 1.0);
    q.offers.push_back({handle, bytes, REGISTA_MEDIUM_RADIO, urgency, scene.data().time + dice.real(0.0, 10.0)});
  }
  constexpr std::int32_t left[] = {1200, 600, 31, 30, 29, 1, 0, -5};
  q.budget.packets_left = left[dice.integer(0, 7)];
  q.budget.line = dice.real(0.0, 1200.0);
  q.budget.match_time_left = dice.chance(0.1) ? 0.0 : dice.real(0.0, 1200.0);
  q.budget.since_own = dice.real(0.0, 20.0);
  q.budget.since_team = dice.real(0.0, q.budget.since_own);
  q.budget.bytes_free = static_cast<std::uint32_t>(dice.integer(0, 80));
  q.budget.share = dice.chance(0.5) ? 1.0 : dice.real(0.01, 1.0);
  return q;
}

void check_sent(const Sent& sent, const Query& query, std::uint32_t own_reasons, Findings& findings) {
  if (sent.send != 0 && sent.send != 1) findings.say("decide: send is ", sent.send, ", neither 0 nor 1");
  const bool event = sent.reason >= 0 && sent.reason < REGISTA_EVENT_COUNT;
  const bool own =
      sent.reason >= REGISTA_REASON_OWN && static_cast<std::uint32_t>(sent.reason - REGISTA_REASON_OWN) < own_reasons;
  if (sent.send == 1 && !event && !own) {
    findings.say("decide: sends for the reason ", sent.reason, ", which does not exist");
  }
  for (std::size_t i = 0; i < sent.granted.size(); ++i) {
    const std::uint64_t handle = sent.granted[i];
    const bool offered = std::any_of(query.offers.begin(), query.offers.end(),
                                     [handle](const regista_offer& offer) { return offer.handle == handle; });
    if (!offered) findings.say("decide: granted handle ", handle, ", which nobody offered");
    if (std::count(sent.granted.begin(), sent.granted.end(), handle) > 1) {
      findings.say("decide: granted an offer twice");
    }
  }
}

}  // namespace

std::vector<Scenario> sender_scenarios(const Options& options) {
  constexpr std::size_t rounds = 4;
  std::vector<Scenario> out;
  for (const int size : team_sizes) {
    std::vector<Scene> scenario;
    for (const Scene& scene : scenes(size, options.seed)) {
      const std::int32_t phase = scene.data().mine.game.phase;
      if (phase == REGISTA_PHASE_INITIAL || phase == REGISTA_PHASE_FINISHED) continue;  // never called then
      for (std::size_t round = 0; round < rounds; ++round) {
        SceneData data = scene.data();
        data.tick = scenario.size();
        data.time = 0.1 * static_cast<double>(data.tick);
        scenario.emplace_back(std::move(data));
      }
    }
    const auto play = [seed = options.seed](Instance& instance, const Scene& scene, std::size_t i, Findings& findings,
                                            Trail& trail) {
      const Query q = query_for(scene, i % rounds, seed);
      const Sent sent = instance.decide(scene, q.events, q.offers, q.budget);
      trail.add(sent.send);
      trail.add(sent.reason);
      trail.add_all(sent.granted);
      check_sent(sent, q, instance.reason_count(), findings);
    };
    out.push_back(scenario_of_scenes(size, "decide", scenario, play));
  }
  return out;
}

}  // namespace regista::testkit
