// SPDX-License-Identifier: MIT
// Assigner of B-Human (Roefer et al., "B-Human 2022 - More Team Play with Less Communication", RoboCup 2022, LNCS
// 13561; numbers of the code release of 2025): active_player.hpp chooses who plays the ball, each robot for itself;
// positions.hpp gives the other tasks, on what was last sent. This file is glue.
//
// Base points are the places of tasks before the offset (task.before), for the offset is what the positioner adds.
// Utilities are not weighed, but pairs that the host forbids stay forbidden.
//
// Not here: the mirrored formations and the vote of teammates on formation and side, as the host's roles have one place
// each. Decided by us: without an active player, because nobody sees the ball, the task of the active player is given
// like the others; what a silent robot said of its task and its ball counts for 25 s, and who was never heard stands
// where the team's predictor has it.
//
// What was sent the extension regista.told says: of each teammate the newest packet that was heard, of this robot the
// last one that left. So a packet that is lost leaves the older row in force until the next. A host without the
// extension cannot have this assigner.
//
// Messages: statement.hpp, the tasks of a robot. The own list is the one that left in a packet (transmitted); who sends
// a packet without one, or whose offer is dropped, has the list that it sent before, here as with the teammates.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <plugins/assigners/task_order.hpp>
#include <regista/assigner.hpp>
#include <regista/mailbox.hpp>
#include <regista/told.hpp>

#include "../negotiation/standing_offer.hpp"
#include "active_player.hpp"
#include "extrapolation.hpp"
#include "positions.hpp"
#include "statement.hpp"

namespace {

using b_human::ActiveRule;
using b_human::Candidate;
using b_human::Member;
using b_human::Position;
using b_human::TaskList;

constexpr double never = -std::numeric_limits<double>::infinity();

struct BHuman {
  static constexpr auto id = "b_human", version = "1.0.0",
                        summary = "First at the ball plays it; others: least sorted walks from last sent poses";
  static constexpr unsigned reads = REGISTA_READS_NOTHING;

  std::string active_role = "striker";
  ActiveRule rule;
  double holder_bonus = 1.0, claim_lapses_after = 25.0;
  static constexpr std::tuple parameters{
      regista::text(
          "active_role", &BHuman::active_role,
          "Name of the role that the active player takes; empty, or no such role: there is none (assumption)"),
      regista::real("holder_bonus", &BHuman::holder_bonus, {0.0, 10.0}, "m",
                    "By which who holds a position counts as nearer to it; B-Human: 1")
          .tunable(),
      regista::real("claim_lapses_after", &BHuman::claim_lapses_after, {1.0, 3600.0}, "s",
                    "What a robot said of its task and its ball counts so long after it was sent; assumption"),
      regista::within(
          &BHuman::rule,
          regista::real("active_bonus", &ActiveRule::holder_bonus, {0.0, 20.0}, "s",
                        "By which the active player counts as faster; B-Human: 1")
              .tunable(),
          regista::real("forward", &ActiveRule::forward, {0.01, 10.0}, "m/s",
                        "Speed ahead in the time to the ball; B-Human: 0.26"),
          regista::real("sideways", &ActiveRule::sideways, {0.01, 10.0}, "m/s",
                        "Speed sideways in the time to the ball; B-Human: 0.22"),
          regista::real("turn_rate", &ActiveRule::turn_rate, {0.1, 20.0}, "rad/s",
                        "Speed of turning in the time to the ball; B-Human: 100 degrees a second"),
          regista::real("longest_get_up", &ActiveRule::longest_get_up, {0.0, 60.0}, "s",
                        "What lying on the ground costs at most; B-Human: 5"),
          regista::real("blind_penalty", &ActiveRule::blind_penalty, {0.0, 60.0}, "s",
                        "What not seeing the ball costs; B-Human: 2")
              .tunable(),
          regista::real("age_to_become", &ActiveRule::age_to_become, {0.05, 25.0}, "s",
                        "A ball at most so old makes a robot active; B-Human: 1")
              .tunable(),
          regista::real("age_to_stay", &ActiveRule::age_to_stay, {0.05, 25.0}, "s",
                        "A ball at most so old lets it stay active; B-Human: 5")
              .tunable(),
          regista::real("near", &ActiveRule::near, {0.0, 100.0}, "m",
                        "Distance of a teammate from its ball at which off_when_near holds; B-Human: 2.5"),
          regista::real("far", &ActiveRule::far, {0.0, 100.0}, "m",
                        "Distance of a teammate from its ball at which off_when_far holds; B-Human: 7.5"),
          regista::real("off_when_near", &ActiveRule::off_when_near, {0.0, 100.0}, "m",
                        "A teammate whose ball is farther from the own one cannot be active; B-Human: 0.78"),
          regista::real("off_when_far", &ActiveRule::off_when_far, {0.0, 100.0}, "m",
                        "The same for one far from its ball; B-Human: 1.55"))};

  // What each robot said last, by number - 1; the own row as it left.
  struct Entry {
    std::optional<regista::ToldPacket> said;
    bool ball_is_off = false;       // of a teammate: see active_player.hpp
    std::optional<TaskList> tasks;  // the newest, perhaps of an older packet
    double tasks_sent = never;
  };

  int own_number = 1;
  std::size_t roles = 0;
  std::vector<const char*> names;    // of roles; they live as long as the instance
  std::vector<bool> is_active_role;  // by row of the table of roles
  std::vector<Entry> table;
  regista::Told told;
  negotiation::StandingOffer offer;
  TaskList next;  // as it was last offered
  double now = 0.0, ball_seen_at = never;
  b_human::Positions positions;
  std::vector<Member> members;
  std::vector<Position> tasks;
  std::vector<Candidate> candidates;
  std::vector<std::size_t> candidate_row;
  std::vector<std::uint32_t> order, choice;
  std::vector<std::int32_t> assigned;
  std::vector<std::uint8_t> bytes;

  void setup(const regista::Environment& environment, const regista::Host& host) {
    if (host.extension<regista_told>(REGISTA_TOLD_EXTENSION) == nullptr) {
      throw std::runtime_error("needs a host with the extension " REGISTA_TOLD_EXTENSION);
    }
    told = regista::Told(host);
    const std::size_t robots = environment->team_size;
    own_number = environment->own_number;
    roles = std::min(environment.roles().size(), b_human::most_roles);
    for (const regista::Role& role : environment.roles()) {
      names.push_back(role.name);
      is_active_role.push_back(active_role == role.name);
    }
    table.resize(robots);
    offer.setup(host.mailbox(), b_human::statement_bytes(roles));
    bytes.reserve(b_human::statement_bytes(roles));
    positions.reserve(robots, environment.roles().size());
    members.reserve(robots);
    candidates.reserve(robots);
    candidate_row.reserve(robots);
    assigned.reserve(robots);
    tasks.reserve(environment.roles().size());
    order.reserve(environment.roles().size());
    choice.reserve(environment.roles().size());
  }

  void reset(std::uint64_t) {
    std::fill(table.begin(), table.end(), Entry{});
    offer.forget();
    next = {};
    now = 0.0;
    ball_seen_at = never;
  }

  void assign(const regista::Frame& frame, regista::UtilityMatrix utilities, regista::Assignment out) {
    now = frame.time();
    look_at_ball(frame.mine());
    look_at_packets(frame.mine());
    list_tasks(frame.tasks());
    list_members(frame);
    assigned.assign(out.size(), regista::Assignment::no_task);
    if (utilities.columns() > 0) {
      const auto not_forbidden = [&](std::size_t row, std::size_t column) {
        return utilities(row, column) != regista::UtilityMatrix::forbidden;
      };
      const std::optional<std::size_t> column = active_column(frame.tasks());
      std::optional<std::size_t> active;
      if (column) active = active_row(frame, *column, not_forbidden);
      put_in_order(frame.tasks(), active ? column : std::nullopt);
      const auto allowed = [&](std::size_t row, std::size_t j) {
        if (active && (row == *active) != (j == *column)) return false;
        return not_forbidden(row, j);
      };
      positions.assign(members, tasks, allowed, b_human::millimetres(holder_bonus), order, choice, assigned);
    }
    for (std::size_t row = 0; row < out.size(); ++row) out[row] = assigned[row];
    say();
  }

  void receive(const regista::Message& message) {
    const auto index = static_cast<std::size_t>(message.sender()) - 1;
    if (message.sender() < 1 || index >= table.size() || message.sender() == own_number) return;
    const std::optional<TaskList> list = b_human::read(message.bytes(), roles);
    if (list && message.time_sent() > table[index].tasks_sent) has_said(table[index], *list, message.time_sent());
  }
  void transmitted(std::uint64_t handle) {
    if (offer.gone(handle)) has_said(table[static_cast<std::size_t>(own_number) - 1], next, now);
  }
  void dropped(std::uint64_t handle) { offer.gone(handle); }

  // "has the tasks striker, supporter"
  std::string describe(std::span<const std::uint8_t> segment) const {
    const std::optional<TaskList> list = b_human::read(segment, roles);
    if (!list) return "no list of tasks of this team";
    std::string out;
    for (std::size_t row = 0; row < roles; ++row) {
      if (list->has(static_cast<std::int32_t>(row)))
        out += (out.empty() ? "has the tasks " : ", ") + std::string(names[row]);
    }
    return out.empty() ? "has no tasks" : out;
  }

 private:
  static void has_said(Entry& entry, const TaskList& tasks, double time_sent) {
    entry.tasks = tasks;
    entry.tasks_sent = time_sent;
  }

  // Sighted by the own eyes.
  void look_at_ball(const regista::World& mine) {
    if (mine.ball_known() && told.sees_ball().value_or(false)) ball_seen_at = now;
  }

  // Whose packet is new its ball is compared with the own one. Who knows no ball cannot compare.
  void look_at_packets(const regista::World& mine) {
    for (std::size_t k = 0; k < table.size(); ++k) {
      Entry& entry = table[k];
      const std::optional<regista::ToldPacket> packet = told.packet(static_cast<int>(k) + 1);
      const bool is_new = packet && (!entry.said || packet->time_sent > entry.said->time_sent);
      entry.said = packet;
      if (!is_new) continue;
      entry.ball_is_off = false;
      if (!mine.ball_known() || !knows_ball(*packet)) continue;
      const b_human::Point own{mine.ball().position[0], mine.ball().position[1]};
      entry.ball_is_off =
          b_human::is_another_ball({packet->pose[0], packet->pose[1]}, {packet->ball[0], packet->ball[1]}, own, rule);
    }
  }
  static bool knows_ball(const regista::ToldPacket& packet) { return (packet.flags & REGISTA_TOLD_BALL) != 0; }

  void list_tasks(const regista::Span<regista::Task>& all) {
    tasks.clear();
    for (const regista::Task& task : all) tasks.push_back({task.id, {task.before[0], task.before[1]}});
  }

  bool counts(const Entry& entry) const { return entry.said && now - entry.said->time_sent <= claim_lapses_after; }
  const Entry& entry_of(int number) const { return table[static_cast<std::size_t>(number) - 1]; }

  void list_members(const regista::Frame& frame) {
    members.clear();
    for (const std::int32_t number : frame.world().active()) {
      const Entry& entry = entry_of(number);
      Member& member = members.emplace_back();
      const regista::World world = number == own_number ? frame.mine() : frame.world();
      const double* pose = entry.said ? entry.said->pose : world.robot(number).pose;
      member.x = b_human::millimetres(pose[0]);
      member.y = b_human::millimetres(pose[1]);
      if (counts(entry)) member.claims = entry.said->role;
      if (entry.tasks) member.has = &*entry.tasks;
    }
  }

  std::optional<std::size_t> active_column(const regista::Span<regista::Task>& all) const {
    for (std::size_t j = 0; j < all.size(); ++j) {
      const auto row = static_cast<std::size_t>(all[j].id);
      if (row < is_active_role.size() && is_active_role[row]) return j;
    }
    return std::nullopt;
  }

  // Rounded as in a packet.
  Candidate myself(const regista::World& mine, std::int32_t active_task) const {
    const regista::Robot& self = mine.robot(own_number);
    const double age = b_human::whole_hundredths(now - ball_seen_at);
    Candidate out;
    out.pose = {b_human::millimetres(self.pose[0]) / 1000.0, b_human::millimetres(self.pose[1]) / 1000.0, self.pose[2]};
    out.knows_ball = mine.ball_known() && age <= rule.age_to_stay;
    if (out.knows_ball) out.ball_age = age;
    out.is_active = self.role == active_task;
    out.until_up = self.time_until_up;
    return out;
  }

  // On its straight way from where it was to where it said to walk.
  Candidate teammate(const Entry& entry, std::int32_t active_task, double until_up) const {
    const regista::ToldPacket& said = *entry.said;
    const double speed = std::sqrt(said.velocity[0] * said.velocity[0] + said.velocity[1] * said.velocity[1]);
    const b_human::Point by_now =
        b_human::walked_on({said.pose[0], said.pose[1]}, {said.target[0], said.target[1]}, speed, now - said.time_sent);
    return {{by_now.x, by_now.y, said.pose[2]}, knows_ball(said), entry.ball_is_off, said.ball_age,
            said.role == active_task,           until_up};
  }

  template <class Allowed>
  std::optional<std::size_t> active_row(const regista::Frame& frame, std::size_t column, const Allowed& allowed) {
    const regista::World mine = frame.mine();
    if (!mine.ball_known()) return std::nullopt;
    const b_human::Point ball{b_human::millimetres(mine.ball().position[0]) / 1000.0,
                              b_human::millimetres(mine.ball().position[1]) / 1000.0};
    candidates.clear();
    candidate_row.clear();
    const regista::Span<std::int32_t> active = frame.world().active();
    for (std::size_t row = 0; row < active.size(); ++row) {
      if (!allowed(row, column) || !b_human::Common(members[row], tasks).can_take(tasks[column])) continue;
      const std::int32_t number = active[row];
      if (number == own_number) {
        candidates.push_back(myself(mine, tasks[column].id));
      } else {
        const Entry& entry = entry_of(number);
        if (!counts(entry)) continue;
        candidates.push_back(teammate(entry, tasks[column].id, mine.robot(number).time_until_up));
      }
      candidate_row.push_back(row);
    }
    const std::optional<std::size_t> found = b_human::active_player(candidates, ball, rule);
    return found ? std::optional(candidate_row[*found]) : std::nullopt;
  }

  // The task of the active player is taken in any case, then those that are required.
  void put_in_order(const regista::Span<regista::Task>& all, std::optional<std::size_t> first) {
    assignment::by_importance(all, order);
    assignment::by_need(all, order, choice, first);
  }

  void say() {
    next = {};
    for (const Position& task : tasks) next.add(task.id);
    b_human::write(next, roles, bytes);
    offer.say(bytes, now);
  }
};

}  // namespace

REGISTA_PLUGIN(BHuman, regista::assigner)
