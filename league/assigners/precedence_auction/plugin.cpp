// SPDX-License-Identifier: MIT
// Assigner plugin around algorithm.hpp. A task's group is that of its role in the team's page, the lower number first;
// tasks without a group make up the last one. What is odd about the groups of the page is said at once, where the host
// tells of them from the beginning; else more groups than the team can do are noticed in the match.
#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <regista/assigner.hpp>
#include <regista/log.hpp>
#include <regista/mailbox.hpp>
#include <regista/roles.hpp>

#include "../distributed_auction/desk.hpp"
#include "algorithm.hpp"
#include "groups.hpp"

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

  auction::Auctioneer<precedence::OneOfEachGroup> desk;
  std::vector<precedence::OneOfEachGroup::Best> best;
  regista::Log log;
  unsigned team_size = 0;
  bool knows_groups = false;  // since setup, and has said what is odd about them
  bool has_warned = false;

  void setup(const regista::Environment& environment, const regista::Host& host) {
    log = regista::Log(host);
    team_size = environment->team_size;
    best.reserve(environment.roles().size());
    desk.setup(environment, host, settings);
    knows_groups = look_at_groups(environment, regista::Roles(host));
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
  std::size_t most_groups() const { return std::size_t{team_size} * static_cast<std::size_t>(tasks_per_robot); }

  // False: the host does not tell. One robot speaks for all, which have the same page.
  bool look_at_groups(const regista::Environment& environment, const regista::Roles& facts) const {
    std::vector<precedence::RoleInGroup> roles;
    for (const regista::Role& role : environment.roles()) {
      const auto told = facts.role(static_cast<int>(roles.size()));
      if (!told) return false;
      roles.push_back({role.name, role.list, told->group});
    }
    if (environment->own_number != 1) return true;
    for (const precedence::GroupsOfList& each : precedence::groups_of_lists(roles)) {
      const std::string list = "roles " + std::string(each.list) + ": ";
      if (each.groups.size() > most_groups()) {
        log.warning(list + std::to_string(each.groups.size()) + " groups, and the team can do tasks of " +
                    std::to_string(most_groups()) + ": some stay without a robot");
      }
      if (!each.without.empty()) log.debug(list + "without a group, and so in the last one: " + each.without);
    }
    return true;
  }

  // A team's page may ask for what no team of its size can do. It is played as far as it goes.
  void warn_of_groups_without_robots(const regista::Span<regista::Task>& tasks) {
    if (knows_groups || has_warned) return;
    std::size_t groups = 0;
    for (std::size_t j = 0; j < tasks.size(); ++j) {
      bool is_new = true;
      for (std::size_t k = 0; k < j; ++k) is_new = is_new && tasks[k].group != tasks[j].group;
      groups += is_new ? 1u : 0u;
    }
    if (groups <= most_groups()) return;
    has_warned = true;
    log.warning("more groups of tasks than robots can take: some stay without a robot");
  }
};

}  // namespace

REGISTA_PLUGIN(PrecedenceAuction, regista::assigner)
