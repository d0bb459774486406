// SPDX-License-Identifier: MIT
// Assigner plugin around negotiator.hpp. Teammates claim roles in the core of every packet, too: that is what counts of
// robots that made no statement to this instance. Contexts with an assigner of the same parameters share an instance;
// one with others has its own, whose packets the rest does not hear.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include <plugins/assigners/task_order.hpp>
#include <regista/assigner.hpp>
#include <regista/host.hpp>
#include <regista/mailbox.hpp>

#include "../negotiation/reserve.hpp"
#include "../negotiation/standing_offer.hpp"
#include "negotiator.hpp"

namespace {

struct RoleExchange {
  static constexpr auto id = "role_exchange", version = "1.0.0",
                        summary = "Robots tell utilities, and exchange roles when all concerned wish it (CS Freiburg)";
  static constexpr bool negotiates = true;
  static constexpr unsigned reads = REGISTA_READS_PREVIOUS;

  role_exchange::Settings settings;
  enum class Urgent { never, answers, wishes };
  static constexpr std::array urgent_names{"never", "answers", "wishes"};
  Urgent urgent = Urgent::answers;
  int stop_negotiating_at = negotiation::usual_reserve;
  static constexpr std::tuple parameters{
      regista::within(
          &RoleExchange::settings,
          regista::real("keep_bonus", &role_exchange::Settings::keep_bonus, {0.0, 1.0}, "1",
                        "Added to the utility of the role that the robot has (assumption)")
              .tunable(),
          regista::real("largest", &role_exchange::Settings::largest, {0.001, 1e6}, "1",
                        "Largest utility in a packet, sent in 255 steps; larger ones count as this (assumption)"),
          regista::real("dead_band", &role_exchange::Settings::dead_band, {0.0, 1.0}, "1",
                        "A utility that changed by no more than this is sent unchanged (assumption)")
              .tunable(),
          regista::real("lapse", &role_exchange::Settings::lapse, {1.0, 3600.0}, "s",
                        "What a robot said holds for this long after it was sent (assumption)"),
          regista::real("patience", &role_exchange::Settings::patience, {0.0, 60.0}, "s",
                        "After this time without a role a robot takes any free one (assumption)")
              .tunable()),
      regista::choice(
          "urgent", &RoleExchange::urgent, urgent_names,
          "What is worth a packet of its own: nothing, a wish that completes an exchange, or every new wish "
          "(assumption: answers)"),
      negotiation::stop_negotiating_at(&RoleExchange::stop_negotiating_at)};

  role_exchange::Negotiator negotiator;
  negotiation::StandingOffer offer;
  negotiation::Reserve reserve;
  std::size_t roles = 0;
  int own = 1;
  bool called = false;
  std::uint64_t last_tick = 0;
  std::vector<std::string> names;
  std::vector<std::int32_t> members, tasks, claims;
  std::vector<double> claimed;
  std::vector<std::uint32_t> order, choice;

  void setup(const regista::Environment& environment, const regista::Host& host) {
    const std::size_t robots = environment->team_size;
    roles = environment.roles().size();
    own = environment->own_number;
    for (const regista::Role& role : environment.roles()) names.emplace_back(role.name);
    negotiator.reserve(settings, own, robots, roles);
    reserve.setup(environment, host, stop_negotiating_at);
    offer.setup(host.mailbox(), role_exchange::message_bytes(roles, std::min(robots, roles)));
    members.reserve(robots);
    claims.reserve(robots);
    claimed.reserve(robots);
    tasks.reserve(roles);
    order.reserve(roles);
    choice.reserve(roles);
  }
  void reset(std::uint64_t) {
    negotiator.forget();
    offer.forget();
    called = false;
  }

  void assign(const regista::Frame& frame, regista::UtilityMatrix utilities, regista::Assignment out) {
    if (reserve.is_reached()) {
      called = false;  // what others decide meanwhile, negotiator takes on
      offer.withdraw();
      return reserve.assign_by_rank(frame, utilities, out);
    }
    const role_exchange::Situation now = read(frame, utilities);
    negotiator.decide(now);
    if (negotiator.speaks()) {
      const bool worth_a_packet = urgent == Urgent::wishes    ? negotiator.wish_is_news()
                                  : urgent == Urgent::answers ? negotiator.completes_change()
                                                              : false;
      offer.say(negotiator.message(), frame.time(), worth_a_packet ? 1.0 : 0.0);
    } else {
      offer.withdraw();
    }
    for (std::size_t row = 0; row < members.size(); ++row) {
      const bool self = members[row] == own;
      const std::int32_t role = self ? negotiator.role() : negotiator.role_of(now, row);
      out[row] = regista::Assignment::no_task;
      for (std::size_t column = 0; column < tasks.size(); ++column) {
        const bool allowed = utilities(row, column) != regista::UtilityMatrix::forbidden;
        if (tasks[column] == role && allowed) out[row] = static_cast<std::int32_t>(column);
      }
    }
  }

  void receive(const regista::Message& message) {
    negotiator.hear(message.sender(), message.bytes(), message.time_sent());
  }
  void transmitted(std::uint64_t handle) {
    if (offer.gone(handle)) negotiator.sent(offer.said());
  }
  void dropped(std::uint64_t handle) { offer.gone(handle); }

  // "plays striker, wishes supporter; striker 0.61, supporter 0.70"
  std::string describe(std::span<const std::uint8_t> bytes) const {
    role_exchange::Statement said;
    if (!role_exchange::read_statement(bytes, roles, said)) return "no statement about these roles";
    const auto name = [&](std::int32_t role) {
      return role == role_exchange::no_role ? std::string("nothing") : names[static_cast<std::size_t>(role)];
    };
    std::string text = "plays " + name(said.role) +
                       (said.wish == said.role ? std::string(" and stays") : ", wishes " + name(said.wish));
    char separator = ';';
    for (std::size_t role = 0; role < roles; ++role) {
      if (said.utilities[role] == role_exchange::cannot) continue;
      const double utility = said.utilities[role] * settings.largest / role_exchange::most_steps;
      const auto hundredths = static_cast<long>(std::lround(100.0 * utility));
      text += separator + (' ' + names[role]) + ' ' + std::to_string(hundredths / 100) + '.' +
              std::to_string(hundredths / 10 % 10) + std::to_string(hundredths % 10);
      separator = ',';
    }
    return text;
  }

 private:
  role_exchange::Situation read(const regista::Frame& frame, const regista::UtilityMatrix& utilities) {
    const regista::World world = frame.world();
    const bool begins = !called || frame.tick() != last_tick + 1;
    called = true;
    last_tick = frame.tick();
    members.clear();
    for (const std::int32_t number : world.active()) members.push_back(number);
    tasks.clear();
    for (const regista::Task& task : frame.tasks()) tasks.push_back(task.id);
    claims.clear();
    claimed.clear();
    for (const regista::Robot& robot : world.robots()) {
      const bool heard = (robot.flags & REGISTA_ROBOT_KNOWN) != 0 && robot.role < static_cast<std::int32_t>(roles);
      claims.push_back(heard ? robot.role : role_exchange::no_role);
      claimed.push_back(heard ? frame.time() - robot.age : -settings.lapse);
    }
    assignment::by_importance(frame.tasks(), order);
    assignment::by_need(frame.tasks(), order, choice);
    return {
        .time = frame.time(),
        .members = members,
        .tasks = tasks,
        .choice = choice,
        .order = order,
        .utilities = {utilities.data(), utilities.rows(), utilities.columns(), utilities.stride()},
        .claims = claims,
        .claimed = claimed,
        .begins = begins,
        .own_role = frame.previous_task(own),
    };
  }
};

}  // namespace

REGISTA_PLUGIN(RoleExchange, regista::assigner)
