// SPDX-License-Identifier: MIT
// Assigner plugin for CBAA and CBBA of Choi, Brunet and How, "Consensus-Based Decentralized Auctions for Robust Task
// Allocation" (IEEE Transactions on Robotics 25(4), 912-926, 2009): glue around consensus.hpp and
// table.hpp (the algorithm), path.hpp (what tasks are worth), standing_bid.hpp (when to bid anew) and segment.hpp.
//
// The paper leaves to us, or we do otherwise:
// - A robot does one task at a time, and roles do not end. It plays the first task of its bundle, the one with its
//   highest bid. The others are those that it would take next, and nobody plays them meanwhile: so with CBBA a robot
//   may stand idle although a task is open, with CBAA it does not.
// - What a robot says rides along with each of its packets, however often; a lost packet costs time alone. It must fit
//   into one packet in any case: where a packet has no room for the bundles of all robots, bundles are shorter than the
//   team's page wants, and a line in the log says so.
// - Packets are rare. A robot plays what it has said: it leaves a task for another one when a packet has told of that,
//   and at once only when it hears that somebody else wins its task. Else the task would be nobody's until then.
// - The paper gives tasks values. Here a task's value is its utility, less for each place further down in the list of
//   roles, so that the important ones are settled first.
// - What a robot has won becomes nobody's when the game controller has penalised it, and what was said of it before is
//   out of date then. The same tasks become nobody's when the host has given the robot up, or when for a while there
//   were no news of it, neither its own nor by others.
// - A new epoch, which begins when other robots are penalised or another list of roles is played, makes all bid anew
//   with their utilities of that moment, also those who only hear of it. Auctions with prices that may only rise forget
//   everything then, and ignore what is of an earlier epoch. Here the stamps tell what is out of date, and who forgets
//   what the others have won tries to win it again: roles were held twice for longer when we tried.
#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include <regista/assigner.hpp>
#include <regista/log.hpp>
#include <regista/mailbox.hpp>

#include "../negotiation/bids.hpp"
#include "../negotiation/epoch.hpp"
#include "../negotiation/reserve.hpp"
#include "../negotiation/standing_offer.hpp"
#include "consensus.hpp"
#include "path.hpp"
#include "segment.hpp"
#include "standing_bid.hpp"

namespace {

using consensus_bundle::Segment;
using consensus_bundle::tick_of;

struct ConsensusBundle {
  static constexpr auto id = "consensus_bundle", version = "1.0.0",
                        summary = "Robots outbid each other for tasks and agree on who wins each (CBAA, CBBA)";
  static constexpr unsigned reads = REGISTA_READS_NOTHING;
  static constexpr bool negotiates = true;

  int bundle = 1;
  double kept_per_place = 1.0;
  double rebid_after = 0.02;
  double lapses_after = 25.0;
  int stop_negotiating_at = negotiation::usual_reserve;
  consensus_bundle::Worth worth;
  static constexpr std::tuple parameters{
      regista::integer("bundle", &ConsensusBundle::bundle, {1.0, 16.0}, "1",
                       "Most tasks that a robot wins, of which it plays the first; 1 is CBAA, more is CBBA (Choi, "
                       "Brunet and How 2009)"),
      regista::real("kept_per_place", &ConsensusBundle::kept_per_place, {0.1, 1.0}, "1",
                    "Share of its utility that a task keeps for each place further down in the list of roles; that "
                    "tasks differ in value is the paper's, the number is an assumption")
          .tunable(),
      regista::real("rebid_after", &ConsensusBundle::rebid_after, {0.0, 1.0}, "1",
                    "A robot bids anew when what a task is worth to it has changed by more than this (assumption)")
          .tunable(),
      regista::real("lapses_after", &ConsensusBundle::lapses_after, {1.0, 120.0}, "s",
                    "A claim ends when nothing was heard of its holder for this long, directly or by others "
                    "(assumption)"),
      negotiation::stop_negotiating_at(&ConsensusBundle::stop_negotiating_at),
      regista::within(
          &ConsensusBundle::worth,
          regista::real("step", &consensus_bundle::Worth::step, {1e-6, 1.0}, "1",
                        "Bids are whole numbers of such steps of utility, at most 4095 of them (assumption)")
              .log_scale(),
          regista::real("kept_per_second", &consensus_bundle::Worth::kept_per_second, {0.01, 1.0}, "1",
                        "With a bundle of more than one task: share of its worth that a task keeps for each second of "
                        "detour on the way to it; that time discounts is the paper's, the number is an assumption")
              .tunable())};

  int own = 0;
  std::size_t limit = 1;
  regista::Span<regista::Role> roles;
  consensus_bundle::Consensus consensus;
  consensus_bundle::StandingBid standing;
  Segment segment;
  negotiation::StandingOffer offer;
  negotiation::Reserve reserve;
  negotiation::Epoch epoch;
  consensus_bundle::Told told;
  std::vector<std::uint8_t> bytes;
  std::vector<consensus_bundle::Chance> chances;  // by id of the task, as all that follow
  std::vector<std::int32_t> column_of;            // -1: not among the tasks
  std::vector<int> list_of;                       // number of the role list
  std::vector<double> newest;                     // time at which the newest packet of a robot was sent, by number - 1
  std::size_t offered = 0, told_last = 0;         // the own first task in what is offered, and in what left last
  std::vector<char> penalised;                    // by number - 1

  void setup(const regista::Environment& environment, const regista::Host& host) {
    own = environment->own_number;
    roles = environment.roles();
    const std::size_t robots = environment->team_size, tasks = roles.size();
    consensus.setup(own, robots, tasks);
    standing.setup(tasks);
    segment.setup(robots, tasks);
    shorten_bundle(robots, tasks, host);
    if (environment->walk_forward > 0.0) worth.speed = environment->walk_forward;
    worth.most = Segment::most_bid;
    offer.setup(host.mailbox(), segment.bytes(tasks));
    reserve.setup(environment, host, stop_negotiating_at);
    bytes.reserve(segment.bytes(tasks));
    told.claims.reserve(tasks);
    told.stamps.reserve(robots);
    chances.resize(tasks);
    column_of.resize(tasks);
    list_of.resize(tasks);
    for (std::size_t task = 0; task < tasks; ++task) {
      std::size_t first = 0;
      while (std::string_view(roles[first].list) != roles[task].list) ++first;
      list_of[task] = static_cast<int>(first);
    }
    newest.resize(robots);
    penalised.resize(robots);
    forget();
  }
  void reset(std::uint64_t) { forget(); }

  void assign(const regista::Frame& frame, regista::UtilityMatrix utilities, regista::Assignment out) {
    if (reserve.is_reached()) {
      stop();
      return reserve.assign_by_rank(frame, utilities, out);
    }
    const auto active = frame.world().active();
    const std::int64_t now = tick_of(frame.time());
    end_claims(frame.world(), now);
    begin_epoch(frame);
    find_columns(frame.tasks());
    const std::size_t row = negotiation::row_of(active, own);
    if (row < out.size()) {
      look(frame, utilities, row);
      consensus.rebuild(limit, [&](auto path, std::uint32_t task) {
        return consensus_bundle::gain_of(worth, standing.start(), standing.tasks(), path, task);
      });
    } else {
      consensus.release();
      standing.forget();
    }
    for (std::size_t k = 0; k < out.size(); ++k) out[k] = column_for(active[k], utilities, k);
    if (row < out.size() && still_plays(utilities, row)) out[row] = column_of[told_last];
    if (row == out.size()) told_last = column_of.size();
    offered = consensus.first_task_of(own);
    segment.write(epoch.number(), own, now, consensus.claims(), consensus.stamps(), bytes);
    offer.say(bytes, frame.time());
  }

  void receive(const regista::Message& message) {
    const int sender = message.sender();
    if (sender < 1 || sender > static_cast<int>(newest.size()) || sender == own) return;
    double& time = newest[static_cast<std::size_t>(sender - 1)];
    constexpr double latest = 1e9;  // s: no match lasts so long
    if (!(message.time_sent() > time) || !(message.time_sent() <= std::min(message.time_heard(), latest))) return;
    std::uint8_t number = 0;
    if (!segment.read(message.bytes(), sender, tick_of(message.time_sent()), number, told)) return;
    time = message.time_sent();
    if (!consensus.hear(told)) return;
    if (epoch.hear(number).joined) standing.forget();
  }
  void transmitted(std::uint64_t handle) {
    if (offer.gone(handle)) told_last = offered;
  }
  void dropped(std::uint64_t handle) { offer.gone(handle); }

  // "epoch 3: goalkeeper 1 with 812, striker 4 with 655"
  std::string describe(std::span<const std::uint8_t> said) const {
    consensus_bundle::Told read;
    std::uint8_t number = 0;
    if (!segment.read(said, own, 0, number, read)) return "no claims of this team";
    std::string text = "epoch " + std::to_string(number) + ':';
    bool some = false;
    for (std::size_t task = 0; task < read.claims.size(); ++task) {
      const consensus_bundle::Claim& claim = read.claims[task];
      if (claim.winner == consensus_bundle::nobody) continue;
      text += some ? ", " : " ";
      text += std::string(roles[task].name) + ' ' + std::to_string(claim.winner) + " with " + std::to_string(claim.bid);
      some = true;
    }
    return some ? text : text + " nobody wins a task";
  }

 private:
  // All robots of a team have the same room and shorten alike.
  void shorten_bundle(std::size_t robots, std::size_t tasks, const regista::Host& host) {
    const std::size_t wanted = static_cast<std::size_t>(bundle), room = host.mailbox().bytes_free();
    const auto longest = [&] { return segment.bytes(std::min(tasks, robots * limit)); };
    limit = wanted;
    while (limit > 1 && longest() > room) --limit;
    const std::string has_room = "a packet has room for " + std::to_string(room) + " bytes of bids";
    if (longest() > room) {
      regista::Log(host).warning(has_room + ", and a task for each robot may take " + std::to_string(longest()) +
                                 ": what does not fit is not sent");
    } else if (limit < wanted) {
      regista::Log(host).warning(has_room + ": bundle is " + std::to_string(limit) + " and not " +
                                 std::to_string(wanted));
    }
  }

  void forget() {
    consensus.forget();
    standing.forget();
    offer.forget();
    offered = told_last = column_of.size();
    epoch.forget();
    std::fill(newest.begin(), newest.end(), -1.0);
    std::fill(penalised.begin(), penalised.end(), char{0});
  }

  // Nobody hears what this robot would win; what the others have won lapses by itself.
  void stop() {
    consensus.release();
    standing.forget();
    offer.withdraw();
    offered = told_last = column_of.size();
  }

  // Of robots that do not play, and of those that nobody has heard of for long.
  void end_claims(const regista::World& world, std::int64_t now) {
    for (const regista::Robot& robot : world.robots()) {
      const auto k = static_cast<std::size_t>(robot.number - 1);
      if (robot.number == own || k >= penalised.size()) continue;
      const bool is_penalised = (robot.flags & REGISTA_ROBOT_PENALISED) != 0;
      if (is_penalised && penalised[k] == 0) consensus.ignore_before(robot.number, now);
      penalised[k] = is_penalised ? 1 : 0;
      const std::int64_t heard = consensus.stamps()[k];
      const bool plays = (robot.flags & REGISTA_ROBOT_ACTIVE) != 0;
      if (!plays || heard == consensus_bundle::never || now - heard > tick_of(lapses_after)) {
        consensus.release_all_of(robot.number);
      }
    }
  }

  void begin_epoch(const regista::Frame& frame) {
    negotiation::Subject subject;
    for (const regista::Robot& robot : frame.world().robots()) {
      if ((robot.flags & REGISTA_ROBOT_PENALISED) == 0) subject.add_robot(robot.number);
    }
    const auto tasks = frame.tasks();
    if (!tasks.empty() && knows(tasks[0].id)) subject.add_task(list_of[static_cast<std::size_t>(tasks[0].id)]);
    if (epoch.about(subject)) standing.forget();
  }

  bool knows(int task) const { return task >= 0 && task < static_cast<int>(column_of.size()); }

  void find_columns(const regista::Span<regista::Task>& tasks) {
    std::fill(column_of.begin(), column_of.end(), -1);
    for (std::size_t column = 0; column < tasks.size(); ++column) {
      if (knows(tasks[column].id))
        column_of[static_cast<std::size_t>(tasks[column].id)] = static_cast<std::int32_t>(column);
    }
  }

  void look(const regista::Frame& frame, const regista::UtilityMatrix& utilities, std::size_t row) {
    for (std::size_t task = 0; task < chances.size(); ++task) {
      chances[task] = {};
      if (column_of[task] < 0) continue;
      const auto column = static_cast<std::size_t>(column_of[task]);
      if (utilities(row, column) == regista::UtilityMatrix::forbidden) continue;
      const regista::Task& each = frame.tasks()[column];
      const double value = consensus_bundle::share_kept(kept_per_place, each.priority);
      chances[task] = {true, utilities(row, column) * value, {each.after[0], each.after[1]}};
    }
    const double* pose = frame.world().robot(own).pose;
    standing.look(chances, {pose[0], pose[1]}, rebid_after);
  }

  // It has told that it does this task, and knows nobody who wins it.
  bool still_plays(const regista::UtilityMatrix& utilities, std::size_t row) const {
    if (told_last == column_of.size() || column_of[told_last] < 0) return false;
    if (utilities(row, static_cast<std::size_t>(column_of[told_last])) == regista::UtilityMatrix::forbidden)
      return false;
    const int winner = consensus.claims()[told_last].winner;
    return winner == own || winner == consensus_bundle::nobody;
  }

  // The own task, or what a teammate is thought to do.
  std::int32_t column_for(int number, const regista::UtilityMatrix& utilities, std::size_t row) const {
    const std::size_t task = consensus.first_task_of(number);
    if (task == column_of.size()) {
      const auto k = static_cast<std::size_t>(number - 1);
      const bool heard = number == own || (k < newest.size() && consensus.stamps()[k] != consensus_bundle::never);
      return heard ? regista::Assignment::no_task : regista::Assignment::unknown_task;
    }
    const std::int32_t column = column_of[task];
    const bool can =
        column >= 0 && utilities(row, static_cast<std::size_t>(column)) != regista::UtilityMatrix::forbidden;
    return can ? column : regista::Assignment::unknown_task;
  }
};

}  // namespace

REGISTA_PLUGIN(ConsensusBundle, regista::assigner)
