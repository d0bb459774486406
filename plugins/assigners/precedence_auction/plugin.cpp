// SPDX-License-Identifier: MIT
// Assigner plugin around algorithm.hpp. A task's group is that of its role in the team's page, the lower number first;
// tasks without a group make up the last one.
#include <array>
#include <span>
#include <string>
#include <vector>

#include <regista/assigner.hpp>
#include <regista/log.hpp>
#include <regista/mailbox.hpp>

#include "../distributed_auction/desk.hpp"
#include "algorithm.hpp"

namespace {

struct PrecedenceAuction {
  static constexpr auto id = "precedence_auction", version = "1.0.0",
                        summary = "An auction of groups of tasks, of each of which a robot takes one at most (Luo)";
  static constexpr unsigned reads = REGISTA_READS_NOTHING;
  static constexpr bool negotiates = true;
  static constexpr std::array orders{"sum", "first"};

  auction::Settings settings;
  int tasks_per_robot = 1;
  precedence::Order order = precedence::Order::sum;
  static constexpr std::tuple parameters{
      regista::integer("tasks_per_robot", &PrecedenceAuction::tasks_per_robot, {1, 64}, "1",
                       "Tasks of different groups that a robot may hold at once; it plays one of them (assumption)"),
      regista::choice("order", &PrecedenceAuction::order, orders,
                      "sum: groups only exclude each other and all are bid for at once, as published; first: earlier "
                      "groups choose their robots before later ones (assumption)"),
      regista::within(&PrecedenceAuction::settings, auction::shared_parameters,
                      regista::real("done_within", &auction::Settings::done_within, {0.0, 5.0}, "m",
                                    "A held task is done when its robot is so near, and a robot goes on to a task of a "
                                    "later group when all before it are done; 0: roles are never done (assumption)"))};

  auction::Desk<precedence::OneOfEachGroup> desk;
  std::vector<precedence::OneOfEachGroup::Best> best;
  regista::Log log;
  unsigned team_size = 0;
  bool has_warned = false;

  void setup(const regista::Environment& environment, const regista::Host& host) {
    log = regista::Log(host);
    team_size = environment->team_size;
    best.reserve(environment.roles().size());
    desk.setup(environment, host.mailbox(), settings);
  }
  void reset(std::uint64_t) {
    desk.reset();
    has_warned = false;
  }
  void assign(const regista::Frame& frame, regista::UtilityMatrix utilities, regista::Assignment out) {
    warn_of_groups_without_robots(frame.tasks());
    desk.assign(frame, utilities, out, {desk.epsilon(), static_cast<std::size_t>(tasks_per_robot), order, &best});
  }
  void receive(const regista::Message& message) { desk.receive(message); }
  void transmitted(std::uint64_t handle) { desk.transmitted(handle); }
  void dropped(std::uint64_t handle) { desk.dropped(handle); }
  std::string describe(std::span<const std::uint8_t> bytes) const { return desk.describe(bytes); }

 private:
  // A team's page may ask for what no team of its size can do. It is played as far as it goes.
  void warn_of_groups_without_robots(const regista::Span<regista::Task>& tasks) {
    if (has_warned) return;
    std::size_t groups = 0;
    for (std::size_t j = 0; j < tasks.size(); ++j) {
      bool is_new = true;
      for (std::size_t k = 0; k < j; ++k) is_new = is_new && tasks[k].group != tasks[j].group;
      groups += is_new ? 1u : 0u;
    }
    if (groups <= std::size_t{team_size} * static_cast<std::size_t>(tasks_per_robot)) return;
    has_warned = true;
    log.warning("more groups of tasks than robots can take: some stay without a robot");
  }
};

}  // namespace

REGISTA_PLUGIN(PrecedenceAuction, regista::assigner)
