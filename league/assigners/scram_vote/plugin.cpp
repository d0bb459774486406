// SPDX-License-Identifier: MIT
// Assigner plugin around scram/from_frame.hpp and vote.hpp: SCRAM on what each robot knows, then the vote of
// MacAlpine, Barrera and Stone, "Positioning to Win" (RoboCup 2012).
//
// The own map goes along with every packet, the newest always. All play the map with the most votes among the own one
// and the newest of each teammate that plays; of equals the one with the lowest-numbered voter. Ours:
//   - A vote counts only if it was cast for just the robots that play here. So after a robot has left or returned, all
//     play their own maps until they have heard new ones; no map that names a robot which left is ever played.
//   - A vote counts only if at least half of the tasks that it gives are known here: else it is about another list.
//   - A vote counts for `vote_age`. A vote that is void for some only divides the team: with 10 s a team that hears two
//     fifths of its packets, one a second and robot, does not settle in the rehearsal. 25 s is the silence after which
//     a robot is given up.
//   - Where the elected map does not fit what a robot knows: ../negotiation/follow_map.hpp.
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <plugins/assigners/scram/from_frame.hpp>
#include <regista/assigner.hpp>
#include <regista/host.hpp>
#include <regista/mailbox.hpp>

#include "../negotiation/follow_map.hpp"
#include "../negotiation/reserve.hpp"
#include "../negotiation/say_map.hpp"
#include "../negotiation/standing_offer.hpp"
#include "../negotiation/told_map.hpp"
#include "vote.hpp"

namespace {

struct ScramVote {
  static constexpr auto id = "scram_vote", version = "1.0.0",
                        summary = "SCRAM, and of the robots' results the one with the most votes is played";
  static constexpr unsigned reads = REGISTA_READS_NOTHING;
  static constexpr bool negotiates = true;

  scram::Settings settings;
  double vote_age = 25.0;
  int stop_negotiating_at = negotiation::usual_reserve;
  static constexpr std::tuple parameters{regista::within(&ScramVote::settings, scram::parameters),
                                         regista::real("vote_age", &ScramVote::vote_age, {0.1, 60.0}, "s",
                                                       "A vote counts for this long after it was sent (assumption)"),
                                         negotiation::stop_negotiating_at(&ScramVote::stop_negotiating_at)};

  scram::FrameSolver solver;
  scram::MapOfFrame here;
  scram::BallotBox ballots;
  scram::Follower follower;
  negotiation::StandingOffer offer;
  negotiation::Reserve reserve;
  std::vector<std::int32_t> assigned, map;
  std::vector<std::uint8_t> bytes;

  void setup(const regista::Environment& environment, const regista::Host& host) {
    const std::size_t robots = environment->team_size, roles = environment.roles().size();
    solver.reserve(robots, roles);
    here.setup(environment);
    ballots.reserve(here.code());
    follower.reserve(roles);
    reserve.setup(environment, host, stop_negotiating_at);
    offer.setup(host.mailbox(), here.code().bytes());
    bytes.reserve(here.code().bytes());
    assigned.reserve(robots);
    map.reserve(robots);
  }

  void reset(std::uint64_t) {
    ballots.clear();
    offer.forget();
  }

  void assign(const regista::Frame& frame, regista::UtilityMatrix utilities, regista::Assignment out) {
    if (reserve.is_reached()) {
      offer.withdraw();
      return reserve.assign_by_rank(frame, utilities, out);
    }
    assigned.resize(out.size());
    solver.assign(settings, frame, utilities, assigned);
    if (out.size() == 0 || utilities.columns() == 0) return offer.withdraw();  // nothing to vote on
    here.look(frame, solver.order());
    here.write(assigned, map);
    negotiation::BitWriter writer(bytes);
    here.code().write(map, writer);
    offer.say(bytes, frame.time());
    ballots.elect(frame.own_number(), map, frame.time() - vote_age, [&](int voter, std::span<const std::int32_t> told) {
      return here.plays(voter) && scram::has_members(told, here.now().numbers) && scram::is_about(told, here.now());
    });
    follower.follow(
        map, here.now(),
        [&](std::size_t row, std::size_t column) {
          return utilities(row, column) != regista::UtilityMatrix::forbidden;
        },
        assigned);
    for (std::size_t row = 0; row < out.size(); ++row) out[row] = assigned[row];
  }

  void receive(const regista::Message& message) { ballots.put(message.sender(), message.bytes(), message.time_sent()); }
  void transmitted(std::uint64_t handle) { offer.gone(handle); }
  void dropped(std::uint64_t handle) { offer.gone(handle); }

  // "vote: 1 goalkeeper, 2 striker, 3 idle".
  std::string describe(std::span<const std::uint8_t> said) const {
    negotiation::BitReader in(said);
    const std::string text = here.describe(in);
    return text.empty() ? "no vote of this team" : "vote: " + text;
  }
};

}  // namespace

REGISTA_PLUGIN(ScramVote, regista::assigner)
