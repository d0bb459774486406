// SPDX-License-Identifier: MIT
// Assigner plugin around algorithm.hpp and vote.hpp.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include <regista/assigner.hpp>
#include <regista/mailbox.hpp>

#include "../task_order.hpp"
#include "algorithm.hpp"
#include "vote.hpp"

namespace {

struct Scram {
  static constexpr auto id = "scram", version = "1.0.0",
                        summary = "Least longest walk, then the next longest or the least sum of squares (SCRAM)";
  static constexpr unsigned reads = REGISTA_READS_NOTHING;

  enum class Cost { distance, utility };
  static constexpr std::array criteria{"mmdr", "mmd_msd2"};
  static constexpr std::array costs{"distance", "utility"};

  scram::Criterion criterion = scram::Criterion::mmdr;
  Cost cost = Cost::distance;
  bool vote = false;
  double vote_age = 10.0;
  static constexpr std::tuple parameters{
      regista::choice("criterion", &Scram::criterion, criteria,
                      "After the longest walk: mmdr minimises the next longest and so on, mmd_msd2 the sum of squared "
                      "distances (MacAlpine, Price and Stone 2015)"),
      regista::choice("cost", &Scram::cost, costs,
                      "What is long: distance is from the robot to the task's place as in the paper, utility how much "
                      "the pair's utility falls short of the largest one"),
      regista::boolean("vote", &Scram::vote,
                       "Robots tell their assignments and play the one with the most recent votes (MacAlpine, Barrera "
                       "and Stone 2012)"),
      regista::real("vote_age", &Scram::vote_age, {0.1, 60.0}, "s",
                    "A vote counts for this long after it was sent (assumption)")};

  scram::Solver solver;
  std::vector<double> values;
  std::vector<std::uint32_t> order, choice;
  std::vector<std::int32_t> assigned;

  regista::Mailbox mailbox;
  scram::BallotBox ballots;
  unsigned team_size = 0;
  std::size_t roles = 0;
  std::uint64_t offer = 0;  // pending, 0 = none
  std::vector<std::uint8_t> offered, ballot;
  std::vector<std::int32_t> tasks, tasks_before, numbers, row_of_number, scratch;

  void setup(const regista::Environment& environment, regista::Mailbox way_out) {
    const std::size_t robots = environment->team_size;
    roles = environment.roles().size();
    mailbox = way_out;
    team_size = environment->team_size;
    solver.reserve(robots, roles);
    values.reserve(robots * roles);
    order.reserve(roles);
    choice.reserve(roles);
    assigned.reserve(robots);
    if (!vote) return;
    ballots.reserve(team_size, roles);
    for (auto* bytes : {&offered, &ballot}) bytes->reserve(scram::ballot_bytes(roles, team_size));
    for (auto* each : {&tasks, &tasks_before, &numbers}) each->reserve(roles);
    scratch.reserve(2 * roles);
    row_of_number.reserve(robots + 1);
  }

  void reset(std::uint64_t) {
    ballots.clear();
    tasks_before.clear();
    offered.clear();
    offer = 0;
  }

  void assign(const regista::Frame& frame, regista::UtilityMatrix utilities, regista::Assignment out) {
    assigned.assign(out.size(), regista::Assignment::no_task);
    if (utilities.columns() > 0) {
      assignment::by_importance(frame.tasks(), order);
      choose_first_the_required(frame.tasks());
      fill_costs(frame, utilities);
      solver.assign({values.data(), utilities.rows(), utilities.columns(), utilities.columns()}, criterion, order,
                    choice, assigned);
      if (vote) take_part_in_vote(frame, utilities);
    }
    for (std::size_t row = 0; row < out.size(); ++row) out[row] = assigned[row];
  }

  void receive(const regista::Message& message) {
    if (vote) ballots.put(message.sender(), message.bytes(), message.time_sent());
  }
  void transmitted(std::uint64_t handle) { forget(handle); }
  void dropped(std::uint64_t handle) { forget(handle); }

  // "vote for tasks of print 5: 1 0 3": robots in order of the tasks' importance, 0 for nobody. Nobody at the end is
  // left out, as a ballot does not tell it from bits that fill its last byte.
  std::string describe(std::span<const std::uint8_t> bytes) const {
    if (!vote || bytes.empty()) return "no vote";
    const std::size_t robots = scram::most_tasks(bytes.size(), team_size);
    std::vector<std::int32_t> named(std::min(robots, roles));
    if (scram::ballot_bytes(named.size(), team_size) != bytes.size()) return "no vote of this team";
    scram::read_ballot(bytes, team_size, named);
    while (!named.empty() && named.back() == 0) named.pop_back();
    std::string out = "vote for tasks of print " + std::to_string(scram::fingerprint_of(bytes)) + ':';
    for (const std::int32_t number : named) out += ' ' + std::to_string(number);
    return out;
  }

 private:
  void choose_first_the_required(const regista::Span<regista::Task>& all) {
    choice.clear();
    for (const std::uint32_t wanted : {1u, 0u}) {
      for (const std::uint32_t column : order) {
        const bool required = (all[column].flags & REGISTA_TASK_REQUIRED) != 0;
        if (required == (wanted == 1u)) choice.push_back(column);
      }
    }
  }

  // Squared distances order pairs as distances do and are what mmd_msd2 sums. In place of a distance, a utility falls
  // short of the largest by a number whose square is summed; for mmdr its order is enough.
  void fill_costs(const regista::Frame& frame, const regista::UtilityMatrix& utilities) {
    const std::size_t rows = utilities.rows(), columns = utilities.columns();
    values.resize(rows * columns);
    const regista::World world = frame.world();
    const regista::Span<regista::Task> all = frame.tasks();
    double largest = 0.0;
    if (cost == Cost::utility && criterion == scram::Criterion::mmd_msd2) {
      for (std::size_t i = 0; i < rows; ++i) {
        for (std::size_t j = 0; j < columns; ++j) largest = std::max(largest, utilities(i, j));
      }
    }
    for (std::size_t i = 0; i < rows; ++i) {
      const double* pose = world.robot(world.active()[i]).pose;
      for (std::size_t j = 0; j < columns; ++j) {
        double& value = values[i * columns + j];
        if (utilities(i, j) == regista::UtilityMatrix::forbidden) {
          value = scram::infinity;
        } else if (cost == Cost::distance) {
          const double dx = all[j].after[0] - pose[0], dy = all[j].after[1] - pose[1];
          value = dx * dx + dy * dy;
        } else if (criterion == scram::Criterion::mmdr) {
          value = -utilities(i, j);
        } else {
          const double shortfall = largest - utilities(i, j);
          value = shortfall * shortfall;
        }
      }
    }
  }

  void take_part_in_vote(const regista::Frame& frame, const regista::UtilityMatrix& utilities) {
    const regista::Span<std::int32_t> active = frame.world().active();
    const std::uint8_t print = note_tasks(frame.tasks());
    row_of_number.assign(team_size + 1, -1);
    for (std::size_t row = 0; row < active.size(); ++row) {
      row_of_number[static_cast<std::size_t>(active[row])] = static_cast<std::int32_t>(row);
    }
    numbers.assign(order.size(), 0);
    std::size_t pairs = 0;
    for (std::size_t k = 0; k < order.size(); ++k) {
      for (std::size_t row = 0; row < assigned.size(); ++row) {
        if (assigned[row] != static_cast<std::int32_t>(order[k])) continue;
        numbers[k] = active[row];
        ++pairs;
      }
    }
    scram::write_ballot(print, numbers, team_size, ballot);
    if (offer == 0 || offered != ballot) {
      offered = ballot;
      offer = mailbox.offer(offered, 0.0, frame.time() + vote_age, offer);
    }
    scratch.resize(2 * order.size());
    ballots.elect(numbers, frame.time() - vote_age, scratch,
                  [&](std::span<const std::int32_t> named) { return can_be_played(named, utilities, pairs); });
    std::fill(assigned.begin(), assigned.end(), regista::Assignment::no_task);
    for (std::size_t k = 0; k < order.size(); ++k) {
      if (numbers[k] == 0) continue;
      const std::int32_t row = row_of_number[static_cast<std::size_t>(numbers[k])];
      assigned[static_cast<std::size_t>(row)] = static_cast<std::int32_t>(order[k]);
    }
  }

  // A teammate may know other robots to be out, or have played another game altogether: what counts here are robots
  // that are active here, once each, in allowed pairs, and no fewer of them than in the own assignment.
  bool can_be_played(std::span<const std::int32_t> named, const regista::UtilityMatrix& utilities,
                     std::size_t pairs) const {
    std::size_t count = 0;
    for (std::size_t k = 0; k < named.size(); ++k) {
      if (named[k] == 0) continue;
      if (named[k] > static_cast<std::int32_t>(team_size)) return false;
      const std::int32_t row = row_of_number[static_cast<std::size_t>(named[k])];
      if (row < 0 || utilities(static_cast<std::size_t>(row), order[k]) == regista::UtilityMatrix::forbidden) {
        return false;
      }
      if (std::find(named.begin(), named.begin() + static_cast<std::ptrdiff_t>(k), named[k]) !=
          named.begin() + static_cast<std::ptrdiff_t>(k)) {
        return false;
      }
      ++count;
    }
    return count == pairs;
  }

  // Notices that the tasks are others than before; returns their fingerprint.
  std::uint8_t note_tasks(const regista::Span<regista::Task>& all) {
    tasks.clear();
    scram::Fingerprint now, before;
    for (const std::uint32_t column : order) {
      tasks.push_back(all[column].id);
      now.add(all[column].id);
    }
    if (tasks != tasks_before) {
      for (const std::int32_t each : tasks_before) before.add(each);
      ballots.tasks_changed(now.value(), !tasks_before.empty() && now.value() == before.value());
      tasks_before = tasks;
    }
    return now.value();
  }

  void forget(std::uint64_t handle) {
    if (handle == offer) offer = 0;
  }
};

}  // namespace

REGISTA_PLUGIN(Scram, regista::assigner)
